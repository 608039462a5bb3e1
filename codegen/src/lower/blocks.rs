//! Decomposition of constraints into blocks that pin coordinates, independently of the forces.
//!
//! As many constraints as they have coordinates determine the accelerations of these by
//! themselves, `G_b q''_b = gamma_b`: forces, masses and other coordinates have no influence. In
//! the inverse of the bordered matrix all coupling entries are exactly zero. A factorization of
//! the whole finds these zeros only up to rounding.
//!
//! The blocks are found by the decomposition of Dulmage and Mendelsohn (Can. J. Math. 10, 1958)
//! of the pattern of G. It uses a largest matching of constraints with coordinates. Coordinates
//! that an unmatched one reaches are free; the others form blocks, which are strong components by
//! the algorithm of Tarjan (SIAM J. Comput. 1, 1972).

/// Coordinates and constraints in the order of solution.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Blocks {
    /// Blocks that constraints alone determine. Each reads only itself and those before it.
    pub pinned: Vec<Block>,
    /// All other coordinates, with the equations of motion and the remaining constraints.
    pub free: Block,
}

/// Coordinates with constraints.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Block {
    /// Coordinates, ascending.
    pub coordinates: Vec<usize>,
    /// Constraints, ascending; as many as coordinates in a pinned block.
    pub constraints: Vec<usize>,
}

/// Finds the blocks of constraints, which are given by the coordinates that each contains. If
/// there are too many constraints for a matching, all is free.
#[must_use]
pub fn blocks(held: &[Vec<usize>], coordinates: usize) -> Blocks {
    let Some(partner) = matching(held, coordinates) else {
        let free = Block {
            coordinates: (0..coordinates).collect(),
            constraints: (0..held.len()).collect(),
        };
        return Blocks { pinned: Vec::new(), free };
    };
    let is_free = free(held, &partner);
    let is_left = |constraint: &usize| held[*constraint].iter().any(|c| is_free[*c]);
    let free = Block {
        coordinates: (0..coordinates).filter(|c| is_free[*c]).collect(),
        constraints: (0..held.len()).filter(is_left).collect(),
    };
    let mut search = Search { held, partner: &partner, ..Search::default() };
    search.number = vec![None; held.len()];
    search.low = vec![0; held.len()];
    for constraint in (0..held.len()).filter(|constraint| !is_left(constraint)) {
        search.visit(constraint);
    }
    let own = |constraint: &usize| partner.iter().position(|p| *p == Some(*constraint));
    let pinned = search.components.into_iter().map(|mut constraints| {
        constraints.sort_unstable();
        let mut coordinates: Vec<usize> = constraints.iter().filter_map(own).collect();
        coordinates.sort_unstable();
        Block { coordinates, constraints }
    });
    Blocks { pinned: pinned.collect(), free }
}

/// Returns the constraint of each coordinate, if every constraint can have a coordinate of its
/// own.
fn matching(held: &[Vec<usize>], coordinates: usize) -> Option<Vec<Option<usize>>> {
    let mut partner = vec![None; coordinates];
    for constraint in 0..held.len() {
        let mut seen = vec![false; coordinates];
        if !augment(held, constraint, &mut seen, &mut partner) {
            return None;
        }
    }
    Some(partner)
}

/// Finds a coordinate for a constraint, and moves other constraints to other coordinates if
/// necessary.
fn augment(
    held: &[Vec<usize>],
    constraint: usize,
    seen: &mut [bool],
    partner: &mut [Option<usize>],
) -> bool {
    for &coordinate in &held[constraint] {
        if std::mem::replace(&mut seen[coordinate], true) {
            continue;
        }
        let is_mine = match partner[coordinate] {
            None => true,
            Some(other) => augment(held, other, seen, partner),
        };
        if is_mine {
            partner[coordinate] = Some(constraint);
            return true;
        }
    }
    false
}

/// Returns the coordinates that a coordinate without a constraint of its own reaches.
fn free(held: &[Vec<usize>], partner: &[Option<usize>]) -> Vec<bool> {
    let mut is_free: Vec<bool> = partner.iter().map(Option::is_none).collect();
    let mut is_grown = true;
    while std::mem::take(&mut is_grown) {
        for (coordinate, constraint) in partner.iter().enumerate() {
            let Some(constraint) = constraint else { continue };
            if !is_free[coordinate] && held[*constraint].iter().any(|c| is_free[*c]) {
                is_free[coordinate] = true;
                is_grown = true;
            }
        }
    }
    is_free
}

/// Strong components; those that others read come first.
#[derive(Default)]
struct Search<'a> {
    held: &'a [Vec<usize>],
    partner: &'a [Option<usize>],
    number: Vec<Option<usize>>,
    low: Vec<usize>,
    open: Vec<usize>,
    next: usize,
    components: Vec<Vec<usize>>,
}

impl Search<'_> {
    fn visit(&mut self, constraint: usize) {
        if self.number[constraint].is_some() {
            return;
        }
        let number = self.next;
        self.next += 1;
        self.number[constraint] = Some(number);
        self.low[constraint] = number;
        self.open.push(constraint);
        for &coordinate in &self.held[constraint] {
            let Some(other) = self.partner[coordinate] else { continue };
            match self.number[other] {
                None => {
                    self.visit(other);
                    self.low[constraint] = self.low[constraint].min(self.low[other]);
                }
                Some(number) if self.open.contains(&other) => {
                    self.low[constraint] = self.low[constraint].min(number);
                }
                Some(_) => {}
            }
        }
        if self.low[constraint] == number {
            let start = self.open.iter().position(|c| *c == constraint).unwrap_or(0);
            self.components.push(self.open.split_off(start));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn block(coordinates: &[usize], constraints: &[usize]) -> Block {
        Block { coordinates: coordinates.to_vec(), constraints: constraints.to_vec() }
    }

    #[test]
    fn what_is_held_alone_comes_before_what_leans_on_it() {
        // 0 is fixed by the second constraint, 1 and 2 depend on each other and on 0, 3 is free.
        let held = [vec![0, 1, 2], vec![0], vec![1, 2]];
        let found = blocks(&held, 4);
        assert_eq!(found.pinned, [block(&[0], &[1]), block(&[1, 2], &[0, 2])]);
        assert_eq!(found.free, block(&[3], &[]));
    }

    #[test]
    fn a_pendulum_stays_free() {
        // Constraints of x and phi, and of y and phi.
        let found = blocks(&[vec![0, 2], vec![1, 2]], 3);
        assert_eq!(found, Blocks { pinned: vec![], free: block(&[0, 1, 2], &[0, 1]) });
    }

    #[test]
    fn what_hangs_on_pinned_coordinates_is_free_of_them() {
        // 0 is fixed, 1 and 2 share a constraint with it.
        let found = blocks(&[vec![0], vec![0, 1, 2]], 3);
        assert_eq!(found.pinned, [block(&[0], &[0])]);
        assert_eq!(found.free, block(&[1, 2], &[1]));
    }

    #[test]
    fn too_many_constraints_leave_all_as_it_is() {
        let found = blocks(&[vec![0], vec![0]], 2);
        assert_eq!(found, Blocks { pinned: vec![], free: block(&[0, 1], &[0, 1]) });
    }
}
