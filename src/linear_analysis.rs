//! Linear analysis of scenes: operating points, eigenmodes and frequency responses.
//!
//! At a [`Point`] (t, y, p), small deviations follow
//!
//! ```text
//! dy' = A dy + b dp          A = dy'/dy, b = dy'/dp, as emitted
//! do  = C dy + d dp          C = do/dy, d = do/dp of the scene's outputs o
//! ```
//!
//! [`operating_point`] finds such a point. [`Linearization`] holds A and provides
//! [`Linearization::modes`], [`Linearization::second_order`], [`Linearization::response`] and
//! [`Linearization::state_space`].
//! Eigenmodes and the matrices M, D, K refer to all generalized coordinates \[q, q', z\], including
//! positions that y leaves out; see [`Linearization::motion_names`]. Time is held: a force that
//! depends on t has its value at the point's time.
//!
//! The algebra is dense, for scenes of up to [`MAX_STATES`] states. Eigenmodes and equilibria of
//! machines whose coordinates are each coupled to few others, such as chains, are possible for up
//! to [`MAX_STATES_OF_CHAINS`] states.

mod along;
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
mod output_slopes;
mod regulator;
mod response;
mod rest;
mod search;
mod slopes;
mod sparse_rows;
mod state_space;
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

pub use along::{Piece, models_along};
pub use campbell::{
    Branch, Campbell, Critical, Growing, Variation, campbell, campbell_over_speeds,
};
pub use equilibrium::equilibrium;
pub use error::{LinearError, Residual};
pub use largest::Largest;
pub use modes::{Mode, ModeKind};
pub use operating_point::{Place, operating_point};
pub use regulator::{Estimator, Regulator, RegulatorError, Weight};
pub use response::{FORCE_ON, Response, logarithmic_range};
pub use slopes::{ModeSlope, NoSlope, PointSlopes};
pub use state_space::{Hidden, Hold, Rows, Sampling, Signal, StateSpace};
pub(crate) use steady::{growth, steady_start, steady_tangents};

/// Maximum number of states for dense matrices; beyond, they take too much time.
pub const MAX_STATES: usize = 2000;

/// Maximum number of states; beyond, the shapes of all eigenmodes take too much memory.
pub const MAX_STATES_OF_CHAINS: usize = 10_000;

/// Time \[s\], state y and parameters of an analysis.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// Time \[s\].
    pub time: f64,
    /// State, of length `states`.
    pub state: Vec<f64>,
    /// Parameters.
    pub parameters: Vec<f64>,
}

/// The linear equations dy' = A dy about a point.
///
/// A rotor with J = 2 kg m^2 on a spring with c = 50 N m/rad and a damper with d = 0.8 N m s/rad has
/// the natural frequency sqrt(c/J) and the damping ratio d/(2 sqrt(c J)):
///
/// ```
/// use machinist::linear_analysis::{Linearization, Place, operating_point};
/// use machinist::{Method, Simulation};
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/oscillator.rs"));
/// # fn main() -> Result<(), machinist::linear_analysis::LinearError> {
///
/// let run = Simulation::new(&Oscillator).method(Method::Dop853);
/// let linear = Linearization::at(&Oscillator, operating_point(&run, Place::Equilibrium)?)?;
/// let modes = linear.modes()?;
/// assert!((modes[0].natural_frequency() - 5.0).abs() < 1e-12);
/// assert!((modes[0].damping_ratio() - 0.04).abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
///
/// At resonance, its angle follows a torque with the amplitude 1/(d w) and a lag of a quarter:
///
/// ```
/// use machinist::Simulation;
/// use machinist::linear_analysis::{Linearization, Place, operating_point};
/// # include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/oscillator.rs"));
/// # fn main() -> Result<(), machinist::linear_analysis::LinearError> {
///
/// let point = operating_point(&Simulation::new(&Oscillator), Place::Initial)?;
/// let linear = Linearization::at(&Oscillator, point)?;
/// let response = linear.response("rotor.angle", "rotor.angle", &[5.0])?;
/// assert!((response.amplitudes[0] - 1.0 / (0.8 * 5.0)).abs() < 1e-12);
/// assert!((response.phases[0] + std::f64::consts::FRAC_PI_2).abs() < 1e-12);
/// # Ok(())
/// # }
/// ```
#[derive(Clone)]
pub struct Linearization<'a> {
    simulator: &'a dyn Simulator<f64>,
    point: Point,
    matrix: SparseRows,
    /// A as a dense matrix, made on demand.
    full: OnceLock<DMatrix<f64>>,
}

/// The mechanical part, M dq'' + D dq' + K dq = df, in the units of the scene's coordinates. It
/// neglects the feedback of first-order states.
///
/// For a machine with constraints, the matrices are those of the allowed motions dq = E dr, with
/// columns of E of length 1 relative to the scales of q': E^T M E, E^T D E, E^T K E. K contains the
/// geometric stiffness of the constraint forces.
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
    /// Linearizes a scene about a point by its emitted Jacobian.
    ///
    /// # Errors
    /// [`LinearError`] if the scene has more than [`MAX_STATES_OF_CHAINS`] states, if lengths in
    /// the point differ from those of the scene, or if a value is not finite.
    pub fn at(simulator: &'a dyn Simulator<f64>, point: Point) -> Result<Self, LinearError> {
        let matrix = jacobian(simulator, &point)?;
        Ok(Self { simulator, point, matrix, full: OnceLock::new() })
    }

    /// Returns the point of the linearization.
    #[must_use]
    pub fn point(&self) -> &Point {
        &self.point
    }

    /// Returns A = dy'/dy, `states` by `states`.
    ///
    /// # Errors
    /// [`LinearError::TooLarge`] for more than [`MAX_STATES`] states.
    pub fn matrix(&self) -> Result<&DMatrix<f64>, LinearError> {
        require_small(self.simulator)?;
        Ok(self.full.get_or_init(|| self.matrix.full()))
    }

    /// Returns the simulator.
    #[must_use]
    pub fn simulator(&self) -> &'a dyn Simulator<f64> {
        self.simulator
    }

    /// Returns M, D and K. They are exact derivatives of f where accelerations are zero; elsewhere
    /// K also contains the change of M times acceleration.
    ///
    /// # Errors
    /// [`LinearError::TooLarge`] for more than [`MAX_STATES`] states.
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

    /// Returns the names of \[q, q', z\], the components of mode shapes. They include all
    /// generalized coordinates, even those whose positions are not in the state.
    #[must_use]
    pub fn motion_names(&self) -> Vec<String> {
        motions::names(self.simulator)
    }

    /// Returns M at the point.
    fn mass_matrix(&self) -> DMatrix<f64> {
        let pattern = self.simulator.mass_matrix_pattern();
        let mut values = vec![0.0; pattern.entries.len()];
        let Point { time, state, parameters } = &self.point;
        self.simulator.mass_matrix(*time, state, parameters, &mut values);
        crate::dense::dense(pattern, &values)
    }
}

/// Returns y' at a point.
fn rate(simulator: &dyn Simulator<f64>, point: &Point) -> DVector<f64> {
    let mut rate = DVector::zeros(point.state.len());
    simulator.rate(point.time, &point.state, &point.parameters, rate.as_mut_slice());
    rate
}

/// Returns the emitted dy'/dy at a point, after checking the point.
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

/// Returns a matrix as a dense one if it is not too large.
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

/// Returns the scales of all states; 1 for a scale that is not a positive number.
fn scales(simulator: &dyn Simulator<f64>) -> DVector<f64> {
    let scale = |index: usize| {
        let scale = simulator.state_scale(index);
        if scale.is_finite() && scale > 0.0 { scale } else { 1.0 }
    };
    DVector::from_fn(simulator.shape().states(), |index, _| scale(index))
}

/// Returns the index of a name among `count` quantities.
fn position<'q>(
    name: &str,
    count: usize,
    quantity: impl Fn(usize) -> Quantity<'q>,
) -> Option<usize> {
    (0..count).find(|index| quantity(*index).name == name)
}
