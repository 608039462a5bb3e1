//! Structure of a model: constant, linear and independent parts, and how often each operation has
//! to be done.
//!
//! Excluded: use of the structure. This module only reports it.

use machinist_model::{Dependence, MatrixTape, Model, NodeId, Op, Tape, needed_nodes};

/// Numbers of operations of a tape, by how often their operands change.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Frequency {
    /// Operations on parameters only, needed once a run.
    pub once: usize,
    /// Operations on time and parameters only, needed once for each time, whatever the state.
    pub by_time: usize,
    /// Operations on the state, needed at every evaluation.
    pub by_state: usize,
}

/// Structure of a model.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Structure {
    /// Number of coordinates, the rows of M.
    pub coordinates: usize,
    /// True if no entry of M depends on state or time.
    pub constant_mass: bool,
    /// True if M has entries on its diagonal only.
    pub diagonal_mass: bool,
    /// Number of entries of dy'/dy that depend on parameters only, and of all entries.
    pub constant_jacobian: (usize, usize),
    /// Entries of the state whose rate is a y + b(t), where a depends on parameters only.
    pub linear_rows: Vec<u32>,
    /// Entries among them whose rates depend only on each other: a linear time-invariant part,
    /// which could be integrated separately and first.
    pub linear_part: Vec<u32>,
    /// True if y' does not depend explicitly on time.
    pub autonomous: bool,
    /// Groups of entries of the state that do not depend on each other.
    pub subsystems: Vec<Vec<u32>>,
    /// Operations of y'.
    pub rate: Frequency,
    /// Operations of dy'/dy.
    pub jacobian: Frequency,
}

impl Structure {
    /// Analyses a model.
    #[must_use]
    pub fn of(model: &Model) -> Self {
        let mass = &model.mass_matrix;
        let jacobian = &model.rate_jacobian;
        let rate = Dependence::of(&model.rate);
        let linear_rows = linear_rows(model);
        let reads = reads(&model.rate);
        Structure {
            coordinates: mass.pattern.rows,
            constant_mass: constants(mass) == mass.pattern.entries.len(),
            diagonal_mass: mass.pattern.entries.iter().all(|(row, column)| row == column),
            constant_jacobian: (constants(jacobian), jacobian.pattern.entries.len()),
            linear_part: closed_part(&reads, &linear_rows),
            linear_rows,
            autonomous: model.rate.results.iter().all(|id| !rate.on_time(*id)),
            subsystems: subsystems(&reads),
            rate: Frequency::of(&model.rate),
            jacobian: Frequency::of(&jacobian.tape),
        }
    }

    /// Reports whether y' is A y + b(t), where A depends on parameters only.
    #[must_use]
    pub fn is_linear(&self) -> bool {
        let states: usize = self.subsystems.iter().map(Vec::len).sum();
        self.linear_rows.len() == states
    }
}

impl Frequency {
    /// Counts the operations of a tape.
    #[must_use]
    pub fn of(tape: &Tape) -> Self {
        let dependence = Dependence::of(tape);
        let needed = needed_nodes(tape);
        let mut frequency = Frequency::default();
        for (index, node) in tape.nodes.iter().enumerate() {
            if !needed[index] || !node.op.is_arithmetic() {
                continue;
            }
            let id = NodeId(index as u32);
            if dependence.on_state(id) {
                frequency.by_state += 1;
            } else if dependence.on_time(id) {
                frequency.by_time += 1;
            } else {
                frequency.once += 1;
            }
        }
        frequency
    }
}

/// Returns the number of entries of a matrix that depend on parameters only.
fn constants(matrix: &MatrixTape) -> usize {
    let dependence = Dependence::of(&matrix.tape);
    matrix.tape.results.iter().filter(|id| !dependence.on_anything(**id)).count()
}

/// Returns the rows of dy'/dy that depend on parameters only, without those of rates that are
/// discontinuous in the state: even if the derivative is constant on each side, the rate is not
/// linear.
fn linear_rows(model: &Model) -> Vec<u32> {
    let jacobian = &model.rate_jacobian;
    let dependence = Dependence::of(&jacobian.tape);
    let switched = switched(&model.rate);
    let is_linear = |row: u32| {
        let entries = jacobian.pattern.entries.iter().zip(&jacobian.tape.results);
        let mut entries = entries.filter(|((entry_row, _), _)| *entry_row == row);
        let result = model.rate.results[row as usize];
        !switched[result.0 as usize] && entries.all(|(_, id)| !dependence.on_anything(*id))
    };
    (0..model.states.len() as u32).filter(|row| is_linear(*row)).collect()
}

/// Reports, for each node, whether it depends on a comparison or an interval of a table that the
/// state selects.
fn switched(tape: &Tape) -> Vec<bool> {
    let dependence = Dependence::of(tape);
    let on_state = |id: NodeId| dependence.on_state(id);
    let mut switched: Vec<bool> = Vec::with_capacity(tape.nodes.len());
    for node in &tape.nodes {
        let decides = match node.op {
            Op::SelectLess { lhs, rhs, .. } => on_state(lhs) || on_state(rhs),
            Op::Table { argument, .. } => on_state(argument),
            _ => false,
        };
        switched.push(decides || node.op.operands().iter().any(|id| switched[id.0 as usize]));
    }
    switched
}

/// Returns the entries of the state that each result of a tape reads, in order. They are more
/// than the nonzeros of its derivatives: those of a discontinuity are zero on both sides.
fn reads(tape: &Tape) -> Vec<Vec<u32>> {
    let of = |result: &NodeId| {
        let (mut open, mut seen) = (vec![*result], vec![false; tape.nodes.len()]);
        let mut entries = Vec::new();
        while let Some(id) = open.pop() {
            if std::mem::replace(&mut seen[id.0 as usize], true) {
                continue;
            }
            let op = &tape.nodes[id.0 as usize].op;
            match op {
                Op::State(entry) => entries.push(*entry),
                _ => open.extend(op.operands()),
            }
        }
        entries.sort_unstable();
        entries.dedup();
        entries
    };
    tape.results.iter().map(of).collect()
}

/// Returns the largest part of `rows` whose rates read only entries of that part.
fn closed_part(reads: &[Vec<u32>], rows: &[u32]) -> Vec<u32> {
    let mut part = rows.to_vec();
    loop {
        let is_open = |row: &&u32| reads[**row as usize].iter().any(|entry| !part.contains(entry));
        match part.iter().find(is_open).copied() {
            Some(open) => part.retain(|row| *row != open),
            None => return part,
        }
    }
}

/// Returns the connected parts of the state, according to the entries that each rate reads.
fn subsystems(reads: &[Vec<u32>]) -> Vec<Vec<u32>> {
    let count = reads.len();
    let mut group: Vec<usize> = (0..count).collect();
    for (row, entries) in reads.iter().enumerate() {
        for &entry in entries {
            let (a, b) = (group[row], group[entry as usize]);
            let (from, to) = (a.max(b), a.min(b));
            group.iter_mut().filter(|g| **g == from).for_each(|g| *g = to);
        }
    }
    let parts = (0..count).map(|first| {
        let members = (0..count).filter(|entry| group[*entry] == first);
        members.map(|entry| entry as u32).collect::<Vec<_>>()
    });
    parts.filter(|part| !part.is_empty()).collect()
}

#[cfg(test)]
mod tests {
    use machinist_model::{Node, SparsityPattern, TableId};

    use super::*;

    fn tape(ops: &[Op], results: &[u32]) -> Tape {
        let nodes = ops.iter().map(|&op| Node { op, name: None }).collect();
        Tape { nodes, results: results.iter().copied().map(NodeId).collect() }
    }

    #[test]
    fn a_rate_is_switched_by_what_the_state_decides() {
        let [x, t, p] = [NodeId(0), NodeId(1), NodeId(2)];
        let select = |lhs, rhs| Op::SelectLess { lhs, rhs, then: p, otherwise: p };
        let over = |argument| Op::Table { table: TableId(0), order: 0, argument };
        let ops = [
            Op::State(0),
            Op::Time,
            Op::Parameter(0),
            select(x, p),
            select(p, x),
            select(t, p),
            over(x),
            over(t),
            Op::Add(NodeId(3), p),
            Op::Mul(x, t),
        ];
        let expected = [false, false, false, true, true, false, true, false, true, false];
        assert_eq!(switched(&tape(&ops, &[9])), expected);
    }

    #[test]
    fn parts_are_what_reads_nothing_else() {
        // 0 and 1 read each other, 2 reads 1, 3 reads itself; all but 1 are linear.
        let reads = [vec![1], vec![0], vec![1, 2], vec![3]];
        assert_eq!(closed_part(&reads, &[0, 2, 3]), [3]);
        assert_eq!(closed_part(&reads, &[0, 1, 2]), [0, 1, 2]);
        assert_eq!(closed_part(&reads, &[0, 1, 3]), [0, 1, 3]);
        assert_eq!(subsystems(&reads), [vec![0, 1, 2], vec![3]]);
        assert_eq!(subsystems(&[vec![2], vec![], vec![]]), [vec![0, 2], vec![1]]);
    }

    #[test]
    fn operations_are_counted_by_how_often_they_change() {
        let ops = [
            Op::State(4),
            Op::Time,
            Op::Parameter(0),
            Op::Mul(NodeId(2), NodeId(2)),
            Op::Add(NodeId(1), NodeId(3)),
            Op::Mul(NodeId(0), NodeId(4)),
            Op::Neg(NodeId(5)),
            // An unused operation.
            Op::Neg(NodeId(0)),
        ];
        let tape = tape(&ops, &[3, 6, 4]);
        assert_eq!(Frequency::of(&tape), Frequency { once: 1, by_time: 1, by_state: 2 });
        assert_eq!(reads(&tape), [vec![], vec![4], vec![]]);
        let entries = vec![(0, 0), (0, 1), (1, 1)];
        let pattern = SparsityPattern { rows: 2, columns: 2, entries };
        assert_eq!(constants(&MatrixTape { pattern, tape, solve: None }), 1);
    }

    #[test]
    fn a_machine_is_linear_if_all_of_its_rows_are() {
        let structure = |linear_rows| Structure {
            coordinates: 1,
            constant_mass: true,
            diagonal_mass: true,
            constant_jacobian: (0, 0),
            linear_rows,
            linear_part: vec![],
            autonomous: true,
            subsystems: vec![vec![0, 2], vec![1]],
            rate: Frequency::default(),
            jacobian: Frequency::default(),
        };
        assert!(structure(vec![0, 1, 2]).is_linear());
        assert!(!structure(vec![0, 2]).is_linear());
    }
}
