//! Splitting of an expression's text into tokens.

use std::ops::Range;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, Zero as _};

use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::measure::{self, Measure};
use crate::spec::names::quoted;
use crate::spec::toml::Tree;

/// Maximum length of an expression in bytes.
const MAX_EXPRESSION: usize = 64 << 10;
/// Maximum number of digits; no double needs more for its exact value.
const MAX_DIGITS: usize = 800;
/// Limit of powers of ten in numbers of an expression.
const MAX_POWER_OF_TEN: i64 = 70_000;
/// Hint for other comparison operators.
const ONLY_COMPARISON: &str = "the only comparison is `x < y`, within piecewise";

/// An exact number that is zero, or finite and nonzero as an `f64`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Literal(pub BigRational);

impl Literal {
    /// Returns the literal of an integer.
    #[must_use]
    pub fn of_integer(integer: i64) -> Self {
        Literal(BigRational::from_integer(integer.into()))
    }

    /// Reads `2`, `-0.5`, `1e-3`; `None` if it is not a number or beyond `f64`.
    #[must_use]
    pub fn parse(text: &str) -> Option<Self> {
        let rounded: f64 = text.parse().ok().filter(|value: &f64| value.is_finite())?;
        let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        if whole.len() + fraction.len() > MAX_DIGITS {
            return None;
        }
        let digits: BigInt = format!("{whole}{fraction}").parse().ok()?;
        if digits.is_zero() {
            return Some(Literal(BigRational::zero()));
        }
        let exponent = exponent.parse::<i64>().ok()?.checked_sub(fraction.len() as i64)?;
        if rounded == 0.0 || exponent.abs() > MAX_POWER_OF_TEN {
            return None;
        }
        let power = BigInt::from(10).pow(exponent.unsigned_abs() as u32);
        let one = BigInt::one();
        let scale = if exponent < 0 { (one, power) } else { (power, one) };
        Some(Literal(BigRational::from_integer(digits) * BigRational::new(scale.0, scale.1)))
    }
}

/// Text of an expression and its place in the file.
#[derive(Debug, Clone, Copy)]
pub struct Text<'a> {
    /// The characters.
    pub value: &'a str,
    whole: Span,
    inner: Option<u32>,
}

impl<'a> Text<'a> {
    /// Returns the text of a string of a TOML file; `None` for anything else.
    #[must_use]
    pub fn of(tree: &'a Spanned<Tree>) -> Option<Self> {
        match &tree.value {
            Tree::Text { value, inner } => Some(Text { value, whole: tree.span, inner: *inner }),
            _ => None,
        }
    }

    /// Returns the span in the file of the bytes `range` of the text. It is the whole string if
    /// escapes make offsets meaningless.
    #[must_use]
    pub fn span(&self, range: Range<usize>) -> Span {
        self.inner.map_or(self.whole, |inner| {
            let start = inner as usize;
            Span::new(self.whole.file, start + range.start..start + range.end)
        })
    }
}

/// A token of an expression.
#[derive(Debug, Clone, PartialEq)]
pub enum Token {
    /// A number.
    Number(Literal),
    /// A unit in brackets.
    Unit(Measure),
    /// A name, preceded by that of an instance, if any. Instances inside others have names with
    /// dots.
    Name(Option<String>, String),
    /// A quoted text.
    Text(String),
    /// One of `+ - * / ^ ( ) , <`.
    Mark(char),
}

/// Splits an expression into tokens.
///
/// # Errors
/// A character that belongs to no expression, a number beyond `f64`, an unknown unit of measure,
/// or more than 64 KiB.
pub fn tokens(text: &Text<'_>) -> Result<Vec<Spanned<Token>>, Box<Mistake>> {
    if text.value.len() > MAX_EXPRESSION {
        let span = text.span(0..0);
        return Err(Box::new(Mistake::new(
            Code::TooLarge,
            span,
            "an expression is at most 64 KiB long",
            "here",
        )));
    }
    let mut lexer = Lexer { text, at: 0 };
    let mut tokens = Vec::new();
    while let Some(c) = lexer.skip_space() {
        let start = lexer.at;
        let token = lexer.token(c)?;
        if matches!(token, Token::Number(_)) {
            lexer.no_bare_unit(start)?;
        }
        tokens.push(Spanned { value: token, span: text.span(start..lexer.at) });
    }
    Ok(tokens)
}

struct Lexer<'a> {
    text: &'a Text<'a>,
    at: usize,
}

impl Lexer<'_> {
    fn token(&mut self, c: char) -> Result<Token, Box<Mistake>> {
        match c {
            '0'..='9' => self.number(),
            'a'..='z' | 'A'..='Z' | '_' => Ok(self.name()),
            '"' | '\'' => {
                self.delimited(c, c).map(|range| Token::Text(self.text.value[range].to_owned()))
            }
            '[' => self.unit(),
            '+' | '-' | '*' | '/' | '^' | '(' | ')' | ',' | '<' => {
                self.at += 1;
                self.no_double(c)?;
                Ok(Token::Mark(c))
            }
            other => {
                let range = self.at..self.at + other.len_utf8();
                let help = match other {
                    '>' => "the only comparison is `x < y`, within piecewise: swap the two sides",
                    '=' | '!' => ONLY_COMPARISON,
                    '.' => "a number starts with a digit: 0.5",
                    _ => "names and operators must be ASCII",
                };
                let message =
                    format!("{} is not allowed in an expression", quoted(&other.to_string()));
                Err(Box::new(self.mistake(range, message, "here", help)))
            }
        }
    }

    /// Rejects a unit of measure that follows the number at `start` without brackets.
    fn no_bare_unit(&mut self, start: usize) -> Result<(), Box<Mistake>> {
        let number = self.at - start;
        let Some(c) = self.skip_space() else { return Ok(()) };
        if c.is_ascii() && !c.is_ascii_alphabetic() {
            return Ok(());
        }
        let text = &self.text.value[start..];
        let Some((meant, length)) = measure::in_brackets(text, number) else { return Ok(()) };
        let range = self.at..start + length;
        let written = &self.text.value[range.clone()];
        let is_name = written.chars().all(|c| c.is_ascii_alphanumeric());
        let product = format!("{}*{written}", &text[..number]);
        let help = if is_name {
            format!("write `{meant}`, or `{product}` for a product")
        } else {
            format!("write `{meant}`")
        };
        let message = "a unit of measure must be in brackets".to_owned();
        Err(Box::new(self.mistake(range, message, "here", &help)))
    }

    /// Rejects `**` and `<=`, which are operators of other languages.
    fn no_double(&self, c: char) -> Result<(), Box<Mistake>> {
        let next = self.rest().chars().next();
        let help = match (c, next) {
            ('*', Some('*')) => "write a power as x^2",
            ('<', Some('=')) => ONLY_COMPARISON,
            _ => return Ok(()),
        };
        let range = self.at - 1..self.at + 1;
        let message = format!("{} is not an operator", quoted(&self.text.value[range.clone()]));
        Err(Box::new(self.mistake(range, message, "here", help)))
    }

    fn number(&mut self) -> Result<Token, Box<Mistake>> {
        let start = self.at;
        self.digits();
        if self.rest().starts_with('.') {
            self.at += 1;
            if self.digits() == 0 {
                let message = "digits are missing after the point".to_owned();
                return Err(Box::new(self.mistake(
                    start..self.at,
                    message,
                    "here",
                    "write 2 or 2.0",
                )));
            }
        }
        let before_exponent = self.at;
        if self.rest().starts_with(['e', 'E']) {
            self.at += 1;
            self.at += usize::from(self.rest().starts_with(['+', '-']));
            if self.digits() == 0 {
                self.at = before_exponent;
            }
        }
        let range = start..self.at;
        if let Some(literal) = Literal::parse(&self.text.value[range.clone()]) {
            return Ok(Token::Number(literal));
        }
        if range.len() > MAX_DIGITS {
            let message = format!("a number has at most {MAX_DIGITS} digits");
            return Err(Box::new(self.mistake(range, message, "too long", "round it")));
        }
        let message = "this number is outside the range of an f64".to_owned();
        let help = "values range from about 1e-308 to 1e308";
        Err(Box::new(self.mistake(range, message, "too large or too small", help)))
    }

    fn digits(&mut self) -> usize {
        let rest = self.rest();
        let length = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
        self.at += length;
        length
    }

    /// Reads a name, or several with dots between: all but the last are the instance.
    fn name(&mut self) -> Token {
        let mut path: Option<String> = None;
        loop {
            let mut word = self.word();
            if let Some(index) = self.index() {
                // A number is inserted at once, an `i` when its value is known.
                let number = index.parse::<u32>();
                word = number.map_or(format!("{word}[{index}]"), |n| format!("{word}_{n}"));
            }
            let mut after = self.rest().chars();
            let dotted = after.next() == Some('.')
                && after.next().is_some_and(|c| c.is_ascii_alphabetic() || c == '_');
            if !dotted {
                return Token::Name(path, word);
            }
            self.at += 1;
            path = Some(path.map_or(word.clone(), |path| format!("{path}.{word}")));
        }
    }

    /// Returns the text in brackets directly after a name: `3`, `i`, `i+1`.
    fn index(&mut self) -> Option<String> {
        let (inside, after) = self.rest().strip_prefix('[')?.split_once(']')?;
        let index: String = inside.chars().filter(|c| *c != ' ').collect();
        let word = |c: char| c.is_ascii_digit() || "i+-".contains(c);
        // Only before the name of a quantity of an instance: units of measure may have the names
        // of instances.
        if !after.starts_with('.') || index.is_empty() || !index.chars().all(word) {
            return None;
        }
        self.at += inside.len() + 2;
        Some(index)
    }

    fn word(&mut self) -> String {
        let rest = self.rest();
        let word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let length = rest.find(|c| !word(c)).unwrap_or(rest.len());
        let found = rest[..length].to_owned();
        self.at += length;
        found
    }

    fn unit(&mut self) -> Result<Token, Box<Mistake>> {
        let range = self.delimited('[', ']')?;
        Measure::parse(&self.text.value[range.clone()]).map(Token::Unit).map_err(|error| {
            let at = range.start + error.range.start..range.start + error.range.end;
            Box::new(self.mistake(at, error.message, "here", &error.help))
        })
    }

    /// Returns the range between `open`, which is next, and `close`.
    fn delimited(&mut self, open: char, close: char) -> Result<Range<usize>, Box<Mistake>> {
        let start = self.at + open.len_utf8();
        let Some(length) = self.text.value[start..].find(close) else {
            let message = format!("{} is missing", quoted(&close.to_string()));
            return Err(Box::new(self.mistake(self.at..start, message, "opened here", "")));
        };
        self.at = start + length + close.len_utf8();
        Ok(start..start + length)
    }

    fn skip_space(&mut self) -> Option<char> {
        let rest = self.rest();
        self.at += rest.len() - rest.trim_start_matches([' ', '\t', '\n', '\r']).len();
        self.rest().chars().next()
    }

    fn rest(&self) -> &str {
        &self.text.value[self.at..]
    }

    fn mistake(&self, range: Range<usize>, message: String, label: &str, help: &str) -> Mistake {
        Mistake::new(Code::Syntax, self.text.span(range), message, label).help(help)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimal_numbers_are_exact() {
        let tenth = BigRational::new(1.into(), 10.into());
        for text in ["0.1", "1e-1", "0.01e1", "100E-3", "0.1000"] {
            assert_eq!(Literal::parse(text), Some(Literal(tenth.clone())), "{text}");
        }
        assert_eq!(Literal::parse("-0.1"), Some(Literal(-tenth)));
        assert_eq!(Literal::parse("+5"), Some(Literal::of_integer(5)));
        assert_eq!(Literal::parse("0e999999999999"), Some(Literal::of_integer(0)));
    }

    #[test]
    fn numbers_beyond_f64_are_refused() {
        for text in ["1e400", "1e-400", "1e999999999999999999999", "nan", "inf", "", "1e309"] {
            assert_eq!(Literal::parse(text), None, "{text}");
        }
    }
}
