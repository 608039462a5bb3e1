//! Options shared by commands: the scene, its derivation, the run, and limits.
//!
//! A command that runs a scene flattens [`SceneArgs`] and [`RunArgs`], one that only derives it
//! [`SourceArgs`], and one that runs it as its spec says [`TimeArgs`]. A test compares the options
//! of all commands.

use std::num::NonZeroUsize;
use std::time::Duration;

use clap::{Args, ValueEnum};
use machinist::{Discretisation, Simulation};
#[cfg(feature = "derive")]
use machinist_algebra::cas::Algebra;
#[cfg(feature = "derive")]
use machinist_codegen::mechanics::reduce::Keep;
use machinist_contract::Simulator;
#[cfg(feature = "derive")]
use machinist_model::file::Stamped;
use serde_json::{Value, json};

use super::amount::{Amount, assignment, plain, time};
use super::scene::{Loading, Scene};
#[cfg(feature = "derive")]
use super::scene::{SceneSource, stamped_opened};
use super::settings::{TIME_LIMIT, time_limit, with_method, with_parameters};
use crate::config;
#[cfg(feature = "derive")]
use crate::deriving;
use crate::failure::Failure;

/// Options for the derivation of a spec.
#[cfg(feature = "derive")]
#[derive(Debug, Clone, Default, PartialEq, Args)]
#[command(next_help_heading = "Derivation")]
pub struct DeriveArgs {
    /// Algebra used for derivation: plain or symbolica. Symbolica simplifies further, but only one
    /// process on a computer can run it. Default: symbolica for gen, derive and the report of all
    /// scenes, otherwise plain
    #[arg(long, value_name = "NAME", value_parser = algebra)]
    algebra: Option<Algebra>,
    /// Derive without reading or writing the cache
    #[arg(long)]
    no_cache: bool,
}

#[cfg(feature = "derive")]
impl DeriveArgs {
    /// Applies the options to all further derivations. The first algebra that is named counts.
    pub fn apply(&self) {
        if self.no_cache {
            deriving::turn_off_cache();
        }
        self.algebra.into_iter().for_each(deriving::derive_by);
    }
}

/// Returns the algebra of a name.
#[cfg(feature = "derive")]
pub fn algebra(name: &str) -> Result<Algebra, String> {
    let known = Algebra::ALL.iter().find(|algebra| algebra.name() == name);
    known.copied().ok_or_else(|| {
        if name == "symbolica" {
            return "this build has no Symbolica; `plain`, the default, derives the same motion, \
                    and `cargo install --path app` in Machinist's sources builds a program with \
                    both"
                .to_owned();
        }
        let names: Vec<&str> = Algebra::ALL.iter().map(|algebra| algebra.name()).collect();
        format!("this build supports {}", names.join(" and "))
    })
}

/// Extent of the reduction.
#[derive(Debug, Clone, Copy, Default, PartialEq, Args)]
#[command(next_help_heading = "Machine")]
pub struct KeepArgs {
    /// Keep everything, even what no output needs
    #[arg(long)]
    pub keep_all: bool,
}

/// Discretization of fields.
#[derive(Debug, Clone, Copy, Default, PartialEq, Args)]
#[command(next_help_heading = "Machine")]
pub struct FieldArgs {
    /// Number of elements of each field
    #[arg(long, value_name = "NUMBER")]
    pub elements: Option<usize>,
    /// Order of the elements of fields
    #[arg(long, value_name = "NUMBER")]
    pub order: Option<usize>,
}

/// Scene of a command that derives it without running it.
#[cfg(feature = "derive")]
#[derive(Debug, Clone, Args)]
pub struct SourceArgs {
    /// Name of a built-in scene, a scene file or a model file
    pub scene: String,
    #[command(flatten)]
    pub keep: KeepArgs,
    #[command(flatten)]
    pub derivation: DeriveArgs,
}

#[cfg(feature = "derive")]
impl SourceArgs {
    /// Resolves the scene, to be derived as asked for.
    pub fn given(&self) -> Result<SceneSource, Failure> {
        self.derivation.apply();
        SceneSource::of(&self.scene)
    }

    /// Returns the extent of the reduction asked for.
    pub fn keep(&self) -> Keep {
        if self.keep.keep_all { Keep::All } else { Keep::Needed }
    }

    /// Returns the model of the scene with parameters in place of those names that are inputs of
    /// units, and the names of the parameters.
    pub fn stamped_opened(&self, names: &[String]) -> Result<(Stamped, Vec<String>), Failure> {
        self.derivation.apply();
        stamped_opened(&self.scene, self.keep.keep_all, names)
    }
}

/// Scene of a command that runs it.
#[derive(Debug, Clone, Args)]
pub struct SceneArgs {
    /// Name of a built-in scene, a scene file or a model file
    pub scene: String,
    #[command(flatten)]
    pub machine: MachineArgs,
}

/// Changes of a scene, and the form in which it runs.
#[derive(Debug, Clone, Default, PartialEq, Args)]
#[command(next_help_heading = "Machine")]
pub struct MachineArgs {
    /// Set a parameter: in its SI unit, or with a unit, `"1200 mm"`; repeatable
    #[arg(long, value_name = "UNIT.PARAMETER=VALUE", value_parser = assignment)]
    pub set: Vec<(String, Amount)>,
    /// Set the initial value of a state, likewise; repeatable
    #[arg(long, value_name = "UNIT.STATE=VALUE", value_parser = assignment)]
    pub initial: Vec<(String, Amount)>,
    #[command(flatten)]
    pub keep: KeepArgs,
    #[command(flatten)]
    pub fields: FieldArgs,
    /// Derive the equations and run them as machine code or by an interpreter. Default: emitted
    /// code of built-in scenes, otherwise the faster of both
    #[arg(long, value_name = "FORM")]
    pub code: Option<Code>,
    #[cfg(feature = "derive")]
    #[command(flatten)]
    pub derivation: DeriveArgs,
}

/// Form in which derived equations run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Code {
    /// Machine code, compiled when the scene is loaded
    Compiled,
    /// Interpreted tapes
    Interpreted,
}

impl SceneArgs {
    /// Loads the scene.
    pub fn load(&self) -> Result<Scene, Failure> {
        self.machine.load(&self.scene)
    }

    /// Prepares a run with the parameters and initial values asked for.
    pub fn simulation<'a>(
        &self,
        simulator: &'a dyn Simulator<f64>,
    ) -> Result<Simulation<'a>, Failure> {
        self.machine.simulation(simulator)
    }
}

impl MachineArgs {
    /// Loads a scene in the form asked for.
    pub fn load(&self, scene: &str) -> Result<Scene, Failure> {
        Scene::load(scene, &self.loading())
    }

    /// Returns the form asked for.
    pub fn loading(&self) -> Loading {
        #[cfg(feature = "derive")]
        self.derivation.apply();
        let FieldArgs { elements, order } = self.fields;
        let wanted = Discretisation { elements, order };
        Loading { keep_all: self.keep.keep_all, wanted, code: self.code, ..Loading::default() }
    }

    /// Prepares a run with the parameters and initial values asked for.
    pub fn simulation<'a>(
        &self,
        simulator: &'a dyn Simulator<f64>,
    ) -> Result<Simulation<'a>, Failure> {
        self.with_initial(with_parameters(Simulation::new(simulator), &self.set)?)
    }

    /// Sets the initial values asked for.
    pub fn with_initial<'a>(&self, mut run: Simulation<'a>) -> Result<Simulation<'a>, Failure> {
        for (index, (name, amount)) in self.initial.iter().enumerate() {
            if self.initial[..index].iter().any(|(earlier, _)| earlier == name) {
                let twice = format!("`--initial {name}` is given twice");
                return Err(Failure::input(twice, "leave one of them out"));
            }
            amount.check_of(name, &run)?;
            run = run.initial_value(name, amount.value)?;
        }
        Ok(run)
    }
}

/// Options of a run.
#[derive(Debug, Clone, Default, PartialEq, Args)]
#[command(next_help_heading = "Run")]
pub struct RunArgs {
    #[command(flatten)]
    pub span: SpanArgs,
    /// Relative tolerance
    #[arg(long, value_name = "TOLERANCE", value_parser = plain, allow_hyphen_values = true)]
    pub rtol: Option<f64>,
    /// Absolute tolerances: of all states, each in its SI unit, or of one, `mass.x=0.1um`. Default:
    /// the relative tolerance times the scale of the state
    #[arg(long, value_name = "[UNIT.STATE=]VALUE", value_delimiter = ',', value_parser = atol,
        allow_hyphen_values = true)]
    pub atol: Vec<Atol>,
    /// Integration method: auto, exact, taylor, tsit5, dop853, rodas5p or radau, or of diffsol: bdf,
    /// tr_bdf2, esdirk34 or tsit45
    #[arg(long, value_name = "NAME")]
    pub method: Option<String>,
    /// Choices of the method auto: `explicit=taylor`, dop853 or tsit5, `implicit=radau` or rodas5p,
    /// `exact=no`, `loosest=` and `loosest_kept=` tolerances of steps
    #[arg(long, value_name = "CHOICES", conflicts_with = "method")]
    pub auto: Option<machinist::method::Auto>,
    /// Project states of a conservative machine with constraints onto its energy after each step
    #[arg(long)]
    pub constant_energy: bool,
    /// Maximum number of steps of each run. Default: ten million
    #[arg(long, value_name = "NUMBER")]
    pub max_steps: Option<NonZeroUsize>,
    #[command(flatten)]
    pub time: TimeArgs,
}

/// Start and end of a run.
#[derive(Debug, Clone, Default, PartialEq, Args)]
#[command(next_help_heading = "Run")]
pub struct SpanArgs {
    /// Start time: in seconds, or with a unit, `"5 s"`, `500ms`, `2min`
    #[arg(long, value_name = "TIME", value_parser = time, allow_hyphen_values = true)]
    pub from: Option<f64>,
    /// End time, likewise
    #[arg(long, value_name = "TIME", value_parser = time, allow_hyphen_values = true)]
    pub until: Option<f64>,
    /// Initial state: the equilibrium near the scene's initial values, or these values as given.
    /// Default: as in the scene
    #[arg(long, value_name = "STATE")]
    pub start: Option<Start>,
}

/// Limit on the computing time.
#[derive(Debug, Clone, Copy, Default, PartialEq, Args)]
#[command(next_help_heading = "Run")]
pub struct TimeArgs {
    /// Limit on the computing time of each run, in seconds or with a unit, `2min`. Default: 30 s
    /// for verify, report and watch, otherwise none
    #[arg(long, value_name = "TIME", value_parser = time_limit, allow_hyphen_values = true)]
    time_limit: Option<Duration>,
}

/// Initial state of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Start {
    /// Equilibrium near the initial values
    Equilibrium,
    /// Initial values as given
    Given,
}

/// Absolute tolerance in SI units.
#[derive(Debug, Clone, PartialEq)]
pub enum Atol {
    /// Of every state.
    All(f64),
    /// Of one state.
    One(String, Amount),
}

/// Parses `1e-9` or `state=0.1um`, as `--atol` takes it.
fn atol(text: &str) -> Result<Atol, String> {
    if text.contains('=') {
        return assignment(text).map(|(name, amount)| Atol::One(name, amount));
    }
    plain(text).map(Atol::All).map_err(|why| {
        format!("{why}; name the state of a tolerance with a unit, such as mass.x=0.1um")
    })
}

impl RunArgs {
    /// Applies the options to a run.
    pub fn apply<'a>(&self, run: Simulation<'a>) -> Result<Simulation<'a>, Failure> {
        self.adjust(run, None)
    }

    /// Applies the options to a run whose tolerance is not above a bound unless it is asked for.
    pub fn apply_bounded<'a>(
        &self,
        run: Simulation<'a>,
        bound: f64,
    ) -> Result<Simulation<'a>, Failure> {
        self.adjust(run, Some(bound))
    }

    fn adjust<'a>(
        &self,
        run: Simulation<'a>,
        bound: Option<f64>,
    ) -> Result<Simulation<'a>, Failure> {
        let mut run = self.span.apply(run);
        if self.rtol.is_none() {
            run = config::rtol().into_iter().fold(run, Simulation::rtol);
        }
        let bounded = bound.map(|bound| run.relative_tolerance().min(bound));
        run = self.rtol.or(bounded).into_iter().fold(run, Simulation::rtol);
        run = self.with_atol(run)?;
        run = match self.auto {
            Some(choices) => run.auto(choices),
            None => with_method(run, self.method().as_deref())?,
        };
        run = run.with_constant_energy(self.constant_energy);
        run = self.max_steps.into_iter().fold(run, |run, steps| run.max_steps(steps.get()));
        Ok(self.time.time_limit.into_iter().fold(run, Simulation::time_limit))
    }

    /// Returns the name of the method asked for, with choices of `auto` if there are any.
    fn chosen_method(&self) -> Option<String> {
        self.auto.map_or_else(|| self.method(), |choices| Some(format!("auto with {choices}")))
    }

    /// Returns the name of the method asked for.
    fn method(&self) -> Option<String> {
        self.method.clone().or_else(config::method)
    }

    fn with_atol<'a>(&self, run: Simulation<'a>) -> Result<Simulation<'a>, Failure> {
        if self.atol.is_empty() {
            return Ok(run);
        }
        let simulator = run.simulator();
        let states = 0..simulator.shape().states();
        let scaled = |index| run.relative_tolerance() * simulator.state_scale(index);
        let mut all: Vec<f64> = states.clone().map(scaled).collect();
        for one in &self.atol {
            if let Atol::All(value) = one {
                all.fill(*value);
            }
        }
        for one in &self.atol {
            let Atol::One(name, amount) = one else { continue };
            let names = states.clone().map(|index| simulator.state(index).name);
            let Some(index) = names.clone().position(|known| known == name) else {
                let message = format!("--atol: there is no state `{}`", name.escape_debug());
                return Err(Failure::unknown(message, name, names));
            };
            amount.check(name, simulator.state(index).unit)?;
            all[index] = amount.value;
        }
        Ok(run.atol(&all))
    }

    /// Returns the options that change numbers, for the settings recorded in tables.
    pub fn as_json(&self) -> [(&'static str, Option<Value>); 6] {
        let start = self.span.start.map(|start| match start {
            Start::Equilibrium => "equilibrium",
            Start::Given => "given",
        });
        let atol = self.atol.iter().map(|one| match one {
            Atol::All(value) => json!(value),
            Atol::One(name, amount) => json!({ name: amount.value }),
        });
        let atol: Vec<Value> = atol.collect();
        [
            ("from", self.span.from.map(Value::from)),
            ("until", self.span.until.map(Value::from)),
            ("start", start.map(Value::from)),
            ("rtol", self.rtol.or_else(config::rtol).map(Value::from)),
            ("atol", (!atol.is_empty()).then_some(Value::Array(atol))),
            ("method", self.chosen_method().map(Value::from)),
        ]
    }

    /// Returns an option that only matters if the machine moves, if one is given.
    pub fn given_for_motion(&self) -> Option<&'static str> {
        let Self { span, rtol, atol, method, auto, constant_energy, max_steps, time } = self;
        let given = [
            ("--until", span.until.is_some()),
            ("--rtol", rtol.is_some()),
            ("--atol", !atol.is_empty()),
            ("--method", method.is_some()),
            ("--auto", auto.is_some()),
            ("--constant-energy", *constant_energy),
            ("--max-steps", max_steps.is_some()),
            ("--time-limit", time.time_limit.is_some()),
        ];
        given.into_iter().find(|(_, is_given)| *is_given).map(|(name, _)| name)
    }
}

impl SpanArgs {
    /// Applies the options to a run.
    pub fn apply<'a>(&self, mut run: Simulation<'a>) -> Simulation<'a> {
        run = self.from.into_iter().fold(run, Simulation::from);
        run = self.until.into_iter().fold(run, Simulation::until);
        let wanted = self.start.map(|start| start == Start::Equilibrium);
        wanted.into_iter().fold(run, Simulation::in_equilibrium)
    }

    /// Returns the start time of a run \[s\].
    pub fn start_time(&self, simulator: &dyn Simulator<f64>) -> f64 {
        self.from.unwrap_or(simulator.run_defaults().from)
    }
}

impl TimeArgs {
    /// Returns the limit asked for.
    pub fn limit(self) -> Option<Duration> {
        self.time_limit
    }

    /// Returns the limit asked for, or that of checks and pages.
    pub fn limit_or_default(self) -> Duration {
        self.time_limit.unwrap_or(TIME_LIMIT)
    }
}
