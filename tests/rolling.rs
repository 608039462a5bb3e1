//! Small motions of rolling bodies: constraints of velocities that depend on positions.

use machinist::Simulation;
use machinist::linear_analysis::{Linearization, Mode, ModeKind, Place, operating_point};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;
use num_complex::Complex64;

use crate::own_scene::of_text;

/// A ball on a turntable about its centre, on springs and dampers with stiffness m k and damping m
/// d.
const BALL: &str = r#"
    [scene]
    name = "ball"
    [units.ball]
    unit = "ball"
    [outputs]
    x = "ball.x"
    [run]
    until = 1
    points = 11
    rtol = 1e-9
    method = "auto"
    [define.ball.coordinates]
    x = { unit = "m" }
    y = { unit = "m" }
    a = { unit = "rad" }
    b = { unit = "rad" }
    [define.ball.parameters]
    m = { value = 0.1, unit = "kg" }
    R = { value = 0.02, unit = "m" }
    k = { value = 20, unit = "1/s^2" }
    d = { value = 3, unit = "1/s" }
    W = { value = 3.5, unit = "rad/s" }
    [define.ball.energy]
    kinetic = "m*(x_dot^2 + y_dot^2)/2 + m*R^2/5*(a_dot^2 + b_dot^2)"
    potential = "m*k*(x^2 + y^2)/2"
    dissipation = "m*d*(x_dot^2 + y_dot^2)/2"
    [define.ball.constraints.rx]
    expression = "x_dot - R*b_dot + W*y"
    [define.ball.constraints.ry]
    expression = "y_dot + R*a_dot - W*x"
    "#;

/// A wheel behind a moving kingpin, with the kingpin on a lateral spring.
const CASTER: &str = r#"
    [scene]
    name = "caster"
    [units.s]
    unit = "s"
    [initial]
    "s.x_dot" = "speed"
    [parameters]
    speed = { value = 5, unit = "m/s" }
    [outputs]
    y = "s.y"
    [run]
    until = 1
    points = 11
    rtol = 1e-9
    method = "auto"
    [define.s.coordinates]
    x = { unit = "m" }
    y = { unit = "m" }
    psi = { unit = "rad" }
    [define.s.parameters]
    M = { value = 100, unit = "kg" }
    m = { value = 2, unit = "kg" }
    J = { value = 0.08, unit = "kg m^2" }
    a = { value = 0.2, unit = "m" }
    b = { value = 0.1, unit = "m" }
    k = { value = 2e3, unit = "N/m" }
    d = { value = 5, unit = "N s/m" }
    [define.s.energy]
    kinetic = "M*x_dot^2/2 + m*((x_dot + b*sin(psi)*psi_dot)^2 + (y_dot - b*cos(psi)*psi_dot)^2)/2 + J*psi_dot^2/2"
    potential = "k*y^2/2"
    dissipation = "d*y_dot^2/2"
    [define.s.constraints.wheel]
    expression = "-sin(psi)*(x_dot + a*sin(psi)*psi_dot) + cos(psi)*(y_dot - a*cos(psi)*psi_dot)"
    "#;

fn at_start<'s>(machine: &'s ModelSimulator, name: &str, value: f64) -> Linearization<'s> {
    let run = Simulation::new(machine).parameter(name, value).expect("a parameter");
    let point = operating_point(&run, Place::Initial).expect("a start");
    Linearization::at(machine, point).expect("it is regular")
}

fn moving(modes: &[Mode]) -> Vec<Complex64> {
    let moving = modes.iter().filter(|mode| mode.kind != ModeKind::Free);
    moving
        .inspect(|mode| assert!(mode.residual < 1e-12, "{mode:?}"))
        .map(Mode::eigenvalue)
        .collect()
}

/// With s = x + i y the ball's spin follows s' - i W s, and as it is drawn by 2/5 m of it,
/// (7/5) s'' + (d - 2/5 i W) s' + k s = 0.
#[test]
fn a_ball_at_rest_at_the_centre_of_a_turntable_moves_as_the_closed_form_says() {
    let ball = of_text(BALL, Keep::All);
    for speed in [0.0, 3.5, -12.0] {
        let (half, k) = (Complex64::new(3.0, -0.4 * speed) / 2.8, 20.0 / 1.4);
        let root = (half * half - k).sqrt();
        let exact = [-half + root, -half - root];
        let modes = at_start(&ball, "ball.W", speed).modes().expect("eigenvalues");
        let found = moving(&modes);
        assert_eq!(found.len(), 2, "{speed}: {modes:?}");
        for exact in exact {
            let exact = Complex64::new(exact.re, exact.im.abs());
            let off = found.iter().map(|found| (found - exact).norm()).fold(f64::MAX, f64::min);
            assert!(off < 1e-10, "{speed}: {exact} is not in {found:?}");
        }
    }
}

/// With psi = e^(s t) and y = (a + speed/s) psi, the force of the wheel eliminated:
/// ((m (a - b) s^2 + a d s + a k) (a s + speed) + (J + m b^2 - a b m) s^3) psi = 0.
#[test]
fn a_caster_that_runs_straight_shimmies_as_its_polynomial_says() {
    let caster = of_text(CASTER, Keep::All);
    for speed in [5.0, 20.0] {
        let modes = at_start(&caster, "speed", speed).modes().expect("eigenvalues");
        let found = moving(&modes);
        assert_eq!(found.len(), 2, "{speed}: {modes:?}");
        assert!(found.iter().any(|value| value.im == 0.0 && value.re < 0.0), "{found:?}");
        assert!(found.iter().any(|value| value.im > 0.0 && value.re > 0.0), "{found:?}");
        for s in found {
            let terms = [0.1 * s.powi(3), 0.2 * (1.0 + speed) * s * s, (80.0 + speed) * s]
                .map(|term| (term, term.norm()));
            let sum = terms.iter().map(|(term, _)| term).sum::<Complex64>() + 400.0 * speed;
            let size = terms.iter().map(|(_, size)| size).sum::<f64>();
            assert!(sum.norm() < 1e-11 * size, "{speed}: {s} leaves {sum} of {size}");
        }
    }
}
