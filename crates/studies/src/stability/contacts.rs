//! Cases of contact, of winders and of fields.
//!
//! Fields have few elements: the cases strain methods, and the elements are verified elsewhere.

use super::Case;
use super::truth::Truth;
use crate::closed_form::OneSidedStop;
use crate::closed_form::winder::{
    BENCH_BOBBIN, BENCH_FORCE, BENCH_SHAPE, BobbinOscillator, Deflection,
};
use crate::verify::machine::{
    Machine, contact_oscillator, reed_beat_up_one_sided, saw_gin_shaft, shaft_with_rotors,
    winder_full, winder_linear,
};

/// Returns all cases of this file.
pub(super) fn all() -> Vec<Case> {
    let parts = [stops(), layers(), bounces(), shafts(), fells(), released_shafts()];
    parts.into_iter().flatten().collect()
}

/// Returns a case without a closed form.
fn converged(
    part: &'static str,
    name: String,
    machine: &Machine,
    setting: (&'static str, f64),
    times: &[f64],
) -> Case {
    let (simulator, settings) = (machine.simulator(), vec![setting]);
    Case { part, name, simulator, settings, times: times.to_vec(), truth: Truth::Converged }
}

/// Returns a mass that meets stops of many stiffnesses, of which the last are met for a
/// microsecond.
fn stops() -> Vec<Case> {
    let machine = contact_oscillator();
    let case = |power: i32| {
        let stop =
            OneSidedStop { mass: 1.0, stiffness: 400.0, distance: 0.005, stop: 10f64.powi(power) };
        let closed = move |t| {
            let now = stop.motion(t, -0.02);
            vec![now.x, now.v, (now.switches % 2) as f64]
        };
        Case {
            part: "contact with a stop",
            name: format!("stop of {:.0e} N/m", stop.stop),
            simulator: machine.simulator(),
            settings: vec![("stop.stiffness", stop.stop)],
            times: vec![0.3, 0.7, 1.1, 2.0],
            truth: Truth::Closed("stitched sinusoids", Box::new(closed)),
        }
    };
    [2, 4, 6, 8, 10, 12].map(case).into()
}

/// Returns the bench winder's bobbin on linear layers of many stiffnesses.
fn layers() -> Vec<Case> {
    let machine = winder_linear();
    let case = |power: i32| {
        let bobbin = BobbinOscillator { layer_stiffness: 10f64.powi(power), ..BENCH_BOBBIN };
        let closed = move |t| {
            let start = Deflection::default();
            let now = bobbin.motion(t, start, &[BENCH_FORCE], &[BENCH_SHAPE]);
            vec![now.value, now.rate]
        };
        Case {
            part: "layer of a winder",
            name: format!("layer of {:.0e} N/m", bobbin.layer_stiffness),
            simulator: machine.simulator(),
            settings: vec![("layer.stiffness", bobbin.layer_stiffness)],
            times: vec![0.01, 0.05, 0.2],
            truth: Truth::Closed("transient and steady response", Box::new(closed)),
        }
    };
    [2, 5, 8, 11].map(case).into()
}

/// Returns the bench winder's bobbin that leaves its drum, with layers of many stiffnesses and
/// with pressures from none to one that never lets it leave.
fn bounces() -> Vec<Case> {
    let machine = winder_full();
    let case = |name: String, setting| {
        converged("bobbin that leaves its drum", name, &machine, setting, &[0.03, 0.07, 0.1])
    };
    let layers =
        [1e3, 1e5, 1e7].map(|c: f64| case(format!("layer of {c:.0e} N/m"), ("layer.stiffness", c)));
    let pressures =
        [1.0, 1e2, 1e4].map(|n: f64| case(format!("pressure of {n:.0e} N"), ("holder.preload", n)));
    layers.into_iter().chain(pressures).collect()
}

/// Returns the saw gin on distributed shafts, soft and stiff.
fn shafts() -> Vec<Case> {
    let machine = saw_gin_shaft();
    let case = |modulus: f64| {
        let name = format!("shear modulus {modulus:.0e} Pa");
        let setting = ("saws.shear_modulus", modulus);
        converged("saw gin with a field", name, &machine, setting, &[0.02, 0.05, 0.1])
    };
    [1e8, 8e10, 1e13, 1e16].map(case).into()
}

/// Returns the reed that meets fells of many stiffnesses, on a shaft as a field.
fn fells() -> Vec<Case> {
    let machine = reed_beat_up_one_sided();
    let case = |stiffness: f64| {
        let name = format!("fell of {stiffness:.0e} N m/rad");
        let setting = ("fell.stiffness", stiffness);
        converged("reed against its fell, a field", name, &machine, setting, &[0.002, 0.006, 0.01])
    };
    [1e2, 1e4, 1e6, 1e7].map(case).into()
}

/// Returns a shaft with rotors, released twisted and without damping.
fn released_shafts() -> Vec<Case> {
    let machine = shaft_with_rotors();
    let case = |until: f64| Case {
        part: "conserved energy of a field",
        name: format!("shaft with rotors, {until} s"),
        simulator: machine.simulator(),
        settings: vec![("shaft.damping_time", 0.0)],
        times: (0..=200).map(|index| f64::from(index) * until / 200.0).collect(),
        truth: Truth::Energy,
    };
    [0.1, 10.0].map(case).into()
}
