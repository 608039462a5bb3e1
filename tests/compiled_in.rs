//! Features that a program does not request are not compiled into it.

mod common;

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use common::HardSpring;
use machinist::{Method, SimulateError, Simulation};

/// Returns the names of the crates that a set of features of this crate links, according to Cargo.
fn linked(features: &str) -> BTreeSet<String> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let tree = Command::new(cargo)
        .args(["tree", "--offline", "--locked", "--package", "machinist", "--edges", "normal"])
        .args(["--prefix", "none", "--no-default-features", "--features", features])
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")))
        .output()
        .expect("cargo starts");
    assert!(tree.status.success(), "{}", String::from_utf8_lossy(&tree.stderr));
    let tree = String::from_utf8(tree.stdout).expect("text");
    let names = tree.lines().filter_map(|line| line.split_whitespace().next());
    names.map(str::to_owned).collect()
}

#[test]
fn explicit_methods_link_no_other_solver_and_no_computer_algebra() {
    let names = linked("");
    assert!(names.contains("machinist-contract"), "{names:?}");
    for name in ["diffsol", "faer", "rayon", "symbolica"] {
        assert!(!names.contains(name), "{name} is linked");
    }
    for name in ["machinist-algebra", "machinist-codegen", "machinist-model"] {
        assert!(!names.contains(name), "{name} is linked");
    }
}

#[test]
fn each_family_of_methods_links_what_it_needs_only() {
    let implicit = linked("implicit");
    assert!(!implicit.contains("diffsol") && !implicit.contains("faer"), "{implicit:?}");
    assert!(linked("diffsol").contains("diffsol"));
    let everything = linked("diffsol,implicit,linear,sweep");
    assert!(!everything.contains("symbolica"), "{everything:?}");
}

#[test]
fn a_family_that_is_off_has_no_methods_and_says_how_to_get_them() {
    for (feature, is_on) in
        [("diffsol", cfg!(feature = "diffsol")), ("implicit", cfg!(feature = "implicit"))]
    {
        let of_feature = Method::ALL.iter().filter(|method| method.feature() == Some(feature));
        for &method in of_feature.filter(|method| method.suits(&HardSpring)) {
            assert_eq!(method.is_compiled_in(), is_on, "{method}");
            match Simulation::new(&HardSpring).until(0.1).method(method).run() {
                Ok(_) => assert!(is_on, "{method}"),
                Err(SimulateError::NotCompiledIn(error)) => {
                    assert!(!is_on, "{method}");
                    let error = error.to_string();
                    for part in [method.name(), &format!("`{feature}`"), "tsit5, dop853"] {
                        assert!(error.contains(part), "{error} lacks {part}");
                    }
                }
                Err(error) => panic!("{method}: {error}"),
            }
        }
    }
}

#[test]
fn explicit_methods_are_always_there_and_agree() {
    let end = |method| {
        let run = Simulation::new(&HardSpring).until(1.0).rtol(1e-10).method(method).run();
        run.expect("a run").columns[0].values.last().copied().expect("a value")
    };
    assert!(Method::Taylor.is_compiled_in());
    assert!((end(Method::Tsit5) - end(Method::Dop853)).abs() < 1e-8);
}
