//! Robot descriptions in URDF, as read and as a spec.
//!
//! Excluded: shapes, meshes, transmissions, sensors and the extensions of simulators, which do not
//! take part in the equations of motion.

mod read;
mod robot;
mod spec;

pub use read::read;
pub use robot::Motion;
pub use spec::Spec;
