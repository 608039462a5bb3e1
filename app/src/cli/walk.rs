//! `machinist studies walk`: a comparison of models of a winder, and a map of its stability.

use std::path::PathBuf;

use crate::plot::plot_map;
use clap::Args;
use machinist_studies::winder_walk::map::{Condition, FASTEST, StabilityMap};
use machinist_studies::winder_walk::{Stage, Walk, Winder};
use serde::Serialize;

use super::amount::quantity;
use super::output::{columns, draw_file, print, require_picture};
use super::table::paragraph;
use crate::failure::Failure;
use crate::number::number;
use crate::progress::during;

#[derive(Debug, Args)]
pub struct WalkCommand {
    /// Winding speed [m/s]
    #[arg(long, value_parser = quantity("m/s"), value_name = "SPEED", default_value = "5.5", allow_hyphen_values = true)]
    speed: f64,
    /// Radius of the empty bobbin [m]
    #[arg(long, value_parser = quantity("m"), value_name = "RADIUS", allow_hyphen_values = true)]
    radius_min: Option<f64>,
    /// Radius of the full package [m]
    #[arg(long, value_parser = quantity("m"), value_name = "RADIUS", allow_hyphen_values = true)]
    radius_max: Option<f64>,
    /// Force once per turn of the drum [N]. Default: that of an unbalance with 25 N at 5.5 m/s
    #[arg(long, value_parser = quantity("N"), value_name = "FORCE", allow_hyphen_values = true)]
    force: Option<f64>,
    /// Amplitude of the drum's shape, twice per turn [m]
    #[arg(long, value_parser = quantity("m"), value_name = "AMPLITUDE", allow_hyphen_values = true)]
    shape: Option<f64>,
    /// Force once per turn of an irregular package [N]
    #[arg(long, value_parser = quantity("N"), value_name = "FORCE", allow_hyphen_values = true)]
    package: Option<f64>,
    /// Contact force at rest with the empty bobbin [N]
    #[arg(long, value_parser = quantity("N"), value_name = "FORCE", allow_hyphen_values = true)]
    preload: Option<f64>,
    /// Growth of that force with the radius of the package [N/m]: 3800 N/m if only the holder's
    /// spring presses
    #[arg(long, value_parser = quantity("N/m"), value_name = "STIFFNESS", default_value = "0", allow_hyphen_values = true)]
    growth: f64,
    /// Tension of the thread [N]
    #[arg(long, value_parser = quantity("N"), value_name = "FORCE", allow_hyphen_values = true)]
    tension: Option<f64>,
    /// Greatest elastic slip nu of the package on the drum, in the last stage; the study has at most
    /// 0.04
    #[arg(long, value_parser = quantity("1"), value_name = "SLIP", default_value = "0", allow_hyphen_values = true)]
    slip: f64,
    /// Largest permissible force on the yarn [N], for the stability map
    #[arg(long, value_parser = quantity("N"), value_name = "FORCE", allow_hyphen_values = true)]
    largest: Option<f64>,
    /// Draw the stability map to a .svg or .png file
    #[arg(long, help_heading = "Output", value_name = "FILE")]
    map: Option<PathBuf>,
    /// Print JSON, with the stability map
    #[arg(long, help_heading = "Output")]
    json: bool,
}

/// Output of `--json`.
#[derive(Serialize)]
struct Answer<'a> {
    walk: &'a Walk,
    decided: usize,
    why: Vec<String>,
    map: &'a StabilityMap,
}

impl WalkCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        require_picture(self.map.as_deref(), "--map")?;
        let winder = self.winder()?;
        if let Some(mistake) = winder.mistake() {
            return Err(Failure::input(
                mistake,
                "`machinist studies walk --help` lists the options",
            ));
        }
        let failed = |error| Failure::unsuccessful(error, "");
        let walk = during("walking", || Walk::of(&winder).map_err(failed))?;
        let map = StabilityMap::of(&winder, winder.speed.max(FASTEST)).map_err(failed)?;
        if let Some(file) = &self.map {
            draw_file(file, |path| plot_map(&map, path))?;
        }
        if self.json {
            let (decided, why) = (walk.decided().number, walk.why());
            let answer = Answer { walk: &walk, decided, why, map: &map };
            let text = serde_json::to_string_pretty(&answer)
                .map_err(|error| Failure::unsuccessful(error, ""))?;
            return print(&format!("{text}\n"));
        }
        let mut text = described(&walk);
        text.push_str(&shares(&map));
        if let Some(file) = &self.map {
            text.extend(["\nwrote ", &file.display().to_string(), "\n"]);
        }
        print(&text)
    }

    fn winder(&self) -> Result<Winder, Failure> {
        let winder =
            Winder::at_speed(self.speed).map_err(|error| Failure::unsuccessful(error, ""))?;
        let (least, most) = winder.radii;
        Ok(Winder {
            radii: (self.radius_min.unwrap_or(least), self.radius_max.unwrap_or(most)),
            force: self.force.unwrap_or(winder.force),
            shape: self.shape.unwrap_or(winder.shape),
            package: self.package.unwrap_or(winder.package),
            preload: self.preload.unwrap_or(winder.preload),
            growth: self.growth,
            tension: self.tension.unwrap_or(winder.tension),
            elastic_slip: self.slip,
            largest: self.largest.unwrap_or(winder.largest),
            ..winder
        })
    }
}

fn described(walk: &Walk) -> String {
    let Winder { speed, radii, force, shape, package, preload, growth, tension, .. } = walk.winder;
    let slip = walk.winder.elastic_slip;
    let when = |is: bool, words: String| if is { words } else { String::new() };
    let of_package = when(package > 0.0, format!(" and {} N of the package", number(package, 4)));
    let growing = when(growth > 0.0, format!(" that grows by {} N/m", number(growth, 4)));
    let slipping = when(slip > 0.0, format!(", elastic slip of {} at most", number(slip, 4)));
    let mut text = format!(
        "Winder at {speed} m/s, package of {} to {} mm, {} N and {} mm of the drum{of_package},\n\
         {preload} N pressure{growing}, {tension} N tension{slipping}\n\n",
        number(1e3 * radii.0, 4),
        number(1e3 * radii.1, 4),
        number(force, 4),
        number(1e3 * shape, 4)
    );
    text.extend(walk.why().iter().map(|line| paragraph(line)));
    text.push('\n');
    text.push_str(&columns(&table(walk), 1));
    let later = walk.later();
    if later.is_empty() {
        text.push_str("\nThere is no later stage.\n");
    }
    let told = |stage: &Stage| {
        let (cost, change) = (number(walk.cost(stage), 2), walk.change(stage));
        let number = stage.number;
        let costs = format!("would have cost {cost} times as much, and changed: {change}.");
        format!("\n{}", paragraph(&format!("Stage {number} {costs}")))
    };
    text.extend(later.iter().map(told));
    text
}

/// Header of [`line`].
pub const HEADING: [&str; 8] = [
    "stage",
    "resonance [rad/s]",
    "nearest ratio",
    "amplitude [mm]",
    "least N [N]",
    "no contact [%]",
    "slipping [%]",
    "slip [%]",
];

fn table(walk: &Walk) -> Vec<[String; 8]> {
    std::iter::once(HEADING.map(str::to_owned)).chain(walk.stages.iter().map(line)).collect()
}

/// Formats one stage for people. Unknown values are dashes.
pub fn line(stage: &Stage) -> [String; 8] {
    let none = || "-".to_owned();
    let range = |(first, last): (f64, f64)| format!("{} to {}", number(first, 4), number(last, 4));
    let running = &stage.running;
    let percent = |share: f64| if stage.number == 3 { number(100.0 * share, 3) } else { none() };
    [
        format!("{} {}", stage.number, stage.name),
        stage.resonance.map_or_else(none, range),
        stage.nearest().map_or_else(none, |nearest| number(nearest.ratio, 3)),
        number(1e3 * running.amplitude, 4),
        number(running.least_pressure, 4),
        percent(running.open),
        percent(running.slipping),
        percent(running.slip),
    ]
}

fn shares(map: &StabilityMap) -> String {
    let (first, last) = (map.speeds.first(), map.speeds.last());
    let [from, to] = [first, last].map(|speed| number(speed.copied().unwrap_or(f64::NAN), 3));
    let found: Vec<String> = Condition::ALL
        .into_iter()
        .filter(|condition| map.share(*condition) > 0.0)
        .map(|condition| format!("{} {:.0} %", condition.name(), 100.0 * map.share(condition)))
        .collect();
    let found = found.join(", ");
    let text =
        format!("Over these radii and {from} to {to} m/s, a linear layer, worst phases: {found}");
    format!("\n{}", paragraph(&text))
}
