//! Command-line values that a spec would refuse, and parameters that nothing uses.

use std::fs;

use crate::process::{REPOSITORY, answer, assert_refused, machinist};

/// Writes the example of the gear with a parameter that nothing uses.
fn gear() -> tempfile::TempDir {
    let example = format!("{REPOSITORY}/specs/scenes/parts/rotational/gear.toml");
    let text = fs::read_to_string(example).expect("an example");
    let text = format!("{text}\n[parameters]\nspare = {{ value = 1, unit = \"m\" }}\n");
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("gear.toml"), text).expect("written");
    folder
}

#[test]
fn set_refuses_what_the_file_would_refuse_and_writes_nothing() {
    let folder = gear();
    let rule = "the ratio of port `gear.a` is a number other than 0, but it is 0";
    for arguments in [
        &["run", "gear.toml", "--set", "gear.ratio=0", "--out", "run.csv"][..],
        &["modes", "gear.toml", "--set", "gear.ratio=0"],
        &["verify", "gear.toml", "--set", "gear.ratio=0"],
        &["spectrum", "gear.toml", "--outputs", "motor", "--set", "gear.ratio=0"],
    ] {
        let command = machinist(&folder, &[arguments, &["--algebra", "plain"]].concat());
        let output = crate::process::output(command);
        let said = crate::process::said(&output) + &*String::from_utf8_lossy(&output.stdout);
        let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(!output.status.success(), "{arguments:?}: {said}");
        assert!(said.contains(rule) || said.contains("a number other than 0"), "{said}");
    }
    assert!(!folder.path().join("run.csv").exists());
    let run = ["run", "gear.toml", "--set", "gear.ratio=0", "--algebra", "plain"];
    assert_refused(machinist(&folder, &run), &[rule]);
    let good = ["run", "gear.toml", "--set", "gear.ratio=-2", "--algebra", "plain"];
    answer(machinist(&folder, &good));
}

#[test]
fn a_parameter_that_nothing_uses_is_told_to_be_unused_by_every_command() {
    let folder = gear();
    for arguments in [
        &["run", "gear.toml", "--set", "spare=2"][..],
        &["campbell", "gear.toml", "--parameter", "spare=1..2"],
        &["sweep", "gear.toml", "--parameter", "spare=1..2", "--count", "2"],
        &["modes", "gear.toml", "--set", "spare=2"],
        &["modes", "gear.toml", "--at", "initial", "--sensitivities", "spare"],
        &["run", "gear.toml", "--sensitivities", "spare"],
        &["gradient", "gear.toml", "--of", "max(motor)", "--set", "spare=2"],
    ] {
        let command = machinist(&folder, &[arguments, &["--algebra", "plain"]].concat());
        let words = "nothing in scene `rotational_gear` uses parameter `spare`";
        assert_refused(command, &[words]);
    }
    let command = ["run", "gear.toml", "--set", "spar=2", "--algebra", "plain"];
    assert_refused(machinist(&folder, &command), &["has no parameter `spar`"]);
}
