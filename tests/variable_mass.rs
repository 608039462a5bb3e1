//! Kinetic energy that depends on first-order states: momentum and energy.

use machinist::{Method, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::own_scene::of_text;

/// A cart that is loaded with sand while it is pushed; sand falls in from rest.
const CART: &str = r#"
[scene]
name = "cart"
title = "Cart loaded as it goes"

[units.cart]
unit = "cart"

[outputs]
speed = "cart.v"
mass = "cart.mass"

[run]
until = 2.0
points = 21
rtol = 1e-12
method = "dop853"

[define.cart.unit]
name = "cart"
title = "Cart"

[define.cart.coordinates.x]
unit = "m"
doc = "place"
velocity = "v"

[define.cart.states.mass]
unit = "kg"
doc = "the mass"
rate = "load*(1 + v/unit_speed)"
initial = "empty"

[define.cart.parameters]
empty = { value = 2.0, unit = "kg", doc = "mass at the start" }
load = { value = 0.7, unit = "kg/s", doc = "sand" }
unit_speed = { value = 1.0, unit = "m/s", doc = "speed at which twice as much falls in" }
force = { value = 3.0, unit = "N", doc = "push" }

[define.cart.energy]
kinetic = "mass*v^2/2"

[[define.cart.forces]]
coordinate = "x"
expression = "force"
doc = "push"
"#;

fn cart() -> ModelSimulator {
    of_text(CART, Keep::Needed)
}

#[test]
fn a_cart_that_is_loaded_gains_momentum_and_not_speed_by_its_push() {
    let run = Simulation::new(&cart()).method(Method::Dop853).run().expect("it runs");
    let column = |name: &str| run.column(name).expect("an output");
    for ((time, speed), mass) in run.times.iter().zip(column("speed")).zip(column("mass")) {
        assert!((mass * speed - 3.0 * time).abs() < 1e-10, "at {time} s");
    }
    assert!(column("mass")[20] > 4.0, "it was loaded");
}

#[test]
fn what_sand_takes_to_be_carried_along_is_in_the_account() {
    let run = Simulation::new(&cart()).with_energy_balance(true).run().expect("it runs");
    let balance = run.energy_balance.as_ref().expect("it was asked for");
    assert!(balance.max_residual_relative() < 1e-11, "{balance:?}");
    // Push times distance would be more than the supplied energy.
    let energy = run.last("energy.total").expect("an energy");
    let supplied = balance.supplied.last().copied().unwrap_or_default();
    assert!(
        (energy - supplied).abs() < 1e-10 && balance.dissipated.iter().all(|lost| *lost == 0.0)
    );
}
