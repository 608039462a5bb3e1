//! Help in groups, and tables in the width of the terminal.

use std::collections::BTreeSet;

use crate::process::{REPOSITORY, answer, machinist};

/// Returns the names of commands below each heading of `machinist --help`.
fn groups(help: &str) -> Vec<(&str, Vec<&str>)> {
    let mut groups: Vec<(&str, Vec<&str>)> = Vec::new();
    for line in help.lines() {
        if let Some(heading) = line.strip_suffix(':').filter(|line| !line.starts_with(' ')) {
            groups.push((heading, Vec::new()));
        } else if let Some((_, names)) = groups.last_mut()
            && let Some(line) = line.strip_prefix("  ").filter(|line| !line.starts_with([' ', '-']))
        {
            names.extend(line.split_whitespace().next());
        }
    }
    groups.retain(|(_, names)| !names.is_empty());
    groups
}

#[test]
fn every_command_is_in_one_group_of_the_help() {
    let help = answer(machinist(REPOSITORY, &["--help"]));
    let groups = groups(&help);
    let names: Vec<&str> = groups.iter().map(|(group, _)| *group).collect();
    assert_eq!(names, ["Everyday", "Analyse", "Decide", "Share", "Look", "Project"]);
    let listed: Vec<&str> = groups.iter().flat_map(|(_, names)| names.iter().copied()).collect();
    let once: BTreeSet<&str> = listed.iter().copied().collect();
    assert_eq!(once.len(), listed.len(), "{listed:?}");
    let program = machinist_app::command();
    let all = program.get_subcommands().filter(|command| !command.is_hide_set());
    assert_eq!(once, all.map(clap::Command::get_name).collect(), "{help}");
}

#[test]
fn the_help_of_every_command_fits_the_width() {
    for command in machinist_app::command().get_subcommands() {
        if command.is_hide_set() {
            continue;
        }
        let help = answer(machinist(REPOSITORY, &[command.get_name(), "--help"]));
        for line in help.lines().filter(|line| !line.starts_with("Usage:")) {
            assert!(line.chars().count() <= 100, "{}: {line}", command.get_name());
        }
    }
}

/// Commands that print tables.
const TABLES: [&[&str]; 12] = [
    &["list"],
    &["parts"],
    &["parts", "show", "rotational/clutch"],
    &["show", "saw_gin"],
    &["run", "saw_gin", "--until", "1ms"],
    &["modes", "winder_linear", "--at", "initial"],
    &["modes", "two_mass", "--at", "initial", "--sensitivities", "coupling.stiffness"],
    &["bench", "two_mass", "--methods", "tsit5", "--rtols", "1e-3", "--runs", "1"],
    &["stability", "--only", "Prothero-Robinson: lambda = -1e8"],
    &["verify", "two_mass", "--only", "derivation", "--long"],
    &["sensitivity", "two_mass", "--until", "1ms"],
    &["explain", "two_mass", "--without-times"],
];

#[test]
fn tables_fit_the_width_and_lose_nothing() {
    for arguments in TABLES {
        let within = |columns: &str| {
            let mut command = machinist(REPOSITORY, arguments);
            command.env("COLUMNS", columns);
            answer(command)
        };
        let wide = within("1000");
        let words = |text: &str| -> BTreeSet<String> {
            text.split_whitespace().map(str::to_owned).collect()
        };
        for width in [72, 100] {
            let text = within(&width.to_string());
            let is_table = |line: &&str| line.contains("  ");
            for line in text.lines().filter(is_table) {
                assert!(line.chars().count() <= width, "{arguments:?} at {width}: {line}");
            }
            let lost: Vec<String> = words(&wide).difference(&words(&text)).cloned().collect();
            // Times differ between runs of a benchmark.
            assert!(
                lost.is_empty() || arguments[0] == "bench",
                "{arguments:?} at {width}: {lost:?}"
            );
        }
    }
}

#[test]
fn reasons_and_references_of_checks_are_shown_on_demand() {
    let verify = |more: &[&str]| {
        let words = [&["verify", "two_mass", "--only", "independent"], more].concat();
        answer(machinist(REPOSITORY, &words))
    };
    let (short, long) = (verify(&[]), verify(&["--long"]));
    assert!(!short.contains("against") && long.contains("      against "), "{short}{long}");
    assert!(short.lines().count() < long.lines().count());
}

#[test]
fn the_ledger_of_a_study_lists_what_is_asked_for() {
    let ledger = |more: &[&str]| {
        answer(machinist(REPOSITORY, &[&["studies", "ledger", "--help"], more].concat()))
    };
    assert!(ledger(&[]).contains("--only"));
    let walk = machinist(REPOSITORY, &["walk", "--speed", "1.5"]);
    let output = crate::process::output(walk);
    assert!(output.status.success());
    assert!(crate::process::said(&output).contains("`walk` is now `studies walk`"));
}
