//! One page that shows and proves everything: equations, structure, runs,
//! checks, costs and the reproduction ledger of all scenes. It needs no network.
//!
//! Data are gathered first, here; then the files in `src/report/` turn them into
//! sections, and `page.rs` puts the sections together.

mod equations;
mod fields;
mod figure;
mod gather;
mod ledger;
mod licences;
mod modes;
mod page;
mod reduction;
mod scene;
mod stability;
mod verification;
mod winder_walk;

pub use gather::page;
