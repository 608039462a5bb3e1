//! `machinist list`: the scenes that are built in.

use clap::Args;
use machinist_scenes::scenes;

use super::Failure;
use super::output::{columns, print};

#[derive(Debug, Args)]
pub struct List {}

impl List {
    #[expect(clippy::unused_self, reason = "alike for all commands")]
    pub fn execute(&self) -> Result<(), Failure> {
        let found = scenes::NAMES.iter().filter_map(|name| scenes::find::<f64>(name));
        let rows: Vec<[String; 2]> =
            found.map(|scene| [scene.name().to_owned(), scene.title().to_owned()]).collect();
        print(&columns(&rows, 2))
    }
}
