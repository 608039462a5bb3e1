//! Reduction of a scene does not change its outputs.

use std::path::{Path, PathBuf};

use machinist::{Method, Simulation, Trajectory};
use machinist_app::object::Compiler;
use machinist_codegen::emit::EmitOptions;
use machinist_codegen::emit::rust::emit;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_contract::{Describe as _, Simulator as _};
use machinist_model::Model;
use machinist_model::ModelSimulator;
use machinist_model::{What, Why};

/// Scene file with a given text, in a folder that lasts as long as it.
pub struct Spec {
    folder: tempfile::TempDir,
}

impl Spec {
    pub fn new(text: &str) -> Self {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("scene.toml"), text).expect("written");
        std::fs::write(folder.path().join("wind.csv"), "time [s],load [N m]\n0,0\n1,2\n2,1\n")
            .expect("written");
        Spec { folder }
    }

    fn program(&self, keep: Keep) -> Model {
        program(&self.folder.path().join("scene.toml"), keep)
    }

    pub fn needed(&self) -> Model {
        self.program(Keep::Needed)
    }
}

fn program(path: &Path, keep: Keep) -> Model {
    match pipeline::generate(path, keep) {
        Ok(program) => program,
        Err(errors) => panic!("{}", errors.render()),
    }
}

fn scenes() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/scenes");
    let entries = std::fs::read_dir(folder).expect("the folder of scenes");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    paths.sort();
    paths
}

pub fn scene(name: &str) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../specs/scenes/{name}.toml"));
    program(&path, Keep::Needed)
}

pub fn states(program: &Model) -> Vec<&str> {
    program
        .states
        .iter()
        .map(|state| &state.quantity)
        .map(|quantity| quantity.name.path.as_str())
        .collect()
}

fn left_out(program: &Model, what: What, why: Why) -> Vec<&str> {
    let left_out = program.reduction.left_out.iter();
    let these = left_out.filter(|thing| thing.what == what && thing.why == why);
    these.map(|thing| thing.name.as_str()).collect()
}

/// Runs a model with errors near rounding.
fn run(program: &Model, until: Option<f64>) -> Trajectory {
    let simulator = ModelSimulator::new(program.clone());
    let states = simulator.shape().states();
    let until = until.unwrap_or(simulator.run_defaults().until);
    let run = Simulation::new(&simulator).until(until).points(41).rtol(1e-13);
    run.atol(&vec![1e-14; states]).method(Method::Dop853).run().expect("the run")
}

/// Returns the largest difference of an output from the unreduced scene's, relative to its largest
/// value.
fn distance(needed: &Model, all: &Model, until: Option<f64>) -> f64 {
    let (needed_run, all_run) = (run(needed, until), run(all, until));
    let mut largest: f64 = 0.0;
    assert!(!all.wanted.is_empty());
    for output in &all.wanted {
        let name = &output.name.path;
        let column = |run: &Trajectory| run.column(name).expect("the output").to_vec();
        let (ours, theirs) = (column(&needed_run), column(&all_run));
        let size = theirs.iter().fold(0.0_f64, |size, value| size.max(value.abs()));
        for (a, b) in ours.iter().zip(&theirs) {
            let distance = (a - b).abs() / size.max(f64::MIN_POSITIVE);
            assert!(distance <= 1e-9, "{}: {name}: {a} for {b}", all.name);
            largest = largest.max(distance);
        }
    }
    largest
}

/// Asserts at some states that the power balance closes and that the Jacobian is that of the rate.
fn assert_sound(program: &Model) {
    let simulator = ModelSimulator::new(program.clone());
    let shape = simulator.shape();
    let parameters: Vec<f64> =
        (0..shape.parameters).map(|index| simulator.parameter_default(index)).collect();
    for sample in 0..8_u32 {
        let value = |index: usize| (f64::from(sample) * 1.7 + index as f64 * 0.9 + 0.3).sin();
        let state: Vec<f64> = (0..shape.states()).map(value).collect();
        let time = 0.17 * f64::from(sample);
        let power = simulator.power_balance(time, &state, &parameters);
        let size = power.stored_rate.abs() + power.supplied.abs() + power.dissipated.abs();
        let residual = power.residual().abs();
        assert!(residual <= 1e-12 * size.max(1e-3), "{}: {power:?}", program.name);
        assert_derivative(&simulator, time, &state, &parameters);
    }
}

/// Compares the rate Jacobian with central differences.
fn assert_derivative(simulator: &ModelSimulator, time: f64, state: &[f64], parameters: &[f64]) {
    let pattern = simulator.rate_jacobian_pattern();
    let mut values = vec![0.0; pattern.entries.len()];
    simulator.rate_jacobian(time, state, parameters, &mut values);
    let rate = |state: &[f64]| {
        let mut rate = vec![0.0; state.len()];
        simulator.rate(time, state, parameters, &mut rate);
        rate
    };
    for column in 0..state.len() {
        let step = 1e-5;
        let (mut ahead, mut behind) = (state.to_vec(), state.to_vec());
        ahead[column] += step;
        behind[column] -= step;
        let (ahead, behind) = (rate(&ahead), rate(&behind));
        for row in 0..state.len() {
            let place = (row as u32, column as u32);
            let at = pattern.entries.iter().position(|entry| *entry == place);
            let (ours, theirs) =
                (at.map_or(0.0, |at| values[at]), (ahead[row] - behind[row]) / (2.0 * step));
            let size = ours.abs().max(ahead[row].abs()).max(1.0);
            assert!((ours - theirs).abs() <= 1e-6 * size, "{place:?}: {ours} for {theirs}");
        }
    }
}

/// Returns whether all functions of both are the same, so that runs agree to the last bit.
fn computes_the_same(one: &Model, other: &Model) -> bool {
    one.states == other.states
        && one.quadratures == other.quadratures
        && one.parameters == other.parameters
        && one.tables == other.tables
        && one.initial_state == other.initial_state
        && one.discontinuities == other.discontinuities
        && one.rate == other.rate
        && one.outputs == other.outputs
}

#[test]
fn every_scene_gives_the_outputs_of_its_unreduced_twin() {
    for path in scenes() {
        let (needed, all) = (program(&path, Keep::Needed), program(&path, Keep::All));
        assert!(needed.states.len() <= all.states.len());
        assert!(all.reduction.left_out.is_empty());
        if computes_the_same(&needed, &all) {
            continue;
        }
        // From the start, where motors switch on. `explain` compares whole runs.
        let run = &all.run;
        let until = run.from + 0.25 * (run.until - run.from);
        println!("{}: {:.1e}", all.name, distance(&needed, &all, Some(until)));
    }
}

#[test]
fn the_motor_alone_has_no_angle() {
    let motor = scene("motor_run_up");
    assert_eq!(motor.states.len(), 5);
    assert_eq!(left_out(&motor, What::State, Why::Cyclic), ["motor.phi"]);
    assert_sound(&motor);
}

#[test]
fn the_saw_gin_has_a_twist_in_place_of_two_angles() {
    let gin = scene("saw_gin");
    assert_eq!(gin.states.len(), 7);
    assert_eq!(states(&gin)[..3], ["coupling.twist", "motor.omega", "cylinder.omega"]);
    assert_eq!(left_out(&gin, What::State, Why::Cyclic), ["cylinder.phi"]);
    assert_eq!((gin.positions(), gin.quadratures), (1, 0));
    assert_sound(&gin);
}

pub const GIN: &str = r#"
[scene]
name = "gin"
[units.motor]
unit = "textile/induction_motor"
[units.coupling]
unit = "coupling"
[units.cylinder]
unit = "rotor"
[units.load]
unit = "textile/technological_load"
[[joints]]
connect = ["motor.shaft", "coupling.driving"]
[[joints]]
connect = ["cylinder.shaft", "coupling.driven"]
[[joints]]
connect = ["cylinder.shaft", "load.shaft"]
[run]
until = 2.0
points = 21
rtol = 1e-8
method = "tsit45"
[outputs]
speed = "cylinder.omega"
"#;

#[test]
fn an_angle_asked_for_is_integrated_last_and_is_the_same() {
    let spec = Spec::new(&format!("{GIN}\nangle = \"cylinder.phi\"\nother = \"motor.phi\"\n"));
    let (needed, all) = (spec.needed(), spec.program(Keep::All));
    assert_eq!(needed.states.len(), 8);
    assert_eq!(needed.quadratures, 1);
    assert_eq!(states(&needed)[7], "cylinder.phi");
    let columns = needed.rate_jacobian.pattern.entries.iter().map(|(_, column)| *column);
    assert!(columns.clone().all(|column| column != 7), "no rate depends on it");
    assert_sound(&needed);
    let until = Some(0.5);
    let (ours, theirs) = (run(&needed, until), run(&all, until));
    for name in ["angle", "other"] {
        let (ours, theirs) = (ours.column(name).unwrap(), theirs.column(name).unwrap());
        for (a, b) in ours.iter().zip(theirs) {
            assert!((a - b).abs() <= 1e-10, "{name}: {a} for {b}");
        }
    }
}

#[test]
fn a_unit_that_no_output_reaches_leaves_no_trace() {
    let with_reed = GIN.replace(
        "[run]",
        "[units.reed]\nunit = \"reed\"\n[define.reed.coordinates.bend]\nunit = \"rad\"\n\
         [define.reed.parameters.mass]\nvalue = 0.3\nunit = \"kg m^2\"\n\
         [define.reed.parameters.stiffness]\nvalue = 900.0\nunit = \"N m\"\n\
         [define.reed.parameters.plucked]\nvalue = 0.2\nunit = \"s\"\n\
         [define.reed.helpers.wind]\nunit = \"N m\"\n\
         expression = \"table(\\\"wind.csv\\\", \\\"load\\\", t)*step(t, plucked)\"\n\
         [define.reed.energy]\nkinetic = \"mass*bend_dot^2/2\"\npotential = \"stiffness*bend^2/2\"\n\
         [[define.reed.forces]]\ncoordinate = \"bend\"\nexpression = \"wind\"\n\
         [initial]\n\"reed.bend\" = 0.1\n[run]",
    );
    let spec = Spec::new(&with_reed);
    let (needed, all) = (spec.needed(), spec.program(Keep::All));
    assert_eq!(all.states.len(), 10);
    assert_eq!(left_out(&needed, What::State, Why::Unreachable), ["reed.bend", "reed.bend_dot"]);
    assert_eq!(left_out(&needed, What::Unit, Why::Unreachable), ["reed"]);
    assert_eq!(left_out(&needed, What::Table, Why::Unreachable).len(), 1);
    assert_eq!(left_out(&needed, What::Jump, Why::Unreachable).len(), 1);
    assert_eq!(
        left_out(&needed, What::Parameter, Why::Unreachable),
        ["reed.mass", "reed.stiffness", "reed.plucked"]
    );
    assert_sound(&needed);
    // Without comments, which name the files and describe the scene.
    let text = emit(&needed, &EmitOptions::for_scenes()).expect("emitted");
    assert!(!text.contains("reed"), "{text}");
    assert!(!holds(&compiled(&needed), "reed"), "the object file has a name of the reed");
    assert!(holds(&compiled(&all), "reed"), "and has none where the reed is kept");
    let without = Spec::new(GIN).needed();
    assert_eq!(needed.rate, without.rate);
    assert_eq!(needed.energy, without.energy);
    assert_eq!(needed.power_balance, without.power_balance);
}

fn compiled(program: &Model) -> Vec<u8> {
    Compiler::new().expect("a compiler").object(program).expect("compiled")
}

fn holds(object: &[u8], name: &str) -> bool {
    object.windows(name.len()).any(|bytes| bytes.eq_ignore_ascii_case(name.as_bytes()))
}

#[test]
fn a_scene_holds_no_name_of_units_it_is_not_made_of() {
    for (name, absent, present) in [
        ("two_mass", ["motor", "reed", "holder"], "coupling"),
        ("motor_run_up", ["twist", "cylinder", "shaft"], "motor"),
        ("winder_linear", ["motor", "twist", "reed"], "holder"),
    ] {
        let program = scene(name);
        let text = emit(&program, &EmitOptions::for_scenes()).expect("emitted");
        // Comments name the sources and describe the machine.
        let code: String = text.lines().filter(|line| !line.trim().starts_with("//")).collect();
        let object = compiled(&program);
        for absent in absent {
            assert!(!code.contains(absent), "{name}: {absent} is in the emitted text");
            assert!(!holds(&object, absent), "{name}: {absent} is in the object file");
        }
        assert!(code.contains(present) && holds(&object, present), "{name} lacks {present}");
    }
}

#[test]
fn a_jump_stays_where_something_kept_jumps() {
    let text = GIN.replace(
        "[run]",
        "[parameters.on]\nvalue = 0.1\nunit = \"s\"\n[[forces]]\nport = \"motor.shaft\"\n\
         expression = \"1 [N m]*step(t, on)\"\n[run]",
    );
    let spec = Spec::new(&text);
    let needed = spec.needed();
    // In addition to the time about which the load engages.
    let without = Spec::new(GIN).needed().discontinuities.results.len();
    assert_eq!((without, needed.discontinuities.results.len()), (1, 2));
    distance(&needed, &spec.program(Keep::All), Some(0.2));
}

pub const CHAIN: &str = r#"
[scene]
name = "chain"
[units]
a = { unit = "rotor", parameters = { inertia = 2.0 } }
b = { unit = "rotor", parameters = { inertia = 0.7 } }
c = { unit = "rotor", parameters = { inertia = 0.3 } }
first = { unit = "coupling", parameters = { stiffness = 40.0, damping = 0.3, ratio = 2.0 } }
second = { unit = "coupling", parameters = { stiffness = 90.0, damping = 0.1, ratio = 0.5 } }
[[joints]]
connect = ["a.shaft", "first.driving"]
[[joints]]
connect = ["b.shaft", "first.driven"]
[[joints]]
connect = ["b.shaft", "second.driving"]
[[joints]]
connect = ["c.shaft", "second.driven"]
[[forces]]
port = "a.shaft"
expression = "3 [N m]*sin(2 [rad/s]*t)"
[initial]
"a.phi" = 0.3
"c.omega" = 1.5
[run]
until = 3.0
points = 11
rtol = 1e-8
method = "tsit45"
[outputs]
speed = "c.omega"
torque = "second.torque"
twist = "first.twist"
"#;

#[test]
fn a_chain_with_ratios_has_one_position_less() {
    let spec = Spec::new(CHAIN);
    let needed = spec.needed();
    assert_eq!((needed.states.len(), needed.positions()), (5, 2));
    distance(&needed, &spec.program(Keep::All), None);
    assert_sound(&needed);
}

#[test]
fn two_chains_apart_lose_a_position_each_and_both_angles_come_back() {
    let other = CHAIN
        .replace("\na = {", "\nd = { unit = \"rotor\" }\na = {")
        .replace(
            "\nfirst = {",
            "\ne = { unit = \"rotor\" }\nf = { unit = \"coupling\" }\nfirst = {",
        )
        .replace(
            "[run]",
            "\"d.omega\" = 2.0\n[[joints]]\nconnect = [\"d.shaft\", \"f.driving\"]\n\
             [[joints]]\nconnect = [\"e.shaft\", \"f.driven\"]\n[run]",
        );
    let spec = Spec::new(&format!("{other}other = \"f.torque\"\n"));
    let needed = spec.needed();
    assert_eq!((needed.states.len(), needed.positions()), (8, 3));
    distance(&needed, &spec.program(Keep::All), Some(1.0));
    assert_sound(&needed);
    let spec = Spec::new(&format!(
        "{other}other = \"f.torque\"\n\
         both = {{ expression = \"a.phi + sin(e.phi)*d.phi\", unit = \"rad\" }}\n"
    ));
    let needed = spec.needed();
    assert_eq!((needed.states.len(), needed.quadratures), (10, 2));
    distance(&needed, &spec.program(Keep::All), Some(1.0));
    assert_sound(&needed);
}

/// Two rotors with a force on the first, which is also the output.
pub fn pair(force: &str) -> Spec {
    Spec::new(&format!(
        "[scene]\nname = \"pair\"\n[units]\na = {{ unit = \"rotor\" }}\nb = {{ unit = \"rotor\" }}\n\
         [[forces]]\nport = \"a.shaft\"\nexpression = \"{force}\"\n\
         [[forces]]\nport = \"b.shaft\"\nexpression = \"-({force})\"\n\
         [initial]\n\"a.phi\" = 0.4\n\"b.omega\" = 0.5\n\
         [outputs]\nspeed = \"a.omega\"\n\
         [run]\nuntil = 1.0\npoints = 11\nrtol = 1e-8\nmethod = \"tsit45\"\n"
    ))
}

#[test]
fn functions_and_conditions_of_relative_positions_are_seen_through() {
    for force in [
        "-2 [N m]*tanh(a.phi - b.phi)",
        "-2 [N m]*max(a.phi - b.phi, 0.1)^2",
        "-2 [N m]*sign(a.phi - b.phi)*(1 + (a.phi - b.phi)^2)/(3 + cos(b.phi - a.phi))",
    ] {
        let spec = pair(force);
        let needed = spec.needed();
        assert_eq!(states(&needed), ["a.phi_relative", "a.omega", "b.omega"], "{force}");
        if !force.contains("sign") {
            distance(&needed, &spec.program(Keep::All), None);
            assert_sound(&needed);
        }
    }
}

#[test]
fn functions_and_conditions_of_absolute_positions_keep_them() {
    for force in [
        "-2 [N m]*tanh(a.phi - b.phi)*sin(a.phi)",
        "-2 [N m]*max(a.phi, 0.1)*(a.phi - b.phi)",
        "-2 [N m]*(a.phi - b.phi)*sign(a.phi)",
        "-2 [N m]*(a.phi - 0.5*b.phi)/(1 + (a.phi - b.phi)^2)",
    ] {
        assert_eq!(pair(force).needed().states.len(), 4, "{force}");
    }
}

#[test]
fn a_weight_that_hangs_without_being_asked_for_is_a_force_from_outside() {
    let spec = Spec::new(
        "[scene]\nname = \"hoist\"\n[units.weight]\nunit = \"weight\"\n\
         [define.weight.coordinates.height]\nunit = \"m\"\n\
         [define.weight.parameters.mass]\nvalue = 3.0\nunit = \"kg\"\n\
         [define.weight.parameters.drag]\nvalue = 0.5\nunit = \"kg/s\"\n\
         [define.weight.energy]\nkinetic = \"mass*height_dot^2/2\"\n\
         potential = \"mass*9.81 [m/s^2]*height\"\ndissipation = \"drag*height_dot^2/2\"\n\
         [outputs]\nspeed = \"weight.height_dot\"\n\
         [run]\nuntil = 1.0\npoints = 11\nrtol = 1e-8\nmethod = \"tsit45\"\n",
    );
    let needed = spec.needed();
    assert_eq!(states(&needed), ["weight.height_dot"]);
    assert_sound(&needed);
    distance(&needed, &spec.program(Keep::All), None);
}

#[test]
fn a_first_order_state_that_only_listens_goes_and_the_balance_still_closes() {
    let spec = Spec::new(
        "[scene]\nname = \"filter\"\n[units.circuit]\nunit = \"circuit\"\n\
         [define.circuit.parameters.l]\nvalue = 0.2\nunit = \"H\"\n\
         [define.circuit.parameters.r]\nvalue = 3.0\nunit = \"ohm\"\n\
         [define.circuit.states.i]\nunit = \"A\"\nrate = \"(5 [V]*sin(3 [rad/s]*t) - r*i)/l\"\ninitial = \"1 [A]\"\n\
         [define.circuit.states.j]\nunit = \"A\"\nrate = \"(i - j)*4 [1/s]\"\ninitial = \"2 [A]\"\n\
         [define.circuit.energy]\nstored = \"l*i^2/2 + l*(i - j)^2/2\"\n\
         [define.circuit.power]\nsupplied = \"5 [V]*sin(3 [rad/s]*t)*i\"\n\
         dissipated = \"r*i^2 - l*(i - j)*((5 [V]*sin(3 [rad/s]*t) - r*i)/l - (i - j)*4 [1/s])\"\n\
         [outputs]\ncurrent = \"circuit.i\"\n\
         [run]\nuntil = 1.0\npoints = 11\nrtol = 1e-8\nmethod = \"tsit45\"\n",
    );
    let (needed, all) = (spec.needed(), spec.program(Keep::All));
    assert_eq!(states(&needed), ["circuit.i"]);
    assert_sound(&all);
    assert_sound(&needed);
    distance(&needed, &all, None);
}

#[test]
fn a_state_that_is_only_counted_stands_last() {
    let spec = Spec::new(
        "[scene]\nname = \"meter\"\n[units.circuit]\nunit = \"circuit\"\n\
         [define.circuit.states.charge]\nunit = \"C\"\nrate = \"i\"\n\
         [define.circuit.states.i]\nunit = \"A\"\nrate = \"-i*2 [1/s]\"\ninitial = \"1 [A]\"\n\
         [outputs]\ncharge = \"circuit.charge\"\n\
         [run]\nuntil = 1.0\npoints = 11\nrtol = 1e-8\nmethod = \"tsit45\"\n",
    );
    let needed = spec.needed();
    assert_eq!(states(&needed), ["circuit.i", "circuit.charge"]);
    assert_eq!(needed.quadratures, 1);
    distance(&needed, &spec.program(Keep::All), None);
}

#[test]
fn fixed_parameters_become_numbers_and_zeros_take_their_terms_with_them() {
    let undamped =
        CHAIN.replace("damping = 0.3", "damping = 0.0").replace("ratio = 2.0", "ratio = 1.0");
    let spec = Spec::new(&format!("{undamped}\n[tunable]\nparameters = [\"a.inertia\"]\n"));
    let (needed, all) = (spec.needed(), spec.program(Keep::All));
    let parameters = needed.parameters.iter();
    let parameters: Vec<&str> = parameters.map(|p| p.quantity.name.path.as_str()).collect();
    assert_eq!(parameters, ["a.inertia"]);
    assert_eq!(left_out(&needed, What::Parameter, Why::Zero), ["first.damping"]);
    assert_eq!(left_out(&needed, What::Parameter, Why::Fixed).len(), 7);
    let operations = machinist_model::operations;
    assert!(operations(&needed.rate) < operations(&Spec::new(&undamped).needed().rate));
    distance(&needed, &all, None);
    assert_sound(&needed);
    let spec = Spec::new(&format!("{undamped}\n[tunable]\nparameters = []\n"));
    assert!(spec.needed().parameters.is_empty());
    distance(&spec.needed(), &all, None);
}

#[test]
fn a_fixed_parameter_that_would_divide_by_zero_stays() {
    let text = CHAIN.replace(
        "[run]",
        "[parameters.width]\nvalue = 0.0\nunit = \"s\"\n[parameters.on]\nvalue = 0.5\nunit = \"s\"\n\
         [[forces]]\nport = \"b.shaft\"\n\
         expression = \"piecewise(t < on, 1 [N m], 2 [N m] + 0*(t/(width + t)))\"\n\
         [[forces]]\nport = \"c.shaft\"\nexpression = \"min(1, t/width)*1 [N m]\"\n[tunable]\nparameters = []\n[run]",
    );
    let needed = Spec::new(&text).needed();
    let parameters = needed.parameters.iter();
    let parameters: Vec<&str> = parameters.map(|p| p.quantity.name.path.as_str()).collect();
    assert_eq!(parameters, ["width"]);
}

#[test]
fn a_scene_without_outputs_keeps_its_states() {
    let text = CHAIN.split("[outputs]").next().expect("the rest");
    assert_eq!(Spec::new(text).needed().states.len(), 6);
}

fn frozen(outputs: &str, tolerance: &str) -> Spec {
    let text = GIN.replace("speed = \"cylinder.omega\"\n", outputs).replace(
        "[run]",
        &format!("[freeze]\nrigid = [\"coupling\"]\ntolerance = {tolerance}\n[run]"),
    );
    Spec::new(&text)
}

#[test]
fn a_rigid_coupling_makes_two_rotors_one() {
    let spec = frozen("speed = \"cylinder.omega\"\nmotor = \"motor.omega\"\n", "0.05");
    let (needed, exact) = (spec.needed(), spec.program(Keep::Exact));
    assert_eq!((needed.states.len(), exact.states.len()), (5, 7));
    assert_eq!(left_out(&needed, What::State, Why::Frozen), ["motor.phi", "motor.omega"]);
    let unneeded = left_out(&needed, What::Parameter, Why::Unreachable);
    assert_eq!(unneeded, ["coupling.stiffness", "coupling.damping"]);
    assert_sound(&needed);
    let (ours, theirs) = (run(&needed, Some(1.0)), run(&exact, Some(1.0)));
    let (ours, theirs) = (ours.last("speed").unwrap(), theirs.last("speed").unwrap());
    assert!((ours - theirs).abs() < 1e-2 * theirs, "{ours} for {theirs}");
    assert!((ours - theirs).abs() > 1e-12 * theirs, "freezing changes something");
}

#[test]
fn what_does_not_hold_a_ratio_or_does_not_start_at_rest_is_not_frozen() {
    let refused = |text: &str| {
        let spec = Spec::new(text);
        let path = spec.folder.path().join("scene.toml");
        pipeline::generate(&path, Keep::Needed).expect_err("refused").render()
    };
    let freeze = |unit: &str| format!("\n[freeze]\nrigid = [\"{unit}\"]\ntolerance = 0.1\n");
    let moving = format!("{CHAIN}{}", freeze("second"));
    assert!(refused(&moving).contains("not at rest at the start"));
    let springless = format!("{CHAIN}{}", freeze("a"));
    assert!(refused(&springless).contains("no potential energy of two coordinates"));
}
