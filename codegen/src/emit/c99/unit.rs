//! Sources of a functional mock-up unit: a wrapper of FMI around the emitted machine.
//!
//! `unit.c` and `run.c` are the same for every version of the standard and have all rules of modes,
//! starts and events. The others translate calls. The snippets are C; a line `#ifdef` with one of
//! the conditions of `holds` is decided here, so that the files contain what their machine needs.

use std::fmt::Write as _;

use machinist_contract::RelationKind;
use machinist_model::Model;

use super::layout::{comment, remark};
use super::{C99File, C99Options, Real, Scene, description, emit, events};
use crate::emit::EmitError;

const HEADER: &str = include_str!("unit/unit.h");
const SOURCE: &str = concat!(include_str!("unit/unit.c"), "\n", include_str!("unit/run.c"));
const FMI2: &str = include_str!("unit/fmi2.c");
const FMI3: &str = concat!(include_str!("unit/fmi3.c"), "\n", include_str!("unit/fmi3_rest.c"));

/// Version of the standard.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FmiVersion {
    /// FMI 2.0.
    Two,
    /// FMI 3.0.
    #[default]
    Three,
}

/// Quantity of the machine that a variable stands for, with its index among those of its kind.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum UnitKind {
    /// Time t.
    Time,
    /// Continuous entry of the state.
    State(usize),
    /// Rate of an entry of the state.
    Derivative(usize),
    /// Entry of the state that is a mode.
    Mode(usize),
    /// A parameter.
    Parameter(usize),
    /// Wanted output.
    Output(usize),
    /// Event indicator.
    Indicator(usize),
    /// Largest step of Co-Simulation.
    Step,
}

/// Time at which a host may set a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Settable {
    /// At no time.
    Never,
    /// Before initialization mode, as a guess.
    Guess,
    /// Until the end of initialization mode.
    Fixed,
    /// Also at events and between communication steps.
    Tunable,
    /// At any time.
    Input,
}

/// Variable of the unit. Its position in the list is its value reference.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitVariable {
    /// Unique name.
    pub name: String,
    /// Meaning and unit, for readers of the sources.
    pub meaning: String,
    /// Quantity of the machine.
    pub kind: UnitKind,
    /// Time at which a host may set it.
    pub settable: Settable,
    /// Typical size of a state, above zero.
    pub nominal: f64,
}

/// Options of a unit.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitOptions {
    /// Version of the standard.
    pub version: FmiVersion,
    /// Text that ties the sources to their description.
    pub token: String,
    /// All variables, by value reference.
    pub variables: Vec<UnitVariable>,
    /// Largest step of Co-Simulation \[s\].
    pub step: f64,
    /// Sentence about the method, the step and its error.
    pub statement: String,
}

/// Emits the sources of a unit: header and source of the machine, of the wrapper, and the functions
/// of the standard. The last three are to be compiled with the standard's own headers.
///
/// # Errors
/// As [`emit`]; also for numbers other than `double`, and for a machine without continuous states.
pub fn emit_unit(
    model: &Model,
    options: &C99Options,
    unit: &UnitOptions,
) -> Result<Vec<C99File>, EmitError> {
    let unsupported = |message: &str| EmitError::Unsupported { message: message.to_owned() };
    if options.real != Real::Double {
        return Err(unsupported("the standard has numbers of type double alone"));
    }
    if !unit.variables.iter().any(|variable| matches!(variable.kind, UnitKind::State(_))) {
        return Err(unsupported("a machine without continuous states has nothing to integrate"));
    }
    let mut files = emit(model, options)?;
    let of_machine = [".h", ".c"].map(|ending| format!("{}{ending}", model.name));
    files.retain(|file| of_machine.contains(&file.name));
    let live = &model.live();
    let scene = Scene::new(live, options)?;
    let sources = Sources { scene: &scene, unit, model };
    let functions = match unit.version {
        FmiVersion::Two => ("fmi2", FMI2),
        FmiVersion::Three => ("fmi3", FMI3),
    };
    let name = &model.name;
    files.extend([
        C99File { name: format!("{name}_unit.h"), text: sources.header() },
        C99File { name: format!("{name}_unit.c"), text: sources.source()? },
        C99File { name: format!("{name}_{}.c", functions.0), text: sources.functions(functions.1) },
    ]);
    Ok(files)
}

/// Texts of a unit.
struct Sources<'a> {
    scene: &'a Scene<'a>,
    unit: &'a UnitOptions,
    /// The model with its relations, which the scene does not hold.
    model: &'a Model,
}

impl Sources<'_> {
    fn header(&self) -> String {
        let count = |is: fn(UnitKind) -> bool| {
            self.unit.variables.iter().filter(|variable| is(variable.kind)).count().to_string()
        };
        let text = self.resolved(HEADER);
        let text = text
            .replace("VARIABLE_COUNT", &self.unit.variables.len().to_string())
            .replace("CONTINUOUS_COUNT", &count(|kind| matches!(kind, UnitKind::State(_))))
            .replace("INDICATOR_COUNT", &count(|kind| matches!(kind, UnitKind::Indicator(_))))
            .replace("TOKEN_TEXT", &literal(&self.unit.token));
        let doc = format!(
            "{}. {} as a functional mock-up unit: what no version of the standard decides. {}",
            description::first_line(),
            self.model.name,
            self.unit.statement
        );
        format!("{}\n{}", comment([doc]), self.filled(&text))
    }

    fn source(&self) -> Result<String, EmitError> {
        let run = &self.model.run;
        let number = |place: &str, value: f64| {
            let literal = Real::Double.literal(value);
            literal.ok_or_else(|| EmitError::NotFinite { place: place.to_owned(), value })
        };
        let text = self.filled(&self.resolved(SOURCE));
        let text = text
            .replace("VARIABLE_ROWS\n", &self.variables())
            .replace("STATE_ROWS\n", &self.states(|_, row| Ok(row))?)
            .replace(
                "NOMINAL_ROWS\n",
                &self.states(|variable, _| number("nominal", variable.nominal))?,
            )
            .replace("WHOLE_ROWS\n", &self.wholes())
            .replace("DEFAULT_SPAN", &number("span of the run", run.until - run.from)?)
            .replace("DEFAULT_TOLERANCE", &number("tolerance", run.rtol)?)
            .replace("DEFAULT_STEP", &number("step", self.unit.step)?);
        let doc = format!("{}; see {}_unit.h.", description::first_line(), self.model.name);
        Ok(format!("{}\n{text}", comment([doc])))
    }

    fn functions(&self, snippet: &str) -> String {
        let name = &self.model.name;
        let doc = format!(
            "{}. The functions of the standard for {name}, in terms of {name}_unit.h. The headers \
             of the standard come with the importer. Define its macro of a function prefix, as \
             {name}_, to link several units together.",
            description::first_line()
        );
        format!("{}\n{}", comment([doc]), self.filled(snippet))
    }

    fn filled(&self, text: &str) -> String {
        self.scene.filled(&text.replace("scene.h", &format!("{}.h", self.model.name)))
    }

    /// Decides the conditions of a snippet.
    fn resolved(&self, snippet: &str) -> String {
        let mut text = String::with_capacity(snippet.len());
        // True for each open condition that is kept.
        let mut open: Vec<bool> = Vec::new();
        for line in snippet.lines() {
            if let Some(name) = line.strip_prefix("#ifdef ") {
                open.push(self.holds(name));
            } else if line == "#else" {
                if let Some(last) = open.last_mut() {
                    *last = !*last;
                }
            } else if line == "#endif" {
                open.pop();
            } else if open.iter().all(|kept| *kept) {
                text.push_str(line);
                text.push('\n');
            }
        }
        text
    }

    /// Returns whether a condition holds.
    fn holds(&self, condition: &str) -> bool {
        let model = self.model;
        let indicators = model.events.len() + model.kink_guards.results.len();
        match condition {
            "SCENE_EVENTS" => !model.events.is_empty(),
            "SCENE_KINKS" => !model.kink_guards.results.is_empty(),
            "SCENE_DISCONTINUITIES" => !model.discontinuities.results.is_empty(),
            "FRICTION_JUMPS" => events::has_jumping_friction(model),
            "SCENE_CONSTRAINTS" => !model.constraints.is_empty(),
            "SCENE_OUTPUTS" => !model.wanted.is_empty(),
            "SOME_INDICATORS" => indicators > 0,
            "NO_INDICATORS" => indicators == 0,
            "STARTS_ELSEWHERE" => self.scene.options.start.is_some(),
            "WHOLE" => self.whole().any(|is_whole| is_whole),
            other => unreachable!("the snippets have no condition `{other}`"),
        }
    }

    /// Iterates over the guards of kinks: whether each is the argument of `floor`.
    fn whole(&self) -> impl Iterator<Item = bool> {
        let relations = &self.model.relations;
        (0..self.model.kink_guards.results.len())
            .map(|kink| relations.get(kink).is_some_and(|r| r.kind == RelationKind::Whole))
    }

    fn wholes(&self) -> String {
        let rows: Vec<&str> = self.whole().map(|is| if is { "1" } else { "0" }).collect();
        super::layout::statement(&rows.join(", "), 4)
    }

    /// Returns a row of an array for each continuous state, from the variable and its place.
    fn states(
        &self,
        row: impl Fn(&UnitVariable, String) -> Result<String, EmitError>,
    ) -> Result<String, EmitError> {
        let states = self.unit.variables.iter();
        let states = states.filter(|variable| matches!(variable.kind, UnitKind::State(_)));
        let rows: Vec<String> = states
            .map(|variable| Ok(format!("    {}", row(variable, self.place(variable.kind))?)))
            .collect::<Result<_, EmitError>>()?;
        Ok(format!("{}\n", rows.join(",\n")))
    }

    fn variables(&self) -> String {
        let mut text = String::new();
        let last = self.unit.variables.len() - 1;
        for (reference, variable) in self.unit.variables.iter().enumerate() {
            let kind = match variable.kind {
                UnitKind::Time => "TIME",
                UnitKind::State(_) => "STATE",
                UnitKind::Derivative(_) => "DERIVATIVE",
                UnitKind::Mode(_) => "MODE",
                UnitKind::Parameter(_) => "PARAMETER",
                UnitKind::Output(_) => "OUTPUT",
                UnitKind::Indicator(_) => "INDICATOR",
                UnitKind::Step => "STEP",
            };
            let settable = match variable.settable {
                Settable::Never => "NEVER",
                Settable::Guess => "GUESS",
                Settable::Fixed => "FIXED",
                Settable::Tunable => "TUNABLE",
                Settable::Input => "INPUT",
            };
            let (name, place) = (literal(&variable.name), self.place(variable.kind));
            let comma = if reference < last { "," } else { "" };
            let remark = remark(&format!("{reference}: {}", variable.meaning));
            let row = format!("    {{ \"{name}\", {kind}, {settable}, {place} }}{comma} {remark}");
            let _ = writeln!(text, "{row}");
        }
        text
    }

    /// Returns the place of a quantity within the struct of its kind.
    fn place(&self, kind: UnitKind) -> String {
        let scene = self.scene;
        let (structure, member) = match kind {
            UnitKind::Time | UnitKind::Step => return "0u".to_owned(),
            UnitKind::Indicator(index) => return format!("{index}u"),
            UnitKind::State(entry) | UnitKind::Derivative(entry) | UnitKind::Mode(entry) => {
                ("state_t", &scene.state_members[entry])
            }
            UnitKind::Parameter(index) => ("parameters_t", &scene.parameter_members[index]),
            UnitKind::Output(index) => ("outputs_t", &scene.output_members[index]),
        };
        format!("offsetof({}, {member})", scene.public(structure))
    }
}

/// Returns a text as the inside of a string literal of C.
fn literal(text: &str) -> String {
    let mut literal = String::with_capacity(text.len());
    for sign in text.chars() {
        match sign {
            '"' | '\\' => literal.extend(['\\', sign]),
            // Trigraphs.
            '?' => literal.push_str("\\?"),
            sign if sign.is_control() => literal.push(' '),
            sign => literal.push(sign),
        }
    }
    literal
}
