//! Scenes as functional mock-up units: archives, and their library as called by hosts of FMI 2.0
//! and 3.0.
#![allow(unsafe_code, reason = "what hosts call takes pointers")]

mod archives;
mod calls;
mod derivatives;
mod events;
mod fmi2;
mod host;
mod peers;
mod runs;
mod sources;
mod starts;
mod states;

pub use host::unpacked;
