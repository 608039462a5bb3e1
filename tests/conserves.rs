//! Conservation of energy, determined from the structure of the powers.

use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Describe as _;
use machinist_model::ModelSimulator;

use crate::own_scene::{of_specs, of_text};

/// Returns a pendulum on a rod, with additional energy terms.
fn bob(more: &str) -> ModelSimulator {
    of_text(
        &format!(
            r#"
            [scene]
            name = "bob"
            [units.p]
            unit = "bob"
            [initial]
            "p.x" = 0.6
            "p.y" = -0.8
            [run]
            until = 10
            [define.bob.coordinates]
            x = {{ unit = "m" }}
            y = {{ unit = "m" }}
            [define.bob.parameters]
            mass = {{ value = 1, unit = "kg" }}
            drag = {{ value = 0.5, unit = "N s/m" }}
            late = {{ value = 0.3, unit = "1" }}
            [define.bob.energy]
            kinetic = "0.5*mass*(x_dot^2 + y_dot^2)"
            potential = "mass*9.81 [m/s^2]*y"
            {more}
            [define.bob.constraints.rod]
            expression = "x^2 + y^2 - 1 [m^2]"
            "#
        ),
        Keep::All,
    )
}

/// Returns the parameters of a machine, with the drag at a value.
fn with_drag(machine: &ModelSimulator, drag: f64) -> Vec<f64> {
    let value = |index: usize| match machine.parameter(index).name {
        "p.drag" => drag,
        _ => machine.parameter_default(index),
    };
    (0..machine.shape().parameters).map(value).collect()
}

#[test]
fn losses_count_wherever_they_are_and_not_where_a_parameter_takes_them_away() {
    // The start, and places beside it, lose nothing: the brake begins beyond.
    let late = "dissipation = \"0.5*drag*max(0 - x/(1 [m]) - late, 0)*(x_dot^2 + y_dot^2)\"";
    for (more, with, without) in [
        ("", true, true),
        (late, false, true),
        ("dissipation = \"0.5*drag*x_dot^2\"", false, true),
        ("dissipation = \"0.5*(drag + 1e-300 [N s/m])*x_dot^2\"", false, false),
    ] {
        let bob = bob(more);
        assert_eq!(bob.conserves_energy(&with_drag(&bob, 0.5)), Some(with), "{more}");
        assert_eq!(bob.conserves_energy(&with_drag(&bob, 0.0)), Some(without), "{more}");
    }
}

#[test]
fn machines_of_the_specs_conserve_energy_as_they_say() {
    for (name, conserves) in [
        ("pendulum_constrained", Some(true)),
        ("saw_gin", Some(false)),
        ("stick_slip", Some(false)),
        ("shaft_step_torque", None),
    ] {
        let machine = of_specs(name, Keep::Needed);
        let parameters: Vec<f64> =
            (0..machine.shape().parameters).map(|k| machine.parameter_default(k)).collect();
        assert_eq!(machine.conserves_energy(&parameters), conserves, "{name}");
    }
}
