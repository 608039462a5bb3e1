//! Specs, tables, expressions and units of measure made by damaging good ones. Each is read as a
//! system that contains only numbers, or rejected with a message, in time and without a panic.

use std::sync::Arc;
use std::time::Duration;

use fastrand::Rng;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline::compile;
use machinist_codegen::scene::compose;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_codegen::spec::load_scene;
use machinist_codegen::spec::measure::Measure;

use machinist_model::file::{Stamped, read, write};

use crate::common::describe;
use crate::damaged_model::refused_or_run;
use crate::mutation::{Fuzz, Rule, damage, expression, pick, texts};

/// Folder to which other folders are relative.
const ROOT: &str = env!("CARGO_MANIFEST_DIR");
const PATIENCE: Duration = Duration::from_secs(2);
/// Marks the beginning of each file of a bundle: a spec is damaged together with the units and
/// tables it names.
const FILE: &str = "#=== ";
/// Allowed paths for the files of a bundle; any other is replaced by that of the scene.
const PLACES: [&str; 4] = ["scenes/made.toml", "units/made.toml", "scenes/a.csv", "scenes/b.csv"];
const TABLE: &str = "time [s],force [N]\n0,0\n1,40\n2,0\n4,-20.5\n";

fn read_bundle(input: &[u8]) -> Result<bool, String> {
    read_system(input).map(|system| system.is_some())
}

/// Writes the files of a bundle, and reads the scene; `None` if it is rejected as it should be.
fn read_system(input: &[u8]) -> Result<Option<LagrangianSystem>, String> {
    let folder = tempfile::tempdir().expect("temporary folder");
    for name in ["scenes", "units"] {
        std::fs::create_dir(folder.path().join(name)).expect("a folder");
    }
    let mut files: Vec<(&str, Vec<u8>)> = Vec::new();
    for line in input.split_inclusive(|byte| *byte == b'\n') {
        let mark = line.strip_prefix(FILE.as_bytes()).map(<[u8]>::trim_ascii);
        let place = PLACES.into_iter().find(|place| mark == Some(place.as_bytes()));
        match (place, files.last_mut()) {
            (Some(place), _) => files.push((place, Vec::new())),
            (None, Some((_, text))) => text.extend_from_slice(line),
            (None, None) => files.push((PLACES[0], line.to_vec())),
        }
    }
    for (place, text) in files {
        std::fs::write(folder.path().join(place), text).expect("a file");
    }
    let scene = folder.path().join(PLACES[0]);
    match load_scene(&scene).and_then(|spec| compose(&spec)) {
        Ok(system) => holds_numbers(&system).map(|()| Some(system)),
        Err(errors) => {
            let report = errors.render();
            let told = errors.errors().iter().all(|error| !error.message.trim().is_empty());
            match () {
                () if errors.errors().is_empty() || !told => Err("refused without words".into()),
                () if report.trim().is_empty() => Err("an empty report".to_owned()),
                () if report.len() > 400_000 => Err("a report too long to read".to_owned()),
                () => Ok(None),
            }
        }
    }
}

/// Checks that all numbers of a system are finite, both in memory and in print.
fn holds_numbers(system: &LagrangianSystem) -> Result<(), String> {
    let mut numbers: Vec<(&str, f64)> =
        system.parameters.iter().map(|p| ("a parameter", p.value)).collect();
    numbers.extend(system.coordinates.iter().flat_map(|c| c.scale).map(|s| ("a scale", s)));
    numbers.extend(system.first_order.iter().map(|z| ("a scale", z.scale)));
    let run = &system.run;
    numbers.extend([run.from, run.until, run.rtol].map(|number| ("the run", number)));
    for table in &system.tables {
        numbers.extend(table.knots.iter().map(|knot| ("a knot", *knot)));
        let coefficients = table.coefficients.as_flattened();
        numbers.extend(coefficients.iter().map(|number| ("a cubic", *number)));
    }
    for field in &system.fields {
        let places = field.attachments.iter().map(|at| at.x).chain([field.length_value]);
        numbers.extend(places.chain(field.scale).map(|number| ("a field", number)));
    }
    if let Some((what, number)) = numbers.iter().find(|(_, number)| !number.is_finite()) {
        return Err(format!("{what} is {number}"));
    }
    if !(run.until > run.from && run.rtol > 0.0 && run.points >= 2) {
        return Err("a run that makes no sense".to_owned());
    }
    // The user's texts are on lines that begin otherwise.
    let kinds = ["  initial", "  rate", "T =", "V =", "D =", "Q =", "stored", "supplied", "dissip"];
    let printed = describe(system);
    let mut lines = printed.lines().filter(|line| kinds.iter().any(|kind| line.starts_with(kind)));
    let is_none = |line: &&str| {
        let mut words = line.split(|c: char| !c.is_alphanumeric() && c != '_' && c != '.');
        words.any(|word| word == "NaN" || word == "inf")
    };
    lines.find(is_none).map_or(Ok(()), |line| Err(format!("no number in: {line:.200}")))
}

#[test]
fn damaged_specs_are_read_to_numbers_or_refused() {
    let scenes = texts(ROOT, &["../specs/scenes", "tests/pass"], "toml");
    let bad = texts(ROOT, &["tests/fail"], "toml");
    let units = texts(ROOT, &["../specs/units"], "toml");
    let make = move |rng: &mut Rng| {
        let begun = if rng.u32(0..5) == 0 { &bad } else { &scenes };
        let scene = pick(rng, begun).expect("a scene");
        let others = if rng.bool() { &scenes } else { &units };
        let other = pick(rng, others).expect("another");
        let mut bundle = format!("{FILE}scenes/made.toml\n{scene}\n");
        if rng.u32(0..8) == 0 {
            // The unit of some instance is defined by the user.
            let unit = pick(rng, &units).expect("a unit");
            let own = "[units.own]\nunit = \"made\"\n";
            bundle.extend([own, FILE, "units/made.toml\n", unit]);
        } else if bundle.contains(".csv") {
            let tables = bundle.replace("wind.csv", "a.csv").replace("speeds.csv", "b.csv");
            bundle = format!("{tables}{FILE}scenes/a.csv\n{}", TABLE.replace("force", "push"));
            bundle.extend([FILE, "scenes/b.csv\ntime [s],speed [rad/s]\n-1,1\n3,1\n"]);
        }
        damage(rng, bundle.as_bytes(), other.as_bytes())
    };
    let rule: Rule = Arc::new(read_bundle);
    Fuzz { name: "specs", few: 150, patience: PATIENCE }.run(make, &rule);
}

/// Returns a machine of one mass with places for an expression and a table.
fn machine(expression: &str, table: &str) -> Vec<u8> {
    format!(
        "{FILE}scenes/made.toml\n\
         [scene]\nname = \"made\"\n\
         [define.mass.coordinates.x]\nunit = \"m\"\n\
         [define.mass.parameters.m]\nvalue = 1\nunit = \"kg\"\n\
         [define.mass.inputs.push]\nunit = \"N\"\n\
         [define.mass.energy]\nkinetic = \"m*x_dot^2/2\"\n\
         [[define.mass.forces]]\ncoordinate = \"x\"\nexpression = \"push\"\n\
         [define.mass.states.z]\nunit = \"1\"\nrate = \"x_dot/(1 [m])\"\n\
         [units.body]\nunit = \"mass\"\ninputs = {{ push = \"made*(1 [N])\" }}\n\
         [parameters.a]\nvalue = 2\nunit = \"1\"\n\
         [parameters.b]\nvalue = 0\nunit = \"1\"\n\
         [helpers.made]\nexpression = '''{expression}'''\nunit = \"1\"\n\
         [outputs]\nx = \"body.x\"\n\
         [run]\nuntil = 1\npoints = 3\nrtol = 1e-6\nmethod = \"auto\"\n\
         {FILE}scenes/a.csv\n{table}"
    )
    .into_bytes()
}

#[test]
fn random_expressions_are_read_to_numbers_or_refused() {
    let make = |rng: &mut Rng| {
        let names = ["a", "b", "body.z", "body.x/(1 [m])", "body.x_dot/(1 [m/s])", "t/(1 [s])"];
        let names = names.map(str::to_owned);
        let depth = [2, 3, 5, 7][rng.usize(0..4)];
        let text = expression(rng, &names, depth);
        // Whatever the units of its numbers are, some expression of dimensionless numbers is
        // left.
        let text = if rng.bool() { text } else { pure(&text) };
        machine(&text, TABLE)
    };
    let rule: Rule = Arc::new(read_bundle);
    Fuzz { name: "expressions", few: 150, patience: PATIENCE }.run(make, &rule);
}

/// Derives the system that was read too, and runs its model.
fn derive(input: &[u8]) -> Result<bool, String> {
    let Some(system) = read_system(input)? else { return Ok(false) };
    match compile(system, Keep::Needed) {
        Ok(model) => {
            let bytes = write(&Stamped { generator: "a test".to_owned(), model });
            refused_or_run(&bytes)?;
            read(&bytes).map(|_| true).map_err(|error| error.to_string())
        }
        Err(errors) if errors.errors().iter().all(|error| error.message.is_empty()) => {
            Err("refused without words".to_owned())
        }
        Err(_) => Ok(false),
    }
}

#[test]
fn machines_of_random_expressions_are_derived_and_run() {
    // Only small ones: anything made of them is derived quickly, or without bound.
    let scenes = texts(ROOT, &["tests/pass", "../specs/scenes/parts"], "toml");
    let make = move |rng: &mut Rng| {
        if rng.u32(0..3) == 0 {
            let [scene, other] = [(); 2].map(|()| pick(rng, &scenes).expect("a scene"));
            return damage(rng, scene.as_bytes(), other.as_bytes());
        }
        let names = ["a", "b", "body.z", "body.x/(1 [m])", "body.x_dot/(1 [m/s])", "t/(1 [s])"];
        let depth = [1, 2, 3, 4][rng.usize(0..4)];
        machine(&pure(&expression(rng, &names.map(str::to_owned), depth)), TABLE)
    };
    let rule: Rule = Arc::new(derive);
    // Others may derive meanwhile, and only one at a time.
    let patience = Duration::from_secs(30);
    Fuzz { name: "derived", few: 40, patience }.run(make, &rule);
}

/// Makes the numbers and times of an expression dimensionless, as far as the text shows them.
fn pure(text: &str) -> String {
    let mut kept = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(" [") {
        kept.push_str(before);
        let (unit, after) = after.split_once(']').unwrap_or((after, ""));
        let stays = matches!(unit, "m" | "m/s" | "s");
        if stays {
            kept.extend([" [", unit, "]"]);
        }
        rest = after;
    }
    kept + rest
}

#[test]
fn damaged_tables_are_read_to_numbers_or_refused() {
    let tables = texts(ROOT, &["tests/pass", "tests/fail", "../specs"], "csv");
    let make = move |rng: &mut Rng| {
        let short = |text: &str| text.lines().take(30).collect::<Vec<_>>().join("\n");
        let other = short(pick(rng, &tables).expect("a table"));
        let table = damage(rng, TABLE.as_bytes(), other.as_bytes());
        let mut bundle = machine("table('a.csv', 'force', t)/(1 [N])", "");
        bundle.extend(table);
        bundle
    };
    let rule: Rule = Arc::new(read_bundle);
    Fuzz { name: "tables", few: 150, patience: PATIENCE }.run(make, &rule);
}

#[test]
fn damaged_units_of_measure_are_read_or_refused() {
    let rule: Rule = Arc::new(|input: &[u8]| {
        let text = String::from_utf8_lossy(input);
        let unit = match Measure::parse(&text) {
            Ok(unit) => unit,
            Err(error) if error.message.trim().is_empty() => return Err("no words".to_owned()),
            Err(_) => return Ok(false),
        };
        let (unit, written) = (unit.unit.dimension, unit.unit.dimension.as_unit());
        // A product may have a higher power than units may be written with.
        match Measure::parse(&written) {
            Ok(again) if again.unit.dimension != unit => {
                Err(format!("{text} is written {written}, which reads as another"))
            }
            _ => Ok(true),
        }
    });
    let make = |rng: &mut Rng| {
        let units = ["kg m^2", "N m/rad", "N m s/rad", "m^(1/2)", "V s", "1/s", "W/(m^2 K)", "mol"];
        let [one, other] = [(); 2].map(|()| units[rng.usize(0..units.len())]);
        damage(rng, format!("{one} {other}").as_bytes(), other.as_bytes())
    };
    Fuzz { name: "units", few: 500, patience: PATIENCE }.run(make, &rule);
}
