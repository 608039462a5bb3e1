//! The command line of Machinist.

fn main() {}
