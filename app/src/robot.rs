//! Descriptions of robots in URDF, MJCF and SDF and as tables of Denavit and Hartenberg, as read and as a
//! spec.
//!
//! Excluded: meshes, transmissions, drives, sensors, contact and the extensions of simulators. Those
//! that would change the motion are named.

mod dh;
mod digits;
mod includes;
mod loops;
mod masses;
mod mjcf;
mod sdf;
mod shapes;
mod spec;
mod tendons;
mod tree;
mod urdf;
mod xml;

pub use dh::Convention;
pub use includes::Source;
pub use spec::Spec;
pub use tree::{Motion, Robot, RobotError};

/// Reads a robot from XML: MJCF if its root is `<mujoco>`, SDF if it is `<sdf>`, else URDF.
///
/// # Errors
/// The first mistake, with its line.
pub fn of_xml(text: &str) -> Result<Robot, RobotError> {
    let document = xml::parsed(text)?;
    let mut robot = match document.root_element().tag_name().name() {
        "mujoco" => mjcf::read(&document),
        "sdf" => sdf::read(&document),
        _ => urdf::read(&document),
    }?;
    robot.align();
    Ok(robot)
}

/// Reads a robot from a table of Denavit and Hartenberg.
///
/// # Errors
/// The first mistake, with its line.
pub fn of_table(name: &str, text: &str, convention: Convention) -> Result<Robot, RobotError> {
    dh::read(name, text, convention)
}
