//! Runs the machine of `specs/own_machine.toml`, whose simulator `build.rs` emits, and prints it.

mod machine {
    machinist_contract::include_scene!("own_machine");
}

use machinist::trajectory::{Column, ColumnKind, Trajectory};
use machinist::{SimulateError, Simulation};

fn main() -> Result<(), SimulateError> {
    // As the spec says; `.until(5.0)`, `.rtol(1e-10)` and so on change that.
    let simulation = Simulation::new(&machine::OwnMachine);
    let run = simulation.parameter("lifting_torque", 3.0)?.run()?;
    println!("{} ({})", run.title, run.method);
    for note in &run.notes {
        println!("{note}");
    }
    print_outputs(&run, 11);
    Ok(())
}

/// Outputs at about so many times of a run, at least two.
fn print_outputs(run: &Trajectory, rows: usize) {
    let outputs: Vec<&Column> = run.of_kind(ColumnKind::Output).collect();
    let head = |output: &&Column| format!("{} [{}]", output.name, output.unit);
    let heads: Vec<String> = outputs.iter().map(head).collect();
    println!("\n{:>8}  {}", "time [s]", heads.join("  "));
    let every = ((run.times.len() - 1) / (rows - 1)).max(1);
    for row in (0..run.times.len()).step_by(every) {
        print!("{:>8.3}", run.times[row]);
        for (output, head) in outputs.iter().zip(&heads) {
            print!("  {:>1$.4}", output.values[row], head.len());
        }
        println!();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use machine::{Parameters, STATES, initial_state, rate, state};

    type State = [f64; STATES];

    fn run() -> Trajectory {
        let run = Simulation::new(&machine::OwnMachine).run();
        run.expect("a run to its end")
    }

    /// As the check of the spec says, here in Rust. `machinist verify specs/own_machine.toml`
    /// checks this and more.
    #[test]
    fn the_lifting_torque_alone_changes_the_momentum() {
        let p = Parameters::<f64>::default();
        let run = run();
        let momentum = run.column("momentum").expect("an output");
        for (time, momentum) in run.times.iter().zip(momentum) {
            let expected = p.gear_ratio * p.lifting_torque * (time - p.start).max(0.0);
            let error = momentum - expected;
            assert!(error.abs() < 1e-6, "{error} N m s at {time} s");
        }
    }

    /// As a controller would: plain arrays, steps of one size, nothing allocated.
    #[test]
    fn fixed_steps_lift_the_load_as_the_run_does() {
        const STEP: f64 = 5e-4;
        let p = Parameters::<f64>::default();
        // Until then it rests.
        let mut time = p.start;
        let mut y = initial_state(&p);
        while time < 2.0 - STEP / 2.0 {
            y = runge_kutta_step(time, STEP, &y, &p);
            time += STEP;
        }
        let expected = run().last("drum.omega").expect("a state");
        let difference = y[state::DRUM_OMEGA] - expected;
        assert!(difference.abs() < 1e-6, "{difference} rad/s");
    }

    /// One step of the classical Runge-Kutta method of fourth order.
    fn runge_kutta_step(t: f64, h: f64, y: &State, p: &Parameters<f64>) -> State {
        let along = |k: &State, h: f64| -> State { std::array::from_fn(|i| y[i] + h * k[i]) };
        let k1 = rate(t, y, p);
        let k2 = rate(t + h / 2.0, &along(&k1, h / 2.0), p);
        let k3 = rate(t + h / 2.0, &along(&k2, h / 2.0), p);
        let k4 = rate(t + h, &along(&k3, h), p);
        std::array::from_fn(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]))
    }
}
