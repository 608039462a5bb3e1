//! Kinetic energies that jump: by place, by events and by moving boundaries, by all methods against
//! closed forms and steep smooth changes.

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_model::ModelSimulator;

use crate::own_scene::{of_files, of_text};

const OWN: [Method; 6] =
    [Method::Tsit5, Method::Dop853, Method::Rodas5p, Method::Radau, Method::Taylor, Method::Auto];

/// Returns a mass in the plane, starting at (-1 m, 0) with 1 m/s along x and `along` along y.
fn plane(kinetic: &str, definition: &str) -> ModelSimulator {
    let text = format!(
        r#"
        [scene]
        name = "plane"
        [units.u]
        unit = "u"
        [initial]
        "u.x" = -1.0
        "u.vx" = 1.0
        [run]
        until = 3.0
        points = 31
        rtol = 1e-9
        method = "auto"
        [define.u.coordinates.x]
        unit = "m"
        velocity = "vx"
        [define.u.coordinates.y]
        unit = "m"
        velocity = "vy"
        [define.u.parameters]
        m = {{ value = 1.0, unit = "kg" }}
        more = {{ value = 2.0, unit = "kg" }}
        c = {{ value = 0.0, unit = "m/s" }}
        [define.u.energy]
        kinetic = "{kinetic}"
        {definition}
        "#
    );
    of_text(&text, Keep::All)
}

fn run(machine: &ModelSimulator, method: Method, values: &[(&str, f64)], along: f64) -> Trajectory {
    let mut run = Simulation::new(machine).method(method).with_energy_balance(true);
    for (name, value) in values {
        run = run.parameter(name, *value).expect("a parameter");
    }
    run.initial_value("u.vy", along).expect("a state").run().expect("it runs")
}

fn last(run: &Trajectory, name: &str) -> f64 {
    *run.column(name).expect("a column").last().expect("a row")
}

fn assert_near(found: f64, expected: f64, allowed: f64, what: &str) {
    assert!((found - expected).abs() <= allowed, "{what}: {found} and not {expected}");
}

const STEP: &str = "piecewise(x < 0, m, more)*(vx^2 + vy^2)/2";

#[test]
fn a_mass_that_jumps_at_a_place_is_refracted_or_thrown_back_as_energy_allows() {
    let machine = plane(STEP, "");
    for method in OWN {
        for more in [0.1, 0.5, 0.99, 1.0, 1.01, 3.0, 50.0] {
            for along in [0.0, 0.3, -1.0, 4.0] {
                let run = run(&machine, method, &[("u.more", more)], along);
                let what = format!("{method}, {more} kg, {along} m/s");
                // The momentum along the boundary goes on, the energy does too.
                let behind = along / more;
                let left = (1.0 + along * along) / more - behind * behind;
                let expected = if left > 0.0 { [left.sqrt(), behind] } else { [-1.0, along] };
                assert_near(last(&run, "u.vx"), expected[0], 1e-10, &what);
                assert_near(last(&run, "u.vy"), expected[1], 1e-10, &what);
                assert_near(last(&run, "u.x"), 2.0 * expected[0], 1e-8, &what);
                assert_near(last(&run, "energy.residual"), 0.0, 1e-9, &what);
            }
        }
    }
}

#[test]
fn a_boundary_that_moves_does_work_on_a_mass_that_jumps() {
    let machine = plane("piecewise(x < c*t, m, more)*(vx^2 + vy^2)/2", "");
    for method in OWN {
        for more in [0.3, 0.9, 2.0, 10.0] {
            for c in [-2.0, -0.5, 0.2] {
                let run = run(&machine, method, &[("u.more", more), ("u.c", c)], 0.0);
                // more v^2/2 - v^2/2 = c (more v+ - v): the work of the impulse.
                let v0 = 1.0 / more;
                let left = c * c - 2.0 * c * v0 + v0;
                let expected = if left > 0.0 { c + left.sqrt() } else { 2.0 * c - 1.0 };
                let what = format!("{method}, {more} kg, {c} m/s");
                assert_near(last(&run, "u.vx"), expected, 1e-9, &what);
                assert_near(last(&run, "energy.residual"), 0.0, 1e-9, &what);
            }
        }
    }
}

#[test]
fn a_jump_at_a_place_is_the_limit_of_steep_changes() {
    // Coupled and oblique: M is full, the boundary is neither along x nor along y.
    let kinetic = |share: &str| {
        format!("m*(vx^2 + vy^2 + vx*vy)/2 + more*({share})*(vx - 2*vy)^2/2 + 3 [kg]*vy^2/2")
    };
    let sharp = plane(&kinetic("piecewise(x + y/3 < 0, 0, 1)"), "");
    let width = |w: &str| plane(&kinetic(&format!("(1 + tanh((x + y/3)/({w})))/2")), "");
    let (steep, steeper) = (width("2e-3 [m]"), width("1e-3 [m]"));
    for along in [-0.6, 0.0, 1.5] {
        let of = |machine| run(machine, Method::Dop853, &[("u.more", 1.5)], along);
        let runs = [of(&sharp), of(&steep), of(&steeper)];
        for name in ["u.vx", "u.vy"] {
            let [sharp, wide, narrow] = [0, 1, 2].map(|index| last(&runs[index], name));
            let what = format!("{name}, {along} m/s: {wide} {narrow}");
            assert_near(sharp, 2.0 * narrow - wide, 1e-6, &what);
        }
    }
}

#[test]
fn a_table_as_transmission_keeps_the_energy_at_its_corners() {
    let table = "table(\"tab.csv\", \"y\", x, \"linear\")";
    let text = format!(
        r#"
        [scene]
        name = "tabled"
        [units.u]
        unit = "u"
        [initial]
        "u.x" = -1.0
        "u.vx" = 1.0
        [run]
        until = 3.0
        rtol = 1e-9
        [define.u.coordinates.x]
        unit = "m"
        velocity = "vx"
        [define.u.energy]
        kinetic = '1 [kg]*der({table})^2/2'
        "#
    );
    let corners = "x [m],y [m]\n-2,-2\n0,0\n0.3,0.9\n5,3.25\n";
    let machine = of_files(&[("tabled.toml", &text), ("tab.csv", corners)], Keep::All);
    for method in OWN {
        let run = Simulation::new(&machine).method(method).run().expect("it runs");
        // The speed of the driven mass stays at 1 m/s; the slopes are 1, 3, 0.5.
        assert_near(last(&run, "u.vx"), 2.0, 1e-9, method.name());
    }
}

#[test]
fn an_event_that_adds_a_mass_keeps_the_momentum() {
    let machine = plane(
        "piecewise(on < 1, m, m + more)*(vx^2 + vy^2)/2",
        r#"
        [define.u.modes.on]
        [define.u.events.meets]
        guard = "x"
        direction = "rising"
        when = { on = 0 }
        set = { on = 1 }
        "#,
    );
    for method in OWN {
        for more in [0.0, 0.5, 20.0] {
            let run = run(&machine, method, &[("u.more", more)], 0.7);
            let what = format!("{method}, {more} kg");
            assert_near(last(&run, "u.vx"), 1.0 / (1.0 + more), 1e-10, &what);
            assert_near(last(&run, "u.vy"), 0.7 / (1.0 + more), 1e-10, &what);
            assert_near(last(&run, "energy.residual"), 0.0, 1e-9, &what);
        }
    }
}

#[test]
fn velocities_that_an_event_sets_are_kept_where_it_adds_a_mass() {
    let machine = plane(
        "piecewise(on < 1, m, m + more)*(vx^2 + vy^2)/2",
        r#"
        [define.u.modes.on]
        [define.u.events.meets]
        guard = "x"
        direction = "rising"
        when = { on = 0 }
        set = { on = 1, vx = "vx/4" }
        "#,
    );
    let run = run(&machine, Method::Auto, &[("u.more", 1.0)], 0.7);
    assert_near(last(&run, "u.vx"), 0.25, 1e-12, "set by the event");
    assert_near(last(&run, "u.vy"), 0.35, 1e-10, "by momentum");
}

#[test]
fn a_mass_that_jumps_with_its_velocity_is_refused() {
    let machine = plane(
        "piecewise(vx < 2 [m/s], m, more)*(vx^2 + vy^2)/2",
        "[[define.u.forces]]\ncoordinate = \"x\"\nexpression = \"1 [N]\"",
    );
    let refused = Simulation::new(&machine).method(Method::Dop853).run().expect_err("no law");
    assert!(refused.to_string().contains("comparison of velocities"), "{refused}");
}

/// Force of a damper over its velocity, or of a spring over its position, with corners at -1 and 1
/// (m/s or m): a table, and the same law by comparisons.
const LAW: [&str; 2] = [
    r#"table("law.csv", "force", ARGUMENT/(1 UNIT), "linear")"#,
    "(ARGUMENT + max(ARGUMENT - 1 UNIT, 0) + min(ARGUMENT + 1 UNIT, 0))*1 [N]/(1 UNIT)",
];

/// Returns a cart with a pendulum, whose inertia varies with its angle, and with a law of force.
fn cart(law: &str, argument: &str, unit: &str) -> ModelSimulator {
    let law = law.replace("ARGUMENT", argument).replace("UNIT", unit);
    let scene = format!(
        r#"
        [scene]
        name = "cart"
        [units.u]
        unit = "u"
        [initial]
        "u.phi" = 2.0
        [run]
        until = 5.0
        points = 51
        rtol = 1e-9
        method = "auto"
        [define.u.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.u.coordinates.phi]
        unit = "rad"
        [define.u.parameters]
        m = {{ value = 1.0, unit = "kg" }}
        l = {{ value = 1.0, unit = "m" }}
        k = {{ value = 10.0, unit = "N/m" }}
        [define.u.energy]
        kinetic = "m*v^2/2 + m*(v^2 + 2*v*phi_dot*l*cos(phi) + (l*phi_dot)^2)/2"
        potential = "-m*9.81 [m/s^2]*l*cos(phi) + k*x^2/2"
        [[define.u.forces]]
        coordinate = "x"
        expression = '-{law}'
        "#
    );
    let table = "at [1],force [N]\n-3,-5\n-1,-1\n1,1\n3,5\n";
    of_files(&[("cart.toml", &scene), ("law.csv", table)], Keep::All)
}

#[test]
fn a_smooth_inertia_does_not_jump_at_the_corners_of_a_law_of_force() {
    for (argument, unit) in [("v", "[m/s]"), ("x", "[m]")] {
        let [by_table, by_branches] = LAW.map(|law| cart(law, argument, unit));
        for method in OWN {
            let run = |machine| {
                let mut run = Simulation::new(machine).method(method);
                if !matches!(method, Method::Rodas5p | Method::Taylor) {
                    run = run.sensitivities(&["u.k"]).expect("a parameter");
                }
                run.run().expect("it runs")
            };
            let [found, wanted] = [run(&by_table), run(&by_branches)];
            for (column, expected) in found.columns.iter().zip(&wanted.columns) {
                let scale = expected.values.iter().fold(1.0, |most: f64, x| most.max(x.abs()));
                for (value, wanted) in column.values.iter().zip(&expected.values) {
                    let what = format!("{argument}, {method}, {}", column.name);
                    assert_near(*value, *wanted, 2e-6 * scale, &what);
                }
            }
        }
    }
}
