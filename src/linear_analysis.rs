//! Linear analysis of any scene: where it runs steadily, how it vibrates there,
//! and how it answers to harmonic disturbances.
//!
//! At a [`Point`] (t, y, p), small deviations follow
//!
//! ```text
//! dy' = A dy + b dp          A = dy'/dy, b = dy'/dp, as emitted
//! do  = C dy + d dp          C = do/dy, d = do/dp of the scene's outputs o
//! ```
//!
//! [`operating_point`] finds such a point, [`Linearization`] holds A and answers
//! with [`Linearization::modes`], [`Linearization::second_order`] and
//! [`Linearization::response`]. Modes and matrices M, D, K are those of all
//! generalized coordinates \[q, q', z\], of the positions left out of y too, see
//! [`Linearization::motion_names`]. Time is held still: a force that depends on t
//! counts with its value at the point's time.
//!
//! All is dense algebra, for scenes of up to [`MAX_STATES`] states, but modes and equilibria of
//! machines whose coordinates each meet but a few others, such as chains: these are for scenes of
//! up to [`MAX_STATES_OF_CHAINS`].

mod banded;
mod bends;
mod campbell;
pub mod differences;
mod equilibrium;
mod error;
mod inverse_iteration;
mod largest;
mod modes;
mod motions;
mod operating_point;
mod response;
mod rest;
mod search;
mod slopes;
mod sparse_rows;
mod steady;
mod turning;
mod undamped;
mod within;

use std::sync::OnceLock;

use machinist_contract::{Quantity, Simulator};
use motions::Motions;
use nalgebra::{DMatrix, DVector};
use sparse_rows::SparseRows;
use within::Within;

pub use campbell::{
    Branch, Campbell, Critical, Growing, Variation, campbell, campbell_over_speeds,
};
pub use equilibrium::equilibrium;
pub use error::{LinearError, Residual};
pub use largest::Largest;
pub use modes::{Mode, ModeKind};
pub use operating_point::{Place, operating_point};
pub use response::{Response, logarithmic_range};
pub use slopes::{ModeSlope, NoSlope, PointSlopes};
pub(crate) use steady::{growth, steady_start, steady_tangents};

/// Largest number of states of dense matrices; beyond, they take too much time.
pub const MAX_STATES: usize = 2000;

/// Largest number of states; beyond, shapes of all modes, as many numbers as the square of them,
/// take too much memory.
pub const MAX_STATES_OF_CHAINS: usize = 10_000;

/// Time \[s\], state y and parameters at which a scene is looked at.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Time \[s\].
    pub time: f64,
    /// State, `states` long.
    pub state: Vec<f64>,
    /// Parameters.
    pub parameters: Vec<f64>,
}

/// dy' = A dy about one point.
#[derive(Clone)]
pub struct Linearization<'a> {
    simulator: &'a dyn Simulator<f64>,
    point: Point,
    matrix: SparseRows,
    /// The same with its zeros, once somebody asks.
    full: OnceLock<DMatrix<f64>>,
}

/// The mechanical part, M dq'' + D dq' + K dq = df, in the units of the scene's
/// coordinates. It leaves out what first-order states feed back.
///
/// Of a machine with constraints, of the motions dq = E dr that these allow, with columns of
/// E of length 1 as the scales of q' measure: E^T M E, E^T D E, E^T K E. K holds the geometric
/// stiffness of the constraints' forces.
#[derive(Debug, Clone, PartialEq)]
pub struct SecondOrder {
    /// M, as emitted.
    pub mass: DMatrix<f64>,
    /// D = -M dq''/dq'.
    pub damping: DMatrix<f64>,
    /// K = -M dq''/dq.
    pub stiffness: DMatrix<f64>,
}

impl<'a> Linearization<'a> {
    /// Linearizes a scene about a point, by its emitted Jacobian.
    ///
    /// # Errors
    /// [`LinearError`] if the scene has more than [`MAX_STATES_OF_CHAINS`] states, if the
    /// point has other lengths than the scene, or if something is not finite.
    pub fn at(simulator: &'a dyn Simulator<f64>, point: Point) -> Result<Self, LinearError> {
        let matrix = jacobian(simulator, &point)?;
        Ok(Self { simulator, point, matrix, full: OnceLock::new() })
    }

    /// Where it was linearized.
    #[must_use]
    pub fn point(&self) -> &Point {
        &self.point
    }

    /// A = dy'/dy, `states` by `states`.
    ///
    /// # Errors
    /// [`LinearError::TooLarge`] of more than [`MAX_STATES`] states.
    pub fn matrix(&self) -> Result<&DMatrix<f64>, LinearError> {
        require_small(self.simulator)?;
        Ok(self.full.get_or_init(|| self.matrix.full()))
    }

    /// The simulator.
    #[must_use]
    pub fn simulator(&self) -> &'a dyn Simulator<f64> {
        self.simulator
    }

    /// M, D and K. Exact as derivatives of f where accelerations are zero;
    /// elsewhere K holds the change of M times acceleration too.
    ///
    /// # Errors
    /// [`LinearError::TooLarge`] of more than [`MAX_STATES`] states.
    pub fn second_order(&self) -> Result<SecondOrder, LinearError> {
        let motions = Motions::new(self.simulator, &self.matrix);
        let (n, mass) = (motions.coordinates, self.mass_matrix());
        let matrix = full(self.simulator, &motions.matrix)?;
        let block = |column: usize| -&mass * matrix.view((n, column), (n, n));
        let whole = SecondOrder { damping: block(n), stiffness: block(0), mass: mass.clone() };
        let Some(within) = Within::of(self.simulator, &self.point, &motions) else {
            return Ok(whole);
        };
        let mut allowed = within.velocities;
        for (mut row, scale) in allowed.row_iter_mut().zip(&motions.scales.as_slice()[n..]) {
            row *= *scale;
        }
        let projected = |matrix: DMatrix<f64>| allowed.transpose() * matrix * &allowed;
        Ok(SecondOrder {
            mass: projected(whole.mass),
            damping: projected(whole.damping),
            stiffness: projected(whole.stiffness),
        })
    }

    /// Names of \[q, q', z\]: what shapes of modes are made of. All generalized
    /// coordinates are among them, whether or not the state holds their positions.
    #[must_use]
    pub fn motion_names(&self) -> Vec<String> {
        motions::names(self.simulator)
    }

    /// M at the point.
    fn mass_matrix(&self) -> DMatrix<f64> {
        let pattern = self.simulator.mass_matrix_pattern();
        let mut values = vec![0.0; pattern.entries.len()];
        let Point { time, state, parameters } = &self.point;
        self.simulator.mass_matrix(*time, state, parameters, &mut values);
        crate::dense::dense(pattern, &values)
    }
}

/// y' at a point.
fn rate(simulator: &dyn Simulator<f64>, point: &Point) -> DVector<f64> {
    let mut rate = DVector::zeros(point.state.len());
    simulator.rate(point.time, &point.state, &point.parameters, rate.as_mut_slice());
    rate
}

/// The emitted dy'/dy at a point, once the point is found to fit the scene.
fn jacobian(simulator: &dyn Simulator<f64>, point: &Point) -> Result<SparseRows, LinearError> {
    check_point(simulator, point)?;
    let pattern = simulator.rate_jacobian_pattern();
    let mut values = vec![0.0; pattern.entries.len()];
    simulator.rate_jacobian(point.time, &point.state, &point.parameters, &mut values);
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(SparseRows::of_pattern(pattern, &values)),
        Some(index) => {
            let name = |state: u32| simulator.state(state as usize).name.to_owned();
            let (row, column) = pattern.entries[index];
            let what =
                format!("the derivative of the rate of `{}` by `{}`", name(row), name(column));
            Err(LinearError::NotFinite { what, value: values[index] })
        }
    }
}

/// A matrix with its zeros, if that is not too large.
fn full(simulator: &dyn Simulator<f64>, rows: &SparseRows) -> Result<DMatrix<f64>, LinearError> {
    require_small(simulator)?;
    Ok(rows.full())
}

fn require_small(simulator: &dyn Simulator<f64>) -> Result<(), LinearError> {
    let is_small = simulator.shape().states() <= MAX_STATES;
    if is_small { Ok(()) } else { Err(too_large(simulator, MAX_STATES)) }
}

fn too_large(simulator: &dyn Simulator<f64>, most: usize) -> LinearError {
    let (scene, states) = (simulator.name().to_owned(), simulator.shape().states());
    LinearError::TooLarge { scene, states, most }
}

fn check_point(simulator: &dyn Simulator<f64>, point: &Point) -> Result<(), LinearError> {
    let shape = simulator.shape();
    let states = shape.states();
    if states > MAX_STATES_OF_CHAINS {
        return Err(too_large(simulator, MAX_STATES_OF_CHAINS));
    }
    let lengths = [
        ("states", states, point.state.len()),
        ("parameters", shape.parameters, point.parameters.len()),
    ];
    for (what, expected, found) in lengths {
        if expected != found {
            let scene = simulator.name().to_owned();
            return Err(LinearError::WrongLength { scene, what, expected, found });
        }
    }
    Ok(())
}

/// Typical sizes of all states; 1 for a scale that is no positive number.
fn scales(simulator: &dyn Simulator<f64>) -> DVector<f64> {
    let scale = |index: usize| {
        let scale = simulator.state_scale(index);
        if scale.is_finite() && scale > 0.0 { scale } else { 1.0 }
    };
    DVector::from_fn(simulator.shape().states(), |index, _| scale(index))
}

/// Position of a name among `count` quantities.
fn position<'q>(
    name: &str,
    count: usize,
    quantity: impl Fn(usize) -> Quantity<'q>,
) -> Option<usize> {
    (0..count).find(|index| quantity(*index).name == name)
}
