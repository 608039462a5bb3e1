//! `machinist modes`: how a scene vibrates about a point.

use std::f64::consts::TAU;
use std::path::PathBuf;

use crate::plot::plot_modes;
use clap::Args;
use machinist::linear_analysis::{Linearization, Mode, ModeKind, SecondOrder};
use nalgebra::DMatrix;
use serde::Serialize;

use super::linear::Where;
use super::output::{columns, draw_file, print, require_picture};
use crate::failure::Failure;
use crate::number::number;

/// States with less than this share of the largest are left out of the table.
const MINOR: f64 = 0.1;
const MOVING: usize = 3;

#[derive(Debug, Args)]
pub struct Modes {
    #[command(flatten)]
    at: Where,
    /// As JSON, with shapes, the point, and the matrices M, D and K
    #[arg(long)]
    json: bool,
    /// Plot the shapes to a file that ends in .svg or .png
    #[arg(long, value_name = "FILE")]
    plot: Option<PathBuf>,
}

/// What `--json` prints.
#[derive(Serialize)]
struct Answer<'a> {
    scene: &'a str,
    place: String,
    time: f64,
    states: Vec<&'a str>,
    state: &'a [f64],
    /// What the shapes of modes are made of.
    motions: Vec<String>,
    modes: &'a [Mode],
    mass: Vec<Vec<f64>>,
    damping: Vec<Vec<f64>>,
    stiffness: Vec<Vec<f64>>,
    /// Null if M is singular.
    undamped_frequencies: Option<Vec<f64>>,
}

impl Modes {
    pub fn execute(&self) -> Result<(), Failure> {
        require_picture(self.plot.as_deref(), "--plot")?;
        let scene = self.at.load()?;
        let linearization = self.at.linearize(&scene)?;
        let modes = linearization.modes()?;
        if let Some(file) = &self.plot {
            draw_file(file, |path| plot_modes(&linearization, &modes, path))?;
        }
        if self.json {
            let answer = self.answer(&linearization, &modes);
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
        }
        if let Some(file) = &self.plot {
            text.extend(["\nwrote ", &file.display().to_string(), "\n"]);
        }
        print(&text)
    }

    fn answer<'a>(&self, linearization: &'a Linearization<'_>, modes: &'a [Mode]) -> Answer<'a> {
        let simulator = linearization.simulator();
        let second_order = linearization.second_order();
        let undamped_frequencies = second_order.undamped_frequencies().ok();
        let SecondOrder { mass, damping, stiffness } = second_order;
        Answer {
            scene: simulator.name(),
            place: self.at.described(linearization),
            time: linearization.point().time,
            states: (0..simulator.shape().states()).map(|i| simulator.state(i).name).collect(),
            state: &linearization.point().state,
            motions: linearization.motion_names(),
            modes,
            mass: rows(&mass),
            damping: rows(&damping),
            stiffness: rows(&stiffness),
            undamped_frequencies,
        }
    }
}

fn rows(matrix: &DMatrix<f64>) -> Vec<Vec<f64>> {
    matrix.row_iter().map(|row| row.iter().copied().collect()).collect()
}

/// What is said where there are no motions.
pub const NO_MOTION: &str = "The constraints leave no motion.";

/// Heading of [`table`].
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

/// One motion for people; what does not apply is empty.
pub fn row(linearization: &Linearization<'_>, mode: &Mode) -> [String; 7] {
    let shown = |value: f64| number(value, 6);
    let none = String::new;
    let moves = moving(linearization, mode);
    let (natural, ratio) = (shown(mode.natural_frequency()), shown(mode.damping_ratio()));
    let decay = if mode.real == 0.0 { none() } else { shown(mode.decay_time()) };
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

/// `cylinder.phi 77 %, driver.phi 23 %`: the largest shares.
fn moving(linearization: &Linearization<'_>, mode: &Mode) -> String {
    let n = linearization.simulator().shape().coordinates;
    let names = linearization.motion_names();
    let motion = |index: usize| if index < n { index } else { index + n };
    let mut order: Vec<usize> = (0..mode.shares.len()).collect();
    order.sort_by(|a, b| mode.shares[*b].total_cmp(&mode.shares[*a]));
    let largest = order.first().map_or(0.0, |index| mode.shares[*index]);
    let major = order.into_iter().filter(|index| mode.shares[*index] >= MINOR * largest);
    let named = major
        .take(MOVING)
        .map(|index| format!("{} {:.0} %", names[motion(index)], 100.0 * mode.shares[index]));
    named.collect::<Vec<_>>().join(", ")
}
