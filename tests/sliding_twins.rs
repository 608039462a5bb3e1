//! Random machines that slide along switching surfaces, against twins in which each comparison is
//! smooth over a small width, extrapolated to no width.

use std::fmt::Write as _;

use machinist::{Method, Simulation, Trajectory};
use machinist_codegen::mechanics::reduce::Keep;

use crate::own_scene::of_text;

const MACHINES: u64 = 24;
const POINTS: usize = 25;

/// Text of a machine: masses between springs, with relays on them. `sign` writes the sign of an
/// expression.
fn text(seed: u64, sign: impl Fn(&str) -> String) -> String {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut within = |low: f64, high: f64| low + (high - low) * random.f64();
    let masses = 1 + (within(0.0, 3.0) as usize).min(2);
    let (mut all, mut kinetic, mut potential) = (String::new(), vec![], vec![]);
    let (mut dissipation, mut forces, mut initial) = (vec![], String::new(), String::new());
    let mut force = |of: usize, expression: &str| {
        writeln!(
            forces,
            "[[define.u.forces]]\ncoordinate = \"x{of}\"\nexpression = \"{expression}\""
        )
        .expect("a string");
    };
    for mass in 0..masses {
        writeln!(all, "[define.u.coordinates.x{mass}]\nunit = \"m\"\nvelocity = \"v{mass}\"")
            .expect("a string");
        kinetic.push(format!("{} [kg]*v{mass}^2/2", within(0.3, 3.0)));
        potential.push(format!("{} [N/m]*x{mass}^2/2", within(2.0, 40.0)));
        dissipation.push(format!("{} [N*s/m]*v{mass}^2/2", within(0.05, 1.0)));
        writeln!(
            initial,
            "\"u.x{mass}\" = {}\n\"u.v{mass}\" = {}",
            within(-0.5, 0.5),
            within(-1.0, 1.0)
        )
        .expect("a string");
        if mass > 0 {
            let before = mass - 1;
            potential.push(format!("{} [N/m]*(x{mass} - x{before})^2/2", within(5.0, 60.0)));
        }
    }
    force(0, &format!("{} [N]*cos({} [rad/s]*t)", within(0.5, 4.0), within(0.8, 4.0)));
    for _ in 0..=(within(0.0, 2.0) as usize) {
        let mass = (within(0.0, masses as f64) as usize).min(masses - 1);
        let (size, belt) = (within(0.3, 6.0), within(-0.4, 0.4));
        match within(0.0, 4.0) as usize {
            // Dry friction against the ground, or against a belt.
            0 => force(mass, &format!("-{size} [N]*{}", sign(&format!("v{mass} - {belt} [m/s]")))),
            // Sliding-mode control.
            1 => {
                let slope = within(0.5, 4.0);
                let surface = format!("v{mass} + {slope} [1/s]*x{mass}");
                force(mass, &format!("-{size} [N]*{}", sign(&surface)));
            }
            // Friction between two masses.
            2 if mass > 0 => {
                let before = mass - 1;
                force(mass, &format!("-{size} [N]*{}", sign(&format!("v{mass} - v{before}"))));
                force(before, &format!("{size} [N]*{}", sign(&format!("v{mass} - v{before}"))));
            }
            // A surface that moves and bends.
            _ => {
                let (way, rate) = (within(0.05, 0.3), within(0.5, 2.0));
                let surface = format!(
                    "v{mass} + 0.5 [1/m]*v{mass}*x{mass} - {way} [m/s]*sin({rate} [rad/s]*t)"
                );
                force(mass, &format!("-{size} [N]*{}", sign(&surface)));
            }
        }
    }
    format!(
        "[scene]\nname = \"slides\"\n[units.u]\nunit = \"u\"\n[initial]\n{initial}\n\
         [run]\nuntil = 4.0\npoints = {POINTS}\nrtol = 1e-8\n{all}\n\
         [define.u.parameters]\nwidth = {{ value = 1e-3, unit = \"m/s\" }}\n\
         [define.u.energy]\nkinetic = \"{}\"\npotential = \"{}\"\ndissipation = \"{}\"\n{forces}",
        kinetic.join(" + "),
        potential.join(" + "),
        dissipation.join(" + "),
    )
}

fn final_states(run: &Trajectory) -> Vec<f64> {
    let of =
        |name: &'static str| (0..3).map_while(move |mass| run.last(&format!("u.{name}{mass}")));
    of("x").chain(of("v")).collect()
}

#[test]
fn random_machines_that_slide_are_the_limit_of_their_smooth_twins() {
    let mut sharp = 0;
    for seed in 0..MACHINES {
        let machine = of_text(&text(seed, |of| format!("sign({of})")), Keep::All);
        let twin = of_text(&text(seed, |of| format!("tanh(({of})/width)")), Keep::All);
        let [wide, middle, narrow] = [1e-4, 5e-5, 2.5e-5].map(|width| {
            let run = Simulation::new(&twin).method(Method::Radau).rtol(1e-10);
            let run = run.parameter("u.width", width).expect("a parameter").run();
            final_states(&run.unwrap_or_else(|stopped| panic!("twin of {seed}: {stopped}")))
        });
        // The error is of first order in the width.
        let limits = |wide: &[f64], narrow: &[f64]| -> Vec<f64> {
            wide.iter().zip(narrow).map(|(wide, narrow)| 2.0 * narrow - wide).collect()
        };
        let (coarse, expected) = (limits(&wide, &middle), limits(&middle, &narrow));
        let errors = coarse.iter().zip(&expected).map(|(a, b)| (a - b).abs());
        let error = errors.fold(0.0, f64::max);
        sharp += usize::from(error < 1e-5);
        for method in [Method::Auto, Method::Tsit5, Method::Dop853, Method::Radau, Method::Rodas5p]
        {
            let run = Simulation::new(&machine).method(method).run();
            let run = run.unwrap_or_else(|stopped| panic!("{method}, {seed}: {stopped}"));
            for (found, expected) in final_states(&run).iter().zip(&expected) {
                assert!(
                    (found - expected).abs() <= 3.0 * error + 1e-5,
                    "{method}, machine {seed}: {found} and not {expected} +- {error:e}"
                );
            }
        }
    }
    assert!(10 * sharp >= 9 * MACHINES as usize, "only {sharp} limits are sharp");
}
