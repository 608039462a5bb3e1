//! Three studies of machines, reproduced.
//!
//! Closed forms and hand-written equations ([`closed_form`]), checks that compare simulators with
//! them ([`verify`]), printed and correct values side by side ([`ledger`]), a second discretization
//! of the reed's shaft ([`reed_cells`]), the choice of a sufficient model of a winder
//! ([`winder_walk`]), references in 31 digits ([`work_precision`]), and extreme cases for methods
//! ([`stability`]).
#![forbid(unsafe_code)]

pub mod closed_form;
pub mod conclusions;
pub mod double_double;
pub mod ledger;
pub mod reed_cells;
pub mod reed_study;
pub mod stability;
pub mod verify;
pub mod winder_walk;
pub mod work_precision;
