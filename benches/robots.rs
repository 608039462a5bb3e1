//! Robots: growth of their derivation with the number of joints, and the speed of their rates.
//!
//! ```text
//! cargo bench -p machinist-tests --features measure --bench robots
//! MACHINIST_PINOCCHIO=venv/lib/python3.11/site-packages/cmeel.prefix MACHINIST_EIGEN=/usr/include/eigen3 \
//!     cargo bench -p machinist-tests --features measure --bench robots
//! ```
//!
//! `-- derive`, `-- speed` and `-- fall` after the command select a part. The second command measures Pinocchio (`pip install pin`) in the same run, compiled by g++ with `-O3
//! -march=native`, as emitted code is for the processor that it runs on. Rates and Jacobians of all
//! are compared. Runs of Pinocchio with scipy and of MuJoCo are measured if `MACHINIST_PYTHON` names an
//! interpreter with them.

#[path = "robots/derive.rs"]
mod derive;
#[path = "robots/fall.rs"]
mod fall;
#[path = "robots/measure.rs"]
mod measure;
#[path = "../tests/spatial/robots.rs"]
mod robots;
#[path = "robots/speed.rs"]
mod speed;
#[path = "growth/table.rs"]
mod table;

use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    let is_asked = |part: &str| {
        let mut parts = std::env::args().skip(1).filter(|argument| !argument.starts_with('-'));
        let first = parts.next();
        first.is_none_or(|first| first == part || parts.any(|other| other == part))
    };
    if is_asked("derive") {
        derive::print()?;
    }
    if is_asked("speed") {
        speed::print()?;
    }
    if is_asked("fall") {
        fall::print()?;
    }
    Ok(())
}
