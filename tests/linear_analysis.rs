#![expect(clippy::float_cmp, reason = "numbers that must come out exactly")]

use machinist_contract::Describe as _;
use machinist_scenes::scenes::motor_run_up::MotorRunUp;
use machinist_scenes::scenes::saw_gin::SawGin;
use machinist_scenes::scenes::two_mass::TwoMass;
use num_complex::Complex64;

use machinist::Simulation;
use machinist::complex_step;
use machinist::linear_analysis::{
    LinearError, Linearization, Mode, ModeKind, Place, Point, SecondOrder, logarithmic_range,
    operating_point,
};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_model::ModelSimulator;
use machinist_studies::closed_form::induction_motor::MOTOR_4A280M8;
use machinist_studies::closed_form::two_mass::SAW_GIN;
use nalgebra::DMatrix;

use crate::own_scene::of_text;

/// Returns two masses under balanced torques.
fn two_mass() -> Simulation<'static> {
    let run = Simulation::new(&TwoMass).parameter("drive_torque", 843.72);
    run.expect("the scene has it")
}

fn rate(simulator: &dyn Simulator<f64>, point: &Point) -> Vec<f64> {
    let mut rate = vec![0.0; point.state.len()];
    simulator.rate(point.time, &point.state, &point.parameters, &mut rate);
    rate
}

fn at_equilibrium<'a>(run: &Simulation<'a>) -> Linearization<'a> {
    let point = operating_point(run, Place::Equilibrium).expect("there is an equilibrium");
    Linearization::at(run.simulator(), point).expect("it is regular")
}

#[test]
fn a_machine_at_constant_speed_is_in_equilibrium_while_its_angle_grows() {
    let point = operating_point(&two_mass(), Place::Equilibrium).expect("in balance");
    let [found, driver_speed, cylinder_speed] = point.state[..] else { panic!() };
    let twist = SAW_GIN.static_twist(843.72, 843.72);
    assert!((found - twist).abs() < 1e-15 + 1e-12 * twist);
    assert!((driver_speed - cylinder_speed).abs() <= 1e-12 * driver_speed.abs());
    assert!(rate(&TwoMass, &point)[1].abs() < 1e-9);
}

#[test]
fn a_machine_that_accelerates_has_no_equilibrium_and_the_rates_left_are_named() {
    let error = operating_point(&Simulation::new(&TwoMass), Place::Equilibrium).unwrap_err();
    let LinearError::NoEquilibrium { residuals, .. } = &error else { panic!("{error}") };
    assert_eq!(residuals.len(), 2);
    assert!(residuals.iter().any(|residual| residual.state == "driver.omega"));
    assert!(error.to_string().contains("driver.omega"), "{error}");
}

#[test]
fn two_masses_swing_as_one_damped_oscillator_and_turn_freely() {
    let modes = at_equilibrium(&two_mass()).modes().expect("eigenvalues");
    let kinds: Vec<ModeKind> = modes.iter().map(|mode| mode.kind).collect();
    assert_eq!(kinds, [ModeKind::Free, ModeKind::Free, ModeKind::Oscillation]);
    let swing = &modes[2];
    let (w, d) = (SAW_GIN.natural_frequency(), SAW_GIN.damping_ratio());
    assert!((swing.natural_frequency() / w - 1.0).abs() < 1e-13);
    assert!((swing.damping_ratio() / d - 1.0).abs() < 1e-13);
    assert!(swing.residual < 1e-14);
    // No momentum: J_d phi_d + J_2 phi_2 = 0; shares as the opposite inertias.
    let ratio = -SAW_GIN.driven_inertia / SAW_GIN.driver_inertia;
    assert!((swing.shape[0][0] - ratio).abs() < 1e-12 && swing.shape[0][1].abs() < 1e-12);
    assert_eq!(swing.shape[1], [1.0, 0.0]);
    assert!((swing.shares[1] - 4.2 / (4.2 + 1.244)).abs() < 1e-12);
    // Velocities are eigenvalue times angle.
    let velocity = Complex64::new(swing.shape[3][0], swing.shape[3][1]);
    assert!((velocity - swing.eigenvalue()).norm() < 1e-10);
}

#[test]
fn motions_account_for_every_state_and_for_the_trace() {
    let run = Simulation::new(&SawGin);
    let gin = at_equilibrium(&run);
    let modes = gin.modes().expect("eigenvalues");
    let count = |mode: &Mode| if mode.kind == ModeKind::Oscillation { 2 } else { 1 };
    // Both angles are accounted for, though the state holds but their difference.
    assert_eq!(modes.iter().map(count).sum::<usize>(), SawGin.shape().states() + 1);
    let sum: f64 = modes.iter().map(|mode| mode.real * count(mode) as f64).sum();
    assert!((sum / gin.matrix().expect("small").trace() - 1.0).abs() < 1e-12);
    for mode in &modes {
        assert!(mode.residual < 1e-12, "{mode:?}");
        assert!((mode.shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    }
}

#[test]
fn the_motor_settles_at_the_speed_where_its_torque_is_the_load() {
    let run = Simulation::new(&MotorRunUp);
    let point = operating_point(&run, Place::Equilibrium).expect("it runs empty");
    let speed = point.state[MotorRunUp.shape().positions];
    assert!((speed / MOTOR_4A280M8.synchronous_speed() - 1.0).abs() < 1e-12, "{speed}");
}

#[test]
fn mechanics_have_the_matrices_written_by_hand() {
    let second_order = || at_equilibrium(&two_mass()).second_order().expect("small");
    let SecondOrder { mass, damping, stiffness } = second_order();
    let coupled = |value: f64| DMatrix::from_row_slice(2, 2, &[value, -value, -value, value]);
    assert!((mass - DMatrix::from_row_slice(2, 2, &[4.2, 0.0, 0.0, 1.244])).amax() < 1e-15);
    assert!((damping - coupled(128.5346)).amax() < 1e-12);
    assert!((&stiffness - coupled(23_065.2)).amax() < 1e-9);
    let frequencies = second_order().undamped_frequencies().expect("M is positive");
    assert_eq!(frequencies[0], 0.0);
    assert!((frequencies[1] / SAW_GIN.natural_frequency() - 1.0).abs() < 1e-13);
}

#[test]
fn the_twist_answers_a_harmonic_load_as_the_closed_form_says() {
    let linear = at_equilibrium(&two_mass());
    let frequencies = logarithmic_range(1.0, 1e4, 41).expect("a range");
    let by_parameter = linear.response("load_torque", "twist", &frequencies).expect("known");
    let by_force = linear.response("cylinder.phi", "twist", &frequencies).expect("known");
    for (index, frequency) in frequencies.iter().enumerate() {
        let exact = SAW_GIN.harmonic_response(1.0, *frequency);
        for response in [&by_parameter, &by_force] {
            assert!((response.amplitudes[index] / exact.amplitude - 1.0).abs() < 1e-11);
        }
        assert!((by_parameter.phases[index] + exact.phase_lag).abs() < 1e-11);
    }
    assert_eq!((by_force.from_unit.as_str(), by_force.to_unit.as_str()), ("N m", "rad"));
}

#[test]
fn a_slow_variation_moves_outputs_as_the_equilibrium_moves() {
    let run = |voltage: f64| {
        let run = Simulation::new(&SawGin).parameter("motor.phase_voltage", voltage);
        run.expect("the scene has it")
    };
    let speed = |voltage: f64| {
        let point = operating_point(&run(voltage), Place::Equilibrium).expect("it runs");
        point.state[SawGin.shape().positions]
    };
    let slope = (speed(220.1) - speed(219.9)) / 0.2;
    let nominal = run(220.0);
    let response = at_equilibrium(&nominal).response("motor.phase_voltage", "motor.omega", &[1e-4]);
    let response = response.expect("known");
    let found = response.amplitudes[0] * response.phases[0].cos();
    assert!((found / slope - 1.0).abs() < 1e-4, "{found} is not {slope}");
}

#[test]
fn derivatives_of_outputs_agree_with_the_complex_step() {
    let run = Simulation::new(&SawGin);
    let gin = at_equilibrium(&run);
    let Point { time, state, parameters } = gin.point().clone();
    for output in 0..SawGin.shape().outputs {
        let found = gin.output_derivatives(output);
        for (index, found) in found.iter().enumerate() {
            let lifted = |values: &[f64], at: Option<usize>| -> Vec<complex_step::ComplexStep> {
                let number = |i: usize| {
                    Complex64::new(values[i], if at == Some(i) { complex_step::STEP } else { 0.0 })
                };
                (0..values.len()).map(|i| complex_step::ComplexStep(number(i))).collect()
            };
            let mut outputs = lifted(&vec![0.0; SawGin.shape().outputs], None);
            let time = complex_step::ComplexStep(Complex64::from(time));
            let (state, parameters) = (lifted(&state, Some(index)), lifted(&parameters, None));
            machinist_contract::Simulator::outputs(
                &SawGin,
                time,
                &state,
                &parameters,
                &mut outputs,
            );
            let exact = outputs[output].derivative();
            assert!(
                (found - exact).abs() <= 1e-10 * exact.abs().max(1e-3),
                "output {output}, state {index}: {found} is not {exact}"
            );
        }
    }
}

#[test]
fn unknown_names_and_bad_ranges_are_refused_with_what_may_be_meant() {
    let linear = at_equilibrium(&two_mass());
    let refused = |from, to| linear.response(from, to, &[1.0]).unwrap_err().to_string();
    let text = refused("load_torqe", "twist");
    assert!(text.contains("load_torqe") && text.contains("did you mean `load_torque`?"), "{text}");
    assert!(refused("load_torque", "twits").contains("did you mean `twist`?"));
    for (from, until, points) in [
        (0.0, 1.0, 10),
        (-1.0, 1.0, 10),
        (2.0, 1.0, 10),
        (1.0, f64::INFINITY, 10),
        (f64::NAN, 1.0, 10),
        (1.0, 2.0, 1),
        (1.0, 2.0, usize::MAX),
    ] {
        let refused = logarithmic_range(from, until, points);
        assert!(matches!(refused, Err(LinearError::BadRange { .. })), "{from} {until} {points}");
    }
    // Their ratio is beyond what a number holds.
    let range = logarithmic_range(1e-320, 1e300, 32).expect("a range");
    assert!(range.is_sorted() && range.iter().all(|frequency| frequency.is_finite()), "{range:?}");
}

#[test]
fn a_point_that_does_not_fit_the_scene_is_refused() {
    let point = Point { time: 0.0, state: vec![0.0; 7], parameters: vec![0.0; 9] };
    let refused = Linearization::at(&TwoMass, point).err();
    assert!(matches!(refused, Some(LinearError::WrongLength { what: "states", .. })));
    let massless = Simulation::new(&TwoMass).parameter("driver.inertia", 0.0).expect("known");
    let point = operating_point(&massless, Place::Initial).expect("nothing is computed");
    let refused = Linearization::at(&TwoMass, point).err();
    assert!(matches!(refused, Some(LinearError::NotFinite { .. })), "{refused:?}");
}

#[test]
fn places_are_read_from_text() {
    assert_eq!("initial".parse(), Ok(Place::Initial));
    assert_eq!("equilibrium".parse(), Ok(Place::Equilibrium));
    assert_eq!("t=0.25".parse(), Ok(Place::Time(0.25)));
    for bad in ["", "t=", "t=x", "t=inf", "0.25", "Initial"] {
        assert!(bad.parse::<Place>().is_err(), "{bad}");
    }
}

#[test]
fn a_soft_spring_beside_a_stiff_one_is_no_free_motion() {
    let text = r#"
        [scene]
        name = "rotors"
        [units]
        a = { unit = "rotor", parameters = { inertia = 1.0 } }
        b = { unit = "rotor", parameters = { inertia = 1.0 } }
        stiff = { unit = "coupling", parameters = { damping = 0.0, ratio = 1.0 } }
        [units.soft]
        unit = "soft"
        [define.soft.coordinates.x]
        unit = "rad"
        [define.soft.ports.end]
        kind = "rotational"
        coordinate = "x"
        [define.soft.energy]
        potential = "1 [N m]*x^2/2"
        [[joints]]
        connect = ["a.shaft", "stiff.driving"]
        [[joints]]
        connect = ["b.shaft", "stiff.driven"]
        [[joints]]
        connect = ["a.shaft", "soft.end"]
        [run]
        until = 1.0
        points = 11
        rtol = 1e-6
        method = "auto"
    "#;
    let rotors = of_text(text, Keep::All);
    for stiffness in [1e4, 1e8, 1e9, 1e10, 1e11, 1e12] {
        let run = Simulation::new(&rotors).parameter("stiff.stiffness", stiffness).expect("one");
        let modes = at_equilibrium(&run).modes().expect("eigenvalues");
        let found: Vec<f64> = modes
            .iter()
            .filter(|mode| mode.kind == ModeKind::Oscillation)
            .map(Mode::natural_frequency)
            .collect();
        // Both swing as one on the soft spring, and against each other on the stiff one.
        let [slow, fast] = found[..] else { panic!("{stiffness}: {found:?}") };
        assert!((slow - 0.5f64.sqrt()).abs() < 1e-4, "{stiffness}: {slow}");
        assert!((fast / (2.0 * stiffness).sqrt() - 1.0).abs() < 1e-3, "{stiffness}: {fast}");
    }
}

/// Returns a damped pendulum on a cart that a spring holds, by its angle or by the position of its
/// bob on a rod, both with a first-order force on the cart.
fn cart_and_bob(by_angle: bool) -> String {
    let head = r#"
        [scene]
        name = "cart"
        [units.cart]
        unit = "cart"
        [outputs]
        place = "cart.s"
        across = "cart.across"
        lag = "cart.lag"
        [run]
        until = 1.0
        points = 11
        rtol = 1e-9
        method = "dop853"
        [define.cart.parameters]
        mass = { value = 3, unit = "kg" }
        bob = { value = 0.7, unit = "kg" }
        length = { value = 0.4, unit = "m" }
        gravity = { value = 9.81, unit = "m/s^2" }
        stiffness = { value = 250, unit = "N/m" }
        damping = { value = 2.5, unit = "N s/m" }
        wind = { value = 1.5, unit = "N" }
        push = { value = 4, unit = "N" }
        [define.cart.states.lag]
        unit = "N"
        rate = "(push - lag)/(0.05 [s])"
        initial = "push"
        [define.cart.coordinates.s]
        unit = "m"
        velocity = "v"
        "#;
    let rest = if by_angle {
        r#"
        [initial]
        "cart.phi" = 0.2
        [define.cart.coordinates.phi]
        unit = "rad"
        [define.cart.outputs.across]
        expression = "s + length*sin(phi)"
        unit = "m"
        [define.cart.energy]
        kinetic = "mass*v^2/2 + bob*((v + length*cos(phi)*phi_dot)^2 + (length*sin(phi)*phi_dot)^2)/2"
        potential = "stiffness*s^2/2 - bob*gravity*length*cos(phi)"
        dissipation = "damping*v^2/2"
        [[define.cart.forces]]
        coordinate = "s"
        expression = "lag + wind"
        conversion = true
        [[define.cart.forces]]
        coordinate = "phi"
        expression = "wind*length*cos(phi)"
        "#
    } else {
        r#"
        [initial]
        "cart.s" = 0
        [guess]
        "cart.x" = 0.1
        "cart.y" = -0.4
        [define.cart.coordinates.x]
        unit = "m"
        [define.cart.coordinates.y]
        unit = "m"
        [define.cart.constraints.rod]
        expression = "(x - s)^2 + y^2 - length^2"
        [define.cart.outputs.across]
        expression = "x"
        unit = "m"
        [define.cart.energy]
        kinetic = "mass*v^2/2 + bob*(x_dot^2 + y_dot^2)/2"
        potential = "stiffness*s^2/2 + bob*gravity*y"
        dissipation = "damping*v^2/2"
        [[define.cart.forces]]
        coordinate = "s"
        expression = "lag"
        conversion = true
        [[define.cart.forces]]
        coordinate = "x"
        expression = "wind"
        "#
    };
    format!("{head}{rest}")
}

#[test]
fn a_machine_answers_within_constraints_as_it_does_by_its_angle() {
    let machines = [true, false].map(|by_angle| of_text(&cart_and_bob(by_angle), Keep::All));
    let linear = machines.each_ref().map(|machine| {
        let run = Simulation::new(machine).in_equilibrium(true);
        let point = operating_point(&run, Place::Initial).expect("it hangs in the wind");
        Linearization::at(machine, point).expect("it is regular")
    });
    let frequencies = logarithmic_range(0.01, 1e4, 61).expect("a range");
    // The wind leans on the bob, so that the rod is tilted: phi = atan(wind/(m g)).
    let tilt = (1.5_f64 / (0.7 * 9.81)).atan();
    let hangs = linear[0].point().state.iter().any(|value| (value - tilt).abs() < 1e-12);
    assert!(hangs, "{:?}", linear[0].point().state);
    for from in ["cart.push", "cart.wind", "cart.stiffness", "cart.damping", "cart.bob", "cart.s"] {
        for to in ["place", "across", "lag", "cart.v"] {
            let [one, other] = linear
                .each_ref()
                .map(|linear| linear.response(from, to, &frequencies).expect("it answers"));
            let largest = one.amplitudes.iter().copied().fold(0.0, f64::max);
            for (index, frequency) in frequencies.iter().enumerate() {
                let polar = |response: &machinist::linear_analysis::Response| {
                    Complex64::from_polar(response.amplitudes[index], response.phases[index])
                };
                let off = (polar(&one) - polar(&other)).norm();
                let size = polar(&one).norm().max(1e-9 * largest);
                assert!(off <= 1e-8 * size, "{to} by {from} at {frequency}: {off:e}");
            }
        }
    }
    let refused = linear[1].response("cart.length", "place", &[1.0]).expect_err("a longer rod");
    assert!(matches!(refused, LinearError::MovesConstraint { .. }), "{refused}");
}

/// Returns a mass of 2 kg on a spring of 800 N/m, 20 rad/s.
fn oscillator() -> ModelSimulator {
    let text = r#"
        [scene]
        name = "oscillator"
        [units.o]
        unit = "o"
        [outputs]
        way = "o.x"
        jolt = { expression = "o.x_ddot", unit = "m/s^2" }
        [run]
        until = 1.0
        points = 11
        rtol = 1e-9
        method = "auto"
        [define.o.coordinates.x]
        unit = "m"
        [define.o.parameters]
        damping = { value = 1, unit = "N s/m" }
        force = { value = 0, unit = "N" }
        [define.o.energy]
        kinetic = "2 [kg]*x_dot^2/2"
        potential = "800 [N/m]*x^2/2"
        dissipation = "damping*x_dot^2/2"
        [[define.o.forces]]
        coordinate = "x"
        expression = "force"
        "#;
    of_text(text, Keep::All)
}

/// |H| = 1/|k - m w^2 + i d w| is largest at w_0 sqrt(1 - 2 z^2), 1/(2 z k sqrt(1 - z^2)).
#[test]
fn the_largest_answer_is_found_between_frequencies_however_sharp_it_is() {
    let oscillator = oscillator();
    for ratio in [0.5, 0.1, 1e-3, 1e-5, 1e-7] {
        let run = Simulation::new(&oscillator).parameter("o.damping", ratio * 80.0).expect("one");
        let linear = at_equilibrium(&run);
        let frequencies = logarithmic_range(3.0, 97.0, 12).expect("a range");
        for from in ["o.force", "o.x"] {
            let response = linear.response(from, "way", &frequencies).expect("it answers");
            let largest = linear.largest(from, "way", &response).expect("modes").expect("points");
            let exact = 1.0 / (2.0 * ratio * 800.0 * (1.0 - ratio * ratio).sqrt());
            assert!((largest.amplitude / exact - 1.0).abs() < 1e-8, "{ratio}: {largest:?}");
            let at = 20.0 * (1.0 - 2.0 * ratio * ratio).sqrt();
            assert!((largest.frequency / at - 1.0).abs() < 1e-6, "{ratio}: {largest:?}");
            let phase = -(ratio * 80.0 * at).atan2(800.0 - 2.0 * at * at);
            assert!((largest.phase - phase).abs() < 1e-3, "{ratio}: {largest:?}, {phase}");
        }
    }
    let run = Simulation::new(&oscillator).parameter("o.damping", 0.0).expect("one");
    let linear = at_equilibrium(&run);
    let found = |frequencies: &[f64]| {
        let response = linear.response("o.x", "way", frequencies).expect("it answers");
        linear.largest("o.x", "way", &response).expect("modes").expect("points")
    };
    let resonance = found(&[1.0, 90.0]);
    assert!(resonance.amplitude.is_infinite() && (resonance.frequency - 20.0).abs() < 1e-12);
    let below = found(&[1.0, 10.0]);
    assert_eq!(below.frequency, 10.0);
    assert!((below.amplitude - 1.0 / 600.0).abs() < 1e-15);
}

/// An acceleration answers a force at once: -w^2/(k - m w^2 + i d w), towards 1/m.
#[test]
fn an_acceleration_answers_a_parameter_and_refuses_a_force_on_a_coordinate() {
    let oscillator = oscillator();
    let linear = at_equilibrium(&Simulation::new(&oscillator));
    let frequencies = logarithmic_range(1.0, 1e4, 9).expect("a range");
    let response = linear.response("o.force", "jolt", &frequencies).expect("it answers");
    for (at, size) in frequencies.iter().zip(&response.amplitudes) {
        let exact = at * at / Complex64::new(800.0 - 2.0 * at * at, *at).norm();
        assert!((size / exact - 1.0).abs() < 1e-9, "{size} is not {exact}");
    }
    let refused = linear.response("o.x", "jolt", &frequencies).expect_err("it is left out");
    let LinearError::DirectFeedthrough { output, coordinate } = &refused else {
        panic!("{refused}")
    };
    assert_eq!((output.as_str(), coordinate.as_str()), ("jolt", "o.x"));
}
