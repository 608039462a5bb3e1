//! Singular directions of a quadratic form, for all values of its other symbols.
//!
//! The test is exact, in the field of [`super::identity`]: a form found singular is singular at all
//! states and parameters, any other form is regular except at isolated ones.

mod quadratic;

use std::collections::{BTreeMap, BTreeSet};

use num_rational::BigRational;

use super::identity::{P, Point, fraction, inverse, times};
use super::{CoordinateId, Expr, Matrix, Symbol};
use quadratic::{Form, Forms};

/// Largest number of coordinates that is examined, because elimination fills in.
const MOST_COORDINATES: usize = 2000;

/// Returns the coordinates of a motion without kinetic energy. Returns `None` if there is no such
/// motion, or if the energy is not quadratic in the velocities.
#[must_use]
pub fn motion_without_energy(kinetic: &Expr, coordinates: usize) -> Option<Vec<CoordinateId>> {
    let vector =
        null_vectors(mass_matrix(kinetic, coordinates, &POINTS[0])?)?.into_iter().next()?;
    Some(vector.into_keys().map(CoordinateId).collect())
}

/// A motion of coordinates: each that moves, and its rate.
pub type Motion = Vec<(CoordinateId, BigRational)>;

/// Returns independent motions without kinetic energy whose rates have constant ratios. Together
/// they contain all motions without energy, except those whose ratios depend on parameters or
/// state. Returns `None` if the energy is not quadratic in the velocities.
#[must_use]
pub fn motions_without_energy(kinetic: &Expr, coordinates: usize) -> Option<Vec<Motion>> {
    let at = |point| null_vectors(mass_matrix(kinetic, coordinates, point)?);
    let mut motions = at(&POINTS[0])?;
    if motions.is_empty() {
        return Some(Vec::new());
    }
    let others = at(&POINTS[1])?;
    motions.retain(|motion| others.contains(motion));
    let rate = |(column, rate): (u32, u64)| {
        let (above, below) = fraction(rate)?;
        Some((CoordinateId(column), BigRational::new(above.into(), below.into())))
    };
    Some(motions.into_iter().filter_map(|one| one.into_iter().map(rate).collect()).collect())
}

/// Returns the second derivatives of a kinetic energy by the velocities, at a point.
fn mass_matrix(kinetic: &Expr, coordinates: usize, point: &Point) -> Option<Vec<Row>> {
    if coordinates > MOST_COORDINATES {
        return None;
    }
    let mut matrix = vec![BTreeMap::new(); coordinates];
    let forms = Forms::new(point, kinetic);
    for term in flat(kinetic) {
        match forms.of(term) {
            Some(Form::Constant(_)) => {}
            Some(Form::Moving(form)) => {
                for ((i, j), value) in form.square {
                    put(&mut matrix, i, j, value);
                    put(&mut matrix, j, i, value);
                }
            }
            // Term by term, as an unusual way to write a quadratic form needs.
            None => add(&mut matrix, term, point)?,
        }
    }
    Some(matrix)
}

/// Returns the nonzero columns of a null vector of a square matrix, for all values of its symbols.
/// Returns `None` if there is no such vector, or if an entry has no value.
#[must_use]
pub fn null_columns(matrix: &Matrix) -> Option<Vec<usize>> {
    if matrix.len() > MOST_COORDINATES {
        return None;
    }
    let row = |entries: &[(usize, Expr)]| -> Option<Row> {
        let mut row = Row::new();
        for (column, entry) in entries {
            let value = POINTS[0].value(entry)?.p;
            if value != 0 {
                row.insert(*column as u32, value);
            }
        }
        Some(row)
    };
    let vectors = null_vectors(matrix.rows().map(row).collect::<Option<_>>()?)?;
    let vector = vectors.into_iter().next()?;
    Some(vector.into_keys().map(|column| column as usize).collect())
}

/// Points at which entries are evaluated.
const POINTS: [Point; 2] = [Point { point: 7 }, Point { point: 8 }];

/// Returns the terms of a sum, including those of nested sums.
fn flat(expr: &Expr) -> Vec<&Expr> {
    match expr {
        Expr::Sum(terms) => terms.iter().flat_map(flat).collect(),
        expr => vec![expr],
    }
}

type Row = BTreeMap<u32, u64>;

/// Adds the second derivatives of a term; returns `None` if it is not quadratic.
fn add(matrix: &mut [Row], term: &Expr, point: &Point) -> Option<()> {
    let velocities: BTreeSet<u32> = term
        .symbols()
        .into_iter()
        .filter_map(|symbol| match symbol {
            Symbol::Velocity(id) => Some(id.0),
            _ => None,
        })
        .collect();
    let at = |moving: &[(u32, i64)]| {
        let moved = term.replace(&|symbol| match symbol {
            Symbol::Velocity(id) => {
                let own = moving.iter().find(|(other, _)| *other == id.0);
                Some(Expr::integer(own.map_or(0, |(_, speed)| *speed)))
            }
            _ => None,
        });
        Some(point.value(&moved)?.p)
    };
    let minus = |a: u64, b: u64| (a + P - b) % P;
    let rest = at(&[])?;
    for i in &velocities {
        let one = minus(at(&[(*i, 1)])?, rest);
        let back = minus(at(&[(*i, -1)])?, rest);
        let own = (one + back) % P;
        let twice = minus(at(&[(*i, 2)])?, rest);
        // T(2 v) - 2 T(v) = T''
        if minus(twice, times(2, one, P)) != own {
            return None;
        }
        put(matrix, *i, *i, own);
        for j in velocities.iter().filter(|j| *j > i) {
            let other = minus(at(&[(*j, 1)])?, rest);
            let both = minus(at(&[(*i, 1), (*j, 1)])?, rest);
            let mixed = minus(minus(both, one), other);
            put(matrix, *i, *j, mixed);
            put(matrix, *j, *i, mixed);
        }
    }
    Some(())
}

fn put(matrix: &mut [Row], row: u32, column: u32, value: u64) {
    let entry = matrix[row as usize].entry(column).or_default();
    *entry = (*entry + value) % P;
    if *entry == 0 {
        matrix[row as usize].remove(&column);
    }
}

/// Returns a basis of the null vectors, by Gaussian elimination on sparse rows. Each vector is 1 in
/// a column of its own.
fn null_vectors(matrix: Vec<Row>) -> Option<Vec<Row>> {
    let columns = matrix.len() as u32;
    // The leading entry of each is 1; only the columns after it are stored.
    let mut leads: BTreeMap<u32, Row> = BTreeMap::new();
    for mut row in matrix {
        while let Some((lead, first)) = row.pop_first() {
            let Some(known) = leads.get(&lead) else {
                let over = inverse(first, P)?;
                let scaled = row.into_iter().map(|(column, entry)| (column, times(entry, over, P)));
                leads.insert(lead, scaled.collect());
                break;
            };
            for (column, entry) in known {
                let own = row.entry(*column).or_default();
                *own = (*own + P - times(first, *entry, P)) % P;
                if *own == 0 {
                    row.remove(column);
                }
            }
        }
    }
    let free = (0..columns).filter(|column| !leads.contains_key(column));
    let vector = |free| {
        let mut vector = Row::from([(free, 1)]);
        for (lead, row) in leads.range(..free).rev() {
            let sum = row.iter().fold(0, |sum, (column, entry)| {
                let known = vector.get(column).copied().unwrap_or(0);
                (sum + times(*entry, known, P)) % P
            });
            if sum != 0 {
                vector.insert(*lead, P - sum);
            }
        }
        vector
    };
    Some(free.map(vector).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expr::{Function, ParameterId};

    fn v(index: u32) -> Expr {
        Expr::Symbol(Symbol::Velocity(CoordinateId(index)))
    }
    fn energy(mass: u32, speed: Expr) -> Expr {
        let square = Expr::Power(Box::new(speed), Box::new(Expr::integer(2)));
        Expr::Product(vec![Expr::Symbol(Symbol::Parameter(ParameterId(mass))), square])
    }
    fn difference(a: u32, b: u32) -> Expr {
        Expr::Sum(vec![v(a), Expr::Product(vec![Expr::integer(-1), v(b)])])
    }

    #[test]
    fn coefficients_of_a_form_are_its_second_differences() {
        let id = |index| Expr::Symbol(Symbol::Coordinate(CoordinateId(index)));
        let cos = |index| Expr::Call(Function::Cos, vec![id(index)]);
        let speed = (0..3).map(|index| Expr::Product(vec![cos(index), v(index)])).collect();
        let kinetic = Expr::Sum(vec![
            energy(0, Expr::Sum(speed)),
            energy(1, difference(0, 2)),
            Expr::Product(vec![v(1), Expr::Sum(vec![v(2), cos(1)]), cos(0)]),
            Expr::Product(vec![cos(2), Expr::Power(Box::new(cos(1)), Box::new(Expr::integer(-2)))]),
        ]);
        for point in &POINTS {
            let mut differences = vec![Row::new(); 3];
            for term in flat(&kinetic) {
                add(&mut differences, term, point).expect("quadratic");
            }
            assert_eq!(mass_matrix(&kinetic, 3, point), Some(differences));
        }
        // Quadratic, but not as a product of linear forms.
        let ratio = Expr::Power(Box::new(v(0)), Box::new(Expr::integer(-1)));
        let cube = Expr::Power(Box::new(v(0)), Box::new(Expr::integer(3)));
        assert_eq!(mass_matrix(&Expr::Product(vec![cube.clone(), ratio]), 1, &POINTS[0]), None);
        assert_eq!(mass_matrix(&cube, 1, &POINTS[0]), None);
    }

    #[test]
    fn a_capacitor_between_two_nodes_leaves_them_free_together() {
        let floating = energy(0, difference(0, 1));
        assert_eq!(
            motion_without_energy(&floating, 2),
            Some(vec![CoordinateId(0), CoordinateId(1)])
        );
        let grounded = Expr::Sum(vec![floating, energy(1, v(1))]);
        assert_eq!(motion_without_energy(&grounded, 2), None);
        assert_eq!(motion_without_energy(&grounded, 3), Some(vec![CoordinateId(2)]));
    }

    #[test]
    fn motions_without_energy_are_found_each_with_its_rates() {
        let ratio = BigRational::new((-5).into(), 2.into());
        let scaled = |number: &BigRational, x| Expr::Product(vec![Expr::Number(number.clone()), x]);
        let turning = Expr::Sum(vec![v(0), scaled(&ratio, v(2))]);
        let kinetic = Expr::Sum(vec![energy(0, turning), energy(1, difference(3, 4))]);
        let one = || BigRational::from_integer(1.into());
        let expected = vec![
            vec![(CoordinateId(1), one())],
            vec![(CoordinateId(0), -ratio), (CoordinateId(2), one())],
            vec![(CoordinateId(3), one()), (CoordinateId(4), one())],
        ];
        assert_eq!(motions_without_energy(&kinetic, 5), Some(expected));
        let parameter = Expr::Symbol(Symbol::Parameter(ParameterId(7)));
        let geared = Expr::Sum(vec![v(0), Expr::Product(vec![parameter, v(1)])]);
        assert_eq!(motions_without_energy(&energy(0, geared), 2), Some(vec![]));
        assert_eq!(motions_without_energy(&energy(0, v(0)), 1), Some(vec![]));
    }

    #[test]
    fn what_is_not_quadratic_is_not_judged() {
        let quartic = Expr::Power(Box::new(v(0)), Box::new(Expr::integer(4)));
        assert_eq!(motion_without_energy(&quartic, 2), None);
    }
}
