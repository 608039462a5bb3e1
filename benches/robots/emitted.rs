//! The program that measures emitted robots. Its argument is a robot; state and parameters are read
//! from standard input.

mod measure;
mod panda;
mod ur5;

use std::io::Read as _;

use machinist_contract::Simulator;

fn main() {
    let robot: &dyn Simulator<f64> = match std::env::args().nth(1).as_deref() {
        Some("ur5") => &ur5::Ur5,
        _ => &panda::Panda,
    };
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text).expect("text");
    let numbers: Vec<f64> =
        text.split_whitespace().map(|number| number.parse().expect("a number")).collect();
    let (state, parameters) = numbers.split_at(robot.shape().states());
    let measured = measure::measure(robot, state, parameters);
    for numbers in [&measured.times[..], &measured.rate, &measured.jacobian] {
        let numbers: Vec<String> = numbers.iter().map(|number| format!("{number:e}")).collect();
        println!("{}", numbers.join(" "));
    }
}
