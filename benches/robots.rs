//! Robots: growth of their derivation with the number of joints, and the speed of their rates.
//!
//! ```text
//! cargo bench -p machinist-tests --features measure --bench robots
//! MACHINIST_PINOCCHIO=venv/lib/python3.11/site-packages/cmeel.prefix MACHINIST_EIGEN=/usr/include/eigen3 \
//!     cargo bench -p machinist-tests --features measure --bench robots
//! ```
//!
//! The second measures Pinocchio (`pip install pin`) in the same run, compiled by g++ with `-O3
//! -march=native`, as emitted code is for the processor that it runs on. Rates and Jacobians of all
//! are compared.

#[path = "robots/derive.rs"]
mod derive;
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
    derive::print()?;
    if std::env::args().any(|argument| argument == "derive") {
        return Ok(());
    }
    speed::print()
}
