//! Simulators emitted by Machinist.
//!
//! The modules under [`scenes`] are emitted from the specs in `specs/` by
//! `machinist gen`; they need [`machinist_contract`] and nothing else: `no_std`, no
//! allocation. Each has a Cargo feature of its own.
#![no_std]
#![forbid(unsafe_code)]

/// Simulators to be measured rather than used; emitted like [`scenes`].
#[cfg(feature = "bench")]
#[path = "scenes/bench/mod.rs"]
pub mod bench;
pub mod scenes;
