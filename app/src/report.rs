//! Pages that show and verify all results: a page for each machine with a drawing, its run, checks,
//! equations, structure and costs; an index of them; a page of the studies. They need no network.
//!
//! Data are gathered first. The files in `src/report/` turn them into sections, and `page.rs` puts
//! them into a page.

mod conclusions;
mod equations;
mod fields;
mod figure;
mod gather;
mod index;
mod key;
mod ledger;
mod licences;
mod live;
mod machine;
mod modes;
mod page;
mod printed_figures;
mod reduction;
mod scene;
mod schematic;
mod space;
mod stability;
mod studies;
mod verification;
mod watched;
mod winder_walk;

pub use gather::{Extent, own, whole};
pub use live::{Headless, HeadlessDrawing};
pub use watched::{Beside, Content, Ran, page, troubles};
