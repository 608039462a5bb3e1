//! `machinist modes`: eigenmodes of a scene about an operating point.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::path::PathBuf;

use crate::plot::plot_modes;
use clap::Args;
use machinist::linear_analysis::{
    Linearization, Mode, ModeKind, ModeSlope, NoSlope, PointSlopes, SecondOrder,
};
use machinist_contract::Quantity;
use nalgebra::DMatrix;
use serde::Serialize;

use super::linear::Where;
use super::output::{columns, draw_file, print, require_picture};
use super::scene::Scene;
use super::table::paragraph;
use crate::failure::Failure;
use crate::number::number;

/// Share of the largest below which states are left out of the table.
const MINOR: f64 = 0.1;
const MOVING: usize = 3;

#[derive(Debug, Args)]
pub struct Modes {
    /// Add derivatives of frequencies and damping by these parameters, as NAME,NAME
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    sensitivities: Vec<String>,
    /// Print JSON, with shapes, operating point, and the matrices M, D and K
    #[arg(long, help_heading = "Output")]
    json: bool,
    /// Plot the shapes to a .svg or .png file
    #[arg(long, help_heading = "Output", value_name = "FILE")]
    plot: Option<PathBuf>,
    #[command(flatten)]
    at: Where,
}

/// Output of `--json`.
#[derive(Serialize)]
struct Answer<'a> {
    scene: &'a str,
    place: String,
    time: f64,
    states: Vec<&'a str>,
    state: &'a [f64],
    /// Names of the entries of mode shapes.
    motions: Vec<String>,
    modes: &'a [Mode],
    #[serde(skip_serializing_if = "Option::is_none")]
    sensitivities: Option<Vec<ModeAnswer<'a>>>,
    /// Null if the matrices are too large to be shown.
    mass: Option<Vec<Vec<f64>>>,
    damping: Option<Vec<Vec<f64>>>,
    stiffness: Option<Vec<Vec<f64>>>,
    /// Null also if M is singular.
    undamped_frequencies: Option<Vec<f64>>,
}

/// Derivatives of one mode.
#[derive(Serialize)]
struct ModeAnswer<'a> {
    #[serde(flatten)]
    by: BTreeMap<&'a str, &'a ModeSlope>,
    /// Reason why there are no derivatives.
    #[serde(skip_serializing_if = "Option::is_none")]
    none: Option<String>,
}

/// Derivatives of every mode by each parameter.
struct Slopes<'a> {
    by: Vec<Quantity<'a>>,
    of_modes: Vec<Result<Vec<ModeSlope>, NoSlope>>,
}

impl Modes {
    pub fn execute(&self) -> Result<(), Failure> {
        require_picture(self.plot.as_deref(), "--plot")?;
        let scene = self.at.load()?;
        let linearization = self.at.linearize(&scene)?;
        let modes = linearization.modes()?;
        let slopes = self.slopes(&scene, &linearization, &modes)?;
        if let Some(file) = &self.plot {
            draw_file(file, |path| plot_modes(&linearization, &modes, path))?;
        }
        if self.json {
            let answer = self.answer(&linearization, &modes, slopes.as_ref());
            let text = serde_json::to_string_pretty(&answer)
                .map_err(|error| Failure::unsuccessful(error, ""))?;
            return print(&format!("{text}\n"));
        }
        let simulator = scene.simulator();
        let mut text = format!(
            "{}: {}\n{}\n\n",
            simulator.name(),
            simulator.title(),
            self.at.described(&linearization)
        );
        if modes.is_empty() {
            text.push_str(NO_MOTION);
            text.push('\n');
        } else {
            text.push_str(&columns(&table(&linearization, &modes), 2));
            text.push_str(&doubts(&linearization, &modes));
        }
        if let Some(slopes) = &slopes {
            text.push_str(&slopes.describe(&linearization, &modes));
        }
        if let Some(file) = &self.plot {
            text.extend(["\nwrote ", &file.display().to_string(), "\n"]);
        }
        print(&text)
    }

    fn slopes<'s>(
        &self,
        scene: &'s Scene,
        linearization: &Linearization<'_>,
        modes: &[Mode],
    ) -> Result<Option<Slopes<'s>>, Failure> {
        if self.sensitivities.is_empty() {
            return Ok(None);
        }
        let run = self.at.run(scene)?;
        let point =
            PointSlopes::of(&run, self.at.place(), linearization.point(), &self.sensitivities)?;
        let of_modes = linearization.mode_slopes(modes, &point)?;
        Ok(Some(Slopes { by: point.by(scene.simulator()), of_modes }))
    }

    fn answer<'a>(
        &self,
        linearization: &'a Linearization<'_>,
        modes: &'a [Mode],
        slopes: Option<&'a Slopes<'_>>,
    ) -> Answer<'a> {
        let simulator = linearization.simulator();
        let second_order = linearization.second_order().ok();
        let undamped_frequencies =
            second_order.as_ref().and_then(|forms| forms.undamped_frequencies().ok());
        let of =
            |form: fn(&SecondOrder) -> &DMatrix<f64>| second_order.as_ref().map(form).map(rows);
        Answer {
            scene: simulator.name(),
            place: self.at.described(linearization),
            time: linearization.point().time,
            states: (0..simulator.shape().states()).map(|i| simulator.state(i).name).collect(),
            state: &linearization.point().state,
            motions: linearization.motion_names(),
            modes,
            sensitivities: slopes.map(|slopes| slopes.answer(linearization, modes)),
            mass: of(|forms| &forms.mass),
            damping: of(|forms| &forms.damping),
            stiffness: of(|forms| &forms.stiffness),
            undamped_frequencies,
        }
    }
}

impl Slopes<'_> {
    fn answer(&self, linearization: &Linearization<'_>, modes: &[Mode]) -> Vec<ModeAnswer<'_>> {
        self.of_modes
            .iter()
            .map(|of_mode| match of_mode {
                Ok(slopes) => {
                    let by = self.by.iter().map(|by| by.name).zip(slopes).collect();
                    ModeAnswer { by, none: None }
                }
                Err(why) => {
                    let none = Some(without(why, linearization, modes));
                    ModeAnswer { by: BTreeMap::new(), none }
                }
            })
            .collect()
    }

    /// Formats a table for each parameter, with the reasons for missing modes.
    fn describe(&self, linearization: &Linearization<'_>, modes: &[Mode]) -> String {
        let shown = |value: f64| number(value, 6);
        let mut text = String::new();
        let point = linearization.point();
        let simulator = linearization.simulator();
        for (column, by) in self.by.iter().enumerate() {
            let parameter = (0..simulator.shape().parameters)
                .find(|index| simulator.parameter(*index).name == by.name)
                .map_or(f64::NAN, |index| point.parameters[index]);
            let unit = if by.unit == "1" { String::new() } else { format!(" {}", by.unit) };
            text.extend([format!("\nBy `{}`, which is {}{unit}:\n\n", by.name, shown(parameter))]);
            let heading = [
                "motion",
                "moves",
                "d(natural)",
                "% per %",
                "d(damping ratio)",
                "d(real part)",
                "d(imaginary part)",
            ];
            let mut lines = vec![heading.map(str::to_owned)];
            for (mode, slopes) in modes.iter().zip(&self.of_modes) {
                let Ok(slopes) = slopes else { continue };
                let slope = slopes[column];
                let [kind, moves, ..] = row(linearization, mode);
                let is_oscillation = mode.kind == ModeKind::Oscillation;
                let only = |value: f64| if is_oscillation { shown(value) } else { String::new() };
                let share = slope.natural_frequency * parameter / mode.natural_frequency();
                lines.push([
                    kind,
                    moves,
                    only(slope.natural_frequency),
                    only(share),
                    only(slope.damping_ratio),
                    shown(slope.real),
                    only(slope.imaginary),
                ]);
            }
            text.push_str(&columns(&lines, 2));
        }
        for (mode, slopes) in modes.iter().zip(&self.of_modes) {
            if let Err(why) = slopes
                && *why != NoSlope::Free
            {
                let [kind, moves, ..] = row(linearization, mode);
                let why = without(why, linearization, modes);
                text.extend([format!("\nno derivatives of the {kind} of {moves}: {why}\n")]);
            }
        }
        text
    }
}

/// Explains why a mode has no derivatives.
fn without(why: &NoSlope, linearization: &Linearization<'_>, modes: &[Mode]) -> String {
    match why {
        NoSlope::Free => "it has no restoring force, for any parameters".to_owned(),
        NoSlope::Repeated(others) => {
            let named = others.iter().map(|other| {
                let [kind, moves, ..] = row(linearization, &modes[*other]);
                format!("the {kind} of {moves}")
            });
            format!(
                "its eigenvalue coincides with that of {}, and they split differently for each \
                 parameter",
                named.collect::<Vec<_>>().join(" and of ")
            )
        }
        NoSlope::Defective => {
            "its eigenvalue is defective: double with a single shape, as at critical damping, \
             where derivatives are infinite"
                .to_owned()
        }
    }
}

fn rows(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

/// Message for machines without motions.
pub const NO_MOTION: &str = "The constraints leave no motion.";

/// Header of [`table`].
pub const HEADING: [&str; 7] = [
    "motion",
    "moves",
    "natural [rad/s]",
    "damped [rad/s]",
    "damped [Hz]",
    "damping ratio",
    "decay time [s]",
];

fn table(linearization: &Linearization<'_>, modes: &[Mode]) -> Vec<[String; 7]> {
    let heading = HEADING.map(str::to_owned);
    std::iter::once(heading).chain(modes.iter().map(|mode| row(linearization, mode))).collect()
}

/// Warns about modes whose shapes do not fulfil the equations well.
fn doubts(linearization: &Linearization<'_>, modes: &[Mode]) -> String {
    const LARGE: f64 = 1e-6;
    let doubtful = modes.iter().filter(|mode| mode.residual.is_nan() || mode.residual > LARGE);
    let told = doubtful.map(|mode| {
        let [kind, moves, ..] = row(linearization, mode);
        let residual = number(mode.residual, 2);
        let doubt = format!(
            "the eigenmode `{kind}` that moves {moves} is accurate to {residual} only: the machine is \
             not steady at this state, or eigenvalues nearly coincide. `--at equilibrium` linearizes \
             about a steady state"
        );
        format!("\n{}", paragraph(&doubt))
    });
    told.collect()
}

/// Formats one mode for people. Cells that do not apply are empty.
pub fn row(linearization: &Linearization<'_>, mode: &Mode) -> [String; 7] {
    let shown = |value: f64| number(value, 6);
    let none = String::new;
    let moves = moving(linearization, mode);
    let (natural, ratio) = (shown(mode.natural_frequency()), shown(mode.damping_ratio()));
    let decay = mode.decay_time();
    let decay = if decay.is_finite() { shown(decay) } else { none() };
    match mode.kind {
        ModeKind::Free => ["free".to_owned(), moves, none(), none(), none(), none(), none()],
        ModeKind::Aperiodic => {
            let kind = if mode.real < 0.0 { "decay" } else { "growth" };
            [kind.to_owned(), moves, none(), none(), none(), none(), decay]
        }
        ModeKind::Oscillation => {
            let kind = "oscillation".to_owned();
            let damped = mode.imaginary;
            [kind, moves, natural, shown(damped), shown(damped / TAU), ratio, decay]
        }
    }
}

/// Formats the largest shares: `cylinder.phi 77 %, driver.phi 23 %`.
fn moving(linearization: &Linearization<'_>, mode: &Mode) -> String {
    let n = linearization.simulator().shape().coordinates;
    let names = linearization.motion_names();
    let motion = |index: usize| if index < n { index } else { index + n };
    let largest = mode.shares.iter().copied().fold(0.0, f64::max);
    let is_major = |index: &usize| mode.shares[*index] >= MINOR * largest;
    let mut major: Vec<usize> = (0..mode.shares.len()).filter(is_major).collect();
    // Shares that differ only by rounding keep the order of the states.
    let size = |index: usize| (1e9 * mode.shares[index]).round();
    major.sort_by(|a, b| size(*b).total_cmp(&size(*a)));
    let named = major
        .into_iter()
        .take(MOVING)
        .map(|index| format!("{} {:.0} %", names[motion(index)], 100.0 * mode.shares[index]));
    named.collect::<Vec<_>>().join(", ")
}
