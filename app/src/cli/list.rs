//! `machinist list`: the scenes and machines that are built in.

use clap::Args;
use machinist_scenes::scenes;

use super::output::{columns, print};
use super::scene::machines;
use super::table::{SECTION, columns_of_section, paragraph};
use crate::failure::Failure;

#[derive(Debug, Args)]
pub struct List {}

impl List {
    #[expect(clippy::unused_self, reason = "alike for all commands")]
    pub fn execute(&self) -> Result<(), Failure> {
        let found = scenes::NAMES.iter().filter_map(|name| scenes::find_f64(name));
        let with_fields =
            scenes::FIELD_NAMES.iter().filter_map(|name| scenes::find_field_f64(name));
        let row = |name: &str, title: &str| [name.to_owned(), title.to_owned()];
        let mut rows: Vec<[String; 2]> =
            found.map(|scene| row(scene.name(), scene.title())).collect();
        rows.extend(with_fields.map(|scene| row(scene.name(), scene.title())));
        rows.sort();
        let machines: Vec<[String; 2]> = machines().map(|[name, title]| row(name, title)).collect();
        if machines.is_empty() {
            return print(&columns(&rows, 2));
        }
        let mut text = section("Emitted simulators", &rows);
        text.push_str(&section("\nMachines of standard parts, derived when they run", &machines));
        text.push('\n');
        for hint in [
            "Every standard part has an example: `machinist parts`, `machinist parts show NAME`.",
            "`machinist new NAME --from MACHINE` starts from one of the machines.",
        ] {
            text.push_str(&paragraph(hint));
        }
        print(&text)
    }
}

fn section(heading: &str, rows: &[[String; 2]]) -> String {
    let rows = columns_of_section(rows, 2);
    rows.lines().fold(format!("{heading}\n"), |text, line| text + SECTION + line + "\n")
}
