//! Plots of a fit: data beside runs, and profiles.

use std::path::Path;

use machinist::fit::{Experiment, Fit, Profile, ProfilePoint};
use machinist::trajectory::{Column, ColumnKind, Trajectory};

use super::answer::Answer;
use crate::cli::output::draw_file;
use crate::failure::Failure;
use crate::plot::plot_profiles;

/// Number of points of a curve in addition to those of the data.
const POINTS: usize = 600;

/// Draws the data of each experiment with the runs before and after.
pub fn draw(fit: &Fit<'_>, answer: &Answer, file: &Path) -> Result<(), Failure> {
    for (index, experiment) in fit.experiments.iter().enumerate() {
        let drawn = compared(fit, experiment, answer)?;
        let names: Vec<&str> = drawn.columns.iter().map(|column| &*column.name).collect();
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        let ending = file.extension().unwrap_or_default().to_string_lossy();
        let path = match index {
            0 => file.to_owned(),
            _ => file.with_file_name(format!("{stem}-{}.{ending}", index + 1)),
        };
        draw_file(&path, |path| crate::plot::plot(&drawn, &names, path))?;
    }
    Ok(())
}

/// Returns the measured values, drawn as dots, with the runs before and after, drawn as lines.
fn compared(
    fit: &Fit<'_>,
    experiment: &Experiment,
    answer: &Answer,
) -> Result<Trajectory, Failure> {
    let measured = &experiment.measured;
    let from = measured.times.first().copied().unwrap_or(0.0);
    let until = measured.times.last().copied().unwrap_or(from);
    let dense = (0..=POINTS).map(|k| from + (until - from) * k as f64 / POINTS as f64);
    let dense = dense.map(|time| (time.clamp(from, until), None));
    let sampled = measured.times.iter().enumerate().map(|(row, time)| (*time, Some(row)));
    let mut all: Vec<(f64, Option<usize>)> = dense.chain(sampled).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let times: Vec<f64> = all.iter().map(|(time, _)| *time).collect();
    let starts: Vec<f64> = fit.unknowns.iter().map(|unknown| unknown.start).collect();
    let fitted: Vec<f64> = answer.parameters.iter().map(|found| found.value).collect();
    let after = fit.run(experiment, &fitted, &times, false)?;
    // A start that cannot be simulated is not drawn.
    let before = fit.run(experiment, &starts, &times, false).ok();
    let mut columns = Vec::new();
    for (name, values) in &measured.columns {
        let Some(of) = after.find(name) else { continue };
        let column = |what: &str, kind: ColumnKind, values: Vec<f64>| Column {
            name: format!("{name}, {what}"),
            kind,
            values,
            ..of.clone()
        };
        let data = all.iter().map(|(_, row)| row.map_or(f64::NAN, |row| values[row])).collect();
        columns.push(column("measured", ColumnKind::Measured, data));
        if let Some(before) = before.as_ref().and_then(|run| run.column(name)) {
            columns.push(column("before", of.kind, before[1..].to_vec()));
        }
        columns.push(column("fitted", of.kind, of.values[1..].to_vec()));
    }
    let title = match fit.experiments {
        [_] => after.title.clone(),
        _ => format!("{}, {}", after.title, experiment.name),
    };
    Ok(Trajectory { times, columns, title, ..after })
}

/// Draws tau of all profiles over the change of their parameters in standard errors. For a linear
/// model, this is a straight line.
pub fn draw_profiles(answer: &Answer, file: &Path) -> Result<(), Failure> {
    /// Extent of the curves in standard errors.
    const MOST: f64 = 8.0;
    let scaled = answer.profiles.iter().filter_map(|profile| {
        let found = answer.parameters.iter().find(|found| found.name == profile.parameter)?;
        Some((profile, found.standard_error.filter(|error| *error > 0.0)?))
    });
    let scaled: Vec<(&Profile, f64)> = scaled.collect();
    let ends = scaled.iter().flat_map(|(profile, error)| {
        let ends = [profile.points.first(), profile.points.last()].into_iter().flatten();
        ends.map(|point| (point.value - profile.value) / error).collect::<Vec<f64>>()
    });
    let far = ends.fold(1.0_f64, |most, end| most.max(end.abs())).min(MOST);
    let places: Vec<f64> =
        (0..=POINTS).map(|k| far * (2.0 * k as f64 / POINTS as f64 - 1.0)).collect();
    let curve = |(profile, error): &(&Profile, f64)| {
        let at = |place: &f64| tau_at(profile, profile.value + place * error);
        (profile.parameter.clone(), places.iter().map(at).collect())
    };
    let mut curves: Vec<(String, Vec<f64>)> = scaled.iter().map(curve).collect();
    curves.push(("linear".to_owned(), places.clone()));
    draw_file(file, |path| plot_profiles(&places, curves, answer.t, &answer.title, path))
}

/// Interpolates tau between the points of a profile with their slopes. NaN outside the points.
fn tau_at(profile: &Profile, value: f64) -> f64 {
    let mut pairs = profile.points.windows(2);
    let pair = pairs.find(|pair| pair[0].value <= value && value <= pair[1].value);
    let Some([a, b]) = pair else { return f64::NAN };
    cubic(a, b, value)
}

fn cubic(a: &ProfilePoint, b: &ProfilePoint, value: f64) -> f64 {
    let width = b.value - a.value;
    let s = (value - a.value) / width;
    let h = [(1.0 + 2.0 * s) * (1.0 - s).powi(2), s * s * (3.0 - 2.0 * s)];
    let slopes = [s * (1.0 - s).powi(2) * a.slope, s * s * (s - 1.0) * b.slope];
    h[0] * a.tau + h[1] * b.tau + width * (slopes[0] + slopes[1])
}
