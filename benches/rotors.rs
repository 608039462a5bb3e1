//! Growth of cost with the length of a chain of rotors and couplings, each a unit, driven and
//! braked at its first rotor, with fitted exponents: derivation by our own algebra, operations and
//! memory, equilibrium, and all natural motions with their shapes.
//!
//! `cargo bench -p machinist-tests --features measure --bench rotors`

mod growth;

use std::error::Error;
use std::fmt::Write as _;
use std::time::Instant;

use growth::{Row, bytes, fastest, print};
use machinist::Simulation;
use machinist::linear_analysis::{Linearization, Place, operating_point};
use machinist_algebra::cas::Algebra;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_model::{Model, ModelSimulator, operations};

const DERIVED: [usize; 4] = [100, 300, 1000, 3000];
/// No larger chains, because shapes need as much memory as the square of the number of states.
const ANALYSED: [usize; 3] = [100, 300, 1000];
const MS: f64 = 1e3;

fn main() -> Result<(), Box<dyn Error>> {
    // Work done once a process must not count for the first row.
    derive(10)?;
    let rows = DERIVED.map(|size| derive(size).map(|(_, costs)| Row { size, costs }));
    let rows: Vec<_> = rows.into_iter().collect::<Result<_, _>>()?;
    let what = ["derive [ms]", "operations of rate and Jacobian", "held at most [kB]"];
    print("chain of rotors", "rotors", &what, &rows);
    let rows = ANALYSED.map(|size| analyse(size).map(|costs| Row { size, costs }));
    let rows: Vec<_> = rows.into_iter().collect::<Result<_, _>>()?;
    let what = ["derive [ms]", "equilibrium [ms]", "modes [ms]", "in all [ms]"];
    print("chain of rotors", "rotors", &what, &rows);
    Ok(())
}

/// Returns the model of a chain, and its costs.
fn derive(rotors: usize) -> Result<(Model, [f64; 3]), Box<dyn Error>> {
    let folder = tempfile::tempdir()?;
    let path = folder.path().join("rotors.toml");
    std::fs::write(&path, spec(rotors)?)?;
    let derived = || {
        let system = pipeline::check(&path).map_err(|errors| errors.render())?;
        let model = pipeline::compile_by(Algebra::Plain, system, Keep::Needed);
        model.map_err(|errors| errors.render())
    };
    bytes::forget_most();
    let before = bytes::held();
    let model = derived()?;
    let most = bytes::most() - before;
    let seconds = fastest(|| {
        assert_eq!(derived().as_ref(), Ok(&model));
        1.0
    });
    let count = operations(&model.rate) + operations(&model.rate_jacobian.tape);
    Ok((model, [seconds * MS, count as f64, most as f64 * 1e-3]))
}

/// Times the analysis from the spec to the natural motions.
fn analyse(rotors: usize) -> Result<[f64; 4], Box<dyn Error>> {
    let (model, [derived, ..]) = derive(rotors)?;
    let simulator = ModelSimulator::compiled_at_once(model);
    let run = Simulation::new(&simulator);
    let begin = Instant::now();
    let point = operating_point(&run, Place::Equilibrium)?;
    let equilibrium = begin.elapsed().as_secs_f64() * MS;
    let begin = Instant::now();
    let modes = Linearization::at(&simulator, point)?.modes()?;
    let natural = begin.elapsed().as_secs_f64() * MS;
    assert!(modes.len() >= rotors, "{} natural motions of {rotors} rotors", modes.len());
    Ok([derived, equilibrium, natural, derived + equilibrium + natural])
}

fn spec(rotors: usize) -> Result<String, std::fmt::Error> {
    let mut text = "[scene]\nname = \"rotors\"\n".to_owned();
    for rotor in 0..rotors {
        writeln!(text, "[units.r{rotor}]\nunit = \"rotor\"\nparameters = {{ inertia = 2.0 }}")?;
    }
    for rotor in 1..rotors {
        let before = rotor - 1;
        writeln!(
            text,
            "[units.c{rotor}]\nunit = \"coupling\"\n\
             parameters = {{ stiffness = 5e3, damping = 50.0 }}\n\
             [[joints]]\nconnect = [\"r{before}.shaft\", \"c{rotor}.driving\"]\n\
             [[joints]]\nconnect = [\"c{rotor}.driven\", \"r{rotor}.shaft\"]"
        )?;
    }
    writeln!(
        text,
        "[[forces]]\nport = \"r0.shaft\"\n\
         expression = \"40 [N m s/rad]*(3 [rad/s] - r0.omega)\"\n\
         [initial]\n\"r0.omega\" = 1.0\n[outputs]\nlast = \"r{}.omega\"\n[run]\nuntil = 0.05",
        rotors - 1
    )?;
    Ok(text)
}
