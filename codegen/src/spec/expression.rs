//! Expressions, with the span of each part.
//!
//! Excluded: meanings of names and dimensions, which the scene resolves.

use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::dimension::Unit;
use crate::spec::lexer::{self, Token};
pub use crate::spec::lexer::{Literal, Text};
use crate::spec::measure::Measure;
use crate::spec::names::quoted;

/// Maximum nesting of parentheses, calls, signs and powers.
pub const MAX_NESTING: usize = 200;

/// A part of an expression.
#[derive(Debug, Clone, PartialEq)]
pub struct Ast {
    /// Source span.
    pub span: Span,
    /// Kind and parts.
    pub node: Node,
}

/// Kind of a part of an expression.
#[derive(Debug, Clone, PartialEq)]
pub enum Node {
    /// A number, with a unit in brackets.
    Number(Literal, Option<Unit>),
    /// `name` or `instance.name`.
    Name(Option<String>, String),
    /// -x.
    Negative(Box<Ast>),
    /// Two or more terms; true for a term that is subtracted.
    Sum(Vec<(bool, Ast)>),
    /// Two or more factors; true for a factor that divides.
    Product(Vec<(bool, Ast)>),
    /// Base and exponent.
    Power(Box<Ast>, Box<Ast>),
    /// Function, span of its name, and arguments.
    Call(String, Span, Vec<Ast>),
    /// a < b, an argument of a call.
    Less(Box<Ast>, Box<Ast>),
    /// A quoted text, an argument of a call.
    Text(String),
}

impl Ast {
    /// Visits every part, each after its own parts.
    pub fn visit<'a>(&'a self, see: &mut impl FnMut(&'a Ast)) {
        match &self.node {
            Node::Number(..) | Node::Name(..) | Node::Text(_) => {}
            Node::Negative(of) => of.visit(see),
            Node::Sum(parts) | Node::Product(parts) => {
                for (_, part) in parts {
                    part.visit(see);
                }
            }
            Node::Power(a, b) | Node::Less(a, b) => {
                a.visit(see);
                b.visit(see);
            }
            Node::Call(_, _, arguments) => {
                for part in arguments {
                    part.visit(see);
                }
            }
        }
        see(self);
    }

    /// Adds the CSV files that the expression refers to.
    pub fn tables(&self, files: &mut Vec<Spanned<String>>) {
        self.visit(&mut |part| {
            if let Node::Call(function, _, arguments) = &part.node
                && let ("table", Some(Ast { span, node: Node::Text(path) })) =
                    (function.as_str(), arguments.first())
            {
                files.push(Spanned { value: path.clone(), span: *span });
            }
        });
    }
}

/// Parses an expression by recursive descent.
///
/// # Errors
/// The first token that fits no rule of the language, or a part nested deeper than
/// [`MAX_NESTING`].
pub fn parse(text: &Text<'_>) -> Result<Ast, Box<Mistake>> {
    let tokens = lexer::tokens(text)?;
    let end = text.span(text.value.len()..text.value.len());
    let mut parser = Parser { tokens: &tokens, at: 0, depth: 0, end };
    let ast = parser.sum()?;
    match parser.peek() {
        None => Ok(ast),
        Some(token) => Err(Box::new(Parser::unexpected(token))),
    }
}

struct Parser<'a> {
    tokens: &'a [Spanned<Token>],
    at: usize,
    depth: usize,
    end: Span,
}

type Parsed = Result<Ast, Box<Mistake>>;

impl<'a> Parser<'a> {
    /// Parses product { ("+" | "-") product }.
    fn sum(&mut self) -> Parsed {
        let first = self.product()?;
        let mut terms = vec![(false, first)];
        while let Some(mark @ ('+' | '-')) = self.mark() {
            self.at += 1;
            terms.push((mark == '-', self.product()?));
        }
        Ok(joined(terms, Node::Sum))
    }

    /// Parses signed { ("*" | "/") signed }.
    fn product(&mut self) -> Parsed {
        let first = self.signed()?;
        let mut factors = vec![(false, first)];
        while let Some(mark @ ('*' | '/')) = self.mark() {
            self.at += 1;
            factors.push((mark == '/', self.signed()?));
        }
        Ok(joined(factors, Node::Product))
    }

    /// Parses { "+" | "-" } power.
    fn signed(&mut self) -> Parsed {
        let Some(mark @ ('+' | '-')) = self.mark() else { return self.power() };
        let sign = self.here();
        self.at += 1;
        let of = self.nested(Self::signed)?;
        if mark == '+' {
            return Ok(of);
        }
        Ok(Ast { span: sign.to(of.span), node: Node::Negative(Box::new(of)) })
    }

    /// Parses atom \["^" signed\].
    fn power(&mut self) -> Parsed {
        let base = self.atom()?;
        if self.mark() != Some('^') {
            return Ok(base);
        }
        self.at += 1;
        let exponent = self.nested(Self::signed)?;
        let span = base.span.to(exponent.span);
        Ok(Ast { span, node: Node::Power(Box::new(base), Box::new(exponent)) })
    }

    /// Parses number \[unit\] | name | name "(" arguments ")" | "(" sum ")".
    fn atom(&mut self) -> Parsed {
        let Some(token) = self.peek() else {
            return Err(Box::new(self.missing("the expression ends too early")));
        };
        self.at += 1;
        match &token.value {
            Token::Number(number) => Ok(self.number(number, token.span)),
            Token::Name(None, name) if self.mark() == Some('(') => self.call(name, token.span),
            Token::Name(instance, name) => {
                Ok(Ast { span: token.span, node: Node::Name(instance.clone(), name.clone()) })
            }
            Token::Mark('(') => {
                let mut inside = self.nested(Self::sum)?;
                inside.span = token.span.to(self.close(token.span)?);
                Ok(inside)
            }
            _ => Err(Box::new(Parser::unexpected(token))),
        }
    }

    /// Returns a number in coherent SI units, converted from the unit in which it is written.
    fn number(&mut self, number: &Literal, span: Span) -> Ast {
        let Some(Spanned { value: Token::Unit(measure), span: end }) = self.peek() else {
            return Ast { span, node: Node::Number(number.clone(), None) };
        };
        self.at += 1;
        let span = span.to(*end);
        let Measure { unit, factor } = measure;
        let size = Literal(&number.0 * &factor.ratio);
        let size = Ast { span, node: Node::Number(size, Some(*unit)) };
        if factor.pis == 0 {
            return size;
        }
        let pi = Ast { span, node: Node::Name(None, "pi".to_owned()) };
        let pis = (0..factor.pis.unsigned_abs()).map(|_| (factor.pis < 0, pi.clone()));
        let factors = std::iter::once((false, size)).chain(pis).collect();
        Ast { span, node: Node::Product(factors) }
    }

    fn call(&mut self, name: &str, name_span: Span) -> Parsed {
        let open = self.here();
        self.at += 1;
        let mut arguments = Vec::new();
        if self.mark() != Some(')') {
            arguments.push(self.nested(Self::argument)?);
        }
        while self.mark() == Some(',') {
            self.at += 1;
            arguments.push(self.nested(Self::argument)?);
        }
        let span = name_span.to(self.close(open)?);
        Ok(Ast { span, node: Node::Call(name.to_owned(), name_span, arguments) })
    }

    /// Parses text | sum \["<" sum\].
    fn argument(&mut self) -> Parsed {
        if let Some(Spanned { value: Token::Text(text), span }) = self.peek() {
            self.at += 1;
            return Ok(Ast { span: *span, node: Node::Text(text.clone()) });
        }
        let left = self.sum()?;
        if self.mark() != Some('<') {
            return Ok(left);
        }
        self.at += 1;
        let right = self.sum()?;
        let span = left.span.to(right.span);
        Ok(Ast { span, node: Node::Less(Box::new(left), Box::new(right)) })
    }

    fn nested(&mut self, rule: fn(&mut Self) -> Parsed) -> Parsed {
        if self.depth >= MAX_NESTING {
            let message = format!("the expression nests deeper than {MAX_NESTING}");
            let mistake = Mistake::new(Code::TooLarge, self.here(), message, "too deep here");
            return Err(Box::new(mistake.help("move a part of it into a helper")));
        }
        self.depth += 1;
        let part = rule(self);
        self.depth -= 1;
        part
    }

    fn close(&mut self, open: Span) -> Result<Span, Box<Mistake>> {
        match self.peek() {
            Some(Spanned { value: Token::Mark(')'), span }) => {
                self.at += 1;
                Ok(*span)
            }
            Some(token) => Err(Box::new(Parser::unexpected(token))),
            None => {
                let mistake = Mistake::new(
                    Code::Syntax,
                    open,
                    "a closing parenthesis is missing",
                    "opened here",
                );
                Err(Box::new(mistake))
            }
        }
    }

    fn peek(&self) -> Option<&'a Spanned<Token>> {
        self.tokens.get(self.at)
    }

    fn mark(&self) -> Option<char> {
        match self.peek()?.value {
            Token::Mark(mark) => Some(mark),
            _ => None,
        }
    }

    fn here(&self) -> Span {
        self.peek().map_or(self.end, |token| token.span)
    }

    fn missing(&self, message: &str) -> Mistake {
        Mistake::new(Code::Syntax, self.end, message, "something is missing here")
    }

    fn unexpected(token: &Spanned<Token>) -> Mistake {
        let (message, help) = match &token.value {
            Token::Mark('<') => (
                "a comparison is allowed only in piecewise".to_owned(),
                "write piecewise(x < y, a, b), which is a where x is less than y, and b elsewhere",
            ),
            Token::Mark(mark) => {
                (format!("{} is not expected here", quoted(&mark.to_string())), "")
            }
            Token::Number(_) => ("a number is not expected here".to_owned(), "is `*` missing?"),
            Token::Name(..) => (
                "a name is not expected here".to_owned(),
                "is `*` missing? Units of measure are written in brackets: 0.1 [s]",
            ),
            Token::Text(_) => (
                "a quoted text is not expected here".to_owned(),
                "only `table` and `motion_law` take texts",
            ),
            Token::Unit(_) => (
                "a unit in brackets is not expected here".to_owned(),
                "it follows a number: 0.1 [s]",
            ),
        };
        Mistake::new(Code::Syntax, token.span, message, "not expected").help(help)
    }
}

/// Returns a single part as it is, or several as a node that spans them.
fn joined(mut parts: Vec<(bool, Ast)>, node: fn(Vec<(bool, Ast)>) -> Node) -> Ast {
    if parts.len() == 1
        && let Some((_, only)) = parts.pop()
    {
        return only;
    }
    let first = parts[0].1.span;
    let span = parts.iter().fold(first, |span, (_, part)| span.to(part.span));
    Ast { span, node: node(parts) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::spec::diagnostic::FileId;
    use crate::spec::toml::Tree;

    /// Formats the expression with all grouping explicit.
    fn grouped(text: &str) -> String {
        let span = Span::new(FileId(0), 0..text.len());
        let tree = Spanned { value: Tree::Text { value: text.to_owned(), inner: Some(0) }, span };
        let read = Text::of(&tree).map(|text| parse(&text));
        match read {
            Some(Ok(ast)) => show(&ast),
            Some(Err(mistake)) => format!("{} at {}", mistake.message, mistake.span.start),
            None => String::new(),
        }
    }

    fn show(ast: &Ast) -> String {
        let parts = |parts: &[(bool, Ast)], marks: [&str; 2]| {
            let shown = parts
                .iter()
                .map(|(second, part)| format!("{}{}", marks[usize::from(*second)], show(part)));
            format!("({})", shown.collect::<String>())
        };
        match &ast.node {
            Node::Number(number, unit) => {
                format!(
                    "{}{}",
                    number.0,
                    unit.map_or(String::new(), |u| format!("[{}]", u.dimension))
                )
            }
            Node::Name(None, name) => name.clone(),
            Node::Name(Some(instance), name) => format!("{instance}.{name}"),
            Node::Negative(of) => format!("(-{})", show(of)),
            Node::Sum(terms) => parts(terms, ["+", "-"]),
            Node::Product(factors) => parts(factors, ["*", "/"]),
            Node::Power(base, exponent) => format!("({}^{})", show(base), show(exponent)),
            Node::Call(name, _, arguments) => {
                format!("{name}({})", arguments.iter().map(show).collect::<Vec<_>>().join(", "))
            }
            Node::Less(a, b) => format!("{} < {}", show(a), show(b)),
            Node::Text(text) => format!("{text:?}"),
        }
    }

    #[test]
    fn operators_bind_as_in_mathematics() {
        for (text, expected) in [
            ("-x^2", "(-(x^2))"),
            ("x^-2", "(x^(-2))"),
            ("x^y^z", "(x^(y^z))"),
            ("a - b - c", "(+a-b-c)"),
            ("a/b*c/d", "(*a/b*c/d)"),
            ("a + b*c^2", "(+a+(*b*(c^2)))"),
            ("-a*b", "(*(-a)*b)"),
            ("2*-a", "(*2*(-a))"),
            ("(a + b)*c", "(*(+a+b)*c)"),
            ("0.1 [s]*motor.phi", "(*1/10[s]*motor.phi)"),
            ("5 [mm] + x", "(+1/200[m]+x)"),
            ("1500 [rpm]*t", "(*(*50[1/s]*pi)*t)"),
            ("-90 [1/deg]", "(-(*16200[1 (dimensionless)]/pi))"),
            ("2e3", "2000"),
            ("piecewise(t < 1 [s], a, b)", "piecewise(t < 1[s], a, b)"),
            ("table('a b.csv', \"load\", t)", "table(\"a b.csv\", \"load\", t)"),
            (" \n a\t", "a"),
        ] {
            assert_eq!(grouped(text), expected, "{text}");
        }
    }

    #[test]
    fn what_fits_no_rule_is_refused_where_it_stands() {
        for (text, expected) in [
            ("", "the expression ends too early at 0"),
            ("a +", "the expression ends too early at 3"),
            ("a b", "a name is not expected here at 2"),
            ("2 3", "a number is not expected here at 2"),
            ("f(a", "a closing parenthesis is missing at 1"),
            ("(a]", "`]` is not allowed in an expression at 2"),
            ("a**b", "`**` is not an operator at 1"),
            ("a <= b", "`<=` is not an operator at 2"),
            ("a; b", "`;` is not allowed in an expression at 1"),
            ("f(a,)", "`)` is not expected here at 4"),
            ("a [m]", "a unit in brackets is not expected here at 2"),
            ("2 [mn]", "unknown unit of measure \"mn\" at 3"),
            ("2 [m", "`]` is missing at 2"),
            ("2.", "digits are missing after the point at 0"),
        ] {
            assert_eq!(grouped(text), expected, "{text}");
        }
    }
}
