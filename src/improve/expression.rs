//! Parser of expressions over results of a run.
//!
//! ```text
//! sum      = product { ("+" | "-") product }
//! product  = unary { ("*" | "/") unary }
//! unary    = "-" unary | power
//! power    = atom [ "^" unary ]
//! atom     = number [ "[" unit "]" ] | name | function "(" sum ")" | "(" sum ")"
//! ```

use std::ops::Range;

use crate::error::did_you_mean;

/// Maximum nesting depth.
const DEEPEST: usize = 100;

/// A node of the syntax tree with its position in the text.
#[derive(Debug, Clone, PartialEq)]
pub struct Expression {
    /// Node.
    pub node: Node,
    /// Range of bytes in the text.
    pub range: Range<usize>,
}

/// Kind of a node with its operands.
#[derive(Debug, Clone, PartialEq)]
pub enum Node {
    /// A number with its unit, if given.
    Number(f64, Option<String>),
    /// A parameter; within a [`Reduction`] also an output, a state, or `t`.
    Name(String),
    /// -a.
    Negative(Box<Expression>),
    /// An operation on two operands.
    Binary(Operator, Box<Expression>, Box<Expression>),
    /// A function of one argument.
    Call(Function, Box<Expression>),
    /// A reduction of a time-dependent quantity.
    Reduce(Reduction, Box<Expression>),
}

/// Operation on two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is what it says")]
pub enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
}

/// Function of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is what it says")]
pub enum Function {
    Abs,
    Sqrt,
    Exp,
    Ln,
    Sin,
    Cos,
    Tan,
    Tanh,
}

/// Reduction of a time-dependent quantity to one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reduction {
    /// Greatest value.
    Max,
    /// Least value.
    Min,
    /// Mean over time.
    Mean,
    /// Integral over time.
    Integral,
    /// Root mean square.
    Rms,
    /// Value at the start.
    Initial,
    /// Value at the end.
    Final,
    /// Time of the greatest value.
    PeakTime,
}

const FUNCTIONS: [(&str, Function); 8] = [
    ("abs", Function::Abs),
    ("sqrt", Function::Sqrt),
    ("exp", Function::Exp),
    ("ln", Function::Ln),
    ("sin", Function::Sin),
    ("cos", Function::Cos),
    ("tan", Function::Tan),
    ("tanh", Function::Tanh),
];

const REDUCTIONS: [(&str, Reduction); 8] = [
    ("max", Reduction::Max),
    ("min", Reduction::Min),
    ("mean", Reduction::Mean),
    ("integral", Reduction::Integral),
    ("rms", Reduction::Rms),
    ("initial", Reduction::Initial),
    ("final", Reduction::Final),
    ("peak_time", Reduction::PeakTime),
];

/// An error in an expression, with its position.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct ExpressionError {
    /// The reason.
    pub message: String,
    /// Hint; may be empty.
    pub help: String,
    /// Range of bytes in the text.
    pub range: Range<usize>,
}

impl ExpressionError {
    /// Code of this kind of error.
    pub const CODE: &'static str = "improve::expression";

    /// Returns the code of this kind of error.
    #[must_use]
    pub fn code(&self) -> &'static str {
        Self::CODE
    }

    /// Creates an error without a hint.
    #[must_use]
    pub fn new(message: impl Into<String>, range: Range<usize>) -> Self {
        Self { message: message.into(), help: String::new(), range }
    }

    /// Adds a hint.
    #[must_use]
    pub fn with_help(self, help: impl Into<String>) -> Self {
        Self { help: help.into(), ..self }
    }
}

/// An inequality, `left <= right` or `left >= right`.
#[derive(Debug, Clone, PartialEq)]
pub struct Inequality {
    /// Left side.
    pub left: Expression,
    /// Right side.
    pub right: Expression,
    /// True if the left side must not exceed the right side; otherwise the reverse.
    pub is_at_most: bool,
}

impl Expression {
    /// Parses an expression.
    ///
    /// # Errors
    /// The problem and its position.
    pub fn parse(text: &str) -> Result<Self, ExpressionError> {
        let mut reader = Reader { text, at: 0, depth: 0 };
        let expression = reader.sum()?;
        reader.end()?;
        Ok(expression)
    }

    /// Calls `look` with each name, its position, and whether it is within a [`Reduction`].
    pub fn for_each_name<'e>(&'e self, look: &mut dyn FnMut(&'e str, &Range<usize>, bool)) {
        self.look(false, look);
    }

    fn look<'e>(&'e self, within: bool, look: &mut dyn FnMut(&'e str, &Range<usize>, bool)) {
        match &self.node {
            Node::Number(..) => {}
            Node::Name(name) => look(name, &self.range, within),
            Node::Negative(a) | Node::Call(_, a) => a.look(within, look),
            Node::Reduce(_, a) => a.look(true, look),
            Node::Binary(_, a, b) => {
                a.look(within, look);
                b.look(within, look);
            }
        }
    }
}

impl Inequality {
    /// Parses an inequality.
    ///
    /// # Errors
    /// The problem and its position.
    pub fn parse(text: &str) -> Result<Self, ExpressionError> {
        let mut reader = Reader { text, at: 0, depth: 0 };
        let left = reader.sum()?;
        let is_at_most = match reader.symbol() {
            Some('<') => true,
            Some('>') => false,
            _ => {
                let help = "write it as max(abs(coupling_torque)) <= 900";
                let message = "an inequality needs `<=` or `>=` here";
                return Err(ExpressionError::new(message, reader.here()).with_help(help));
            }
        };
        reader.at += 1;
        if reader.text[reader.at..].starts_with('=') {
            reader.at += 1;
        }
        let right = reader.sum()?;
        reader.end()?;
        Ok(Self { left, right, is_at_most })
    }
}

struct Reader<'t> {
    text: &'t str,
    at: usize,
    depth: usize,
}

impl Reader<'_> {
    fn skip(&mut self) {
        let rest = &self.text[self.at..];
        self.at += rest.len() - rest.trim_start().len();
    }

    fn symbol(&mut self) -> Option<char> {
        self.skip();
        self.text[self.at..].chars().next()
    }

    fn here(&self) -> Range<usize> {
        let length = self.text[self.at..].chars().next().map_or(0, char::len_utf8);
        self.at..self.at + length
    }

    fn end(&mut self) -> Result<(), ExpressionError> {
        match self.symbol() {
            None => Ok(()),
            Some(c) => Err(ExpressionError::new(format!("{c:?} is not expected"), self.here())),
        }
    }

    fn sum(&mut self) -> Result<Expression, ExpressionError> {
        let mut left = self.product()?;
        loop {
            let operator = match self.symbol() {
                Some('+') => Operator::Add,
                Some('-') => Operator::Subtract,
                _ => return Ok(left),
            };
            self.at += 1;
            left = binary(operator, left, self.product()?);
        }
    }

    fn product(&mut self) -> Result<Expression, ExpressionError> {
        let mut left = self.unary()?;
        loop {
            let operator = match self.symbol() {
                Some('*') => Operator::Multiply,
                Some('/') => Operator::Divide,
                _ => return Ok(left),
            };
            self.at += 1;
            left = binary(operator, left, self.unary()?);
        }
    }

    fn unary(&mut self) -> Result<Expression, ExpressionError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            let message = format!("nodes nest deeper than {DEEPEST}");
            return Err(ExpressionError::new(message, self.here()));
        }
        let found = if self.symbol() == Some('-') {
            let from = self.at;
            self.at += 1;
            let of = self.unary()?;
            let range = from..of.range.end;
            Expression { node: Node::Negative(Box::new(of)), range }
        } else {
            self.power()?
        };
        self.depth -= 1;
        Ok(found)
    }

    fn power(&mut self) -> Result<Expression, ExpressionError> {
        let base = self.atom()?;
        if self.symbol() != Some('^') {
            return Ok(base);
        }
        self.at += 1;
        Ok(binary(Operator::Power, base, self.unary()?))
    }

    fn atom(&mut self) -> Result<Expression, ExpressionError> {
        match self.symbol() {
            Some('(') => {
                self.at += 1;
                let inner = self.sum()?;
                self.close()?;
                Ok(inner)
            }
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() || c == '_' => self.name(),
            Some(c) => {
                let message = format!("a number, a name or `(` is expected, not {c:?}");
                Err(ExpressionError::new(message, self.here()))
            }
            None => Err(ExpressionError::new("the expression ends too early", self.here())),
        }
    }

    fn close(&mut self) -> Result<(), ExpressionError> {
        match self.symbol() {
            Some(')') => {
                self.at += 1;
                Ok(())
            }
            Some(',') => {
                let help = "max and min are taken over time, of one expression; give each limit \
                            its own `--subject-to`";
                let message = "functions take one argument here";
                Err(ExpressionError::new(message, self.here()).with_help(help))
            }
            _ => Err(ExpressionError::new("a closing parenthesis is missing", self.here())),
        }
    }

    fn number(&mut self) -> Result<Expression, ExpressionError> {
        let from = self.at;
        let bytes = self.text.as_bytes();
        let digits = |mut at: usize| {
            while bytes.get(at).is_some_and(|b| b.is_ascii_digit() || *b == b'.') {
                at += 1;
            }
            at
        };
        self.at = digits(self.at);
        if bytes.get(self.at).is_some_and(|b| matches!(b, b'e' | b'E')) {
            let sign =
                usize::from(bytes.get(self.at + 1).is_some_and(|b| matches!(b, b'+' | b'-')));
            if bytes.get(self.at + 1 + sign).is_some_and(u8::is_ascii_digit) {
                self.at = digits(self.at + 1 + sign);
            }
        }
        let text = &self.text[from..self.at];
        let value = text.parse().ok().filter(|value: &f64| value.is_finite());
        let value = value.ok_or_else(|| {
            ExpressionError::new(format!("`{text}` is not a number"), from..self.at)
        })?;
        let mut unit = None;
        if self.symbol() == Some('[') {
            let rest = &self.text[self.at..];
            let length = rest.find(']').ok_or_else(|| {
                ExpressionError::new("the unit has no closing bracket", self.here())
            })?;
            unit = Some(rest[1..length].trim().to_owned());
            self.at += length + 1;
        }
        Ok(Expression { node: Node::Number(value, unit), range: from..self.at })
    }

    fn name(&mut self) -> Result<Expression, ExpressionError> {
        let from = self.at;
        let rest = &self.text[from..];
        let belongs = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
        self.at += rest.find(|c| !belongs(c)).unwrap_or(rest.len());
        let name = &self.text[from..self.at];
        if self.symbol() != Some('(') {
            let node = Node::Name(name.to_owned());
            return Ok(Expression { node, range: from..from + name.len() });
        }
        self.at += 1;
        let of = Box::new(self.sum()?);
        self.close()?;
        let range = from..self.at;
        if let Some((_, function)) = FUNCTIONS.iter().find(|(known, _)| *known == name) {
            return Ok(Expression { node: Node::Call(*function, of), range });
        }
        if let Some((_, reduction)) = REDUCTIONS.iter().find(|(known, _)| *known == name) {
            return Ok(Expression { node: Node::Reduce(*reduction, of), range });
        }
        let known = || REDUCTIONS.iter().map(|r| r.0).chain(FUNCTIONS.iter().map(|f| f.0));
        let all = known().collect::<Vec<_>>().join(", ");
        let message = format!("there is no function `{name}`{}", did_you_mean(name, known()));
        let error = ExpressionError::new(message, from..from + name.len());
        Err(error.with_help(format!("functions are {all}")))
    }
}

fn binary(operator: Operator, left: Expression, right: Expression) -> Expression {
    let range = left.range.start..right.range.end;
    Expression { node: Node::Binary(operator, Box::new(left), Box::new(right)), range }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_bind_before_signs_and_products_before_sums() {
        let told = |text: &str| shown(&Expression::parse(text).expect(text));
        assert_eq!(told("-a^2 + 3*b/2 - c"), "(((-(a ^ 2)) + ((3 * b) / 2)) - c)");
        assert_eq!(told("2^-x^2"), "(2 ^ (-(x ^ 2)))");
        assert_eq!(
            told("max(abs(coupling_torque)) - 1.5e-3[N m]*p.q"),
            "(max(abs(coupling_torque)) - (0.0015[N m] * p.q))"
        );
    }

    fn shown(expression: &Expression) -> String {
        match &expression.node {
            Node::Number(value, None) => value.to_string(),
            Node::Number(value, Some(unit)) => format!("{value}[{unit}]"),
            Node::Name(name) => name.clone(),
            Node::Negative(a) => format!("(-{})", shown(a)),
            Node::Binary(operator, a, b) => {
                let sign = match operator {
                    Operator::Add => '+',
                    Operator::Subtract => '-',
                    Operator::Multiply => '*',
                    Operator::Divide => '/',
                    Operator::Power => '^',
                };
                format!("({} {sign} {})", shown(a), shown(b))
            }
            Node::Call(function, a) => {
                let name = FUNCTIONS.iter().find(|(_, other)| other == function).expect("known").0;
                format!("{name}({})", shown(a))
            }
            Node::Reduce(reduction, a) => {
                let of = REDUCTIONS.iter().find(|(_, other)| other == reduction).expect("known").0;
                format!("{of}({})", shown(a))
            }
        }
    }

    #[test]
    fn what_is_wrong_is_told_with_its_place() {
        for (text, said, range) in [
            ("max(x", "closing", 5..5),
            ("max(x, y)", "one argument", 5..6),
            ("meann(x)", "did you mean `mean`", 0..5),
            ("1 + ", "too early", 4..4),
            ("2 $ 3", "not expected", 2..3),
            ("1e999", "not a number", 0..5),
            ("3 [N", "closing bracket", 2..3),
        ] {
            let error = Expression::parse(text).expect_err(text);
            assert!(error.message.contains(said), "{text}: {error}");
            assert_eq!(error.range, range, "{text}");
        }
        let deep = "(".repeat(1000) + "x" + &")".repeat(1000);
        assert!(Expression::parse(&deep).is_err());
        assert!(Inequality::parse("max(x) = 3").is_err());
        let found = Inequality::parse("3 >= max(x)").expect("one");
        assert!(!found.is_at_most);
    }
}
