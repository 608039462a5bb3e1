//! Models with damaged bytes: refused with a reason, or run without a panic, with the same bits by
//! interpreter and machine code. Shared like `mutation`.
#![allow(dead_code, reason = "every test takes what it needs")]

use std::fmt::Debug;

use fastrand::Rng;
use machinist_contract::{Describe, Simulator};
use machinist_model::file::{MARK, read, seal};
use machinist_model::{F64x2, Lane, Model, ModelSimulator};
use serde::ser::{Serialize, SerializeTuple, Serializer};

use super::mutation::damage_bytes;

/// Length of the header: mark, version, length and hash.
const HEADER: usize = 60;

/// Bytes that are written unchanged.
struct Raw<'a>(&'a [u8]);

impl Serialize for Raw<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(self.0.len())?;
        self.0.iter().try_for_each(|byte| tuple.serialize_element(byte))?;
        tuple.end()
    }
}

/// Returns a model damaged inside with a correct hash; sometimes the file itself is damaged.
pub fn damaged(rng: &mut Rng, model: &[u8], other: &[u8]) -> Vec<u8> {
    if rng.u32(0..20) == 0 {
        return damage_bytes(rng, model, other);
    }
    let mut content = model[HEADER..].to_vec();
    for _ in 0..[1, 1, 1, 2, 3, 8][rng.usize(0..6)] {
        content = damage_bytes(rng, &content, &other[HEADER..]);
    }
    seal(MARK, &Raw(&content))
}

/// Checks the rule for any bytes; returns whether they are a model.
pub fn refused_or_run(bytes: &[u8]) -> Result<bool, String> {
    match read(bytes) {
        Ok(stamped) => run(stamped.model).map(|()| true),
        Err(error) if error.to_string().trim().is_empty() => {
            Err("refused without words".to_owned())
        }
        Err(_) => Ok(false),
    }
}

/// Calls every function of a model in both ways.
pub fn run(model: Model) -> Result<(), String> {
    let interpreted = ModelSimulator::interpreted(model.clone());
    let compiled = ModelSimulator::compiled_at_once(model);
    // Descriptions only have to exist.
    let told = described(&interpreted);
    if told.is_empty() {
        return Err("describes nothing".to_owned());
    }
    for lane in [-1.5, 0.0, 0.25, 1e300] {
        same(&numbers::<f64>(&interpreted, lane), &numbers::<f64>(&compiled, lane))?;
    }
    same(&numbers::<F64x2>(&interpreted, 0.5), &numbers::<F64x2>(&compiled, 0.5))?;
    same(&of_fields(&interpreted), &of_fields(&compiled))
}

fn described(simulator: &ModelSimulator) -> String {
    let shape = simulator.shape();
    let mut text = format!("{shape:?} {:?}", simulator.run_defaults());
    let mut tell = |of: &dyn Debug| text.extend([format!("{of:?}")]);
    for index in 0..shape.states() {
        tell(&simulator.state(index));
        tell(&(simulator.state_kind(index), simulator.state_scale(index)));
        tell(&(simulator.is_mode(index), simulator.is_given(index)));
    }
    (0..shape.coordinates).for_each(|index| tell(&simulator.coordinate(index)));
    (0..shape.parameters).for_each(|index| tell(&simulator.parameter(index)));
    (0..shape.outputs).for_each(|index| tell(&simulator.output(index)));
    (0..simulator.events()).for_each(|index| tell(&simulator.event(index)));
    (0..simulator.constraints()).for_each(|index| tell(&simulator.constraint(index)));
    text
}

/// Returns the results of every function of a model at a state derived from its initial one.
fn numbers<R: Lane>(simulator: &ModelSimulator, shift: f64) -> Vec<(&'static str, Vec<f64>)>
where
    ModelSimulator: Simulator<R>,
{
    let shape = simulator.shape();
    let zero = R::literal(0.0);
    let defaults = (0..shape.parameters).map(|index| simulator.parameter_default(index));
    let p: Vec<R> = defaults.map(R::literal).collect();
    let mut all = Vec::new();
    let mut keep = |name: &'static str, length: usize, write: &dyn Fn(&mut [R])| {
        let mut values = vec![zero; length];
        write(&mut values);
        all.push((name, R::numbers(&values).to_vec()));
        values
    };
    let s: &dyn Simulator<R> = simulator;
    let states = shape.states();
    let start = keep("initial_state", states, &|v| s.initial_state(&p, v));
    let y: Vec<R> = start.into_iter().map(|value| value + R::literal(shift)).collect();
    let t = R::literal(shift);
    let counts = [shape.discontinuities, simulator.events(), simulator.constraints()];
    let [jumps, events, constraints] = counts;
    let resets = (0..events).map(|index| simulator.event(index).sets.len()).sum();
    let patterns = [
        simulator.mass_matrix_pattern(),
        simulator.rate_jacobian_pattern(),
        simulator.parameter_jacobian_pattern(),
        simulator.constraint_matrix_pattern(),
    ];
    let [mass, jacobian, by_parameters, g] = patterns.map(|pattern| pattern.entries.len());
    keep("discontinuities", jumps, &|v| s.discontinuities(&p, v));
    keep("rate", states, &|v| s.rate(t, &y, &p, v));
    keep("mass_matrix", mass, &|v| s.mass_matrix(t, &y, &p, v));
    keep("forcing", shape.coordinates, &|v| s.forcing(t, &y, &p, v));
    keep("rate_jacobian", jacobian, &|v| s.rate_jacobian(t, &y, &p, v));
    keep("parameter_jacobian", by_parameters, &|v| s.parameter_jacobian(t, &y, &p, v));
    keep("time_derivative", states, &|v| s.time_derivative(t, &y, &p, v));
    keep("outputs", shape.outputs, &|v| s.outputs(t, &y, &p, v));
    keep("energy", 1, &|v| v[0] = s.energy(t, &y, &p).kinetic);
    keep("power_balance", 1, &|v| v[0] = s.power_balance(t, &y, &p).supplied);
    keep("guards", events, &|v| s.guards(t, &y, &p, v));
    keep("guard_rates", events, &|v| s.guard_rates(t, &y, &p, v));
    keep("resets", resets, &|v| s.resets(t, &y, &p, v));
    keep("constraint_values", constraints, &|v| s.constraint_values(t, &y, &p, v));
    keep("constraint_rates", constraints, &|v| s.constraint_rates(t, &y, &p, v));
    keep("constraint_matrix", g, &|v| s.constraint_matrix(t, &y, &p, v));
    keep("kink_guards", simulator.kinks(), &|v| s.kink_guards(t, &y, &p, v));
    keep("kink_rates", simulator.kinks(), &|v| s.kink_rates(t, &y, &p, v));
    let c = keep("constants", s.constants(), &|v| s.prepare(&p, v));
    keep("prepared_rate", states, &|v| s.prepared_rate(t, &y, &p, &c, v));
    keep("prepared_rate_jacobian", jacobian, &|v| s.prepared_rate_jacobian(t, &y, &p, &c, v));
    if let Some(linear) = s.linear() {
        let numbers = 4 * linear.excitation_terms().len() + linear.slopes().len();
        keep("excitation", numbers, &|v| linear.excitation(t, &y, &p, v));
        keep("switches", linear.switches(), &|v| linear.switch_times(&p, v));
    }
    if let Some(taylor) = s.taylor().filter(|_| states > 0) {
        const ORDER: usize = 5;
        let work = taylor.series_workspace(ORDER);
        keep("series", (ORDER + 1) * states, &|v| {
            taylor.series(t, &y, &p, v, &mut vec![zero; work]);
        });
    }
    all
}

fn of_fields(simulator: &ModelSimulator) -> Vec<(&'static str, Vec<f64>)> {
    let simulator = simulator.with_fields();
    let shape = simulator.shape();
    let p: Vec<f64> = (0..shape.parameters).map(|k| simulator.parameter_default(k)).collect();
    let (t, x, point) = (0.25, 0.5, [0.1, -0.2, 0.3, 0.4]);
    let mut all = Vec::new();
    for k in 0..simulator.fields() {
        let field = simulator.field(k);
        let (parameters, places) = (field.parameters.len(), field.attachments.len() + 1);
        let mut keep = |name, length: usize, write: &dyn Fn(&mut [f64])| {
            let mut values = vec![0.0; length];
            write(&mut values);
            all.push((name, values));
        };
        keep("inertia", 1, &|v| v[0] = simulator.field_inertia(k, x, &p));
        keep("force", 2, &|v| v.copy_from_slice(&simulator.field_force(k, t, x, &point, &p)));
        keep("force_jacobian", 8, &|v| {
            v.copy_from_slice(&simulator.field_force_jacobian(k, t, x, &point, &p));
        });
        keep("energy", 2, &|v| v.copy_from_slice(&simulator.field_energy(k, t, x, &point, &p)));
        keep("power", 3, &|v| v.copy_from_slice(&simulator.field_power(k, t, x, &point, &p)));
        keep("initial", 2, &|v| v.copy_from_slice(&simulator.field_initial(k, x, &p)));
        keep("places", places, &|v| simulator.field_places(k, &p, v));
        keep("places_gradient", places * parameters, &|v| {
            simulator.field_places_gradient(k, &p, v);
        });
        keep("inertia_gradient", 1 + parameters, &|v| {
            simulator.field_inertia_gradient(k, x, &p, v);
        });
        keep("force_gradient", 2 * (2 + parameters), &|v| {
            simulator.field_force_gradient(k, t, x, &point, &p, v);
        });
    }
    all
}

/// Equal bits; of what is no number the bits are anybody's.
fn same(
    one: &[(&'static str, Vec<f64>)],
    other: &[(&'static str, Vec<f64>)],
) -> Result<(), String> {
    for ((name, one), (_, other)) in one.iter().zip(other) {
        let is_same = |a: &f64, b: &f64| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
        if one.len() != other.len() || !one.iter().zip(other).all(|(a, b)| is_same(a, b)) {
            return Err(format!("{name} differs: {one:?} interpreted, {other:?} compiled"));
        }
    }
    Ok(())
}
