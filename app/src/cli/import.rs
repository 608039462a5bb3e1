//! `machinist import`: the description of a robot to a scene.

use std::path::{Path, PathBuf};

use clap::Args;
use machinist_codegen::pipeline;
use machinist_codegen::spec::MAX_FILE_BYTES;

use super::output::{print, require_ending, write_file};
use crate::failure::Failure;
use crate::robot::{self, Convention, Motion, Spec};

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
        let text = self.read()?;
        let file = self.robot.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let is_table = self.robot.extension().is_some_and(|ending| ending == "csv");
        if self.modified && !is_table {
            let message = "--modified is for Denavit-Hartenberg tables, which end in .csv";
            return Err(Failure::input(message, ""));
        }
        let read = if is_table {
            let convention =
                if self.modified { Convention::Modified } else { Convention::Standard };
            let stem = self.robot.file_stem().unwrap_or_default().to_string_lossy();
            robot::of_table(&stem, &text, convention)
        } else {
            robot::of_xml(&text)
        };
        let read = read.and_then(|mut robot| {
            if self.free_base {
                robot.release()?;
            }
            Ok(robot)
        });
        let robot = read.map_err(|error| {
            let line = if error.line > 0 { format!(":{}", error.line) } else { String::new() };
            let message = format!("{}{line}: {}", self.robot.display(), error.message);
            Failure::input(message, error.help)
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
        for axes in &robot.aligned {
            eprintln!("machinist: {axes}");
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

    fn read(&self) -> Result<String, Failure> {
        let file = |error: &std::io::Error| Failure::file(&self.robot, error);
        let metadata = std::fs::metadata(&self.robot).map_err(|error| file(&error))?;
        if !metadata.is_file() {
            let message = format!("{}: not a regular file", self.robot.display());
            return Err(Failure::input(message, ""));
        }
        let size = metadata.len();
        if size > MAX_FILE_BYTES {
            let message = format!("{}: {size} bytes are too many", self.robot.display());
            return Err(Failure::input(message, format!("at most {MAX_FILE_BYTES} are read")));
        }
        let bytes = std::fs::read(&self.robot).map_err(|error| file(&error))?;
        String::from_utf8(bytes).map_err(|_| {
            let message = format!("{}: not text in UTF-8", self.robot.display());
            Failure::input(message, "")
        })
    }
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
