//! Plots of trajectories, mode shapes, frequency responses and stability maps as SVG and PNG, with
//! an embedded font.

mod heat;
mod linear;
mod map;
mod panel;
mod raster;
pub(crate) mod ruler;

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::register_font;
use thiserror::Error;

pub use heat::{Heat, plot_heat};
pub use linear::{
    plot_branch, plot_campbell, plot_cuts, plot_errors, plot_loads, plot_modes, plot_profiles,
    plot_response, plot_spectrum,
};
use machinist::error::did_you_mean;
use machinist::trajectory::{Column, ColumnKind, Trajectory};
pub use map::plot_map;
use panel::{Panel, over};
use raster::Raster;
use ruler::Axis;

const WIDTH: u32 = 1000;
const TITLE_HEIGHT: u32 = 64;
const PANEL_HEIGHT: u32 = 230;
const TIME_AXIS_HEIGHT: u32 = 46;
const FONT: &str = "sans-serif";

/// Everything is drawn four times as large. An SVG is shown at a quarter of that, so that integer
/// coordinates are fine enough. A PNG is averaged over squares of two by two pixels, because
/// plotters does not smooth thick lines.
const SCALE: u32 = 4;
const SMOOTHING: u32 = 2;

/// Reason why there is no plot.
#[derive(Debug, Error, strum::IntoStaticStr, strum::VariantNames)]
#[strum(prefix = "plot::", serialize_all = "kebab-case")]
pub enum PlotError {
    /// The file's name does not end in `.svg` or `.png`.
    #[error("cannot plot to `{}`: the name must end in .svg or .png", .0.display())]
    UnknownFileType(PathBuf),
    /// The trajectory has no such column.
    #[error("scene `{scene}` has no state, output or energy `{name}`{hint}")]
    UnknownColumn {
        /// Scene of the run.
        scene: String,
        /// Name asked for.
        name: String,
        /// Nearest known name as a question, or empty.
        hint: String,
    },
    /// The trajectory has no columns at all.
    #[error("there are no columns to plot")]
    Nothing,
    /// The plot could not be drawn.
    #[error("cannot draw the plot: {0}")]
    Drawing(String),
    /// The file could not be written.
    #[error("cannot write `{}`", path.display())]
    Writing {
        /// The file.
        path: PathBuf,
        /// Error of the operating system.
        source: io::Error,
    },
}

impl PlotError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.into()
    }
}

/// Draws the named columns over time as stacked panels, one for each unit and size, into an `.svg` or `.png`
/// file. Without names, draws all outputs, or all states if the scene has no outputs.
///
/// With more than 2000 points, the least and the greatest of each bin are drawn, so that spikes
/// stay.
///
/// # Errors
/// [`PlotError`]. In that case no file is written, or only part of one.
pub fn plot(trajectory: &Trajectory, columns: &[&str], path: &Path) -> Result<(), PlotError> {
    let time = ("time [s]".to_owned(), trajectory.times.as_slice());
    let texts = [trajectory.title.as_str(), &subtitle(trajectory)];
    plot_over(time, &chosen(trajectory, columns)?, texts, path)
}

/// Returns the second line of a run's plot.
pub(crate) fn subtitle(trajectory: &Trajectory) -> String {
    let Trajectory { scene, method, rtol, .. } = trajectory;
    format!("{scene}, {method}, rtol {rtol:e}")
}

/// Draws columns over the values of another one, named with its unit, as [`plot`] does over time;
/// `texts` are title and subtitle.
///
/// # Errors
/// As [`plot`].
pub fn plot_over(
    (across, places): (String, &[f64]),
    columns: &[&Column],
    texts: [&str; 2],
    path: &Path,
) -> Result<(), PlotError> {
    let axes = [Axis::Linear(across.into()), Axis::Linear("".into())];
    let panel = |columns: Vec<_>| over(places, columns, [&axes[0], &axes[1]]);
    let panels = alike(columns.iter().copied()).into_iter().map(panel).collect();
    Picture { title: texts[0], subtitle: texts[1].to_owned(), panels }.write(path)
}

/// Drawing that can be written to a file.
trait Drawn {
    /// Width and height, [`SCALE`] times as large as shown.
    fn size(&self) -> (u32, u32);
    fn draw<DB: DrawingBackend>(&self, area: &DrawingArea<DB, Shift>) -> DrawResult<DB>;
}

/// Panels above each other, under a title.
struct Picture<'a> {
    title: &'a str,
    subtitle: String,
    panels: Vec<Panel<'a>>,
}

/// Ratio of sizes from which curves of one unit have panels of their own: the smaller one would be
/// a flat line.
const FLAT: f64 = 50.0;

/// Groups columns of one unit and of like size, in the order of first appearance.
pub(crate) fn alike<'a>(columns: impl IntoIterator<Item = &'a Column>) -> Vec<Vec<&'a Column>> {
    let size = |column: &Column| {
        let sizes = column.values.iter().map(|value| value.abs());
        sizes.filter(|size| size.is_finite()).fold(0.0, f64::max)
    };
    let mut groups: Vec<(f64, Vec<&Column>)> = Vec::new();
    for column in columns {
        let own = size(column);
        // Zero fits any size.
        let fits = |of: f64| own == 0.0 || of == 0.0 || (of / own).max(own / of) < FLAT;
        let same = groups.iter_mut().find(|(of, same)| same[0].unit == column.unit && fits(*of));
        match same {
            Some((of, same)) => {
                *of = of.max(own);
                same.push(column);
            }
            None => groups.push((own, vec![column])),
        }
    }
    groups.into_iter().map(|(_, same)| same).collect()
}

fn chosen<'a>(trajectory: &'a Trajectory, names: &[&str]) -> Result<Vec<&'a Column>, PlotError> {
    if names.is_empty() {
        let outputs: Vec<_> = trajectory.of_kind(ColumnKind::Output).collect();
        let states = || trajectory.of_kind(ColumnKind::State).collect();
        return Ok(if outputs.is_empty() { states() } else { outputs });
    }
    let known = || trajectory.columns.iter().map(|column| column.name.as_str());
    let find = |name: &&str| {
        trajectory.find(name).ok_or_else(|| PlotError::UnknownColumn {
            scene: trajectory.scene.clone(),
            name: (*name).to_owned(),
            hint: did_you_mean(name, known()),
        })
    };
    names.iter().map(find).collect()
}

fn write(picture: &impl Drawn, path: &Path) -> Result<(), PlotError> {
    let ending = path.extension().and_then(|extension| extension.to_str()).unwrap_or_default();
    // Only a font file that cannot be parsed is rejected, and a test parses this one.
    let _ = register_font(FONT, FontStyle::Normal, epaint_default_fonts::UBUNTU_LIGHT);
    let bytes = match ending.to_ascii_lowercase().as_str() {
        "svg" => svg(picture)?.into_bytes(),
        "png" => png(picture)?,
        _ => return Err(PlotError::UnknownFileType(path.to_owned())),
    };
    fs::write(path, bytes).map_err(|source| PlotError::Writing { path: path.to_owned(), source })
}

fn svg(picture: &impl Drawn) -> Result<String, PlotError> {
    let mut text = String::new();
    let (width, height) = picture.size();
    {
        let area = SVGBackend::with_string(&mut text, (width, height)).into_drawing_area();
        picture.draw(&area).map_err(|error| drawing(&error))?;
    }
    let drawn = format!("width=\"{width}\" height=\"{height}\"");
    let shown = format!("width=\"{}\" height=\"{}\"", width / SCALE, height / SCALE);
    Ok(text.replacen(&drawn, &shown, 1))
}

fn png(picture: &impl Drawn) -> Result<Vec<u8>, PlotError> {
    let (width, height) = picture.size();
    let mut pixels = vec![0; width as usize * height as usize * 3];
    {
        let bitmap = BitMapBackend::with_buffer(&mut pixels, (width, height));
        let area = Raster(bitmap).into_drawing_area();
        picture.draw(&area).map_err(|error| drawing(&error))?;
    }
    let (width, height, pixels) = averaged(&pixels, width, height);
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    let written = encoder.write_header().and_then(|mut file| file.write_image_data(&pixels));
    written.map_err(|error| drawing(&error))?;
    Ok(bytes)
}

impl Picture<'_> {
    fn write(&self, path: &Path) -> Result<(), PlotError> {
        if self.panels.is_empty() { Err(PlotError::Nothing) } else { write(self, path) }
    }
}

impl Drawn for Picture<'_> {
    fn size(&self) -> (u32, u32) {
        let height = TITLE_HEIGHT + self.panels.len() as u32 * PANEL_HEIGHT + TIME_AXIS_HEIGHT;
        (WIDTH * SCALE, height * SCALE)
    }

    fn draw<DB: DrawingBackend>(&self, area: &DrawingArea<DB, Shift>) -> DrawResult<DB> {
        area.fill(&WHITE)?;
        let (heading, mut rest) = area.split_vertically(TITLE_HEIGHT * SCALE);
        draw_title(&heading, self.title, &self.subtitle)?;
        for (index, panel) in self.panels.iter().enumerate() {
            let is_last = index + 1 == self.panels.len();
            let (own, below) = rest.split_vertically(PANEL_HEIGHT * SCALE);
            panel.draw(if is_last { &rest } else { &own }, is_last)?;
            rest = below;
        }
        area.present()
    }
}

fn draw_title<DB: DrawingBackend>(
    area: &DrawingArea<DB, Shift>,
    title: &str,
    subtitle: &str,
) -> DrawResult<DB> {
    let at = |x: u32, y: u32| ((x * SCALE) as i32, (y * SCALE) as i32);
    area.draw_text(title, &text(22, panel::INK), at(24, 16))?;
    area.draw_text(subtitle, &text(14, panel::FAINT), at(24, 42))
}

fn drawing(error: &impl ToString) -> PlotError {
    PlotError::Drawing(error.to_string())
}

/// Averages squares of `SMOOTHING` by `SMOOTHING` pixels.
fn averaged(pixels: &[u8], width: u32, height: u32) -> (u32, u32, Vec<u8>) {
    let (step, row) = (SMOOTHING as usize, width as usize * 3);
    let (columns, rows) = (width / SMOOTHING, height / SMOOTHING);
    let mut means = Vec::with_capacity(columns as usize * rows as usize * 3);
    for y in 0..rows as usize {
        for x in 0..columns as usize {
            for channel in 0..3 {
                let at = |i: usize| (y * step + i / step) * row + (x * step + i % step) * 3;
                let sum: usize =
                    (0..step * step).map(|i| usize::from(pixels[at(i) + channel])).sum();
                means.push((sum / (step * step)) as u8);
            }
        }
    }
    (columns, rows, means)
}

type DrawResult<DB> = Result<(), DrawingAreaErrorKind<<DB as DrawingBackend>::ErrorType>>;

fn text(size: u32, color: RGBColor) -> TextStyle<'static> {
    (FONT, f64::from(size * SCALE)).into_font().color(&color)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn curves_share_a_panel_if_their_units_and_sizes_are_alike() {
        let column = |name: &str, unit: &str, value: f64| Column {
            name: name.to_owned(),
            unit: unit.to_owned(),
            kind: ColumnKind::Output,
            doc: String::new(),
            values: vec![0.0, -value, f64::NAN],
        };
        let all = [
            column("force", "N", 8000.0),
            column("pull", "N", 900.0),
            column("twist", "rad", 1e-3),
            column("friction", "N", 2.0),
            column("none", "N", 0.0),
            column("angle", "rad", 30.0),
        ];
        let groups = alike(&all).into_iter();
        let names = groups.map(|same| same.iter().map(|c| c.name.as_str()).collect::<Vec<_>>());
        let expected: [&[&str]; 4] =
            [&["force", "pull", "none"], &["twist"], &["friction"], &["angle"]];
        assert_eq!(names.collect::<Vec<_>>(), expected);
    }

    #[test]
    fn the_font_that_plots_carry_parses() {
        assert!(
            register_font("test", FontStyle::Normal, epaint_default_fonts::UBUNTU_LIGHT).is_ok()
        );
    }

    #[test]
    fn smoothing_averages_each_square() {
        let black_and_white = [0, 0, 0, 255, 255, 255, 255, 255, 255, 0, 0, 0];
        assert_eq!(averaged(&black_and_white, 2, 2), (1, 1, vec![127, 127, 127]));
    }
}
