//! `machinist check`: errors in specs.

use std::fmt::Write;
use std::path::Path;

use clap::Args;
use machinist::constraints;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_contract::Describe as _;
use machinist_model::file::Stamped;
use machinist_model::{Model, ModelSimulator};

use super::arguments::DeriveArgs;
use super::output::print;
use super::scene::{BENCH, SceneSource};
use super::specs;
use crate::deriving;
use crate::failure::{Failure, all};
use crate::spec_source::SpecSource;

#[derive(Debug, Args)]
pub struct Check {
    /// Scene files, folders of them, or names of scenes
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<String>,
    #[command(flatten)]
    derivation: DeriveArgs,
}

impl Check {
    pub fn execute(&self) -> Result<(), Failure> {
        self.derivation.apply();
        let (mut files, mut text) = (Vec::<SpecSource>::new(), String::new());
        for path in &self.paths {
            if Path::new(path).is_dir() {
                files.extend(specs::scene_files(Path::new(path))?);
                files.extend(specs::scene_files_below(Path::new(path), BENCH)?);
                continue;
            }
            match SceneSource::of(path)? {
                SceneSource::Spec(file) => files.push(file),
                // A model file is checked when read.
                SceneSource::Model(stamped) => {
                    let Stamped { generator, model } = *stamped;
                    let name = model.name;
                    let _ = writeln!(text, "{path}: ok, model of {name}, made by {generator}");
                }
            }
        }
        let systems = all(&files, SpecSource::system)?;
        systems.iter().for_each(deriving::warn);
        for (file, system) in files.iter().zip(&systems) {
            let found = found(system, || deriving::model(file, Keep::All))?;
            let _ = writeln!(text, "{file}: {found}");
        }
        print(&text)
    }
}

/// Returns the summary of a valid spec. `model` returns the complete model, which is only needed
/// for constraints.
pub fn found(
    system: &LagrangianSystem,
    model: impl FnOnce() -> Result<Model, Failure>,
) -> Result<String, Failure> {
    Ok(format!("{}{}", counted(system), constraints(system, model)?))
}

/// Returns the numbers of coordinates, states, parameters and outputs of a valid spec.
pub fn counted(system: &LagrangianSystem) -> String {
    format!(
        "ok, {} coordinates, {} first-order states, {} parameters, {} outputs",
        system.coordinates.len(),
        system.first_order.len(),
        system.parameters.len(),
        system.outputs.len(),
    )
}

/// Returns the number of constraints and the degrees of freedom that they leave at the start.
fn constraints(
    system: &LagrangianSystem,
    model: impl FnOnce() -> Result<Model, Failure>,
) -> Result<String, Failure> {
    if system.constraints.is_empty() {
        return Ok(String::new());
    }
    if !system.handed.is_empty() {
        // The degrees of freedom of fields depend on their discretization.
        return Ok(format!(", {} constraints", system.constraints.len()));
    }
    let simulator = ModelSimulator::new(model()?);
    let parameters: Vec<f64> = system.parameters.iter().map(|parameter| parameter.value).collect();
    let time = system.run.from;
    let start = constraints::start(&simulator, &parameters, time);
    let start = start.map_err(|error| Failure::input(error, ""))?;
    let Some(mobility) = constraints::mobility(&simulator, &parameters, time, &start) else {
        return Ok(String::new());
    };
    let counted = format!(
        "{} constraints, mobility {} by rank and {} by Gruebler's count",
        mobility.constraints,
        mobility.by_rank(),
        mobility.by_count(),
    );
    match mobility.redundant.iter().find(|redundant| !redundant.is_shared) {
        None => {
            let state = all_holding(system, &simulator, start);
            let all = constraints::mobility(&simulator, &parameters, time, &state);
            let redundant = all.iter().flat_map(|mobility| &mobility.redundant);
            let shares = redundant.filter(|redundant| redundant.is_shared);
            let shares: Vec<String> = shares
                .map(|redundant| format!("; where it holds, {}", redundant.shares()))
                .collect();
            Ok(format!(", {counted}{}", shares.concat()))
        }
        Some(redundant) => {
            let (name, constraint) = (&system.name, &redundant.constraint);
            let message = format!("{name}: constraint `{constraint}` {}", redundant.why());
            Err(Failure::input(message, format!("{}; {counted}", redundant.hint())))
        }
    }
}

/// Sets the modes to those of the constraints, as far as these can apply together. Of constraints
/// that exclude each other, the first counts.
fn all_holding(
    system: &LagrangianSystem,
    simulator: &ModelSimulator,
    mut state: Vec<f64>,
) -> Vec<f64> {
    let mut set = vec![false; state.len()];
    for constraint in &system.constraints {
        let modes: Vec<(usize, f64)> = constraint
            .when
            .iter()
            .filter_map(|(id, value)| {
                let name = &system.first_order[id.0 as usize].quantity.name.path;
                let entry = (0..state.len()).find(|k| simulator.state(*k).name == *name)?;
                Some((entry, f64::from(*value)))
            })
            .collect();
        let is_free =
            |(entry, value): &(usize, f64)| !set[*entry] || (state[*entry] - value).abs() < 0.5;
        if modes.iter().all(is_free) {
            for (entry, value) in modes {
                (set[entry], state[entry]) = (true, value);
            }
        }
    }
    state
}
