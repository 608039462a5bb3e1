//! What users rely on, one module a subject; `cargo test --test suite events::` runs one.

mod common;
mod own_scene;

mod bench_scenes;
mod bends;
mod campbell;
mod chains;
mod classics;
mod complex_step;
mod constraints;
mod contacts;
mod events;
mod exact;
mod fields;
mod fits;
mod independent;
mod interpreted;
mod kinks;
mod linear_analysis;
mod massless;
mod methods;
mod narrow;
mod onsets;
mod orders;
mod parts;
mod place;
mod prepared;
mod sensitivities;
mod series;
mod simulate;
mod sparsity;
mod sweep;
mod taylor;
mod unrolled;
mod variable_mass;
mod wasm;
