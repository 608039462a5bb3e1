//! Small motions of all coordinates, of the positions left out of the state too.

use machinist_contract::{Simulator, StateKind};
use nalgebra::{DMatrix, DVector};

/// dx' = A dx of x = \[q, q', z\], all n coordinates, all velocities and all
/// first-order states but modes, from dy' = A_y dy of the state y.
///
/// The state holds positions s that are coordinates, differences of some, or fewer
/// than there are: s' = S q', where S are rows of A_y. What depends on q does so
/// through s alone, so that its derivative by q is that by s times S.
pub(super) struct Motions {
    /// n.
    pub coordinates: usize,
    /// m.
    pub first_order: usize,
    /// A, 2 n + m square.
    pub matrix: DMatrix<f64>,
    /// Typical sizes of x.
    pub scales: DVector<f64>,
    /// S, as many rows as there are positions.
    positions_by_coordinates: DMatrix<f64>,
    places: Places,
}

/// Where the state holds what.
pub(super) struct Places {
    pub positions: Vec<usize>,
    pub velocities: Vec<usize>,
    pub first_order: Vec<usize>,
}

impl Places {
    pub fn of(simulator: &dyn Simulator<f64>) -> Self {
        let of_kind = |kind: StateKind| {
            let states = 0..simulator.shape().states();
            // Modes do not move; the motions are those within the modes as they are.
            let moves = |index: &usize| !simulator.is_mode(*index);
            states.filter(|i| simulator.state_kind(*i) == kind).filter(moves).collect()
        };
        Self {
            positions: of_kind(StateKind::Position),
            velocities: of_kind(StateKind::Velocity),
            first_order: of_kind(StateKind::FirstOrder),
        }
    }

    /// Places of \[q', z\].
    pub fn dynamic(&self) -> Vec<usize> {
        [&self.velocities[..], &self.first_order[..]].concat()
    }
}

impl Motions {
    pub fn new(simulator: &dyn Simulator<f64>, of_state: &DMatrix<f64>) -> Self {
        let places = Places::of(simulator);
        let dynamic = places.dynamic();
        let (n, m) = (places.velocities.len(), places.first_order.len());
        let rates = of_state.select_rows(&dynamic);
        let by_coordinates =
            of_state.select_rows(&places.positions).select_columns(&places.velocities);
        let mut matrix = DMatrix::zeros(2 * n + m, 2 * n + m);
        matrix.view_mut((0, n), (n, n)).fill_with_identity();
        let by_q = product(&rates.select_columns(&places.positions), &by_coordinates);
        matrix.view_mut((n, 0), (n + m, n)).copy_from(&by_q);
        matrix.view_mut((n, n), (n + m, n + m)).copy_from(&rates.select_columns(&dynamic));
        let scales = scales(&super::scales(simulator), &places, &by_coordinates);
        let positions_by_coordinates = by_coordinates;
        Self { coordinates: n, first_order: m, matrix, scales, positions_by_coordinates, places }
    }

    /// dx' = A dx that belongs to no state, of scales 1: of motions within constraints.
    pub fn alone(matrix: DMatrix<f64>, coordinates: usize, first_order: usize) -> Self {
        let scales = DVector::from_element(matrix.nrows(), 1.0);
        let none = || Vec::new();
        let places = Places { positions: none(), velocities: none(), first_order: none() };
        let positions_by_coordinates = DMatrix::zeros(0, coordinates);
        Self { coordinates, first_order, matrix, scales, positions_by_coordinates, places }
    }

    /// A with x measured by its scales.
    pub fn scaled(&self) -> DMatrix<f64> {
        let size = self.scales.len();
        DMatrix::from_fn(size, size, |row, column| {
            self.matrix[(row, column)] * self.scales[column] / self.scales[row]
        })
    }

    /// S: positions of the state by coordinates.
    pub fn positions_by_coordinates(&self) -> &DMatrix<f64> {
        &self.positions_by_coordinates
    }

    /// Adds a change dx to a state.
    pub fn add(&self, state: &mut [f64], change: &DVector<f64>) {
        let n = self.coordinates;
        let of_positions = &self.positions_by_coordinates * change.rows(0, n);
        for (place, change) in self.places.positions.iter().zip(&of_positions) {
            state[*place] += change;
        }
        for (place, change) in self.places.dynamic().iter().zip(&change.as_slice()[n..]) {
            state[*place] += change;
        }
    }
}

/// A B of matrices that are mostly zeros. What cancels but for rounding is nothing: a rate that
/// depends on differences does not depend on what these are taken to.
fn product(a: &DMatrix<f64>, b: &DMatrix<f64>) -> DMatrix<f64> {
    const ROUNDING: f64 = 4.0 * f64::EPSILON;
    let nonzeros = |column: &[f64]| -> Vec<(usize, f64)> {
        let entries = column.iter().copied().enumerate();
        entries.filter(|(_, entry)| *entry != 0.0).collect()
    };
    let columns: Vec<_> = a.column_iter().map(|column| nonzeros(column.as_slice())).collect();
    let mut product = DMatrix::<f64>::zeros(a.nrows(), b.ncols());
    let mut terms = vec![0.0; a.nrows()];
    for (mut into, column) in product.column_iter_mut().zip(b.column_iter()) {
        let shares = nonzeros(column.as_slice());
        let entries = || {
            shares
                .iter()
                .flat_map(|(at, share)| columns[*at].iter().map(move |(row, x)| (*row, x * share)))
        };
        for (row, term) in entries() {
            into[row] += term;
            terms[row] += term.abs();
        }
        for (row, _) in entries() {
            if into[row].abs() <= ROUNDING * terms[row] {
                into[row] = 0.0;
            }
        }
        entries().for_each(|(row, _)| terms[row] = 0.0);
    }
    product
}

/// Names of x.
pub(super) fn names(simulator: &dyn Simulator<f64>) -> Vec<String> {
    let places = Places::of(simulator);
    let coordinates = (0..places.velocities.len()).map(|index| simulator.coordinate(index));
    let dynamic = places.dynamic().into_iter().map(|place| simulator.state(place));
    coordinates.chain(dynamic).map(|quantity| quantity.name.to_owned()).collect()
}

/// Typical sizes of x. A coordinate is measured by the least position that it
/// moves; one that moves none, by what its velocity covers in a second.
fn scales(
    of_state: &DVector<f64>,
    places: &Places,
    positions_by_coordinates: &DMatrix<f64>,
) -> DVector<f64> {
    let coordinate = |index: usize| {
        let column = positions_by_coordinates.column(index);
        let sizes = places.positions.iter().zip(column.iter());
        let moved = sizes.filter(|(_, share)| **share != 0.0);
        let least = moved.map(|(place, share)| of_state[*place] / share.abs());
        let least = least.fold(f64::INFINITY, f64::min);
        if least.is_finite() { least } else { of_state[places.velocities[index]] }
    };
    let n = places.velocities.len();
    let dynamic = places.dynamic();
    DVector::from_fn(n + dynamic.len(), |index, _| {
        if index < n { coordinate(index) } else { of_state[dynamic[index - n]] }
    })
}
