//! Forces and times that automatic checks leave out, because no check can judge them.

use super::{MAGNET, failed, machinist, rows, written};

/// Mass on a spring, run for so long that no method finishes within the steps of a reference.
const LONG: &str = r#"
[scene]
name = "long"
[units.wall]
unit = "translational/fixed"
[units.spring]
unit = "translational/spring"
parameters = { stiffness = 1 }
[units.mass]
unit = "translational/mass"
parameters = { mass = 1 }
[[joints]]
connect = ["wall.a", "spring.a"]
[[joints]]
connect = ["spring.b", "mass.a"]
[initial]
"mass.x" = 1
[run]
until = 2e5
points = 11
rtol = 1e-3
method = "tsit5"
"#;

#[test]
fn what_stops_is_told_as_not_checked_and_is_not_left_out() {
    let (_folder, path) = written(LONG);
    let path = path.to_str().expect("a path in UTF-8");
    let output = machinist(&["verify", path, "--algebra", "plain"]);
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let (_, last) = text.rsplit_once("\n\n").expect("a last paragraph");
    let last = last.split_whitespace().collect::<Vec<_>>().join(" ");
    let rows = ["two converged runs agree", "the run at its own method and tolerance"];
    for row in rows {
        assert!(last.contains(row), "{last}");
    }
    assert!(last.contains("not checked: "), "{last}");
}

/// A block on a damped contact, which would pull at other velocities, slides with friction.
#[test]
fn forces_of_a_contact_that_would_pull_are_left_out() {
    let block = |sign: &str| {
        format!(
            r#"
            [scene]
            name = "block"
            [units.block]
            unit = "block"
            [units.contact]
            unit = "one_sided_contact"
            inputs = {{ gap = "block.y", rate = "block.y_dot" }}
            [[forces]]
            port = "block.along"
            expression = "{sign}0.2*contact.force*sign(block.x_dot)"
            [initial]
            "block.x_dot" = 2
            "block.y" = 1e-3
            [run]
            until = 0.5
            points = 51
            rtol = 1e-8
            [define.block.coordinates.x]
            unit = "m"
            [define.block.coordinates.y]
            unit = "m"
            [define.block.ports.along]
            kind = "translational"
            coordinate = "x"
            [define.block.energy]
            kinetic = "2 [kg]*(x_dot^2 + y_dot^2)/2"
            potential = "2 [kg]*9.81 [m/s^2]*y"
            "#
        )
    };
    for (sign, expected) in [("-", vec![]), ("", vec!["no force feeds every motion".to_owned()])] {
        let (_folder, path) = written(&block(sign));
        assert_eq!(failed(&rows(&path, &[]).1), expected);
    }
}

#[test]
fn a_voltage_that_goes_by_the_speed_is_no_force() {
    let by_speed = "(supply + 0.5 [V s^2/m^2]*x_dot^2)";
    let text = MAGNET.replace("\"supply -", &format!("\"{by_speed} -"));
    let text = text.replace("\"supply*", &format!("\"{by_speed}*"));
    let drag =
        "[[define.magnet.forces]]\ncoordinate = \"x\"\nexpression = \"SIGN 3 [N s/m]*x_dot\"\n";
    for (sign, expected) in [("-", vec![]), ("", vec!["no force feeds every motion".to_owned()])] {
        let (_folder, path) = written(&[&text, "\n", &drag.replace("SIGN", sign)].concat());
        assert_eq!(failed(&rows(&path, &[]).1), expected);
    }
}

/// The third derivative of the prescribed motion jumps at the start of the run.
#[test]
fn what_is_imposed_from_the_start_on_passes() {
    let hoist = r#"
        [scene]
        name = "hoist"
        [units.crane]
        unit = "crane"
        [initial]
        "crane.th" = "5 [deg]"
        [run]
        until = 5
        points = 51
        rtol = 1e-9
        [define.crane.coordinates]
        th = { unit = "rad" }
        l = { unit = "m" }
        [define.crane.parameters]
        mass = { value = 300, unit = "kg" }
        [define.crane.energy]
        kinetic = "mass/2*(l_dot^2 + (l*th_dot)^2)"
        potential = "-mass*9.81 [m/s^2]*l*cos(th)"
        [define.crane.constraints.hoist]
        expression = "l - (10 [m] - 4 [m]*smooth_step(t/8 [s]))"
    "#;
    let (_folder, path) = written(hoist);
    assert_eq!(failed(&rows(&path, &[]).1), Vec::<String>::new());
}

/// Pendulum of length l(t) that is held by a torque or swings.
fn pendulum(length: &str, torque: &str, start: &str) -> String {
    format!(
        r#"
        [scene]
        name = "pendulum"
        [units.p]
        unit = "pendulum"
        [initial]
        {start}
        [run]
        until = 4
        points = 41
        rtol = 1e-9
        [define.pendulum.coordinates]
        th = {{ unit = "rad" }}
        [define.pendulum.parameters]
        mass = {{ value = 0.3, unit = "kg" }}
        torque = {{ value = 0.5, unit = "N m" }}
        damping = {{ value = 0.001, unit = "N m s/rad" }}
        [define.pendulum.helpers]
        l = {{ expression = "{length}", unit = "m" }}
        [define.pendulum.energy]
        kinetic = "mass*(der(l*sin(th))^2 + der(l*cos(th))^2)/2"
        potential = "-mass*9.81 [m/s^2]*l*cos(th)"
        dissipation = "damping*th_dot^2/2"
        [[define.pendulum.forces]]
        coordinate = "th"
        expression = "{torque}"
        "#
    )
}

/// At rest, only errors of steps and rounding cause motion, and no row takes those as a scale.
#[test]
fn what_rests_passes() {
    let rests = pendulum("0.25 [m]", "torque", "from = \"equilibrium\"\n\"p.th\" = \"20 [deg]\"");
    let linkage = r#"
        [scene]
        name = "linkage"
        [units]
        crank = { unit = "planar/link", parameters = { length = 0.2, mass = 1, inertia = 0.0033 } }
        coupler = { unit = "planar/link", parameters = { length = 0.5, mass = 2, inertia = 0.042 } }
        rocker = { unit = "planar/link", parameters = { length = 0.35, mass = 1.5, inertia = 0.015 } }
        o = { unit = "planar/fixed" }
        d = { unit = "planar/anchor", parameters = { place_x = 0.45 } }
        spring = { unit = "rotational/spring_damper", parameters = { stiffness = 30, damping = 0.2 } }
        frame = { unit = "rotational/fixed" }
        [[joints]]
        connect = ["crank.phi", "spring.a"]
        [[joints]]
        connect = ["spring.b", "frame.a"]
        [[joints]]
        connect = ["o.a", "crank.a"]
        [[joints]]
        connect = ["crank.b", "coupler.a"]
        [[joints]]
        connect = ["coupler.b", "rocker.b"]
        [[joints]]
        connect = ["rocker.a", "d.a"]
        [initial]
        from = "equilibrium"
        [guess]
        "crank.phi" = 1.05
        "coupler.x_a" = 0.1
        "coupler.y_a" = 0.17
        "coupler.x_b" = 0.55
        "coupler.y_b" = 0.3
        "coupler.phi" = 0.3
        "rocker.phi" = 1.2
        "rocker.x_a" = 0.45
        [run]
        until = 2
        points = 41
        rtol = 1e-9
    "#;
    for text in [&*rests, linkage] {
        let (_folder, path) = written(text);
        let (_, rows) = rows(&path, &[]);
        assert_eq!(failed(&rows), Vec::<&str>::new());
        let account = rows.iter().find(|(name, _)| name.starts_with("energy account"));
        assert_eq!(account.map(|(_, pass)| *pass), Some(Some(true)));
    }
}

/// A rope that is wound up does work on its load, in either direction of swing.
#[test]
fn what_is_wound_up_with_time_is_no_force_that_feeds() {
    let forces = "no force feeds every motion";
    let start = "\"p.th\" = \"10 [deg]\"";
    let of = |length: &str, torque: &str| {
        let (_folder, path) = written(&pendulum(length, torque, start));
        let (_, rows) = rows(&path, &[]);
        let row = rows.iter().find(|(name, _)| name == forces).expect("a row").1;
        (row, failed(&rows).iter().map(|name| (*name).to_owned()).collect::<Vec<_>>())
    };
    let winding = "12 [m] - 0.5 [m/s]*t";
    assert_eq!(of(winding, "0*torque"), (None, vec![]));
    assert_eq!(of("12 [m]", "0*torque"), (Some(true), vec![]));
    let feeding = "0.003 [N m s/rad]*th_dot";
    assert_eq!(of("0.25 [m]", feeding), (Some(false), vec![forces.to_owned()]));
}

/// Rounding may put an output time on either side of a switch, which is no error of a derivative.
#[test]
fn times_of_a_run_at_which_something_switches_are_left_out() {
    let switched = r#"
        [scene]
        name = "switched"
        [units.m]
        unit = "coil"
        [define.coil.coordinates]
        phi = { unit = "rad" }
        [define.coil.parameters]
        J = { value = 4e-6, unit = "kg m^2" }
        b = { value = 2e-4, unit = "N m s" }
        R = { value = 2, unit = "ohm" }
        L = { value = 3e-3, unit = "H" }
        U = { value = 6, unit = "V" }
        K = { value = 0.01, unit = "V s" }
        rate = { value = 200, unit = "1/s" }
        acc = { value = 2000, unit = "1/s^2" }
        [define.coil.helpers]
        steps = { expression = "piecewise(t < rate/acc, acc*t^2/2, rate*t - rate^2/(2*acc))", unit = "1" }
        u = { expression = "U*piecewise(mod(steps, 4) < 1, 1, mod(steps, 4) < 3, -1, 1)", unit = "V" }
        [define.coil.states.i]
        unit = "A"
        rate = "(u - R*i - K*phi_dot)/L"
        [define.coil.energy]
        kinetic = "J*phi_dot^2/2"
        dissipation = "b*phi_dot^2/2"
        stored = "L*i^2/2"
        [define.coil.power]
        supplied = "u*i"
        dissipated = "R*i^2"
        [[define.coil.forces]]
        coordinate = "phi"
        expression = "K*i"
        conversion = true
        [run]
        until = 0.5
        points = 501
        rtol = 1e-6
    "#;
    let (_folder, path) = written(switched);
    let (_, all) = rows(&path, &[]);
    assert_eq!(failed(&all), Vec::<&str>::new());
    for name in
        ["dy'/dp along the run and around it", "sensitivities to the parameters that matter most"]
    {
        let row = all.iter().find(|(row, _)| row == name).expect("a row");
        assert_eq!(row.1, Some(true), "{name}");
    }
}

/// Switches at output times are on different sides for two derivations, by rounding alone; and a rate that
/// depends on time by switches only has derivatives that are zero.
#[test]
fn a_drive_that_time_switches_is_checked_between_its_switches() {
    let drive = |force: &str| {
        format!(
            r#"
            [scene]
            name = "drive"
            [units.m]
            unit = "driven"
            [define.driven.coordinates.x]
            unit = "m"
            [define.driven.parameters]
            m = {{ value = 1, unit = "kg" }}
            c = {{ value = 2, unit = "N s/m" }}
            F = {{ value = 5, unit = "N" }}
            T = {{ value = 0.01, unit = "s" }}
            [define.driven.energy]
            kinetic = "m*x_dot^2/2"
            dissipation = "c*x_dot^2/2"
            [[define.driven.forces]]
            coordinate = "x"
            expression = "{force}"
            [run]
            until = 1
            "#
        )
    };
    for force in [
        "piecewise(mod(t, T) < 0.3*T, F, 0*F)",
        "F*sign(sin(2*pi*t/T))",
        "F*floor(mod(t, 2*T)/T)",
        "F*(step(t, 20*T) - step(t, 50*T))",
    ] {
        let (_folder, path) = written(&drive(force));
        let (_, all) = rows(&path, &[]);
        assert_eq!(failed(&all), Vec::<&str>::new(), "{force}");
        for name in ["independent derivation", "time derivative along the run and around it"] {
            let row = all.iter().find(|(row, _)| row == name).expect("a row");
            assert_eq!(row.1, Some(true), "{force}: {name}");
        }
    }
}
