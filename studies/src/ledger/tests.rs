use super::*;

fn find<'a>(rows: &'a [LedgerRow], figure: &str) -> &'a LedgerRow {
    rows.iter().find(|row| row.figure == figure).expect("the ledger has this figure")
}

#[test]
fn the_ledger_reproduces_what_can_be_reproduced() {
    let rows = ledger().expect("the consistent runs succeed");
    let close = |value: Option<f64>, expected: f64, tolerance: f64| {
        let value = value.expect("the figure exists");
        assert!((value - expected).abs() <= tolerance, "{value} against {expected}");
    };
    close(find(&rows, "torque at slip 0.02").consistent, 954.6866, 5e-5);
    close(find(&rows, "leakage factor 1 - Ks Kr").consistent, 0.089_888, 1e-12);
    close(find(&rows, "natural frequency on the coupling").consistent, 155.03, 5e-3);
    close(find(&rows, "speed 5 s after an empty start").consistent, 78.5398, 1e-3);
    close(find(&rows, "printed law of acceleration at 1.844 s").as_printed, 8743.54, 5e-3);
    close(find(&rows, "mean load, from its density along the shaft").as_printed, 5845.0, 2.0);
    let torque = find(&rows, "largest motor torque in an empty run-up");
    assert!(torque.consistent.expect("it runs") < 2100.0);
    assert!(torque.verdict.contains("with speed for angle 322"), "{}", torque.verdict);
}

#[test]
fn the_literal_reading_never_runs_up() {
    let rows = ledger().expect("the consistent runs succeed");
    let duration = find(&rows, "time until speed stays within 1 % of synchronous");
    assert_eq!(duration.as_printed, None);
    assert!(duration.consistent.expect("it runs up") < 1.0);
}

#[test]
fn the_mobility_table_is_reproduced_and_the_printed_amplitude_is_too_small() {
    let rows = ledger().expect("the consistent runs succeed");
    let mobility: Vec<&LedgerRow> =
        rows.iter().filter(|row| row.figure.starts_with("mobility")).collect();
    assert_eq!(mobility.len(), 5);
    assert!(mobility.iter().all(|row| row.verdict.starts_with("reproduced")));
    let force = find(&rows, "amplitude of the bobbin under force, bench model M5");
    // 25/sqrt(20390^2 + 10450^2) m against 25/sqrt(20390^2 + 21945^2) m.
    assert!((force.consistent.expect("a closed form") - 1.091_13e-3).abs() < 1e-8);
    assert!((force.as_printed.expect("a closed form") - 8.345_6e-4).abs() < 1e-8);
}

#[test]
fn every_row_has_a_verdict_and_a_line() {
    let rows = ledger().expect("the consistent runs succeed");
    assert!(rows.iter().all(|row| row.verdict.len() > 20));
    let text = render_ledger(&rows);
    for row in &rows {
        let says = |line: &&str| line.contains(row.figure) && line.contains(&row.verdict);
        assert_eq!(text.lines().filter(says).count(), 1, "{}", row.figure);
    }
}

#[test]
fn numbers_are_compared_in_words() {
    assert_eq!(compare(100.0, 101.0), "within 1 %");
    assert_eq!(compare(40_000.0, 2000.0), "20 times smaller");
    assert_eq!(compare(1.0, 1.62), "1.6 times larger");
    assert_eq!(compare(1.0, -1.0), "of the other sign");
    assert_eq!(compare(78.54, 78.54), "within 0 %");
}

#[test]
fn digits_are_significant_ones() {
    assert_eq!(digits(0.089_888), "0.089888");
    assert_eq!(digits(8_743.542_81), "8743.543");
    assert_eq!(digits(40_000.0), "40000");
    assert_eq!(digits(-0.5), "-0.5");
    assert_eq!(digits(0.0), "0");
}
