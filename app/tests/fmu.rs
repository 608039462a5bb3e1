//! Scenes as functional mock-up units: archives, and their library as called by a host of FMI 3.0.
#![allow(unsafe_code, reason = "what hosts call takes pointers")]

mod archives;
mod calls;
mod derivatives;
mod events;
mod host;
mod peers;
mod runs;
mod starts;
mod states;
