//! The machines of three studies by hand.
//!
//! Closed forms and hand-written equations ([`closed_form`]), the checks that hold
//! simulators against them ([`verify`]), what is printed beside what is right
//! ([`ledger`]), the reed's shaft cut another way ([`reed_cells`]), which model of a winder is enough ([`winder_walk`]), references in 31
//! digits ([`work_precision`]), and trials that strain methods ([`stability`]).
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
