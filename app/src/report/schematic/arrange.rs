//! Placement of parts: in columns by their distance from one end of the machine, so that parts of a
//! net are at most one column apart.

use std::collections::VecDeque;

use super::Schematic;

/// Returns the column and row of each part.
pub(super) fn places(schematic: &Schematic) -> Vec<(usize, usize)> {
    let neighbours = neighbours(schematic);
    let mut places: Vec<Option<(usize, usize)>> = vec![None; neighbours.len()];
    let mut below = 0;
    for first in 0..neighbours.len() {
        if places[first].is_some() {
            continue;
        }
        let placed = component(&neighbours, first);
        for (part, (column, row)) in &placed {
            places[*part] = Some((*column, row + below));
        }
        below += placed.iter().map(|(_, (_, row))| row + 1).max().unwrap_or(0);
    }
    places.into_iter().flatten().collect()
}

fn neighbours(schematic: &Schematic) -> Vec<Vec<usize>> {
    let mut neighbours = vec![Vec::new(); schematic.parts.len()];
    let mut meet = |a: usize, b: usize| {
        if a != b && !neighbours[a].contains(&b) {
            neighbours[a].push(b);
            neighbours[b].push(a);
        }
    };
    for net in &schematic.nets {
        for (index, (a, _)) in net.ports.iter().enumerate() {
            net.ports[index + 1..].iter().for_each(|(b, _)| meet(*a, *b));
        }
    }
    schematic.links.iter().for_each(|link| meet(link.from, link.to));
    neighbours
}

/// Returns the parts that can be reached from a part, each with the number of steps and the
/// preceding part, in the order in which they are reached.
fn reach(neighbours: &[Vec<usize>], from: usize) -> Vec<(usize, usize, usize)> {
    let mut reached = Vec::new();
    let mut seen = vec![false; neighbours.len()];
    let mut next = VecDeque::from([(from, 0, from)]);
    seen[from] = true;
    while let Some((part, steps, before)) = next.pop_front() {
        reached.push((part, steps, before));
        for neighbour in &neighbours[part] {
            if !std::mem::replace(&mut seen[*neighbour], true) {
                next.push_back((*neighbour, steps + 1, part));
            }
        }
    }
    reached
}

/// Returns the first of the farthest parts.
fn farthest(reached: &[(usize, usize, usize)]) -> usize {
    let most = reached.iter().map(|(_, steps, _)| *steps).max().unwrap_or(0);
    let found = reached.iter().filter(|(_, steps, _)| *steps == most).map(|(part, ..)| *part);
    found.min().unwrap_or(0)
}

/// Places the connected component of a part. The longest path lies along the first row.
fn component(neighbours: &[Vec<usize>], first: usize) -> Vec<(usize, (usize, usize))> {
    let one = farthest(&reach(neighbours, first));
    let other = farthest(&reach(neighbours, one));
    let root = one.min(other);
    let reached = reach(neighbours, root);
    let mut way = vec![one.max(other)];
    while let Some(last) = way.last().copied().filter(|last| *last != root) {
        let before = reached.iter().find(|(part, ..)| *part == last);
        way.push(before.map_or(root, |(_, _, before)| *before));
    }
    let mut placed: Vec<(usize, (usize, usize))> = Vec::new();
    for (part, column, _) in reached {
        let row = |of: &usize| placed.iter().find(|(part, _)| part == of).map(|(_, place)| place.1);
        let rows: Vec<usize> = neighbours[part].iter().filter_map(row).collect();
        let wanted = if way.contains(&part) {
            0
        } else {
            (rows.iter().sum::<usize>() / rows.len().max(1)).max(1)
        };
        let is_taken = |row: usize| placed.iter().any(|(_, place)| *place == (column, row));
        let mut row = wanted;
        while is_taken(row) {
            row += 1;
        }
        placed.push((part, (column, row)));
    }
    placed
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chain_is_a_row_and_what_hangs_from_it_stands_below() {
        // Chain 0 - 1 - 2 - 3, with 4 attached to 1.
        let neighbours = vec![vec![1], vec![0, 2, 4], vec![1, 3], vec![2], vec![1]];
        let mut placed = component(&neighbours, 2);
        placed.sort_unstable();
        let places: Vec<_> = placed.into_iter().map(|(_, place)| place).collect();
        assert_eq!(places, [(0, 0), (1, 0), (2, 0), (3, 0), (2, 1)]);
    }
}
