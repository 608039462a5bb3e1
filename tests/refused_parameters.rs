//! Runs refuse parameter values that would be refused in a spec.

use machinist::error::StopCause;
use machinist::linear_analysis::{Place, operating_point};
use machinist::sweep::{InLanes, Sweep, Sweepable};
use machinist::{Discretisation, FieldSimulator, SimulateError, Simulation};
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::{Describe as _, Simulator};
use machinist_model::{ModelSimulator, file};

use crate::own_scene::{of_text, refusal};

/// A motor, a gear and a load, with more of the gear and of the joint behind it; `unused` is read
/// by nothing.
fn geared(ratio: &str, of_joint: &str, base: &str) -> String {
    format!(
        r#"
        [scene]
        name = "geared"
        [units.motor]
        unit = "rotational/inertia"
        [units.gear]
        unit = "rotational/gear"
        parameters = {{ ratio = {ratio} }}
        [units.load]
        unit = "rotational/inertia"
        [units.drive]
        unit = "sources/torque"
        inputs = {{ torque = "3 [N m]" }}
        [[joints]]
        connect = ["drive.a", "motor.a"]
        [[joints]]
        connect = ["motor.b", "gear.a"]
        [[joints]]
        connect = ["gear.b", "load.a"]
        ratio = "{of_joint}"
        [parameters]
        teeth = {{ value = 20, unit = "1" }}
        base = {{ value = {base}, unit = "1" }}
        unused = {{ value = 1, unit = "m" }}
        [outputs]
        motor = "motor.omega"
        load = "load.omega"
        [run]
        until = 0.1
        points = 3
        "#
    )
}

/// Returns machines, each with a value that its spec refuses.
fn machines() -> Vec<(ModelSimulator, &'static str, f64, &'static str)> {
    let of = |ratio: &str, of_joint: &str| of_text(&geared(ratio, of_joint, "4"), Keep::Needed);
    vec![
        (of("5", "1"), "gear.ratio", 0.0, "the ratio of port `gear.a` is a number other than 0"),
        (of("\"teeth/base\"", "1"), "teeth", 0.0, "the ratio of port `gear.a`"),
        (of("\"teeth/base\"", "1"), "base", 0.0, "is a finite number"),
        (of("\"sqrt(base)\"", "1"), "base", -1.0, "parameter `gear.ratio` is a finite number"),
        (of("5", "base - 3"), "base", 3.0, "the ratio of the joint of `gear.b` and `load.a`"),
    ]
}

fn refused<T>(result: Result<T, SimulateError>, rule: &str, value: f64) {
    let Err(error) = result else { panic!("{rule}: {value} was not refused") };
    let SimulateError::RefusedParameters { rule: told, .. } = &error else { panic!("{error}") };
    assert!(told.contains(rule), "{error}");
    assert!(error.to_string().starts_with("scene `geared`: "), "{error}");
}

#[test]
fn a_run_refuses_what_its_spec_would_refuse() {
    for (machine, name, value, rule) in machines() {
        let run = || Simulation::new(&machine).parameter(name, value);
        refused(run().and_then(|run| run.run()), rule, value);
        refused(run().and_then(|run| run.in_equilibrium(true).run()), rule, value);
        let mut all: Vec<f64> =
            (0..machine.shape().parameters).map(|k| machine.parameter_default(k)).collect();
        let place = (0..all.len()).find(|k| machine.parameter(*k).name == name);
        all[place.expect("a parameter")] = value;
        refused(Simulation::new(&machine).parameters(&all).run(), rule, value);
        let near = value.abs() + 0.5;
        assert!(Simulation::new(&machine).parameter(name, near).and_then(|run| run.run()).is_ok());
        let point = run().map(|run| operating_point(&run, Place::Initial).map(|_| ()));
        let said = point.expect("a parameter").expect_err("refused").to_string();
        assert!(said.contains(rule), "{said}");
    }
}

/// A model with two variants at a time or one.
struct Swept(ModelSimulator, bool);

impl Sweepable for Swept {
    fn single(&self) -> &dyn Simulator<f64> {
        &self.0
    }
    fn in_lanes(&self) -> Option<InLanes<'_>> {
        self.1.then_some(InLanes::Two(self.0.in_pairs()))
    }
}

#[test]
fn a_sweep_refuses_only_the_variants_that_make_no_machine() {
    for in_lanes in [false, true] {
        for (machine, name, value, rule) in machines() {
            let machine = Swept(machine, in_lanes);
            let near = value.abs() + 0.5;
            let values = [near, value, near + 0.25];
            let outcomes = Sweep::new(&machine).vary(name, &values).expect("known").run();
            assert!(outcomes[0].is_ok() && outcomes[2].is_ok(), "{name}");
            let said = outcomes[1].as_ref().expect_err("refused").to_string();
            assert!(said.contains(rule), "{said}");
        }
    }
}

#[test]
fn the_spec_itself_is_refused_by_the_same_values() {
    for (text, words) in [
        (geared("0", "1", "4"), "a ratio must be a number other than 0"),
        (
            geared("\"teeth/base\"", "1", "0"),
            "a ratio must be a number other than 0, but this one is inf",
        ),
        (
            geared("\"sqrt(base)\"", "1", "-1"),
            "a ratio must be a number other than 0, but this one is NaN",
        ),
        (geared("5", "base - 3", "3"), "a ratio must be a number other than 0"),
    ] {
        let said = refusal(&text);
        assert!(said.contains(words), "{said}");
    }
}

#[test]
fn model_files_keep_what_is_refused() {
    for (machine, name, value, rule) in machines() {
        let stamped =
            file::Stamped { generator: "test".to_owned(), model: machine.model().clone() };
        let read = file::read(&file::write(&stamped)).expect("it is whole");
        let read = ModelSimulator::new(read.model);
        let run = Simulation::new(&read).parameter(name, value);
        refused(run.and_then(|run| run.run()), rule, value);
    }
}

/// A shaft as long as its parameter says, with a port on it.
#[test]
fn a_field_has_a_length_and_its_ports_are_on_it() {
    let machine = of_text(
        r#"
        [scene]
        name = "geared"
        [units.shaft]
        unit = "shaft"
        fields = { phi = { elements = 2, order = 2, start = "fixed" } }
        [run]
        until = 1e-4
        points = 2
        [define.shaft.fields.phi]
        unit = "rad"
        over = "length"
        kinetic = "1 [kg m]*phi_dot^2/2"
        potential = "1 [N m^2]*phi_x^2/2"
        [define.shaft.ports.hub]
        kind = "rotational"
        field = "phi"
        at = "from_start"
        [define.shaft.parameters]
        length = { value = 1.0, unit = "m" }
        from_start = { value = 0.5, unit = "m" }
        "#,
        Keep::All,
    );
    let cut = FieldSimulator::new(machine.with_fields(), Discretisation::default());
    let cut = cut.expect("elements");
    let run = |name: &str, value: f64| {
        let run = Simulation::new(&cut).parameter(name, value);
        run.and_then(|run| run.until(1e-5).run())
    };
    refused(run("shaft.length", 0.0), "the length of field `shaft.phi` is above 0 m", 0.0);
    refused(run("shaft.length", 0.25), "beyond port `shaft.hub`", 0.25);
    refused(run("shaft.from_start", -0.5), "the place of port `shaft.hub`", -0.5);
}

#[test]
fn a_parameter_that_nothing_uses_is_told_to_be_unused() {
    let machine = of_text(&geared("5", "1", "4"), Keep::Needed);
    for name in ["unused", "teeth", "base"] {
        let refused = Simulation::new(&machine).parameter(name, 2.0).err();
        let refused = refused.expect("nothing uses it");
        let said = refused.to_string();
        assert!(
            said.contains(&format!("nothing in scene `geared` uses parameter `{name}`")),
            "{said}"
        );
    }
    let unknown = Simulation::new(&machine).parameter("gear.ration", 2.0).err().expect("unknown");
    assert!(unknown.to_string().contains("has no parameter `gear.ration`"), "{unknown}");
}

/// Every parameter of machines of standard parts is set to values that no such machine has. A run
/// that stops at its start because a rate is not finite names the parameter.
#[test]
fn a_parameter_that_leaves_rates_without_a_value_is_named() {
    let scenes = ["drives/winch", "parts/rotational/lossy_gear", "parts/control/pi_controller"]
        .into_iter()
        .chain(["parts/electrical/induction_motor", "parts/hydraulic/valve", "two_mass"]);
    let mut named = Vec::new();
    for scene in scenes {
        let path = format!("{}/../specs/scenes/{scene}.toml", env!("CARGO_MANIFEST_DIR"));
        let text = std::fs::read_to_string(path).expect("a scene");
        let machine = of_text(&text, Keep::Needed);
        for index in 0..machine.shape().parameters {
            let name = machine.parameter(index).name.to_owned();
            for value in [0.0, -1.0] {
                let Ok(run) = Simulation::new(&machine).parameter(&name, value) else { continue };
                let until = machine.run_defaults().from + 1e-9;
                let run = run.until(until).max_steps(10_000).run();
                let Err(SimulateError::Stopped { cause, time, .. }) = run else { continue };
                let StopCause::NotFinite { what, parameters } = &cause else { continue };
                if time == 0.0 && what.starts_with("the rate") {
                    assert!(parameters.contains(&(name.clone(), value)), "{scene} {name}: {cause}");
                    let words = format!("because parameter `{name}` is {value}");
                    assert!(cause.to_string().contains(&words), "{cause}");
                    named.push(name.clone());
                }
            }
        }
    }
    for name in ["gear.ratio", "load.mass", "controller.integral_time", "motor.inductance"] {
        assert!(named.iter().any(|one| one == name), "{name}: {named:?}");
    }
}
