//! Rigid bodies in space: trees of joints, their kinematics and their equations of motion.
//!
//! Excluded: text and names to look up, which [`crate::scene`] has resolved, and the choice of an
//! algebra. All quantities of the recursions are shared parts of expressions, so their number is
//! linear in the number of joints, and nothing is expanded.

pub mod articulated;
pub mod mechanism;
pub mod orientation;
pub mod recursion;
pub mod vector;
