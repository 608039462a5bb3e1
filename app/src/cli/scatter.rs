//! `machinist scatter`: results for parameters with probability distributions.

mod analyses;
mod answer;
mod inputs;
mod runs;

use std::path::PathBuf;

use clap::Args;
use machinist::Simulation;
use machinist::improve::{Expression, Inequality, Node, Reduction, check};
use machinist::scatter::{Design, Sampler};
use machinist_contract::Simulator;

use super::arguments::{RunArgs, SceneArgs};
use super::improve::{expression, units, wrong};
use super::output::{draw_file, print, require_picture, require_table, write_file};
use super::scene::Scene;
use crate::failure::Failure;
use crate::interrupt;
use crate::parquet;
use answer::Answer;
use runs::{Outcome, Ran, Runner};

pub use analyses::{LinearShare, Linearized, propagated};
pub use inputs::{Inputs, Varied, of_scene, varied};
pub use runs::Plan;

/// Default number of samples.
const SAMPLES: usize = 1024;
/// Maximum number of runs.
const MAX_RUNS: usize = 100_000_000;

#[derive(Debug, Args)]
#[expect(clippy::struct_excessive_bools, reason = "switches of the command line")]
pub struct ScatterCommand {
    /// Distribution of a parameter: normal(MEAN, DEVIATION), normal(5 %), uniform(LOW, HIGH),
    /// triangular(LOW, MODE, HIGH), lognormal(MEAN, DEVIATION) or 10 +- 0.5; repeatable
    #[arg(long, value_name = "NAME=DISTRIBUTION", value_parser = varied)]
    vary: Vec<Varied>,
    /// Results: expressions of extremes, means and final values of outputs, such as
    /// max(abs(twist)); repeatable. Default: the final value of each output
    #[arg(long, value_name = "EXPRESSION", allow_hyphen_values = true)]
    of: Vec<String>,
    /// Requirement, such as max(abs(coupling_torque)) < 900, whose probability of failure is
    /// computed; repeatable
    #[arg(long, value_name = "EXPRESSION<EXPRESSION", allow_hyphen_values = true)]
    limit: Vec<String>,
    /// Number of samples. Sobol points are rounded up to 32 times a power of two
    #[arg(long, value_name = "NUMBER", default_value_t = SAMPLES)]
    samples: usize,
    /// Sampler: sobol, random or latin
    #[arg(long, value_name = "NAME", default_value = "sobol")]
    sampler: String,
    /// Seed of the random numbers
    #[arg(long, value_name = "NUMBER", default_value_t = 1)]
    seed: u64,
    /// Confidence of intervals
    #[arg(long, value_name = "PROBABILITY", default_value_t = 0.95)]
    confidence: f64,
    /// Probabilities of the quantiles
    #[arg(long, value_name = "PROBABILITIES", value_delimiter = ',',
        default_values_t = [0.05, 0.5, 0.95])]
    quantiles: Vec<f64>,
    /// Compute Sobol indices of first and total order; takes runs for every parameter
    #[arg(long)]
    indices: bool,
    /// Screen parameters by elementary effects (Morris), with this number of paths
    #[arg(long, value_name = "PATHS")]
    morris: Option<usize>,
    /// Propagate deviations by the sensitivities of one run
    #[arg(long)]
    linear: bool,
    /// Number of output times, including both ends
    #[arg(long, value_name = "NUMBER")]
    points: Option<usize>,
    /// Number of threads. Default: the number of cores
    #[arg(long, value_name = "NUMBER")]
    threads: Option<usize>,
    /// Print JSON
    #[arg(long, help_heading = "Output")]
    json: bool,
    /// Write all runs to a .csv or .parquet file
    #[arg(short, long, help_heading = "Output", value_name = "FILE")]
    out: Option<PathBuf>,
    /// Continue an interrupted scatter, whose runs are in the .parquet file of --out; also with more
    /// --samples
    #[arg(long, help_heading = "Output", requires = "out", conflicts_with_all = ["plot", "morris"])]
    resume: bool,
    /// Plot the quantiles of outputs over time to a .svg or .png file
    #[arg(long, help_heading = "Output", value_name = "FILE")]
    plot: Option<PathBuf>,
    /// Outputs and states to plot. Default: all outputs
    #[arg(
        long,
        help_heading = "Output",
        value_name = "NAMES",
        value_delimiter = ',',
        requires = "plot"
    )]
    columns: Vec<String>,
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    run: RunArgs,
}

/// Results that are computed of each run.
pub struct Results {
    /// Texts of `--of`, and their expressions.
    pub of: Vec<(String, Expression)>,
    /// Texts of `--limit`, and their inequalities.
    pub limits: Vec<(String, Inequality)>,
}

impl Results {
    /// Creates the results from texts of expressions and requirements. Without any, they are the
    /// final values of outputs.
    pub fn new(
        of: &[String],
        limits: &[String],
        simulator: &dyn Simulator<f64>,
    ) -> Result<Self, Failure> {
        let shape = simulator.shape();
        let given = if of.is_empty() && limits.is_empty() {
            let outputs = (0..shape.outputs).map(|index| simulator.output(index).name);
            let states = (0..shape.states()).map(|index| simulator.state(index).name);
            let all: Vec<&str> =
                if shape.outputs > 0 { outputs.collect() } else { states.collect() };
            all.into_iter().map(|name| format!("final({name})")).collect()
        } else {
            of.to_vec()
        };
        let of = given.into_iter().map(|text| {
            let expression = expression("--of", &text, simulator)?;
            Ok((text, expression))
        });
        let of = of.collect::<Result<_, Failure>>()?;
        let limit = |text: &String| {
            let read = Inequality::parse(text).and_then(|limit| {
                check(&limit.left, simulator)?;
                check(&limit.right, simulator)?;
                units::check_sides(&limit, simulator)?;
                Ok(units::sides_in_one_unit(limit, simulator))
            });
            let limit = read.map_err(|error| wrong("--limit", text, &error))?;
            Ok((text.clone(), limit))
        };
        let limits = limits.iter().map(limit).collect::<Result<_, Failure>>()?;
        Ok(Self { of, limits })
    }

    /// Returns the expressions of `--of`, then both sides of each limit.
    pub fn expressions(&self) -> Vec<&Expression> {
        let of = self.of.iter().map(|(_, expression)| expression);
        let sides = self.limits.iter().flat_map(|(_, limit)| [&limit.left, &limit.right]);
        of.chain(sides).collect()
    }

    /// Returns the names of the columns of these expressions.
    pub fn names(&self) -> Vec<String> {
        let of = self.of.iter().map(|(text, _)| text.clone());
        let sides =
            |(text, _): &(String, Inequality)| [format!("{text}: left"), format!("{text}: right")];
        of.chain(self.limits.iter().flat_map(sides)).collect()
    }

    /// Returns whether the first and the last output time suffice.
    pub fn take_ends_only(&self) -> bool {
        self.expressions().into_iter().all(takes_ends_only)
    }
}

impl ScatterCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        self.check_options()?;
        let sampler = Sampler::from_name(&self.sampler).map_err(|error| {
            Failure::at("--sampler", error, "known are sobol, random and latin")
        })?;
        let scene = self.scene.load()?;
        let simulator = scene.simulator();
        let base = self.scene.simulation(simulator)?;
        let set: Vec<&str> = self.scene.machine.set.iter().map(|(name, _)| name.as_str()).collect();
        let inputs = Inputs::new(&of_scene(&self.scene.scene)?, &self.vary, &set, &base)?;
        let results = Results::new(&self.of, &self.limit, simulator)?;
        // Settings are checked before the first run.
        let points = self.points_of(&results);
        let simulation = self.run.apply(points.into_iter().fold(base, Simulation::points))?;
        if self.indices || self.morris.is_some() {
            inputs.require_independent(if self.indices { "--indices" } else { "--morris" })?;
        }
        let dimensions = inputs.names.len();
        let design = Design { sampler, dimensions, samples: self.samples, seed: self.seed };
        let plan = Plan::new(design, self.indices, &inputs)?;
        let others = self.morris.unwrap_or_default().saturating_mul(dimensions + 1);
        if plan.len().saturating_add(others) > MAX_RUNS {
            let message = format!("{} runs are too many", plan.len().saturating_add(others));
            return Err(Failure::input(
                message,
                format!("at most {MAX_RUNS}; give fewer --samples"),
            ));
        }
        let flag = interrupt::flag();
        let runner = Runner::new(self, &scene, &inputs, &results, &flag)?;
        let done =
            if self.resume { self.done(&scene, &inputs, &results, &plan)? } else { Vec::new() };
        let saved = |ran: &Ran| self.save(&scene, &inputs, &results, &plan, ran);
        let ran = runner.run(&plan, done, &saved)?;
        let mut answer = Answer::new(self, &scene, &inputs, &results, &plan, &ran)?;
        if let Some(paths) = self.morris {
            answer.screening = analyses::morris(paths, &runner, &results)?;
        }
        if self.linear {
            let simulation = simulation.until_flagged(&flag);
            answer.linear = analyses::linear(&simulation, &inputs, &results)?;
        }
        self.write(&scene, &inputs, &results, &plan, &ran)?;
        self.tell(&answer)?;
        self.verdict(&plan, &ran)
    }

    fn check_options(&self) -> Result<(), Failure> {
        require_picture(self.plot.as_deref(), "--plot")?;
        if let Some(file) = &self.out {
            require_table(file, &["csv"])?;
        }
        if self.threads == Some(0) {
            return Err(Failure::input("--threads 0: at least one is needed", ""));
        }
        if !(2..=MAX_RUNS).contains(&self.samples) {
            let message = format!("--samples {}: there must be 2 to {MAX_RUNS}", self.samples);
            return Err(Failure::input(message, ""));
        }
        if self.morris.is_some_and(|paths| !(2..=MAX_RUNS).contains(&paths)) {
            return Err(Failure::input("--morris takes at least 2 paths", "10 to 50 are usual"));
        }
        if self.points.is_some_and(|points| points < 2) {
            return Err(Failure::input("--points must be at least 2", ""));
        }
        let is_inside = |p: &f64| *p > 0.0 && *p < 1.0;
        if !is_inside(&self.confidence) {
            let message = format!("--confidence {} is not between 0 and 1", self.confidence);
            return Err(Failure::input(message, "0.95 is usual"));
        }
        match self.quantiles.iter().find(|p| !is_inside(p)) {
            Some(p) => {
                let message = format!("--quantiles: {p} is not between 0 and 1");
                Err(Failure::input(message, "such as --quantiles 0.05,0.5,0.95"))
            }
            None => Ok(()),
        }
    }

    /// Returns the number of output times, unless it is that of the scene.
    fn points_of(&self, results: &Results) -> Option<usize> {
        let suffice = results.take_ends_only() && self.plot.is_none();
        self.points.or(suffice.then_some(2))
    }

    fn write(
        &self,
        scene: &Scene,
        inputs: &Inputs,
        results: &Results,
        plan: &Plan,
        ran: &Ran,
    ) -> Result<(), Failure> {
        self.save(scene, inputs, results, plan, ran)?;
        if let Some(file) = &self.plot {
            let bands = ran.bands(scene.simulator(), &self.quantiles)?;
            draw_file(file, |path| crate::plot::plot(&bands, &[], path))?;
        }
        Ok(())
    }

    /// Writes the runs until now to the file of `--out`.
    fn save(
        &self,
        scene: &Scene,
        inputs: &Inputs,
        results: &Results,
        plan: &Plan,
        ran: &Ran,
    ) -> Result<(), Failure> {
        let Some(file) = &self.out else { return Ok(()) };
        let columns = ran.columns(scene.simulator(), inputs, results, plan);
        if parquet::is_named(file) {
            let of = ("scatter", self.scene.scene.as_str(), scene);
            parquet::write_table(file, &columns, of, self.describe(inputs, results))
        } else {
            write_file(file, |out| parquet::write_csv(&columns, out))
        }
    }

    /// Reads the runs in the file of `--out`.
    fn done(
        &self,
        scene: &Scene,
        inputs: &Inputs,
        results: &Results,
        plan: &Plan,
    ) -> Result<Vec<Outcome>, Failure> {
        let Some(file) = &self.out else { return Ok(Vec::new()) };
        if !parquet::is_named(file) {
            let message = format!("--resume: {} is no .parquet file", file.display());
            return Err(Failure::input(message, "a .csv file does not tell of its settings"));
        }
        if !file.exists() {
            return Ok(Vec::new());
        }
        let of = ("scatter", self.scene.scene.as_str(), scene);
        // Points of other samplers than Latin hypercubes begin with those of fewer samples.
        let is_free = |name: &str| name == "samples" && self.sampler != "latin";
        let columns =
            parquet::read_table(file, of, self.describe(inputs, results), |name, a, b| {
                a == b || is_free(name)
            })?;
        runs::outcomes_of(&columns, inputs, results, plan).ok_or_else(|| {
            let message = format!("--resume: {} has other columns", file.display());
            Failure::input(message, "give another --out")
        })
    }

    /// Returns the settings that determine the numbers besides the machine.
    fn describe(&self, inputs: &Inputs, results: &Results) -> serde_json::Value {
        let mut told = serde_json::json!({
            "results": results.names(),
            "parameters": inputs.describe(),
            "sampler": self.sampler,
            "samples": self.samples,
            "seed": self.seed,
            "indices": self.indices,
            "set": super::amount::as_json(&self.scene.machine.set),
            "points": self.points,
        });
        for (name, value) in self.run.as_json() {
            told[name] = value.unwrap_or_default();
        }
        told
    }

    fn tell(&self, answer: &Answer) -> Result<(), Failure> {
        if self.json {
            let text = serde_json::to_string_pretty(answer)
                .map_err(|error| Failure::unsuccessful(error, ""))?;
            return print(&format!("{text}\n"));
        }
        let mut text = answer.describe();
        for file in [&self.out, &self.plot].into_iter().flatten() {
            text.extend(["\nwrote ", &file.display().to_string(), "\n"]);
        }
        print(&text)
    }

    fn verdict(&self, plan: &Plan, ran: &Ran) -> Result<(), Failure> {
        if ran.is_interrupted {
            let (done, all) = (ran.count(), plan.len());
            let message = format!("interrupted after {done} of {all} runs");
            let is_kept = self.out.as_deref().is_some_and(parquet::is_named);
            let help = if is_kept {
                "the results above are of these runs; --resume does the others"
            } else {
                "the results above are of these runs"
            };
            return Err(Failure::unsuccessful(message, help));
        }
        match ran.stopped().count() {
            0 => Ok(()),
            stopped => {
                let message = format!("{stopped} of {} runs have no result", ran.count());
                let help = if self.out.is_some() {
                    "the last column of the table says why; statistics leave them out"
                } else {
                    "statistics leave them out; --out lists all of them with reasons"
                };
                Err(Failure::unsuccessful(message, help))
            }
        }
    }
}

/// Returns whether an expression only needs the first and the last output time.
fn takes_ends_only(expression: &Expression) -> bool {
    match &expression.node {
        Node::Number(..) | Node::Name(_) => true,
        Node::Negative(a) | Node::Call(_, a) => takes_ends_only(a),
        Node::Binary(_, a, b) => takes_ends_only(a) && takes_ends_only(b),
        Node::Reduce(reduction, _) => matches!(reduction, Reduction::Initial | Reduction::Final),
    }
}
