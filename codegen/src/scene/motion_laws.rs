//! Motion laws of cams and servo drives by VDI 2143: f(x) with f(0) = 0 and f(1) = 1, exact
//! derivatives and known corners.
//!
//! A polynomial law is the polynomial of least degree with given ends. Any other law has an
//! acceleration of two *lobes*, positive before the inflection x = m, negative after it. With the
//! speed G of a lobe, which rises from 0 to 1, its way H, the integral of G, and r = H(1),
//!
//! ```text
//! f' = v0 + D1 G1(x/m)                                     x < m
//! f' = v0 + D1 - D2 G2((x - m)/(1 - m))                    x >= m
//! D1 (m r1 + (1 - m) (1 - r2)) = 1 - v0 - (1 - m) r2 (v1 - v0)      from f(1) = 1
//! D2 = D1 + v0 - v1                                                 from f'(1) = v1
//! ```
//!
//! Beyond its ends a law goes on at the speed that it has there, so a law between rests dwells.
//!
//! Source: VDI 2143 part 1 (1980); R. L. Norton, Cam Design and Manufacturing Handbook, 2nd ed.
//! (2009), chapters 3 and 4.

use machinist_algebra::expr::{Expr, Function, Symbol};
use num_rational::BigRational;

use crate::scene::layout::Scope;
use crate::scene::resolve::{Resolved, Resolver};
use crate::scene::typed::{Typed, Uses, integer, power, product, reciprocal, select_less, sum};
use crate::spec::code::Code;
use crate::spec::diagnostic::Mistake;
use crate::spec::dimension::Angular;
use crate::spec::expression::{Ast, Node};
use crate::spec::{did_you_mean, quoted};

/// Largest number of arguments after x.
pub(super) const MOST_ENDS: usize = 4;
/// Copies of an argument in a law, at most.
const COPIES: usize = 24;
/// Leaves of a law besides its arguments, at most.
const LEAVES: usize = 160;
/// Levels of a law above its arguments, at most.
const LEVELS: usize = 24;

/// Form of a law.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Law {
    /// Fifth degree: position, speed and acceleration at the ends.
    Quintic,
    /// Seventh degree: also no jerk at the ends.
    Septic,
    /// Two lobes.
    Lobes(Lobe, Lobe),
}

/// Speed over a lobe of the acceleration, as the integral of the acceleration from the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Lobe {
    /// Constant acceleration.
    Constant,
    /// Quarter of a cosine, from the peak to zero.
    QuarterCosine,
    /// Half a sine.
    HalfSine,
    /// Quarter of a sine over a quarter of the lobe, then a quarter of a cosine.
    LongCosine,
    /// Quarter of a sine over a quarter of the lobe, constant over a half, quarter of a cosine.
    Trapezoid,
}

const LAWS: &[(&str, Law)] = &[
    ("3-4-5", Law::Quintic),
    ("4-5-6-7", Law::Septic),
    ("parabola", Law::Lobes(Lobe::Constant, Lobe::Constant)),
    ("simple sine", Law::Lobes(Lobe::QuarterCosine, Lobe::QuarterCosine)),
    ("inclined sine", Law::Lobes(Lobe::HalfSine, Lobe::HalfSine)),
    ("modified sine", Law::Lobes(Lobe::LongCosine, Lobe::LongCosine)),
    ("modified trapezoid", Law::Lobes(Lobe::Trapezoid, Lobe::Trapezoid)),
    ("harmonic combination", Law::Lobes(Lobe::LongCosine, Lobe::QuarterCosine)),
];

impl Resolver<'_> {
    /// Resolves a motion law: its name, x, and what holds at its ends.
    pub(super) fn motion_law(
        &mut self,
        name: &Ast,
        x: &Ast,
        ends: &[Ast],
        scope: Scope,
        allowed: Uses,
    ) -> Resolved {
        let law = law_of(name)?;
        let span = name.span.to(ends.last().unwrap_or(x).span);
        let fits = match law {
            Law::Quintic | Law::Septic => matches!(ends.len(), 0 | 2 | 4),
            Law::Lobes(..) => matches!(ends.len(), 0 | 2 | 3),
        };
        if !fits {
            let (further, usage) = match law {
                Law::Quintic | Law::Septic => ("0, 2 or 4", "x, v0, v1, a0, a1"),
                Law::Lobes(..) => ("0, 2 or 3", "x, v0, v1, inflection"),
            };
            let message = format!("this law takes {further} arguments after x, not {}", ends.len());
            let help = format!("write motion_law(\"...\", {usage}): slopes over x at 0 and at 1");
            return Err(Box::new(
                Mistake::new(Code::WrongArguments, span, message, "here").help(help),
            ));
        }
        let argument = self.number(x, scope, allowed)?;
        let mut given = Vec::new();
        for end in ends {
            given.push(self.number(end, scope, allowed)?);
        }
        if let (Law::Lobes(..), Some(inflection), Some(ast)) = (law, given.get(2), ends.get(2))
            && inflection.value.is_some_and(|value| value <= 0.0 || value >= 1.0)
        {
            let message = "the inflection of a law lies between 0 and 1";
            let mistake = Mistake::new(Code::OutOfRange, ast.span, message, "outside");
            return Err(Box::new(
                mistake.help("write the share of x at which it lies, such as 0.4"),
            ));
        }
        let terms = given.iter().fold(argument.terms, |sum, end| sum.saturating_add(end.terms));
        self.spend(terms.saturating_mul(COPIES).saturating_add(LEAVES), span)?;
        let mut parts = vec![&argument; 7];
        parts.extend(given.iter().flat_map(|end| [end, end]));
        let mut typed = Typed::over(&parts);
        typed.terms = terms.saturating_mul(COPIES).saturating_add(LEAVES);
        typed.depth += LEVELS;
        typed.angular = Angular::of_function(argument.uses.moves());
        let ends: Vec<Expr> = given.into_iter().map(|end| end.expr).collect();

        typed.expr = law.expression(&argument.expr, &ends);
        Ok(typed)
    }
}

fn law_of(ast: &Ast) -> Result<Law, Box<Mistake>> {
    let Node::Text(text) = &ast.node else {
        let mistake = Mistake::new(
            Code::WrongArguments,
            ast.span,
            "the name of a law must be quoted",
            "not a text",
        );
        return Err(Box::new(mistake.help("write motion_law(\"modified sine\", x)")));
    };
    let found = LAWS.iter().find(|(name, _)| name == text);
    found.map(|(_, law)| *law).ok_or_else(|| {
        let message = format!("unknown motion law {}", quoted(text));
        let help = did_you_mean(text, LAWS.iter().map(|(name, _)| *name));
        Box::new(Mistake::new(Code::UnknownChoice, ast.span, message, "unknown").help(help))
    })
}

impl Law {
    /// Returns f(x) with its continuation on both sides.
    fn expression(self, x: &Expr, ends: &[Expr]) -> Expr {
        let end = |index: usize| ends.get(index).cloned().unwrap_or_else(|| integer(0));
        let (v0, v1) = (end(0), end(1));
        let inside = match self {
            Self::Quintic => quintic(x, [&v0, &v1, &end(2), &end(3)]),
            Self::Septic => septic(x, [&v0, &v1, &end(2), &end(3)]),
            Self::Lobes(first, second) if ends.is_empty() && first.joins(second) => {
                symmetric(first, x)
            }
            Self::Lobes(first, second) => {
                let middle = ends.get(2).cloned().unwrap_or_else(|| number(1, 2));
                lobes([first, second], x, [&v0, &v1], &middle)
            }
        };
        let before = product(vec![v0, x.clone()]);
        let after = sum(vec![integer(1), product(vec![v1, minus(x.clone(), integer(1))])]);
        let from_zero = select_less(x.clone(), integer(1), inside, after);
        select_less(x.clone(), integer(0), before, from_zero)
    }
}

impl Lobe {
    /// Returns whether the acceleration goes on smoothly through the inflection of a law with
    /// equal lobes.
    fn joins(self, next: Lobe) -> bool {
        self == next && self != Self::Constant
    }

    /// Returns the start of the last piece.
    fn last_corner(self) -> Option<(i64, i64)> {
        match self {
            Self::Constant | Self::QuarterCosine | Self::HalfSine => None,
            Self::LongCosine => Some((1, 4)),
            Self::Trapezoid => Some((3, 4)),
        }
    }

    /// Returns H(1).
    fn end(self) -> Expr {
        match self {
            Self::Constant | Self::HalfSine | Self::Trapezoid => number(1, 2),
            Self::QuarterCosine => product(vec![integer(2), reciprocal(pi())]),
            Self::LongCosine => sum(vec![number(1, 4), reciprocal(pi())]),
        }
    }

    /// Returns H(w) for w from 0 to 1. The last piece goes on beyond 1.
    fn way(self, w: &Expr) -> Expr {
        let over = |factor: (i64, i64), of: Expr| {
            product(vec![number(factor.0, factor.1), reciprocal(pi()), of])
        };
        let angle = |factor: (i64, i64), from: (i64, i64)| {
            product(vec![
                number(factor.0, factor.1),
                pi(),
                minus(w.clone(), number(from.0, from.1)),
            ])
        };
        let sin = |angle: Expr| Expr::Call(Function::Sin, vec![angle]);
        let cos = |angle: Expr| Expr::Call(Function::Cos, vec![angle]);
        let less_cos = |angle: Expr| minus(integer(1), cos(angle));
        match self {
            Self::Constant => product(vec![number(1, 2), squared(w)]),
            Self::QuarterCosine => over((2, 1), less_cos(angle((1, 2), (0, 1)))),
            Self::HalfSine => {
                let wave = over((1, 1), sin(angle((1, 1), (0, 1))));
                product(vec![number(1, 2), minus(w.clone(), wave)])
            }
            Self::LongCosine => {
                let wave = over((1, 2), sin(angle((2, 1), (0, 1))));
                let first = product(vec![number(1, 4), minus(w.clone(), wave)]);
                let second = sum(vec![
                    product(vec![number(1, 4), w.clone()]),
                    over((-1, 8), integer(1)),
                    over((9, 8), less_cos(angle((2, 3), (1, 4)))),
                ]);
                select_less(w.clone(), number(1, 4), first, second)
            }
            Self::Trapezoid => {
                // The greatest acceleration is 2 pi/(2 + pi), so that G(1) = 1.
                let scale =
                    product(vec![integer(2), pi(), reciprocal(sum(vec![integer(2), pi()]))]);
                let wave = over((1, 2), sin(angle((2, 1), (0, 1))));
                let first = over((1, 2), minus(w.clone(), wave));
                let late = minus(w.clone(), number(1, 4));
                let second = sum(vec![
                    over((1, 8), integer(1)),
                    product(vec![over((-1, 4), integer(1)), reciprocal(pi())]),
                    over((1, 2), late.clone()),
                    product(vec![number(1, 2), squared(&late)]),
                ]);
                let third = sum(vec![
                    number(-1, 4),
                    product(vec![number(1, 2), w.clone()]),
                    over((1, 2), w.clone()),
                    product(vec![over((-1, 4), reciprocal(pi())), cos(angle((2, 1), (3, 4)))]),
                ]);
                let rest = select_less(w.clone(), number(3, 4), second, third);
                product(vec![scale, select_less(w.clone(), number(1, 4), first, rest)])
            }
        }
    }

    /// Returns the way of the lobe run through backwards: w - r + H(1 - w).
    fn mirrored(self, w: &Expr) -> Expr {
        let back = self.way(&minus(integer(1), w.clone()));
        sum(vec![w.clone(), product(vec![integer(-1), self.end()]), back])
    }
}

/// Returns a law between rests with its inflection in the middle, whose halves are each other's
/// mirror image: the last piece of the first half reaches beyond the middle.
fn symmetric(lobe: Lobe, x: &Expr) -> Expr {
    let half = |x: &Expr| {
        let way = lobe.way(&product(vec![integer(2), x.clone()]));
        product(vec![number(1, 2), way, reciprocal(lobe.end())])
    };
    let Some((corner, of)) = lobe.last_corner() else { return half(x) };
    let back = minus(integer(1), half(&minus(integer(1), x.clone())));
    select_less(x.clone(), number(2 * of - corner, 2 * of), half(x), back)
}

/// Returns a law of two lobes; see the module.
fn lobes([first, second]: [Lobe; 2], x: &Expr, [v0, v1]: [&Expr; 2], middle: &Expr) -> Expr {
    let rest = minus(integer(1), middle.clone());
    let r1 = first.end();
    let left = minus(integer(1), second.end());
    let lever = sum(vec![
        product(vec![middle.clone(), r1.clone()]),
        product(vec![rest.clone(), second.end()]),
    ]);
    let change = minus(v1.clone(), v0.clone());
    let above = sum(vec![
        integer(1),
        product(vec![integer(-1), v0.clone()]),
        product(vec![integer(-1), rest.clone(), left, change.clone()]),
    ]);
    let d1 = product(vec![above, reciprocal(lever)]);
    let d2 = minus(d1.clone(), change);
    let w1 = product(vec![x.clone(), reciprocal(middle.clone())]);
    let before = sum(vec![
        product(vec![v0.clone(), x.clone()]),
        product(vec![d1.clone(), middle.clone(), first.way(&w1)]),
    ]);
    let late = minus(x.clone(), middle.clone());
    let w2 = product(vec![late.clone(), reciprocal(rest.clone())]);
    let after = sum(vec![
        product(vec![v0.clone(), x.clone()]),
        product(vec![d1.clone(), middle.clone(), r1]),
        product(vec![d1, late]),
        product(vec![integer(-1), d2, rest, second.mirrored(&w2)]),
    ]);
    select_less(x.clone(), middle.clone(), before, after)
}

/// Returns the polynomial of fifth degree with the given speeds and accelerations at its ends:
/// v0 x + a0 x^2/2 + sum c_k x^k, where the c_k are those of p = 1 - v0 - a0/2, q = v1 - v0 - a0
/// and s = a1 - a0.
fn quintic(x: &Expr, ends: [&Expr; 4]) -> Expr {
    blend(x, ends, &[(3, [10, -4, 1]), (4, [-15, 7, -2]), (5, [6, -3, 1])])
}

/// Returns the polynomial of seventh degree that also has no jerk at its ends.
fn septic(x: &Expr, ends: [&Expr; 4]) -> Expr {
    let rows = [(4, [35, -15, 5]), (5, [-84, 39, -14]), (6, [70, -34, 13]), (7, [-20, 10, -4])];
    blend(x, ends, &rows)
}

/// Returns v0 x + a0 x^2/2 + sum (c1 p + c2 q + c3 s/2) x^k for rows (k, c).
fn blend(x: &Expr, [v0, v1, a0, a1]: [&Expr; 4], rows: &[(i64, [i64; 3])]) -> Expr {
    let times = |factor: Expr, of: &Expr| product(vec![factor, of.clone()]);
    let p = sum(vec![integer(1), times(integer(-1), v0), times(number(-1, 2), a0)]);
    let q = sum(vec![v1.clone(), times(integer(-1), v0), times(integer(-1), a0)]);
    let s = minus(a1.clone(), a0.clone());
    let lowest = rows.first().map_or(0, |(exponent, _)| *exponent);
    let coefficient = |c: &[i64; 3]| {
        sum(vec![
            product(vec![integer(c[0]), p.clone()]),
            product(vec![integer(c[1]), q.clone()]),
            product(vec![number(c[2], 2), s.clone()]),
        ])
    };
    let raised = |exponent: i64| power(x.clone(), &BigRational::from_integer(exponent.into()));
    let terms = rows.iter().map(|(exponent, c)| match exponent - lowest {
        0 => coefficient(c),
        more => product(vec![coefficient(c), raised(more)]),
    });
    sum(vec![
        product(vec![v0.clone(), x.clone()]),
        product(vec![number(1, 2), a0.clone(), raised(2)]),
        product(vec![raised(lowest), sum(terms.collect())]),
    ])
}

fn pi() -> Expr {
    Expr::Symbol(Symbol::Pi)
}

fn number(above: i64, below: i64) -> Expr {
    Expr::Number(BigRational::new(above.into(), below.into()))
}

fn squared(of: &Expr) -> Expr {
    power(of.clone(), &BigRational::from_integer(2.into()))
}

/// Returns a - b; numbers are combined.
fn minus(a: Expr, b: Expr) -> Expr {
    match (a, b) {
        (Expr::Number(a), Expr::Number(b)) => Expr::Number(a - b),
        (a, b) => sum(vec![a, product(vec![integer(-1), b])]),
    }
}
