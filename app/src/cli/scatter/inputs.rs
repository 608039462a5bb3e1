//! Parameters with their distributions, from the scene and from `--vary`.

use machinist::Simulation;
use machinist::scatter::{Correlation, Distribution, Law};
use machinist_codegen::scene::scatter::{Scatter, distributions};
use machinist_codegen::spec::Declared;
use machinist_codegen::spec::diagnostic::{FileId, Span};
use machinist_codegen::spec::measure::Measure;
use machinist_codegen::spec::spread::{self, Spread};
use nalgebra::DMatrix;
use serde_json::{Map, Value, json};

use crate::cli::amount::split_number;
use crate::cli::scene::SceneSource;
use crate::failure::{Failure, did_you_mean};

/// Distribution of a parameter on the command line.
#[derive(Debug, Clone, PartialEq)]
pub struct Varied {
    name: String,
    spread: Spread,
}

/// Parses `NAME=DISTRIBUTION`.
pub fn varied(text: &str) -> Result<Varied, String> {
    const EXAMPLE: &str = "write it as NAME=normal(10, 0.5)";
    let (name, spread) = text.split_once('=').ok_or(EXAMPLE)?;
    let spread = Spread::parse(&with_brackets(spread.trim())).map_err(|error| {
        let help = if error.help.is_empty() { String::new() } else { format!("; {}", error.help) };
        format!("{}{help}", error.message)
    })?;
    Ok(Varied { name: name.trim().to_owned(), spread })
}

/// Puts brackets around the units of a distribution, as specs have them: `normal(2 kN, 5 N)`.
fn with_brackets(text: &str) -> String {
    let amount = |text: &str| {
        let (number, unit) = split_number(text.trim());
        match unit.trim() {
            "" | "%" => text.to_owned(),
            unit if number.is_empty() || unit.starts_with('[') => text.to_owned(),
            unit => format!("{number} [{unit}]"),
        }
    };
    let all = |text: &str, between: &str| {
        text.split(between).map(amount).collect::<Vec<_>>().join(between)
    };
    match text.strip_suffix(')').and_then(|text| text.split_once('(')) {
        Some((name, arguments)) => format!("{name}({})", all(arguments, ",")),
        None => all(text, "+-"),
    }
}

/// Parameters that vary.
pub struct Inputs {
    /// Names.
    pub names: Vec<String>,
    /// SI units.
    pub units: Vec<String>,
    /// Distributions.
    pub distributions: Vec<Distribution>,
    /// Correlation of their normal scores.
    pub correlation: Correlation,
    /// Parameters of the scene that have a distribution but are not parameters of the model.
    pub left_out: Vec<String>,
    /// Indices among the parameters of the model.
    places: Vec<usize>,
    /// All parameters of the model.
    base: Vec<f64>,
}

impl Inputs {
    /// Collects the distributions of a scene and of `vary`, which take precedence. Parameters that
    /// are `set` must not have any.
    pub fn new(
        of_scene: &Scatter,
        vary: &[Varied],
        set: &[&str],
        run: &Simulation<'_>,
    ) -> Result<Self, Failure> {
        let mut inputs = Self {
            names: Vec::new(),
            units: Vec::new(),
            distributions: Vec::new(),
            correlation: Correlation::none(0),
            left_out: Vec::new(),
            places: Vec::new(),
            base: run.parameter_values().to_vec(),
        };
        for scattered in &of_scene.parameters {
            if vary.iter().all(|varied| varied.name != scattered.name) {
                inputs.add(&scattered.name, scattered.law, run)?;
            }
        }
        for (index, Varied { name, spread }) in vary.iter().enumerate() {
            if vary[..index].iter().any(|earlier| earlier.name == *name) {
                return Err(Failure::input(format!("`--vary {name}` is given twice"), ""));
            }
            let Some(place) = place_of(run, name) else {
                // Unknown and unused names are rejected with their reason.
                let _ = run.clone().parameter(name, 0.0)?;
                continue;
            };
            let quantity = run.simulator().parameter(place);
            let declared = declared(quantity.unit)?;
            let wrong = |why: String| {
                Failure::input(
                    format!("--vary {name}: {why}"),
                    format!("{name} is in {}", quantity.unit),
                )
            };
            let law = spread.law(inputs.base[place], &declared).map_err(wrong)?;
            inputs.add(name, law, run)?;
        }
        if let Some(name) = set.iter().find(|name| inputs.names.iter().any(|of| of == *name)) {
            let message = format!("`--set {name}`: this parameter has a distribution");
            return Err(Failure::input(
                message,
                format!("give it another with --vary '{name}=...'"),
            ));
        }
        if inputs.names.is_empty() {
            let help = "give one with --vary 'NAME=normal(5 %)', or in the scene: [parameters.NAME] \
                        distribution = \"normal\", or [scatter]";
            let scene = run.simulator().name();
            let message = format!("no parameter of scene `{scene}` has a distribution");
            return Err(Failure::input(message, help));
        }
        inputs.correlation = inputs.correlation(of_scene)?;
        Ok(inputs)
    }

    fn add(&mut self, name: &str, law: spread::Law, run: &Simulation<'_>) -> Result<(), Failure> {
        // Parameters that no output needs, and those that are not tunable, are not in the model.
        let Some(place) = place_of(run, name) else {
            self.left_out.push(name.to_owned());
            return Ok(());
        };
        let law = match law {
            spread::Law::Normal(mean, deviation) => Law::Normal { mean, deviation },
            spread::Law::Uniform(low, high) => Law::Uniform { low, high },
            spread::Law::Triangular(low, mode, high) => Law::Triangular { low, mode, high },
            spread::Law::Lognormal(mean, deviation) => Law::Lognormal { mean, deviation },
        };
        let distribution = Distribution::new(law)
            .map_err(|error| Failure::at(format!("distribution of {name}"), error, ""))?;
        self.names.push(name.to_owned());
        self.units.push(run.simulator().parameter(place).unit.to_owned());
        self.distributions.push(distribution);
        self.places.push(place);
        Ok(())
    }

    /// Returns the scene's correlations of the parameters that vary.
    fn correlation(&self, of_scene: &Scatter) -> Result<Correlation, Failure> {
        let place = |name: &String| {
            of_scene.parameters.iter().position(|scattered| scattered.name == *name)
        };
        let places: Vec<Option<usize>> = self.names.iter().map(place).collect();
        let count = self.names.len();
        let matrix =
            DMatrix::from_fn(count, count, |row, column| match (places[row], places[column]) {
                _ if row == column => 1.0,
                (Some(a), Some(b)) => of_scene.correlations[a][b],
                _ => 0.0,
            });
        Correlation::new(matrix).map_err(|error| Failure::input(error, ""))
    }

    /// Refuses correlated parameters for a measure that an option asks for.
    pub fn require_independent(&self, option: &str) -> Result<(), Failure> {
        if self.correlation.is_none() {
            return Ok(());
        }
        let message = format!("{option}: the parameters are correlated");
        let help = "these measures hold for independent parameters; --linear takes correlations";
        Err(Failure::input(message, help))
    }

    /// Returns the values of the parameters that vary, at a point of the unit cube.
    pub fn values(&self, point: &[f64]) -> Vec<f64> {
        let scores = self.correlation.scores(point);
        let value = |((distribution, u), score): ((&Distribution, &f64), &Option<f64>)| {
            score.map_or_else(|| distribution.quantile(*u), |score| distribution.of_score(score))
        };
        self.distributions.iter().zip(point).zip(&scores).map(value).collect()
    }

    /// Returns all parameters of a run.
    pub fn variant(&self, values: &[f64]) -> Vec<f64> {
        let mut variant = self.base.clone();
        for (place, value) in self.places.iter().zip(values) {
            variant[*place] = *value;
        }
        variant
    }

    /// Describes the distributions for the record of a table.
    pub fn describe(&self) -> Value {
        let mut told = Map::new();
        for (name, distribution) in self.names.iter().zip(&self.distributions) {
            told.insert(name.clone(), format!("{:?}", distribution.law()).into());
        }
        let matrix = self.correlation.matrix();
        let rows: Vec<Vec<f64>> =
            matrix.row_iter().map(|row| row.iter().copied().collect()).collect();
        json!({ "distributions": told, "correlations": rows })
    }
}

fn place_of(run: &Simulation<'_>, name: &str) -> Option<usize> {
    (0..run.parameter_values().len()).find(|index| run.simulator().parameter(*index).name == name)
}

/// Returns the distributions of a scene.
pub fn of_scene(argument: &str) -> Result<Scatter, Failure> {
    match SceneSource::of(argument)? {
        // Model files have no distributions.
        SceneSource::Model(_) => Ok(Scatter::default()),
        SceneSource::Spec(source) => Ok(distributions(&source.read()?)?),
    }
}

/// Returns a unit of the model as a declared one.
fn declared(unit: &str) -> Result<Declared, Failure> {
    let Measure { unit: of, factor } = Measure::parse(unit)
        .map_err(|error| Failure::input(error.message, did_you_mean(unit, std::iter::empty())))?;
    let span = Span { file: FileId(0), start: 0, end: 0 };
    Ok(Declared { text: unit.to_owned(), unit: of, factor, span })
}
