//! Factorization of the mass matrix as a sequence of single operations.

use crate::series::MassMatrix;
use crate::straight::{Step, StepId, Straight};

/// Maximum number of operations of a factorization.
const MOST: usize = 40_000;

/// L D L^T: L below the diagonal, 1/D on it, by rows; `None` for zeros.
pub struct Factors(Vec<Vec<Option<StepId>>>);

impl Factors {
    /// Factors the matrix of zeroth coefficients. Returns `None` if that takes too many operations.
    pub fn new(program: &mut Straight, mass: &MassMatrix, values: &[StepId]) -> Option<Self> {
        let n = mass.right_side.len();
        let mut matrix = vec![vec![None; n]; n];
        for &(row, column, entry) in &mass.lower {
            matrix[row as usize][column as usize] = Some(values[entry.0 as usize]);
        }
        let (zero, one) = (program.literal(0.0), program.literal(1.0));
        let begin = program.steps.len();
        for column in 0..n {
            let diagonal = matrix[column][column].unwrap_or(zero);
            let inverse = program.push(Step::Div(one, diagonal));
            for row in column + 1..n {
                let Some(entry) = matrix[row][column] else { continue };
                let scaled = program.push(Step::Mul(entry, inverse));
                let below =
                    (column + 1..=row).filter_map(|other| Some((other, matrix[other][column]?)));
                for (other, factor) in below.collect::<Vec<_>>() {
                    let product = program.push(Step::Mul(scaled, factor));
                    let before = matrix[row][other].unwrap_or(zero);
                    matrix[row][other] = Some(program.push(Step::Sub(before, product)));
                }
            }
            for row in &mut matrix[column + 1..] {
                row[column] = row[column].map(|entry| program.push(Step::Mul(entry, inverse)));
            }
            matrix[column][column] = Some(inverse);
            if program.steps.len() - begin > MOST {
                return None;
            }
        }
        Some(Self(matrix))
    }

    /// Solves for `solution`; `read` loads entries of the factors.
    pub fn solve(
        &self,
        program: &mut Straight,
        mut solution: Vec<StepId>,
        mut read: impl FnMut(&mut Straight, StepId) -> StepId,
    ) -> Vec<StepId> {
        let n = solution.len();
        for row in 0..n {
            for column in 0..row {
                if let Some(factor) = self.0[row][column] {
                    let factor = read(program, factor);
                    let product = program.push(Step::Mul(factor, solution[column]));
                    solution[row] = program.push(Step::Sub(solution[row], product));
                }
            }
        }
        for row in (0..n).rev() {
            let Some(inverse) = self.0[row][row] else { continue };
            let inverse = read(program, inverse);
            solution[row] = program.push(Step::Mul(solution[row], inverse));
            for below in row + 1..n {
                if let Some(factor) = self.0[below][row] {
                    let factor = read(program, factor);
                    let product = program.push(Step::Mul(factor, solution[below]));
                    solution[row] = program.push(Step::Sub(solution[row], product));
                }
            }
        }
        solution
    }
}
