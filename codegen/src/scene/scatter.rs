//! Probability distributions of the parameters of a scene, in SI units.

use crate::scene::layout::Scope;
use crate::scene::parameters::{self, Given};
use crate::spec::CorrelationSpec;
use crate::spec::code::Code;
use crate::spec::diagnostic::{Diagnostics, Mistake, Span, Spanned};
use crate::spec::spread::{Law, Spread};
use crate::spec::{Declared, SceneSpec, did_you_mean, quoted};

/// Distributions of a scene's parameters.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Scatter {
    /// Parameters with a distribution, in the order of the model's parameters.
    pub parameters: Vec<Scattered>,
    /// Correlation matrix of their normal scores, row by row.
    pub correlations: Vec<Vec<f64>>,
}

/// Parameter with a distribution.
#[derive(Debug, Clone, PartialEq)]
pub struct Scattered {
    /// Name, `instance.parameter`.
    pub name: String,
    /// Distribution.
    pub law: Law,
}

/// Returns the distributions of a scene.
///
/// The scene's `[scatter]` takes precedence over tolerances of an instance's values, and these over
/// the distributions of units.
///
/// # Errors
/// Names that the scene does not have, units of another dimension, bounds out of order, and
/// correlations that contradict each other.
pub fn distributions(spec: &SceneSpec) -> Result<Scatter, Diagnostics> {
    let mut mistakes = Vec::new();
    let found = find(spec, &mut mistakes);
    if mistakes.is_empty() { Ok(found) } else { Err(spec.sources.diagnostics(&mistakes)) }
}

/// Collects the distributions and reports mistakes.
pub(super) fn find(spec: &SceneSpec, mistakes: &mut Vec<Mistake>) -> Scatter {
    let mut found = Scatter::default();
    for (scope, index, value) in parameters::numbers(spec) {
        let name = path_of(spec, scope, index);
        let Some(Spanned { value: spread, span }) = spread_of(spec, scope, index, &name) else {
            continue;
        };
        let unit: &Declared = &parameters::declared(spec, scope, index).unit;
        match spread.law(value, unit).and_then(|law| about(law, value)) {
            Ok(law) => found.parameters.push(Scattered { name, law }),
            Err(message) => {
                let message = format!("distribution of {}: {message}", quoted(&name));
                mistakes.push(Mistake::new(Code::InvalidDistribution, *span, message, "here"));
            }
        }
    }
    for (name, _) in &spec.scatter {
        check_name(spec, name, mistakes);
    }
    // Without all distributions, correlations would be reported as unknown.
    if mistakes.is_empty() {
        found.correlations = correlations(spec, &found.parameters, mistakes);
    }
    found
}

/// Returns an error if bounds exclude the value that runs take.
fn about(law: Law, value: f64) -> Result<Law, String> {
    match law {
        Law::Uniform(low, high) | Law::Triangular(low, _, high)
            if !(low..=high).contains(&value) =>
        {
            Err(format!("the value {value} is not between {low} and {high}"))
        }
        law => Ok(law),
    }
}

fn path_of(spec: &SceneSpec, scope: Scope, index: usize) -> String {
    parameters::path(spec, scope, &parameters::declared(spec, scope, index).name.value)
}

/// Returns the distribution with the highest precedence.
fn spread_of<'s>(
    spec: &'s SceneSpec,
    scope: Scope,
    index: usize,
    name: &str,
) -> Option<&'s Spanned<Spread>> {
    let of_scene = spec.scatter.iter().find(|(known, _)| known.value == name);
    let of_instance = || match scope.base() {
        Scope::Instance(instance) => {
            let own = &parameters::declared(spec, scope, index).name.value;
            tolerance_of(spec, instance, own)
        }
        _ => None,
    };
    of_scene
        .map(|(_, spread)| spread)
        .or_else(of_instance)
        .or_else(|| parameters::declared(spec, scope, index).spread.as_ref())
}

/// Returns the tolerance of the value that the scene or an assembly gives to a parameter. The scene
/// takes precedence.
fn tolerance_of<'s>(
    spec: &'s SceneSpec,
    instance: usize,
    name: &str,
) -> Option<&'s Spanned<Spread>> {
    let one = &spec.instances[instance];
    let from_outside = one.parent.and_then(|parent| {
        let part = &one.name.value[spec.instances[parent].name.value.len() + 1..];
        tolerance_of(spec, parent, &format!("{part}.{name}"))
    });
    from_outside.or_else(|| {
        let own = one.tolerances.iter().find(|(known, _)| known.value == name);
        own.map(|(_, spread)| spread)
    })
}

/// Reports a name that is not a parameter with a number.
fn check_name(spec: &SceneSpec, name: &Spanned<String>, mistakes: &mut Vec<Mistake>) {
    let mut all = parameters::all(spec);
    let found = all.find(|(scope, index)| path_of(spec, *scope, *index) == name.value);
    match found.map(|(scope, index)| parameters::given(spec, scope, index)) {
        Some(Given::Number(_)) => {}
        Some(Given::Expression(..)) => {
            let message = format!("parameter {} is given by an expression", quoted(&name.value));
            let help = "give distributions to the parameters in the expression";
            mistakes.push(
                Mistake::new(Code::WrongKindOfName, name.span, message, "not a number").help(help),
            );
        }
        None => {
            let known: Vec<String> =
                parameters::all(spec).map(|(scope, index)| path_of(spec, scope, index)).collect();
            let message = format!("the scene has no parameter {}", quoted(&name.value));
            let help = did_you_mean(&name.value, known.iter().map(String::as_str));
            mistakes.push(
                Mistake::new(Code::UnknownParameter, name.span, message, "unknown").help(help),
            );
        }
    }
}

/// Returns the whole matrix.
fn correlations(
    spec: &SceneSpec,
    parameters: &[Scattered],
    mistakes: &mut Vec<Mistake>,
) -> Vec<Vec<f64>> {
    let count = parameters.len();
    let mut matrix: Vec<Vec<f64>> = (0..count)
        .map(|row| (0..count).map(|column| f64::from(u8::from(row == column))).collect())
        .collect();
    for block in &spec.correlations {
        let mut places = Vec::new();
        for name in &block.parameters {
            let place = parameters.iter().position(|known| known.name == name.value);
            match place {
                Some(place) if places.contains(&place) => {
                    let message = format!("{} is named twice", quoted(&name.value));
                    mistakes.push(Mistake::new(Code::DuplicateName, name.span, message, "again"));
                }
                Some(place) => places.push(place),
                None => {
                    let message = format!("{} has no distribution", quoted(&name.value));
                    let help = "give it one, in [scatter] or where it is declared";
                    mistakes.push(
                        Mistake::new(Code::InvalidDistribution, name.span, message, "unknown")
                            .help(help),
                    );
                }
            }
        }
        if places.len() == block.parameters.len() {
            fill(&mut matrix, &places, block, mistakes);
        }
    }
    if let Some(block) = spec.correlations.first()
        && mistakes.is_empty()
        && !is_positive_definite(&matrix)
    {
        let message = "the correlation matrix is not positive definite";
        let help = "these correlations contradict each other; smaller ones do not";
        mistakes
            .push(Mistake::new(Code::InvalidDistribution, block.span, message, "here").help(help));
    }
    matrix
}

/// Enters the correlations of a block.
fn fill(
    matrix: &mut [Vec<f64>],
    places: &[usize],
    block: &CorrelationSpec,
    mistakes: &mut Vec<Mistake>,
) {
    let mut refuse = |span: Span, message: String| {
        mistakes.push(Mistake::new(Code::InvalidDistribution, span, message, "here"));
    };
    for (i, row) in block.matrix.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            let (a, b) = (places[i], places[j]);
            if !(-1.0..=1.0).contains(entry) {
                return refuse(block.span, format!("a correlation is from -1 to 1, not {entry}"));
            }
            if (entry - block.matrix[j][i]).abs() > 0.0 {
                return refuse(block.span, "the matrix must be symmetric".to_owned());
            }
            if i == j && (entry - 1.0).abs() > 0.0 {
                return refuse(block.span, "the diagonal of the matrix must be 1".to_owned());
            }
            if i != j && matrix[a][b].abs() > 0.0 && (matrix[a][b] - entry).abs() > 0.0 {
                let [a, b] = [i, j].map(|k| quoted(&block.parameters[k].value));
                return refuse(
                    block.span,
                    format!("the correlation of {a} and {b} is given twice"),
                );
            }
            matrix[a][b] = *entry;
        }
    }
}

/// Returns whether the Cholesky factorization of a symmetric matrix exists.
fn is_positive_definite(matrix: &[Vec<f64>]) -> bool {
    let count = matrix.len();
    let mut factor = vec![vec![0.0; count]; count];
    for row in 0..count {
        for column in 0..=row {
            let known: f64 = (0..column).map(|k| factor[row][k] * factor[column][k]).sum();
            let rest = matrix[row][column] - known;
            factor[row][column] = if row > column {
                rest / factor[column][column]
            } else if rest > 0.0 {
                f64::sqrt(rest)
            } else {
                return false;
            };
        }
    }
    true
}
