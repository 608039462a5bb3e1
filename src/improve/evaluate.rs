//! Values of expressions of a run, with their derivatives.

use super::course::{Course, Value};
use super::expression::{Expression, Function, Node, Operator, Reduction};
use crate::trajectory::Trajectory;

/// A run with sensitivities, and what expressions may name besides.
pub(super) struct Shown<'a> {
    pub run: &'a Trajectory,
    /// First rows of stretches on which courses are smooth.
    pub stretches: Vec<usize>,
    /// Names of what is differentiated by.
    pub by: &'a [String],
    /// Derivatives of a column by the one of them that stands at a place, one for each time.
    pub slopes: &'a dyn Fn(&str, usize) -> &'a [f64],
    /// Values of parameters by name.
    pub parameter: &'a dyn Fn(&str) -> Option<f64>,
}

/// A column of the run with its derivatives.
struct Known<'r> {
    name: String,
    values: &'r [f64],
    slopes: Vec<&'r [f64]>,
}

/// One value that an expression would have, were its extreme another local one; `label` is the
/// time of that.
#[derive(Debug, Clone)]
pub struct Branch {
    /// Value.
    pub value: f64,
    /// Derivatives by what the run was differentiated by.
    pub slopes: Vec<f64>,
    /// Time of the extreme \[s\]; 0 of what is none.
    pub label: f64,
}

impl Shown<'_> {
    /// The value of an expression first, then those by other local extremes, as far as they are
    /// not greater: near the optimum several of them may be the same, and all count.
    pub fn branches(&self, expression: &Expression) -> Vec<Branch> {
        let mut count = 0;
        let first = self.scalar(expression, 0, &mut count);
        let label = |extreme: usize| self.extreme_time(expression, extreme).unwrap_or_default();
        let mut all = vec![Branch { value: first.value, slopes: first.slopes, label: label(0) }];
        // Of one extreme alone; several would be combined in every way.
        for extreme in 1..if count == 1 { self.extremes(expression) } else { 0 } {
            let other = self.scalar(expression, extreme, &mut 0);
            if other.value <= all[0].value {
                let (value, slopes) = (other.value, other.slopes);
                all.push(Branch { value, slopes, label: label(extreme) });
            }
        }
        all
    }

    /// The value of an expression, and its derivatives.
    pub fn value(&self, expression: &Expression) -> (f64, Vec<f64>) {
        let Value { value, slopes } = self.scalar(expression, 0, &mut 0);
        (value, slopes)
    }

    fn constant(&self, value: f64) -> Value {
        Value { value, slopes: vec![0.0; self.by.len()] }
    }

    /// A number by the `extreme`-th of local extremes; `count` is how many extremes there are.
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

    /// Numbers of an expression within a reduction.
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
            // Refused before.
            Node::Reduce(..) => self.constant(f64::NAN),
        }
    }

    /// The one extreme of an expression as a course, risen.
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

/// Where a factor is zero, a slope is, whatever it is multiplied by.
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
