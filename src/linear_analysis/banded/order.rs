//! Decoupled parts of a machine, each in an order that keeps coupled nodes near.

use std::collections::VecDeque;

/// Returns the connected parts of a graph, each in reverse Cuthill-McKee order: by distance from
/// one end of it, so that neighbours get close numbers.
///
/// Source: Cuthill, McKee, "Reducing the bandwidth of sparse symmetric matrices", ACM '69;
/// ends as George, Liu, "An implementation of a pseudoperipheral node finder", ACM TOMS 5 (1979).
pub(super) fn parts(neighbours: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut is_placed = vec![false; neighbours.len()];
    let mut parts = Vec::new();
    for node in 0..neighbours.len() {
        if is_placed[node] {
            continue;
        }
        let mut part = walk(neighbours, end(neighbours, node));
        for node in &part {
            is_placed[*node] = true;
        }
        part.reverse();
        parts.push(part);
    }
    parts
}

/// Returns a node far from others of its part.
fn end(neighbours: &[Vec<usize>], node: usize) -> usize {
    const WALKS: usize = 3;
    (0..WALKS).fold(node, |node, _| walk(neighbours, node).last().copied().unwrap_or(node))
}

/// Returns all reachable nodes, nearest first; nodes at the same distance are ordered by their
/// number of neighbours.
fn walk(neighbours: &[Vec<usize>], start: usize) -> Vec<usize> {
    let mut is_reached = vec![false; neighbours.len()];
    let mut waiting = VecDeque::from([start]);
    let mut order = Vec::new();
    is_reached[start] = true;
    while let Some(node) = waiting.pop_front() {
        order.push(node);
        let new = neighbours[node].iter().copied().filter(|other| !is_reached[*other]);
        let mut new: Vec<usize> = new.collect();
        new.sort_by_key(|other| (neighbours[*other].len(), *other));
        new.dedup();
        for other in &new {
            is_reached[*other] = true;
        }
        waiting.extend(new);
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chains_are_walked_from_end_to_end_whatever_their_numbers_are() {
        // 0 - 3 - 1 - 4, and 2 - 5 by themselves.
        let neighbours = [vec![3], vec![3, 4], vec![5], vec![1, 0], vec![1], vec![2]];
        let mut found = parts(&neighbours);
        for part in &mut found {
            if part[0] > part[part.len() - 1] {
                part.reverse();
            }
        }
        assert_eq!(found, [vec![0, 3, 1, 4], vec![2, 5]]);
    }
}
