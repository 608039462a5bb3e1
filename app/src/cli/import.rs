//! `machinist import`: the description of a robot to a scene.

use std::path::{Path, PathBuf};

use clap::Args;
use machinist_codegen::pipeline;
use machinist_codegen::spec::MAX_FILE_BYTES;

use super::output::{print, require_ending, write_file};
use crate::failure::Failure;
use crate::robot::{self, Convention, Motion, RobotError, Source, Spec};

#[derive(Debug, Args)]
pub struct Import {
    /// Robot in URDF, MJCF or SDF, ending in .urdf, .xml or .sdf, or a Denavit-Hartenberg table, ending in .csv
    robot: PathBuf,
    /// Scene to write, ending in .toml
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
    /// Let the base move freely, instead of fixing it to the world
    #[arg(long)]
    free_base: bool,
    /// The table is in the modified convention, in which a and alpha of a row precede its joint
    #[arg(long)]
    modified: bool,
}

impl Import {
    pub fn execute(&self) -> Result<(), Failure> {
        require_ending(&self.robot, &["urdf", "xml", "sdf", "csv"], "the robot")?;
        require_ending(&self.out, &["toml"], "--out")?;
        let file = self.robot.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let is_table = self.robot.extension().is_some_and(|ending| ending == "csv");
        if self.modified && !is_table {
            let message = "--modified is for Denavit-Hartenberg tables, which end in .csv";
            return Err(Failure::input(message, ""));
        }
        let source = if is_table {
            Source::of(&self.robot, read(&self.robot)?)
        } else {
            Source::read(&self.robot, &|path| read(path))?
        };
        let robot = if is_table {
            let convention =
                if self.modified { Convention::Modified } else { Convention::Standard };
            let stem = self.robot.file_stem().unwrap_or_default().to_string_lossy();
            robot::of_table(&stem, &source.text, convention)
        } else {
            robot::of_xml(&source.text)
        };
        let robot = robot.and_then(|mut robot| {
            if self.free_base {
                robot.release()?;
            }
            Ok(robot)
        });
        let robot = robot.map_err(|error| {
            let (file, line) = source.place(error.line);
            RobotError { line, ..error }.in_file(file)
        })?;
        let spec = Spec::new(&robot, &file).text();
        let warnings = checked(&spec, &self.out)?;
        write_file(&self.out, |out| out.write_all(spec.as_bytes()))?;
        for warning in warnings {
            eprintln!("{warning}");
        }
        for part in &robot.left_out {
            eprintln!("machinist: {part} of {file} is left out");
        }
        for joint in &robot.held {
            eprintln!("machinist: joint `{joint}` is fixed: its motion moves no inertia");
        }
        for joints in &robot.weak {
            eprintln!("machinist: {joints}");
        }
        for note in &robot.notes {
            eprintln!("machinist: {note}");
        }
        for closure in &robot.closures {
            let (name, count) = (&closure.joint.name, closure.constraints().len());
            let kind = if closure.is_planar { "planar loop" } else { "loop" };
            eprintln!("machinist: {count} constraints close the {kind} at joint `{name}`");
        }
        let moving = robot.joints.iter().filter(|joint| joint.motion != Motion::Fixed);
        print(&format!(
            "wrote {}: {} links, {} joints that move\n",
            self.out.display(),
            robot.links.len(),
            moving.count()
        ))
    }
}

/// Reads a text file of limited size.
fn read(path: &Path) -> Result<String, Failure> {
    let file = |error: &std::io::Error| Failure::file(path, error);
    let metadata = std::fs::metadata(path).map_err(|error| file(&error))?;
    if !metadata.is_file() {
        return Err(Failure::input(format!("{}: not a regular file", path.display()), ""));
    }
    let size = metadata.len();
    if size > MAX_FILE_BYTES {
        let message = format!("{}: {size} bytes are too many", path.display());
        return Err(Failure::input(message, format!("at most {MAX_FILE_BYTES} are read")));
    }
    let bytes = std::fs::read(path).map_err(|error| file(&error))?;
    String::from_utf8(bytes)
        .map_err(|_| Failure::input(format!("{}: not text in UTF-8", path.display()), ""))
}

/// Checks the scene before it is written, and returns its warnings.
fn checked(spec: &str, out: &Path) -> Result<Vec<String>, Failure> {
    let folder = tempfile::tempdir().map_err(|error| Failure::unsuccessful(error, ""))?;
    let path = folder.path().join(out.file_name().unwrap_or_default());
    std::fs::write(&path, spec).map_err(|error| Failure::file(&path, &error))?;
    let system = pipeline::check(&path)?;
    // Nobody knows the folder.
    let folder = folder.path().file_name().unwrap_or_default().to_string_lossy();
    let warnings = system.warnings.iter().map(|warning| {
        let text = format!("{:?}", miette::Report::new(warning.clone()));
        text.replace(&format!("{folder}/"), "")
    });
    Ok(warnings.collect())
}
