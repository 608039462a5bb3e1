//! `machinist list`: the scenes that are built in.

use clap::Args;
use machinist_scenes::scenes;

use super::output::{columns, print};
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
        print(&columns(&rows, 2))
    }
}
