//! An extended Kalman filter beside an emitted machine: its design and its memory, as arrays of
//! known sizes.

use std::fmt::Write as _;

use machinist_contract::Dual;
use machinist_contract::elimination::{Pivot, Unknown};
use machinist_contract::fixed_step::{
    Clock, ExtendedKalmanFilter, FilterSizes, FixedSteps, StepMethod,
};
use machinist_model::{Elimination, Model, ModelSimulator};

use super::{header, type_name};
use crate::emit::c99::EstimatorOptions;
use crate::emit::{EmitError, EmitOptions};

/// Emits the module of a filter. It refers to the module of its machine, `super::<scene>`, and calls
/// [`ExtendedKalmanFilter`]. `start` is the state at the start of the spec's run.
///
/// # Errors
/// [`EmitError`] for a number without a literal, and for a filter that cannot run.
pub fn emit_estimator(
    model: &Model,
    filter: &EstimatorOptions,
    method: StepMethod,
    start: &[f64],
    options: &EmitOptions,
) -> Result<String, EmitError> {
    let simulator = ModelSimulator::interpreted(model.clone());
    let simulator = simulator.single();
    let list = Elimination::new(model.states.len(), &model.rate_jacobian.pattern.entries);
    let of_machine = ExtendedKalmanFilter {
        simulator,
        method: method.with(list.borrowed()),
        parts_a_step: FixedSteps::<f64>::enough_parts(simulator),
        measured: &filter.measured,
        estimated: &filter.estimated,
        diffusing: &filter.diffusing,
        disturbed: &filter.disturbed,
    };
    if let Some(why) = of_machine.refusal() {
        return Err(EmitError::Unsupported { message: why.to_owned() });
    }
    let is_implicit = method == StepMethod::Rosenbrock2;
    let sizes = of_machine.sizes();
    let mut text = header::estimator_header(model, (filter, method, bytes(&sizes)), options);
    if is_implicit {
        text.push_str("use machinist_contract::elimination::{Elimination, Pivot, Unknown};\n");
    }
    text.push_str(
        "use machinist_contract::fixed_step::{\n    Clock, Correction, ExtendedKalmanFilter, \
         FilterMemory, FixedMethod, Stepped,\n};\nuse machinist_contract::{Dual, Simulator};\n\n",
    );
    let machine = type_name(&model.name);
    if sizes.constants == 0 {
        let _ = writeln!(text, "use super::{}::{machine};\n", model.name);
    } else {
        let _ = writeln!(text, "use super::{}::{{CONSTANTS, {machine}}};\n", model.name);
    }
    text.push_str(&design(model, filter, start)?);
    if is_implicit {
        text.push_str(&elimination(&list));
    }
    let method = match method {
        StepMethod::Heun => "Heun",
        StepMethod::RungeKutta4 => "RungeKutta4",
        StepMethod::Rosenbrock2 => "Rosenbrock2(ELIMINATION)",
    };
    let text_of = FILTER
        .replace("MACHINE", &machine)
        .replace("METHOD", method)
        .replace("PARTS", &of_machine.parts_a_step.to_string())
        .replace("FROM", &number("the start of the run", model.run.from)?)
        .replace("N_STATE", &sizes.state.to_string())
        .replace("N_PARAMETERS", &sizes.parameters.to_string())
        .replace("N_CONSTANTS", if sizes.constants == 0 { "0" } else { "CONSTANTS" })
        .replace("N_ROOT", &sizes.root.to_string())
        .replace("N_NUMBERS", &sizes.numbers.to_string())
        .replace("N_SIGNS", &sizes.signs.to_string())
        .replace("N_DUALS", &sizes.duals.to_string());
    text.push_str(&text_of);
    match syn::parse_file(&text) {
        Ok(_) => Ok(text),
        Err(error) => Err(EmitError::Unparsable { reason: error.to_string() }),
    }
}

/// Returns the bytes of an estimate with its workspace.
fn bytes(sizes: &FilterSizes) -> usize {
    let FilterSizes { state, parameters, constants, root, numbers, signs, duals } = sizes;
    let numbers = (state + parameters + constants + root + numbers) * size_of::<f64>();
    let bytes = size_of::<Clock<f64>>() + numbers + duals * size_of::<Dual>() + signs;
    bytes.next_multiple_of(align_of::<f64>())
}

/// Returns the constant that lists the elimination of a Rosenbrock step.
fn elimination(list: &Elimination) -> String {
    let of = list.borrowed();
    let lines = |items: Vec<String>, a_line: usize| -> String {
        let lines = items.chunks(a_line).map(|line| format!("        {},\n", line.join(", ")));
        lines.collect()
    };
    let numbers = |of: &[u32]| lines(of.iter().map(u32::to_string).collect(), 12);
    let pairs =
        |of: &[(u32, u32)]| lines(of.iter().map(|(a, b)| format!("({a}, {b})")).collect(), 8);
    let pivots = of.pivots.iter().map(|pivot| {
        let Pivot { place, rows_end, products_end } = pivot;
        format!("Pivot {{ place: {place}, rows_end: {rows_end}, products_end: {products_end} }}")
    });
    let unknowns = of.unknowns.iter().map(|unknown| {
        let Unknown { row, diagonal, terms_end: [lower, upper] } = unknown;
        format!("Unknown {{ row: {row}, diagonal: {diagonal}, terms_end: [{lower}, {upper}] }}")
    });
    let products = of.products.iter().map(|(place, a, b)| format!("({place}, {a}, {b})"));
    format!(
        "/// Elimination of `I - g h J`, with the structural zeros of the Jacobian left out.\n\
         const ELIMINATION: Elimination<'static> = Elimination {{\n    places: {},\n    entries: \
         &[\n{}    ],\n    pivots: &[\n{}    ],\n    rows: &[\n{}    ],\n    products: \
         &[\n{}    ],\n    unknowns: &[\n{}    ],\n    lower: &[\n{}    ],\n    upper: \
         &[\n{}    ],\n}};\n\n",
        of.places,
        numbers(of.entries),
        lines(pivots.collect(), 1),
        numbers(of.rows),
        lines(products.collect(), 6),
        lines(unknowns.collect(), 1),
        pairs(of.lower),
        pairs(of.upper),
    )
}

/// Returns a literal that reads back exactly.
fn number(place: &str, value: f64) -> Result<String, EmitError> {
    if value.is_finite() {
        Ok(format!("{value:?}"))
    } else {
        Err(EmitError::NotFinite { place: place.to_owned(), value })
    }
}

/// Returns the constants of the design.
fn design(model: &Model, filter: &EstimatorOptions, start: &[f64]) -> Result<String, EmitError> {
    let states = model.states.len();
    let output = |index: usize| &model.wanted[index];
    let parameter = |index: usize| &model.parameters[index].quantity;
    let entry = |index: usize| match index.checked_sub(states) {
        None => &model.states[index].quantity,
        Some(slot) => parameter(filter.estimated[slot]),
    };
    let mut text = String::new();
    let mut pairs = |doc: &str, name: &str, of: &[(usize, f64)], told: &dyn Fn(usize) -> String| {
        if of.is_empty() {
            let _ = writeln!(text, "/// {doc}\npub const {name}: [(usize, f64); 0] = [];\n");
            return Ok(());
        }
        let _ = writeln!(text, "/// {doc}\npub const {name}: [(usize, f64); {}] = [", of.len());
        for (index, value) in of {
            let value = number(name, *value)?;
            let _ = writeln!(text, "    ({index}, {value}), // {}", told(*index));
        }
        text.push_str("];\n\n");
        Ok::<(), EmitError>(())
    };
    let told = |quantity: &machinist_model::Quantity| {
        let unit = crate::emit::text::comment_lines(&quantity.unit).join(" ");
        format!("{} [{unit}]", quantity.name.path)
    };
    pairs(
        "Measured outputs, with the standard deviations of their noise.",
        "MEASURED",
        &filter.measured,
        &|index| told(output(index)),
    )?;
    pairs(
        "Entries that diffuse, with intensities per root of a second.",
        "DIFFUSING",
        &filter.diffusing,
        &|index| told(entry(index)),
    )?;
    pairs(
        "Disturbed parameters, with intensities times the root of a second.",
        "DISTURBED",
        &filter.disturbed,
        &|index| told(parameter(index)),
    )?;
    let count = filter.estimated.len();
    let doc = "/// Estimated parameters.\npub const ESTIMATED: [usize; ";
    if count == 0 {
        let _ = writeln!(text, "{doc}0] = [];\n");
    } else {
        let _ = writeln!(text, "{doc}{count}] = [");
        for index in &filter.estimated {
            let _ = writeln!(text, "    {index}, // {}", told(parameter(*index)));
        }
        text.push_str("];\n\n");
    }
    let count = filter.start.len();
    let _ = writeln!(
        text,
        "/// Standard deviations of the entries at the start: states, then estimated parameters.\n\
         pub const DEVIATIONS: [f64; {count}] = ["
    );
    for (index, value) in filter.start.iter().enumerate() {
        let value = number("DEVIATIONS", *value)?;
        let _ = writeln!(text, "    {value}, // {}", told(entry(index)));
    }
    text.push_str("];\n\n");
    let _ = writeln!(text, "/// State at the start.\npub const START: [f64; {states}] = [");
    for (index, value) in start.iter().enumerate() {
        let value = number("START", *value)?;
        let _ = writeln!(text, "    {value}, // {}", told(entry(index)));
    }
    text.push_str("];\n\n");
    Ok(text)
}

const FILTER: &str = "\
/// Returns the filter.
#[must_use]
pub fn filter() -> ExtendedKalmanFilter<'static> {
    ExtendedKalmanFilter {
        simulator: &MACHINE,
        method: FixedMethod::METHOD,
        parts_a_step: PARTS,
        measured: &MEASURED,
        estimated: &ESTIMATED,
        diffusing: &DIFFUSING,
        disturbed: &DISTURBED,
    }
}

/// Estimate of the machine, with its workspace.
#[derive(Debug, Clone)]
pub struct Estimator {
    clock: Clock<f64>,
    state: [f64; N_STATE],
    parameters: [f64; N_PARAMETERS],
    constants: [f64; N_CONSTANTS],
    root: [f64; N_ROOT],
    numbers: [f64; N_NUMBERS],
    signs: [i8; N_SIGNS],
    duals: [Dual; N_DUALS],
}

impl Default for Estimator {
    fn default() -> Self {
        Self::new()
    }
}

impl Estimator {
    /// Returns the estimate at the start of the spec's run.
    #[must_use]
    pub fn new() -> Self {
        let mut estimator = Self {
            clock: Clock::new(FROM),
            state: START,
            parameters: core::array::from_fn(|index| {
                machinist_contract::Describe::parameter_default(&MACHINE, index)
            }),
            constants: [0.0; N_CONSTANTS],
            root: [0.0; N_ROOT],
            numbers: [0.0; N_NUMBERS],
            signs: [0; N_SIGNS],
            duals: [Dual::constant(0.0); N_DUALS],
        };
        estimator.with(|filter, memory| filter.begin(&DEVIATIONS, memory));
        estimator
    }

    fn with<T>(
        &mut self,
        call: impl FnOnce(&ExtendedKalmanFilter<'_>, &mut FilterMemory<'_>) -> T,
    ) -> T {
        let mut memory = FilterMemory {
            clock: self.clock,
            state: &mut self.state,
            parameters: &mut self.parameters,
            constants: &mut self.constants,
            root: &mut self.root,
            numbers: &mut self.numbers,
            signs: &mut self.signs,
            duals: &mut self.duals,
        };
        let result = call(&filter(), &mut memory);
        self.clock = memory.clock;
        result
    }

    /// Advances the estimate by a step [s].
    pub fn predict(&mut self, step: f64) -> Stepped {
        self.with(|filter, memory| filter.predict(step, memory))
    }

    /// Corrects the estimate by measured outputs, in the order of [`MEASURED`]. Values that are not
    /// a number are left out.
    pub fn correct(&mut self, measured: &[f64; MEASURED.len()]) -> Correction {
        self.with(|filter, memory| filter.correct(measured, memory))
    }

    /// Sets a parameter, such as an input.
    ///
    /// # Panics
    /// If there is no parameter with this index.
    pub fn set(&mut self, parameter: usize, value: f64) {
        self.parameters[parameter] = value;
        Simulator::<f64>::prepare(&MACHINE, &self.parameters, &mut self.constants);
    }

    /// Returns the time of the estimate [s].
    #[must_use]
    pub fn time(&self) -> f64 {
        self.clock.time()
    }

    /// Returns the estimated state.
    #[must_use]
    pub fn state(&self) -> &[f64; N_STATE] {
        &self.state
    }

    /// Returns the parameters, with the estimated ones among them.
    #[must_use]
    pub fn parameters(&self) -> &[f64; N_PARAMETERS] {
        &self.parameters
    }

    /// Computes the outputs of the scene at the estimate.
    pub fn outputs(&self, outputs: &mut [f64]) {
        Simulator::outputs(&MACHINE, self.time(), &self.state, &self.parameters, outputs);
    }

    /// Returns the covariance of two entries: states, then estimated parameters.
    #[must_use]
    pub fn covariance(&self, row: usize, column: usize) -> f64 {
        filter().covariance(&self.root, row, column)
    }
}
";
