//! Values of expressions over a run, with derivatives.

use super::course::{Course, Value};
use super::expression::{Expression, Function, Node, Operator, Reduction};
use crate::trajectory::Trajectory;

/// A run with sensitivities, and the names that expressions may contain.
pub(super) struct Shown<'a> {
    pub run: &'a Trajectory,
    /// First rows of segments on which results are smooth.
    pub stretches: Vec<usize>,
    /// Names of the parameters and states by which the run is differentiated.
    pub by: &'a [String],
    /// Returns the derivatives of a column by the parameter with this index, one for each time.
    pub slopes: &'a dyn Fn(&str, usize) -> &'a [f64],
    /// Returns the value of a parameter.
    pub parameter: &'a dyn Fn(&str) -> Option<f64>,
}

/// A column of the run with its derivatives.
struct Known<'r> {
    name: String,
    values: &'r [f64],
    slopes: Vec<&'r [f64]>,
}

/// Value of an expression for another choice of its local extreme; `label` is the time of that
/// extreme.
#[derive(Debug, Clone)]
pub struct Branch {
    /// Value of the expression.
    pub value: f64,
    /// Derivatives of the value.
    pub slopes: Vec<f64>,
    /// Time of the extreme \[s\]; 0 if there is none.
    pub label: f64,
}

impl Shown<'_> {
    /// Returns the value of an expression, then those for other local extremes as far as they are
    /// not greater: near the optimum several of them may be equal, and all matter.
    pub fn branches(&self, expression: &Expression) -> Vec<Branch> {
        let mut count = 0;
        let first = self.scalar(expression, 0, &mut count);
        let label = |extreme: usize| self.extreme_time(expression, extreme).unwrap_or_default();
        let mut all = vec![Branch { value: first.value, slopes: first.slopes, label: label(0) }];
        // This is limited to one extreme, since several could be combined in many ways.
        for extreme in 1..if count == 1 { self.extremes(expression) } else { 0 } {
            let other = self.scalar(expression, extreme, &mut 0);
            if other.value <= all[0].value {
                let (value, slopes) = (other.value, other.slopes);
                all.push(Branch { value, slopes, label: label(extreme) });
            }
        }
        all
    }

    /// Returns the value of an expression and its derivatives.
    pub fn value(&self, expression: &Expression) -> (f64, Vec<f64>) {
        let Value { value, slopes } = self.scalar(expression, 0, &mut 0);
        (value, slopes)
    }

    fn constant(&self, value: f64) -> Value {
        Value { value, slopes: vec![0.0; self.by.len()] }
    }

    /// Evaluates a number with the `extreme`-th local extreme; `count` returns the number of
    /// extremes.
    fn scalar(&self, expression: &Expression, extreme: usize, count: &mut usize) -> Value {
        match &expression.node {
            Node::Number(value, _) => self.constant(*value),
            Node::Name(name) => self.parameter(name),
            Node::Negative(a) => negative(self.scalar(a, extreme, count)),
            Node::Binary(operator, a, b) => {
                let a = self.scalar(a, extreme, count);
                operate(*operator, &a, &self.scalar(b, extreme, count))
            }
            Node::Call(function, a) => call(*function, &self.scalar(a, extreme, count)),
            Node::Reduce(reduction, a) => self.reduced(*reduction, a, extreme, count),
        }
    }

    fn parameter(&self, name: &str) -> Value {
        let mut value = self.constant((self.parameter)(name).unwrap_or(f64::NAN));
        if let Some(place) = self.by.iter().position(|by| by == name) {
            value.slopes[place] = 1.0;
        }
        value
    }

    fn reduced(
        &self,
        reduction: Reduction,
        of: &Expression,
        extreme: usize,
        count: &mut usize,
    ) -> Value {
        let mut course = self.course(of);
        let span = course.times.last().unwrap_or(&0.0) - course.times.first().unwrap_or(&0.0);
        let mut greatest = |course: &Course<'_>| {
            *count += 1;
            let mut all = course.greatest();
            all.swap_remove(extreme.min(all.len() - 1))
        };
        match reduction {
            Reduction::Max => greatest(&course).value,
            Reduction::Min => {
                course.values = course.values.into_iter().map(negative).collect();
                negative(greatest(&course).value)
            }
            Reduction::PeakTime => course.greatest().swap_remove(0).time,
            Reduction::Integral => course.integral(),
            Reduction::Mean => scaled(course.integral(), 1.0 / span),
            Reduction::Rms => {
                course.values =
                    course.values.iter().map(|v| operate(Operator::Multiply, v, v)).collect();
                call(Function::Sqrt, &scaled(course.integral(), 1.0 / span))
            }
            Reduction::Initial => course.values.swap_remove(0),
            Reduction::Final => course.values.pop().unwrap_or_else(|| self.constant(f64::NAN)),
        }
    }

    /// Evaluates an expression within a reduction at all times.
    fn course(&self, expression: &Expression) -> Course<'_> {
        let mut columns: Vec<Known<'_>> = Vec::new();
        expression.for_each_name(&mut |name, _, _| {
            if let Some(values) = self.run.column(name)
                && columns.iter().all(|known| known.name != name)
            {
                let slopes = (0..self.by.len()).map(|by| (self.slopes)(name, by)).collect();
                columns.push(Known { name: name.to_owned(), values, slopes });
            }
        });
        let rows = self.run.times.len();
        let values = (0..rows).map(|row| self.at(expression, &columns, row)).collect();
        Course { times: &self.run.times, stretches: &self.stretches, values }
    }

    fn at(&self, expression: &Expression, columns: &[Known<'_>], row: usize) -> Value {
        match &expression.node {
            Node::Number(value, _) => self.constant(*value),
            Node::Name(name) => match columns.iter().find(|known| known.name == *name) {
                Some(Known { values, slopes, .. }) => Value {
                    value: values[row],
                    slopes: slopes
                        .iter()
                        .map(|slopes| slopes.get(row).copied().unwrap_or(f64::NAN))
                        .collect(),
                },
                None if name == "t" => self.constant(self.run.times[row]),
                None => self.parameter(name),
            },
            Node::Negative(a) => negative(self.at(a, columns, row)),
            Node::Binary(operator, a, b) => {
                let b = self.at(b, columns, row);
                operate(*operator, &self.at(a, columns, row), &b)
            }
            Node::Call(function, a) => call(*function, &self.at(a, columns, row)),
            // This was refused before.
            Node::Reduce(..) => self.constant(f64::NAN),
        }
    }

    /// Returns the argument of the single extreme of an expression, with a sign such that the
    /// extreme is a maximum.
    fn risen(&self, expression: &Expression) -> Option<Course<'_>> {
        match &expression.node {
            Node::Negative(a) | Node::Call(_, a) => self.risen(a),
            Node::Binary(_, a, b) => self.risen(a).or_else(|| self.risen(b)),
            Node::Reduce(Reduction::Max, a) => Some(self.course(a)),
            Node::Reduce(Reduction::Min, a) => {
                let mut course = self.course(a);
                course.values = course.values.into_iter().map(negative).collect();
                Some(course)
            }
            Node::Number(..) | Node::Name(_) | Node::Reduce(..) => None,
        }
    }

    fn extremes(&self, expression: &Expression) -> usize {
        self.risen(expression).map_or(0, |course| course.greatest().len())
    }

    fn extreme_time(&self, expression: &Expression, extreme: usize) -> Option<f64> {
        let all = self.risen(expression)?.greatest();
        all.get(extreme).map(|extreme| extreme.time.value)
    }
}

fn negative(mut a: Value) -> Value {
    a.value = -a.value;
    a.slopes.iter_mut().for_each(|slope| *slope = -*slope);
    a
}

fn scaled(mut a: Value, factor: f64) -> Value {
    a.value *= factor;
    a.slopes.iter_mut().for_each(|slope| *slope *= factor);
    a
}

/// Multiplies by a slope; a zero slope gives zero even for an infinite factor.
fn times(factor: f64, slope: f64) -> f64 {
    if slope == 0.0 { 0.0 } else { factor * slope }
}

fn operate(operator: Operator, a: &Value, b: &Value) -> Value {
    let (x, y) = (a.value, b.value);
    let (value, by_a, by_b) = match operator {
        Operator::Add => (x + y, 1.0, 1.0),
        Operator::Subtract => (x - y, 1.0, -1.0),
        Operator::Multiply => (x * y, y, x),
        Operator::Divide => (x / y, 1.0 / y, -x / (y * y)),
        Operator::Power => (x.powf(y), y * x.powf(y - 1.0), x.powf(y) * x.ln()),
    };
    let slopes = a.slopes.iter().zip(&b.slopes);
    let slopes = slopes.map(|(a, b)| times(by_a, *a) + times(by_b, *b)).collect();
    Value { value, slopes }
}

fn call(function: Function, a: &Value) -> Value {
    let x = a.value;
    let (value, slope) = match function {
        Function::Abs => (x.abs(), x.signum()),
        Function::Sqrt => (x.sqrt(), 0.5 / x.sqrt()),
        Function::Exp => (x.exp(), x.exp()),
        Function::Ln => (x.ln(), 1.0 / x),
        Function::Sin => (x.sin(), x.cos()),
        Function::Cos => (x.cos(), -x.sin()),
        Function::Tan => (x.tan(), 1.0 + x.tan() * x.tan()),
        Function::Tanh => (x.tanh(), 1.0 - x.tanh() * x.tanh()),
    };
    Value { value, slopes: a.slopes.iter().map(|a| times(slope, *a)).collect() }
}
