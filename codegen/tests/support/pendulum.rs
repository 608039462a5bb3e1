//! Damped pendulum under a torque that follows a table with a lag.

use machinist_codegen::scene::system::{
    Coordinate, Definition, FirstOrderState, GeneralizedForce, LagrangianSystem,
};
use machinist_codegen::spec::SourceFile;
use machinist_model::{
    Freeze, Function, MatrixTape, Model, NodeId, Op, RunDefaults, Table, TableId, Tape,
};

use super::{Builder, described, parameter, pattern, quantity, tape, zero};

const PHI: u32 = 0;
const PHI_DOT: u32 = 1;
const TORQUE: u32 = 2;
const MASS: u32 = 0;
pub(super) const LENGTH: u32 = 1;
pub(super) const GRAVITY: u32 = 2;
const DAMPING: u32 = 3;
pub(super) const LAG: u32 = 4;
const START: u32 = 5;

/// Returns a damped pendulum whose torque follows a table with a lag, from a given time:
///
/// ```text
/// m l^2 phi'' = torque - b phi' - m g l sin phi
/// torque' = (load(t) [t >= start] - torque)/lag
/// ```
pub fn pendulum() -> Model {
    pendulum_of(&pendulum_system())
}

/// Returns the pendulum's model with the names of a system.
pub(super) fn pendulum_of(system: &LagrangianSystem) -> Model {
    Model {
        requirements: Vec::new(),
        required: Tape::default(),
        initial_state: tape(|b| vec![b.number(0.5), b.number(0.0), b.number(0.0)]),
        discontinuities: tape(|b| vec![b.parameter(START)]),
        rate: tape(|b| {
            let (speed, acceleration) = (b.state(PHI_DOT), acceleration(b));
            vec![speed, acceleration, torque_rate(b)]
        }),
        rate_jacobian: MatrixTape {
            solve: None,
            pattern: pattern(3, 3, &[(0, 1), (1, 0), (1, 1), (1, 2), (2, 2)]),
            tape: tape(rate_jacobian),
        },
        parameter_jacobian: MatrixTape {
            solve: None,
            pattern: pattern(3, 6, &[(1, 2), (1, 3)]),
            tape: tape(parameter_jacobian),
        },
        time_derivative: tape(|b| {
            let zero = b.number(0.0);
            let slope = load(b, 1);
            let lag = b.parameter(LAG);
            vec![zero, zero, b.push(Op::Div(slope, lag))]
        }),
        mass_matrix: MatrixTape {
            solve: None,
            pattern: pattern(1, 1, &[(0, 0)]),
            tape: tape(|b| vec![inertia(b)]),
        },
        forcing: tape(|b| vec![forcing(b)]),
        outputs: tape(|b| {
            let (height, deflection) = (height(b), b.state(PHI));
            vec![height, deflection]
        }),
        energy: tape(energy),
        power_balance: tape(power_balance),
        ..described(system)
    }
}

/// Returns the system of the pendulum, without its expressions.
pub fn pendulum_system() -> LagrangianSystem {
    LagrangianSystem {
        starts_in_equilibrium: false,
        name: "pendulum".to_owned(),
        title: "Damped pendulum".to_owned(),
        doc: "A point mass on a rod.\n\nIts torque follows a table with a lag.".to_owned(),
        source: "Worked out on paper.".to_owned(),
        shares_redundant: false,
        coordinates: vec![Coordinate {
            position: quantity("arm.phi", "rad", "angle from the vertical"),
            velocity: quantity("arm.phi_dot", "rad/s", "speed of arm.phi"),
            identified: vec![],
            initial: [zero(), zero()],
            is_given: [true; 2],
            scale: [1.0, 10.0],
        }],
        first_order: vec![FirstOrderState {
            quantity: quantity("drive.torque", "N m", "torque on the arm"),
            rate: zero(),
            initial: zero(),
            scale: 100.0,
            is_mode: false,
        }],
        parameters: vec![
            parameter("arm.mass", "kg", 4.2, "mass of the bob"),
            parameter("arm.length", "m", 0.75, "length of the rod"),
            parameter("arm.gravity", "m/s^2", 9.80665, "acceleration of free fall"),
            parameter("arm.damping", "N m s/rad", 0.128_534_6, "viscous damping of the pivot"),
            parameter("drive.lag", "s", 1e-2, "time constant of the drive"),
            parameter("start", "s", 0.1, "time at which the drive starts"),
        ],
        handed: vec![],
        kinetic: zero(),
        potential: zero(),
        mechanisms: Vec::new(),
        drawing: Vec::new(),
        orientations: machinist_codegen::spatial::orientation::Orientations::default(),
        scalars: Vec::new(),
        springs: vec![],
        dissipation: zero(),
        generalized_force: vec![GeneralizedForce { total: zero(), conversion: zero() }],
        stored_energy: zero(),
        supplied_power: zero(),
        dissipated_power: zero(),
        fields: vec![],
        helpers: vec![],
        checks: vec![],
        outputs: vec![
            Definition { quantity: quantity("height", "m", "height of the bob"), expr: zero() },
            Definition { quantity: quantity("deflection", "rad", ""), expr: zero() },
        ],
        tables: vec![Table {
            name: quantity("drive.load", "N m", "").name,
            knots: vec![0.0, 1.0, 3.0],
            coefficients: vec![[0.0, 1.25, 0.0, -0.25], [1.0, 0.5, -0.75, 0.125]],
        }],
        discontinuities: vec![zero()],
        events: vec![],
        constraints: vec![],
        run: RunDefaults {
            from: 0.0,
            until: 2.0,
            points: 1001,
            times: Vec::new(),
            rtol: 1e-8,
            method: "bdf".to_owned(),
        },
        freeze: Freeze::default(),
        warnings: Vec::new(),
        notes: Vec::new(),
        requirements: Vec::new(),
        files: vec![SourceFile {
            path: "specs/scenes/pendulum.toml".into(),
            label: "scenes/pendulum.toml".to_owned(),
            sha256: "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855".to_owned(),
        }],
    }
}

fn inertia(b: &mut Builder) -> NodeId {
    let length = b.parameter(LENGTH);
    let square = b.push(Op::Powi(length, 2));
    let mass = b.parameter(MASS);
    let inertia = b.push(Op::Mul(mass, square));
    b.named("inertia", inertia)
}

fn weight_moment(b: &mut Builder) -> NodeId {
    let factors = [b.parameter(MASS), b.parameter(GRAVITY), b.parameter(LENGTH)];
    b.product(&factors)
}

fn forcing(b: &mut Builder) -> NodeId {
    let (damping, speed) = (b.parameter(DAMPING), b.state(PHI_DOT));
    let friction = b.push(Op::Mul(damping, speed));
    let torque = b.state(TORQUE);
    let driving = b.push(Op::Sub(torque, friction));
    let phi = b.state(PHI);
    let sine = b.push(Op::Call(Function::Sin, phi));
    let moment = weight_moment(b);
    let weight = b.push(Op::Mul(moment, sine));
    b.push(Op::Sub(driving, weight))
}

fn acceleration(b: &mut Builder) -> NodeId {
    let (forcing, inertia) = (forcing(b), inertia(b));
    b.push(Op::Div(forcing, inertia))
}

/// Returns the load or its derivative by time.
fn load(b: &mut Builder, order: u32) -> NodeId {
    let (time, start) = (b.push(Op::Time), b.parameter(START));
    let value = b.push(Op::Table { table: TableId(0), order, argument: time });
    let zero = b.number(0.0);
    b.push(Op::SelectLess { lhs: time, rhs: start, then: zero, otherwise: value })
}

fn torque_rate(b: &mut Builder) -> NodeId {
    let (load, torque) = (load(b, 0), b.state(TORQUE));
    let load = b.named("load", load);
    let missing = b.push(Op::Sub(load, torque));
    let lag = b.parameter(LAG);
    b.push(Op::Div(missing, lag))
}

fn rate_jacobian(b: &mut Builder) -> Vec<NodeId> {
    let (one, inertia) = (b.number(1.0), inertia(b));
    let (phi, moment) = (b.state(PHI), weight_moment(b));
    let cosine = b.push(Op::Call(Function::Cos, phi));
    let stiffness = b.push(Op::Mul(moment, cosine));
    let per_inertia = b.push(Op::Div(stiffness, inertia));
    let by_phi = b.push(Op::Neg(per_inertia));
    let damping = b.parameter(DAMPING);
    let per_inertia = b.push(Op::Div(damping, inertia));
    let by_speed = b.push(Op::Neg(per_inertia));
    let by_torque = b.push(Op::Div(one, inertia));
    let lag = b.parameter(LAG);
    let inverse = b.push(Op::Div(one, lag));
    vec![one, by_phi, by_speed, by_torque, b.push(Op::Neg(inverse))]
}

fn parameter_jacobian(b: &mut Builder) -> Vec<NodeId> {
    let phi = b.state(PHI);
    let sine = b.push(Op::Call(Function::Sin, phi));
    let length = b.parameter(LENGTH);
    let by_gravity = b.push(Op::Div(sine, length));
    let by_gravity = b.push(Op::Neg(by_gravity));
    let (speed, inertia) = (b.state(PHI_DOT), inertia(b));
    let by_damping = b.push(Op::Div(speed, inertia));
    vec![by_gravity, b.push(Op::Neg(by_damping))]
}

fn height(b: &mut Builder) -> NodeId {
    let (phi, one) = (b.state(PHI), b.number(1.0));
    let cosine = b.push(Op::Call(Function::Cos, phi));
    let rise = b.push(Op::Sub(one, cosine));
    let length = b.parameter(LENGTH);
    b.push(Op::Mul(length, rise))
}

fn energy(b: &mut Builder) -> Vec<NodeId> {
    let (inertia, speed) = (inertia(b), b.state(PHI_DOT));
    let square = b.push(Op::Powi(speed, 2));
    let double = b.push(Op::Mul(inertia, square));
    let two = b.number(2.0);
    let kinetic = b.push(Op::Div(double, two));
    let (mass, gravity) = (b.parameter(MASS), b.parameter(GRAVITY));
    let weight = b.push(Op::Mul(mass, gravity));
    let height = height(b);
    vec![kinetic, b.push(Op::Mul(weight, height)), b.number(0.0)]
}

fn power_balance(b: &mut Builder) -> Vec<NodeId> {
    let (speed, torque, damping) = (b.state(PHI_DOT), b.state(TORQUE), b.parameter(DAMPING));
    let supplied = b.push(Op::Mul(torque, speed));
    let square = b.push(Op::Powi(speed, 2));
    let dissipated = b.push(Op::Mul(damping, square));
    vec![b.push(Op::Sub(supplied, dissipated)), supplied, dissipated]
}
