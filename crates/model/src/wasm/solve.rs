//! Matrices that are solved for, with the substitution unrolled: zeros are left out of the steps.

use std::collections::HashMap;

use crate::Solve;
use crate::straight::{Region, Step, StepId, Straight};

/// Returns the program for the matrix. `inputs` gives the right-hand sides and given entries,
/// `factors` the results of the motion that are the factors. Returns `None` if the steps refer to
/// entries that do not exist.
pub(super) fn solved(inputs: &Straight, solve: &Solve, factors: &[u32]) -> Option<Straight> {
    let mut program = inputs.clone();
    let input: HashMap<usize, StepId> =
        program.writes.drain(..).map(|(entry, id)| (entry as usize, id)).collect();
    for (index, entry) in solve.given.iter().enumerate() {
        program.writes.push((*entry, *input.get(&index)?));
    }
    for column in 0..solve.columns {
        let mut x: HashMap<u32, StepId> = HashMap::new();
        for (index, (row, of)) in solve.right_sides.iter().enumerate() {
            if *of == column {
                x.insert(*row, *input.get(&(solve.given.len() + index))?);
            }
        }
        let factor = |program: &mut Straight, factor: u32| {
            let place = *factors.get(factor as usize)?;
            Some(program.push(Step::Read(Region::Motion, place)))
        };
        for step in &solve.steps {
            let mut sum = x.get(&step.row).copied();
            if let (Some(scale), Some(value)) = (step.scale, sum) {
                let scale = factor(&mut program, scale)?;
                sum = Some(program.push(Step::Mul(value, scale)));
            }
            for (by, from) in &step.terms {
                let Some(from) = x.get(from).copied() else { continue };
                let by = factor(&mut program, *by)?;
                let product = program.push(Step::Mul(by, from));
                sum = Some(match sum {
                    Some(sum) => program.push(Step::Sub(sum, product)),
                    None => program.push(Step::Neg(product)),
                });
            }
            if let Some(sum) = sum {
                x.insert(step.row, sum);
            }
        }
        for (entry, row, of) in &solve.solved {
            if *of == column {
                let zero = program.literal(0.0);
                program.writes.push((*entry, x.get(row).copied().unwrap_or(zero)));
            }
        }
    }
    Some(program.pruned())
}
