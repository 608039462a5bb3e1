//! `mod(x, y)`, `floor`, `ceil` and `round`: values, and motions in which they jump.

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::common::column;
use crate::own_scene::{of_text, refusal};

/// Methods that end steps where a rate jumps.
const METHODS: [Method; 6] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Taylor, Method::Auto];

/// Returns a mass of 2 kg with a force on it.
fn pushed(force: &str, outputs: &str) -> String {
    format!(
        "[scene]\nname = \"pushed\"\n[units.cart]\nunit = \"translational/mass\"\n\
         parameters = {{ mass = 2 }}\n\
         [[forces]]\nport = \"cart.a\"\nexpression = \"{force}\"\n\
         [parameters]\npitch = {{ value = 0.3, unit = \"m\" }}\n\
         [initial]\n\"cart.v\" = 0.5\n\
         [outputs]\nx = \"cart.x\"\nv = \"cart.v\"\n{outputs}\n\
         [run]\nuntil = 2.0\npoints = 201\nrtol = 1e-10\nmethod = \"auto\"\n"
    )
}

fn run(scene: &ModelSimulator, method: Method) -> Trajectory {
    let run = Simulation::new(scene).method(method).run();
    run.unwrap_or_else(|error| panic!("{method}: {error}"))
}

#[test]
fn a_remainder_is_that_of_euclid() {
    let outputs = "a = { expression = \"mod(3*t - 2.5 [s], 0.7 [s])\", unit = \"s\" }\n\
                   b = { expression = \"mod(1 - t/1 [s], 0.25)\", unit = \"1\" }\n\
                   c = { expression = \"mod(5*t, -0.7 [s])\", unit = \"s\" }\n\
                   d = { expression = \"mod(700 [mm], 0.25 [m]) + mod(-pi, pi/2)*1 [m]\", unit = \"m\" }\n\
                   rate = { expression = \"der(mod(cart.x, pitch))\", unit = \"m/s\" }\n\
                   turn = { expression = \"mod(20 [rad/s]*t, 2*pi)\", unit = \"deg\" }";
    let run = run(&of_text(&pushed("1 [N]", outputs), Keep::Needed), Method::Auto);
    let beyond = |x: f64, y: f64| x - y * (x / y).floor();
    for (row, t) in run.times.iter().enumerate() {
        let at = |name: &str| column(&run, name)[row];
        // At a multiple, rounding decides on the side.
        let off = (at("a") - (3.0 * t - 2.5).rem_euclid(0.7)).abs();
        assert!(off.min((off - 0.7).abs()) < 1e-14 && at("a") > -1e-14, "{t}: {}", at("a"));
        assert!((at("b") - (1.0 - t).rem_euclid(0.25)).abs() < 1e-14);
        let off = (at("c") - beyond(5.0 * t, -0.7)).abs();
        assert!(off.min((off - 0.7).abs()) < 1e-14 && at("c") <= 1e-14, "{t}: {}", at("c"));
        assert!((at("d") - 0.2).abs() < 1e-15, "{}", at("d"));
        assert!((at("rate") - at("v")).abs() < 1e-12);
        let turned = (20.0 * t).rem_euclid(std::f64::consts::TAU).to_degrees();
        assert!((at("turn") - turned).abs() < 1e-10, "{t}: {}", at("turn"));
    }
}

/// F = 8 N/s mod(t, 0.3 s): each tooth adds an impulse of 0.36 N s and a displacement.
#[test]
fn a_sawtooth_over_time_is_followed_exactly() {
    let scene = of_text(&pushed("8 [N/s]*mod(t, 0.3 [s])", ""), Keep::Needed);
    let exact = |t: f64| {
        let (teeth, rest) = ((t / 0.3).floor(), t.rem_euclid(0.3));
        let (mut x, mut v) = (0.0, 0.5);
        for time in (0..teeth as usize).map(|_| 0.3).chain([rest]) {
            // a = 4 t within a tooth.
            x += v * time + 4.0 * time.powi(3) / 6.0;
            v += 2.0 * time * time;
        }
        (x, v)
    };
    for method in METHODS {
        let run = run(&scene, method);
        for (row, t) in run.times.iter().enumerate() {
            // At the end of a tooth the reference may be on either side, which makes no difference.
            let (x, v) = exact(*t);
            let off = (column(&run, "x")[row] - x).abs().max((column(&run, "v")[row] - v).abs());
            assert!(off < 1e-8, "{method} at {t}: {off:e}");
        }
    }
}

/// F = 40 N/m mod(x, p): over each pitch the energy grows by 40 p^2/2, and between by that of the
/// remainder.
#[test]
fn a_force_that_repeats_along_a_way_does_its_work() {
    let scene = of_text(&pushed("40 [N/m]*mod(cart.x, pitch)", ""), Keep::Needed);
    for method in METHODS {
        let run = run(&scene, method);
        let end = *column(&run, "x").last().expect("a value");
        assert!(end > 3.0 * 0.3, "{method}: it passes several multiples, {end}");
        for (x, v) in column(&run, "x").iter().zip(column(&run, "v")) {
            let (teeth, rest) = ((x / 0.3).floor(), x.rem_euclid(0.3));
            let work = 20.0 * (teeth * 0.09 + rest * rest);
            // 2 kg v^2/2
            let off = v * v - 0.25 - work;
            assert!(off.abs() < 1e-7 * v * v, "{method} at {x}: {off:e}");
        }
    }
}

#[test]
fn whole_numbers_are_those_of_their_definitions() {
    let outputs = "down = { expression = \"floor(cart.x/pitch - 1.5)\", unit = \"1\" }\n\
                   up = { expression = \"ceil(1 - 3*t/1 [s])\", unit = \"1\" }\n\
                   near = { expression = \"round(cart.x/pitch)\", unit = \"1\" }\n\
                   fixed = { expression = \"ceil(2.1) + 10*round(-2.5) + 100*floor(-0.1) + round(2.5)\", unit = \"1\" }\n\
                   rate = { expression = \"der(round(cart.x/pitch))\", unit = \"1/s\" }";
    let run = run(&of_text(&pushed("1 [N]", outputs), Keep::Needed), Method::Auto);
    let near = |found: f64, exact: &dyn Fn(f64) -> f64, at: f64| {
        // At a jump, rounding decides on the side.
        let sides = [exact(at - 1e-12), exact(at), exact(at + 1e-12)];
        assert!(sides.contains(&found), "{found} instead of {sides:?}");
    };
    for (row, t) in run.times.iter().enumerate() {
        let at = |name: &str| column(&run, name)[row];
        near(at("down"), &|x| (x - 1.5).floor(), at("x") / 0.3);
        near(at("up"), &f64::ceil, 1.0 - 3.0 * t);
        near(at("near"), &|x| (x + 0.5).floor(), at("x") / 0.3);
        // 3 - 20 - 100 + 3: halves go up.
        assert_eq!((at("fixed"), at("rate")), (-114.0, 0.0));
    }
}

/// F = 6 N round(x/p): the energy at x is 6 N p times the sum of the steps below.
#[test]
fn a_force_in_steps_along_a_way_does_its_work() {
    let work = |x: f64| {
        let step = (x / 0.3 + 0.5).floor();
        6.0 * (0.3 * step * (step - 1.0) / 2.0 + step * (x - 0.3 * (step - 0.5)))
    };
    for force in [
        "6 [N]*round(cart.x/pitch)",
        "6 [N]*floor(cart.x/pitch + 0.5)",
        "6 [N]*(ceil(cart.x/pitch + 0.5) - 1)",
    ] {
        let scene = of_text(&pushed(force, ""), Keep::Needed);
        for method in METHODS {
            let run = run(&scene, method);
            assert!(*column(&run, "x").last().expect("a value") > 1.5, "{method}");
            for (x, v) in column(&run, "x").iter().zip(column(&run, "v")) {
                // 2 kg v^2/2
                let off = v * v - 0.25 - work(*x);
                assert!(off.abs() < 1e-7 * v * v, "{force}, {method} at {x}: {off:e}");
            }
        }
    }
}

/// F = 3 N floor(t/0.4 s): jumps at known times.
#[test]
fn stairs_over_time_are_followed_exactly() {
    let scene = of_text(&pushed("3 [N]*floor(t/0.4 [s])", ""), Keep::Needed);
    for method in METHODS {
        let run = run(&scene, method);
        let v = *column(&run, "v").last().expect("a value");
        // Up to 2 s: 0.4 s each of 0, 3, 6, 9, 12 N on 2 kg.
        assert!((v - 0.5 - 0.4 * 30.0 / 2.0).abs() < 1e-9, "{method}: {v}");
    }
}

#[test]
fn a_unit_may_be_called_floor() {
    let text = pushed("1 [N]*floor(3.7)", "").replace("cart", "floor");
    let run = run(&of_text(&text, Keep::Needed), Method::Auto);
    let v = *column(&run, "v").last().expect("a value");
    assert!((v - 0.5 - 2.0 * 3.0 / 2.0).abs() < 1e-9, "{v}");
}

#[test]
fn remainders_of_what_does_not_fit_are_refused() {
    for (force, message) in [
        ("1 [N/m]*mod(cart.x, 1 [s])", "the arguments of `mod` differ in dimension"),
        ("1 [N/m]*mod(cart.x, pitch - pitch)", "a remainder by zero"),
        ("1 [N/m]*mod(cart.x)", "mod(x, y)"),
        ("1 [N]*floor(cart.x)", "the argument of this function must be dimensionless"),
        ("1 [N]*ceil(cart.x/pitch, 2)", "ceil"),
        ("1 [N]*rund(cart.x/pitch)", "round"),
    ] {
        let said = refusal(&pushed(force, ""));
        assert!(said.contains(message), "{force}: {said}");
    }
}
