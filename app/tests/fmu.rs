//! Scenes as functional mock-up units: archives, and the library within them as a host of FMI
//! 3.0 calls it.
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
