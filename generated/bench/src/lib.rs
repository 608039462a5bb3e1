//! Simulators emitted by Machinist from the specs in `specs/scenes/bench`, to be measured rather than used. They are not
//! in `machinist-scenes`, so that nobody compiles them who does not measure.
#![no_std]
#![forbid(unsafe_code)]

mod scenes;

pub use scenes::*;
