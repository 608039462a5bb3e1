//! Work of runs: counters of every scene, compared with the table in the book.

mod table;

use std::iter::once;
use std::path::{Path, PathBuf};

use machinist::field::{Discretisation, FieldSimulator};
use machinist::{Method, Simulation};
use machinist_bench_scenes as bench;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
use machinist_scenes::scenes;
use table::{Row, Table};

use crate::own_scene::{folder_of_specs, of_specs, specs_in};

/// Page with the table.
const PAGE: &str = "docs/book/src/work.md";

/// Methods that are checked on every emitted scene without fields: `auto` seldom chooses some of
/// them, and they take only a few seconds in total there.
const OWN: [Method; 5] =
    [Method::Tsit5, Method::Dop853, Method::Taylor, Method::Rodas5p, Method::Radau];

#[test]
fn no_scene_takes_more_work_than_the_book_says() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(PAGE);
    let now = Table { rows: names().iter().flat_map(|name| rows_of(name)).collect() };
    if std::env::var("MACHINIST_BOOK").is_ok_and(|word| word == "write") {
        let text = std::fs::read_to_string(&page).expect("the page");
        std::fs::write(&page, now.put_into(&text)).expect("written");
        return;
    }
    let told = Table::read(&std::fs::read_to_string(&page).expect("the page"));
    let differences = now.differences(&told);
    assert!(
        differences.is_empty(),
        "\n{}\nMACHINIST_BOOK=write before `cargo test -p machinist-tests --test suite work::` \
         writes {PAGE} again; what is worse needs its reason in CHANGELOG.md",
        differences.join("\n")
    );
}

/// Returns the paths of all scenes below `specs/scenes`, without extension.
fn names() -> Vec<String> {
    let root = folder_of_specs();
    let name = |path: PathBuf| {
        let name = path.strip_prefix(&root).expect("below it").with_extension("");
        name.to_str().expect("a plain path").replace('\\', "/")
    };
    let mut names: Vec<String> = specs_in(&root).into_iter().map(name).collect();
    names.sort();
    names
}

/// Returns the rows of a scene by `auto`, and by our other methods if that is cheap.
fn rows_of(name: &str) -> Vec<Row> {
    let of_kit = name.strip_prefix("bench/");
    if let Some(simulator) = of_kit.map_or_else(|| scenes::find_f64(name), bench::find_f64) {
        let own = OWN.into_iter().filter(|method| method.suits(simulator));
        return once(Method::Auto).chain(own).map(|by| row(name, by, simulator)).collect();
    }
    let field = of_kit.map_or_else(|| scenes::find_field_f64(name), bench::find_field_f64);
    if let Some(scene) = field {
        let cut = FieldSimulator::new(scene, Discretisation::default()).expect("as its spec says");
        return vec![row(name, Method::Auto, &cut)];
    }
    let simulator = of_specs(name, Keep::Needed);
    if simulator.model().fields.is_empty() {
        return vec![row(name, Method::Auto, &simulator)];
    }
    let cut = FieldSimulator::new(simulator.with_fields(), Discretisation::default());
    vec![row(name, Method::Auto, &cut.expect("as its spec says"))]
}

/// Runs with the settings of the scene's spec, except for the method.
fn row(name: &str, method: Method, simulator: &dyn Simulator<f64>) -> Row {
    let run = Simulation::new(simulator).method(method).run();
    let run = run.unwrap_or_else(|error| panic!("{name} by {}: {error}", method.name()));
    Row::new(name, method, run.work)
}
