//! Expressions that grow without bound, or are equal to zero in disguise, are derived or
//! rejected, in time and without a panic.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::support::machines;
use machinist_algebra::cas::Algebra;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::pipeline;
use machinist_model::Model;

/// Generous, for unoptimized code beside other builds. An unbounded derivation fails all the
/// same.
const PATIENCE: Duration = Duration::from_secs(60);

/// Returns a temporary file with a spec.
fn file(text: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().expect("temporary folder");
    let path = folder.path().join("made.toml");
    std::fs::write(&path, text).expect("write");
    (folder, path)
}

/// Returns the model of a spec by the default algebra, or its report. Every algebra returns one
/// or the other.
fn derived(text: &str) -> Result<Model, String> {
    let default = derived_by(Algebra::default(), text);
    for other in Algebra::ALL.iter().filter(|one| **one != Algebra::default()) {
        let found = derived_by(*other, text);
        assert_eq!(found.is_ok(), default.is_ok(), "{}: {:?}", other.name(), found.err());
    }
    default
}

fn derived_by(algebra: Algebra, text: &str) -> Result<Model, String> {
    let (folder, path) = file(text);
    let (sender, receiver) = std::sync::mpsc::channel();
    let own = path.clone();
    std::thread::spawn(move || {
        let model = pipeline::check(&own)
            .and_then(|system| pipeline::compile_by(algebra, system, Keep::Needed));
        // If it took too long, nothing receives the model.
        let _ = sender.send(model);
    });
    let start = Instant::now();
    let result = receiver.recv_timeout(PATIENCE);
    let result = result.unwrap_or_else(|_| panic!("no answer after {:?}", start.elapsed()));
    drop(folder);
    result.map_err(|errors| errors.render())
}

/// Returns a mass with this potential energy in N m. Names are x in m, dimensionless numbers a to
/// e, and x/1 m = u.
fn with_potential(potential: &str) -> String {
    format!(
        "[scene]\nname = \"mass\"\nsource = \"Textbook.\"\n[units.m]\nunit = \"held\"\n\
         [define.held.coordinates]\nx = {{ unit = \"m\" }}\n[define.held.parameters]\n\
         p = {{ value = 1.5, unit = \"1\" }}\na = {{ value = 1, unit = \"1\" }}\n\
         b = {{ value = 1, unit = \"1\" }}\nc = {{ value = 1, unit = \"1\" }}\n\
         d = {{ value = 1, unit = \"1\" }}\ne = {{ value = 1, unit = \"1\" }}\n\
         mass = {{ value = 1, unit = \"kg\" }}\n[define.held.helpers]\n\
         u = {{ expression = \"x/1 [m]\", unit = \"1\" }}\n[define.held.energy]\n\
         kinetic = \"mass*x_dot^2/2\"\npotential = \"1 [N m]*({potential})\"\n\
         [outputs]\nplace = \"m.x\"\n[run]\nuntil = 1\npoints = 2\nrtol = 1e-6\n\
         method = \"dop853\"\n"
    )
}

#[test]
fn numbers_of_twenty_thousand_digits_are_handed_over_in_time() {
    derived(&with_potential("asin((1e-320)^64)*u")).expect("is derived");
}

/// Symbolica took most of a minute for sixty-five thousand digits.
#[test]
fn numbers_that_powers_make_too_long_are_refused() {
    let report = refusal("((t/1 [s] + u)*((1e-16)^64))^64");
    assert!(report.contains("nested powers exceed"), "{report}");
}

/// Its derivative by the force contains the sign of the force.
#[test]
fn a_guard_may_hold_the_size_of_a_force() {
    let text = "[scene]\nname = \"gripped\"\n[units.block]\nunit = \"block\"\n[run]\n\
                until = 1\npoints = 11\nrtol = 1e-6\nmethod = \"tsit5\"\n\
                [outputs]\nx = \"block.x\"\n[define.block.coordinates.x]\nunit = \"m\"\n\
                [define.block.constraints.grip]\nexpression = \"x_dot\"\n\
                [define.block.events.breaks]\nguard = \"abs(grip) - 3 [N]\"\n\
                [define.block.energy]\nkinetic = \"1 [kg]*x_dot^2\"\n";
    derived(text).expect("is derived");
}

/// Factoring 1000^64 + a^65 is a search without end.
#[test]
fn high_powers_with_large_numbers_are_derived_in_time() {
    for potential in ["((1000/a)^64 + a)*u", "((0 + 1e3/a)^64 + a)*u^2"] {
        derived(&with_potential(potential)).expect("is derived");
    }
}

/// Each number is finite, and results of the equations are not: such a model was written, and
/// could not be read again.
#[test]
fn equations_with_numbers_beyond_all_bounds_are_refused() {
    for potential in ["((1e9/a)^64 + a)*u", "((0 + 1e9/a)^64 + a)*u^2", "atan(u/1e-308)^2"] {
        let report = derived(&with_potential(potential)).expect_err("is refused");
        assert!(report.contains("is not a finite number"), "{report}");
        assert!(report.contains("a large number to a high power"), "{report}");
    }
}

/// Computing an excitation takes memory for each power of time.
#[test]
fn powers_of_time_have_a_bound_beyond_which_they_are_stepped_through() {
    let inner = "((t/1 [s])^8 + p)^8";
    for (excitation, is_solved) in [(inner.to_owned(), true), (format!("({inner} + p)^3"), false)] {
        let model = derived(&with_potential(&format!("u*{excitation}"))).expect("is derived");
        assert_eq!(model.excitation.is_some(), is_solved, "{excitation}");
    }
}

fn refusal(potential: &str) -> String {
    let report = derived(&with_potential(potential)).expect_err("is refused");
    assert!(report.contains("made.toml:"), "no place in {report}");
    report
}

#[test]
fn what_is_zero_in_disguise_is_no_denominator() {
    for (potential, expected) in [
        ("1/(p - p)", "division by zero"),
        ("1/(0*p)", "division by zero"),
        ("u/((1 + p)^2 - 1 - 2*p - p^2)", "division by zero"),
        ("(u - u)^(-2)", "division by zero"),
        ("1/(sin(u)^2 + cos(u)^2 - 1)", "division by zero"),
        ("ln(p - p)", "the logarithm of zero"),
        ("ln(u/u - 1)", "the logarithm of zero"),
    ] {
        let report = refusal(potential);
        assert!(report.contains(expected), "{potential}: {report}");
    }
}

#[test]
fn the_power_zero_of_anything_is_one() {
    assert!(derived(&with_potential("u^2 + (p - p)^0")).is_ok());
}

#[test]
fn powers_are_raised_from_the_right() {
    let value = |potential: &str| {
        let model = derived(&with_potential(potential)).expect("derived");
        model.forcing.nodes.len()
    };
    assert_eq!(value("u^2^3"), value("u^8"));
    assert_eq!(value("u^(2^3)"), value("u^8"));
}

#[test]
fn large_powers_and_products_are_derived_without_multiplying_them_out() {
    let sums: Vec<String> = (1..=20).map(|i| format!("(a + b + {i}*c + u)")).collect();
    for potential in ["((1 + u)^64)^64", "(a + b + c + d + e + u)^64", sums.join("*").as_str()] {
        if let Err(report) = derived(&with_potential(potential)) {
            panic!("{potential}: {report}");
        }
    }
}

#[test]
fn what_grows_by_differentiation_is_refused_before_it_does() {
    let nested = format!("{}u{}", "sin(".repeat(190), ")".repeat(190));
    assert!(refusal(&nested).contains("second derivative"));
    let shallow = format!("{}u{}", "sin(".repeat(30), ")".repeat(30));
    assert!(derived(&with_potential(&shallow)).is_ok());
}

#[test]
fn deep_nests_of_quotients_and_sines_are_derived() {
    for (open, close) in [("1/(1 + ", ")"), ("sin(", ")")] {
        let nested = format!("{}u{}", open.repeat(40), close.repeat(40));
        if let Err(report) = derived(&with_potential(&nested)) {
            panic!("{open}: {report}");
        }
    }
}

#[test]
fn a_number_of_sixty_thousand_digits_is_refused() {
    let digits = "3".repeat(60_000);
    for number in [format!("0.{digits}"), format!("1.{digits}e5")] {
        assert!(refusal(&format!("{number}*u^2")).contains("at most 800 digits"));
    }
}

#[test]
fn helpers_that_square_each_other_are_derived() {
    let mut helpers = String::from("a0 = { expression = \"u\", unit = \"1\" }\n");
    for i in 1..=9 {
        let before = i - 1;
        let expression = format!("a{before}*a{before} + u");
        let _ = writeln!(helpers, "a{i} = {{ expression = \"{expression}\", unit = \"1\" }}");
    }
    let text = with_potential("a9")
        .replace("[define.held.energy]", &format!("{helpers}[define.held.energy]"));
    if let Err(report) = derived(&text) {
        panic!("{report}");
    }
}

#[test]
fn bodies_that_attract_each_other_derive_in_time() {
    let model = derived(&machines::bodies(5)).expect("derived");
    assert_eq!(model.coordinates.len(), 10);
    // Nothing changes if all of them move together, so two positions are integrated only for
    // outputs.
    assert_eq!(model.states.len(), 20);
    let needed = model.rate_jacobian.pattern.entries.len();
    assert!(needed > 0);
}

#[test]
fn a_chain_of_rotors_derives_in_time() {
    let model = derived(&machines::rotors(40)).expect("derived");
    assert_eq!(model.coordinates.len(), 40);
}

#[test]
fn positions_that_nothing_joins_derive_in_time() {
    let model = derived(&machines::uncoupled(60)).expect("derived");
    // No output needs the angles.
    assert_eq!(model.states.len(), 60);
}

#[test]
fn pendulums_of_several_links_derive_in_time() {
    let model = derived(&machines::pendulum(6)).expect("derived");
    assert_eq!(model.states.len(), 12);
}

#[cfg(unix)]
#[test]
fn a_unit_that_is_a_link_to_another_file_is_refused_unquoted() {
    let (folder, path) = file(&with_potential("u^2").replace("\"held\"", "\"secret\""));
    let outside = tempfile::tempdir().expect("temporary folder");
    let target = outside.path().join("secret");
    std::fs::write(&target, "PASSWORD = hunter2 is no TOML").expect("write");
    std::os::unix::fs::symlink(&target, folder.path().join("secret.toml")).expect("link");
    let report = pipeline::check(Path::new(&path)).expect_err("is refused").render();
    assert!(report.contains("a link to a place outside"), "{report}");
    assert!(!report.contains("hunter2"), "{report}");
}
