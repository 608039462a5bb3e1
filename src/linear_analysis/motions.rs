//! Small motions of all coordinates, including positions that the state leaves out.

use machinist_contract::{Simulator, StateKind};
use nalgebra::{DMatrix, DVector};

use super::sparse_rows::SparseRows;

/// Size relative to the largest below which a singular value or an entry is rounding.
const SMALLEST: f64 = 1e-13;

/// The equations dx' = A dx of x = \[q, q', z\], with all n coordinates, all velocities and all
/// first-order states except modes, derived from dy' = A_y dy of the state y.
///
/// The state contains positions s that are coordinates, differences of coordinates, or fewer than
/// there are coordinates: s' = S q', where S consists of rows of A_y. All dependence on q is
/// through s, so the derivative by q is that by s times S.
///
/// A quaternion s has one part more than the small rotations q about its axes. There S depends on s,
/// and small rotations turn with the rates omega: dq'/dt has the part -omega x q. Since
/// s' = s omega/2 and S q = s q/2, it is 2 S^+ A_ss S q, with A_ss the derivative of s' by s.
pub(super) struct Motions {
    /// Number of coordinates, n.
    pub coordinates: usize,
    /// Number of first-order states, m.
    pub first_order: usize,
    /// A, 2 n + m square.
    pub matrix: SparseRows,
    /// Scales of x.
    pub scales: DVector<f64>,
    /// S, with one row for each position.
    positions_by_coordinates: SparseRows,
    places: Places,
}

/// Indices of positions, velocities and first-order states in the state.
pub(super) struct Places {
    pub positions: Vec<usize>,
    pub velocities: Vec<usize>,
    pub first_order: Vec<usize>,
}

impl Places {
    pub fn of(simulator: &dyn Simulator<f64>) -> Self {
        let of_kind = |kind: StateKind| {
            let states = 0..simulator.shape().states();
            // Modes do not move; the motions are those within the present modes.
            let moves = |index: &usize| !simulator.is_mode(*index);
            states.filter(|i| simulator.state_kind(*i) == kind).filter(moves).collect()
        };
        Self {
            positions: of_kind(StateKind::Position),
            velocities: of_kind(StateKind::Velocity),
            first_order: of_kind(StateKind::FirstOrder),
        }
    }

    /// Returns the indices of \[q', z\].
    pub fn dynamic(&self) -> Vec<usize> {
        [&self.velocities[..], &self.first_order[..]].concat()
    }
}

impl Motions {
    pub fn new(simulator: &dyn Simulator<f64>, of_state: &SparseRows) -> Self {
        let places = Places::of(simulator);
        let dynamic = places.dynamic();
        let (n, m) = (places.velocities.len(), places.first_order.len());
        let [positions, velocities, dynamic_places] =
            [&places.positions, &places.velocities, &dynamic].map(|places| {
                let mut numbers = vec![None; of_state.columns()];
                places
                    .iter()
                    .enumerate()
                    .for_each(|(number, place)| numbers[*place] = Some(number));
                numbers
            });
        let mut by_coordinates = SparseRows::new(n);
        for place in &places.positions {
            let entries = of_state.row(*place).iter();
            by_coordinates.push(entries.filter_map(|(at, x)| Some((velocities[*at]?, *x))));
        }
        let mut matrix = SparseRows::new(2 * n + m);
        let turned = turned(of_state, &places.positions, &positions, &by_coordinates);
        for (index, own) in turned.into_iter().enumerate() {
            matrix.push_in_any_order(own.into_iter().chain([(n + index, 1.0)]).collect());
        }
        let mut by_q = Sums::new(n);
        for place in &dynamic {
            let entries = of_state.row(*place).iter();
            let of_positions = entries.clone().filter_map(|(at, x)| Some((positions[*at]?, *x)));
            let mut row = by_q.product(of_positions, &by_coordinates);
            row.extend(entries.filter_map(|(at, x)| Some((n + dynamic_places[*at]?, *x))));
            matrix.push_in_any_order(row);
        }
        let scales = scales(&super::scales(simulator), &places, &by_coordinates);
        let positions_by_coordinates = by_coordinates;
        Self { coordinates: n, first_order: m, matrix, scales, positions_by_coordinates, places }
    }

    /// Creates equations dx' = A dx that belong to no state, with scales of 1, for motions within
    /// constraints.
    pub fn alone(matrix: &DMatrix<f64>, coordinates: usize, first_order: usize) -> Self {
        let scales = DVector::from_element(matrix.nrows(), 1.0);
        let none = || Vec::new();
        let places = Places { positions: none(), velocities: none(), first_order: none() };
        let positions_by_coordinates = SparseRows::new(coordinates);
        let matrix = SparseRows::of(matrix);
        Self { coordinates, first_order, matrix, scales, positions_by_coordinates, places }
    }

    /// Subtracts S for positions and velocities, for motions seen from a frame that turns with the
    /// machine.
    pub fn seen_turning(mut self, turns: &DMatrix<f64>) -> Self {
        let n = self.coordinates;
        let mut matrix = self.matrix.full();
        for first in [0, n] {
            let mut part = matrix.view_mut((first, first), (n, n));
            part -= turns;
        }
        self.matrix = SparseRows::of(&matrix);
        self
    }

    /// Returns A with x measured by its scales.
    pub fn scaled(&self) -> SparseRows {
        let scales = &self.scales;
        self.matrix.clone().scaled(|row, column, entry| entry * scales[column] / scales[row])
    }

    /// Returns S, the derivative of the state's positions by coordinates.
    pub fn positions_by_coordinates(&self) -> &SparseRows {
        &self.positions_by_coordinates
    }

    /// Adds a change dx to a state.
    pub fn add(&self, state: &mut [f64], change: &DVector<f64>) {
        let n = self.coordinates;
        let of_positions = self.positions_by_coordinates.times(&change.rows(0, n).into_owned());
        for (place, change) in self.places.positions.iter().zip(&of_positions) {
            state[*place] += change;
        }
        for (place, change) in self.places.dynamic().iter().zip(&change.as_slice()[n..]) {
            state[*place] += change;
        }
    }
}

/// Returns the rows of 2 S^+ A_ss S, without zeros. Only rates of quaternions depend on positions.
fn turned(
    of_state: &SparseRows,
    places: &[usize],
    positions: &[Option<usize>],
    by_coordinates: &SparseRows,
) -> Vec<Vec<(usize, f64)>> {
    let n = by_coordinates.columns();
    let of_positions = |place: usize| {
        let entries = of_state.row(place).iter();
        entries.filter_map(|(at, x)| Some((positions[*at]?, *x))).filter(|(_, x)| *x != 0.0)
    };
    let numbers = 0..places.len();
    let rows: Vec<usize> =
        numbers.filter(|number| of_positions(places[*number]).next().is_some()).collect();
    let mut turned = vec![Vec::new(); n];
    if rows.is_empty() {
        return turned;
    }
    let mut of_velocities = DMatrix::zeros(places.len(), n);
    for number in 0..places.len() {
        for (column, entry) in by_coordinates.row(number) {
            of_velocities[(number, *column)] = *entry;
        }
    }
    let mut of_rates = DMatrix::zeros(rows.len(), places.len());
    for (row, number) in rows.iter().enumerate() {
        for (column, entry) in of_positions(places[*number]) {
            of_rates[(row, column)] = entry;
        }
    }
    let own = of_velocities.select_rows(&rows);
    let Ok(inverse) = own.pseudo_inverse(SMALLEST) else { return turned };
    let whole = inverse * of_rates * of_velocities * 2.0;
    let least = SMALLEST * whole.amax();
    for (row, entries) in turned.iter_mut().enumerate() {
        let entry = |column: usize| (column, whole[(row, column)]);
        entries.extend((0..n).map(entry).filter(|(_, entry)| entry.abs() > least));
    }
    turned
}

/// Sums of one row of a product of sparse matrices.
struct Sums {
    /// Sum of the terms and of their absolute values, for each column.
    sums: Vec<(f64, f64)>,
}

impl Sums {
    fn new(columns: usize) -> Self {
        Self { sums: vec![(0.0, 0.0); columns] }
    }

    /// Returns a row times B, as (column, entry) in any order. Sums that cancel except for rounding
    /// are zero, so that a rate that depends on differences does not depend on a common motion.
    fn product(
        &mut self,
        row: impl Iterator<Item = (usize, f64)>,
        matrix: &SparseRows,
    ) -> Vec<(usize, f64)> {
        const ROUNDING: f64 = 4.0 * f64::EPSILON;
        let mut touched = Vec::new();
        for (middle, share) in row {
            for (column, entry) in matrix.row(middle) {
                let (sum, terms) = &mut self.sums[*column];
                let term = share * entry;
                *sum += term;
                *terms += term.abs();
                touched.push(*column);
            }
        }
        // Sums are cleared as they are read, so a repeated column is zero the second time.
        let emptied =
            touched.into_iter().map(|column| (column, std::mem::take(&mut self.sums[column])));
        let left = emptied.filter(|(_, (sum, terms))| sum.abs() > ROUNDING * terms);
        left.map(|(column, (sum, _))| (column, sum)).collect()
    }
}

/// Returns the names of x.
pub(super) fn names(simulator: &dyn Simulator<f64>) -> Vec<String> {
    let places = Places::of(simulator);
    let coordinates = (0..places.velocities.len()).map(|index| simulator.coordinate(index));
    let dynamic = places.dynamic().into_iter().map(|place| simulator.state(place));
    coordinates.chain(dynamic).map(|quantity| quantity.name.to_owned()).collect()
}

/// Returns the scales of x. The scale of a coordinate is that of the smallest position that it
/// moves; if it moves none, that of its velocity times one second.
fn scales(
    of_state: &DVector<f64>,
    places: &Places,
    positions_by_coordinates: &SparseRows,
) -> DVector<f64> {
    let mut least = vec![f64::INFINITY; places.velocities.len()];
    for (place, entries) in places.positions.iter().zip(positions_by_coordinates.iter()) {
        for (coordinate, share) in entries {
            least[*coordinate] = least[*coordinate].min(of_state[*place] / share.abs());
        }
    }
    let velocities = &places.velocities;
    let of_coordinates = least
        .iter()
        .zip(velocities)
        .map(|(least, velocity)| if least.is_finite() { *least } else { of_state[*velocity] });
    let of_rest = places.dynamic().into_iter().map(|place| of_state[place]);
    DVector::from_vec(of_coordinates.chain(of_rest).collect())
}
