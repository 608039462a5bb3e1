//! Algebra: derivatives, sums and products, and which of several equal forms is cheapest.
//!
//! Takes [`Expr`] in and gives [`Expr`] back; in between stands [`Form`], an expression of
//! the [`Algebra`] that a session was opened with, and that nobody else looks into.

mod digits;
#[cfg(feature = "symbolica")]
mod lock;
mod plain;
mod session;
mod simplify;
#[cfg(feature = "symbolica")]
mod symbolica;
mod terms;

use crate::expr::{Expr, Symbol, identity};
use plain::Plain;
use serde::{Deserialize, Serialize};
pub use session::{CasError, GREETED, session};
#[cfg(feature = "symbolica")]
use symbolica::{Known, Vocabulary};
pub use terms::Terms;

/// What works expressions out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Algebra {
    /// The computer algebra system of that name, which simplifies most. It waits for whoever on
    /// this machine uses it.
    #[cfg(feature = "symbolica")]
    Symbolica,
    /// Our own: normal forms, derivatives, products multiplied out, common factors. The same
    /// motion, by equations that are less simplified here and there. It takes no lock.
    #[default]
    Plain,
}

/// Coordinates beyond which Symbolica is not worth its time: nobody reads so many equations.
const MANY: usize = 100;

impl Algebra {
    /// All of them, the one that simplifies most first.
    pub const ALL: &[Self] = &[
        #[cfg(feature = "symbolica")]
        Algebra::Symbolica,
        Algebra::Plain,
    ];

    /// The algebra that simplifies most, for equations that are emitted or read: Symbolica where
    /// the build has it, but for more than 100 coordinates.
    #[must_use]
    pub fn most_simplifying(coordinates: usize) -> Self {
        match Self::ALL {
            [first, ..] if coordinates <= MANY => *first,
            _ => Self::Plain,
        }
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            #[cfg(feature = "symbolica")]
            Algebra::Symbolica => "symbolica",
            Algebra::Plain => "plain",
        }
    }
}

/// An algebra during a session.
pub struct Cas(Engine);

enum Engine {
    #[cfg(feature = "symbolica")]
    Symbolica(Box<Vocabulary>),
    Plain {
        /// Whether an expression without a value was taken in.
        undefined: bool,
    },
}

/// An expression within a session. Not for other threads.
#[derive(Clone)]
pub struct Form(Kind);

#[derive(Clone)]
enum Kind {
    #[cfg(feature = "symbolica")]
    Symbolica(Known),
    Plain(Plain),
}

impl From<Plain> for Form {
    fn from(plain: Plain) -> Self {
        Form(Kind::Plain(plain))
    }
}

#[cfg(feature = "symbolica")]
impl From<Known> for Form {
    fn from(known: Known) -> Self {
        Form(Kind::Symbolica(known))
    }
}

/// The same of a form of either algebra.
macro_rules! of_form {
    ($form:expr, $inner:ident => $value:expr) => {
        match &$form.0 {
            #[cfg(feature = "symbolica")]
            Kind::Symbolica($inner) => $value,
            Kind::Plain($inner) => $value,
        }
    };
}

impl Cas {
    #[cfg(feature = "symbolica")]
    fn symbolica() -> Self {
        Cas(Engine::Symbolica(Box::new(Vocabulary::new())))
    }

    fn plain() -> Self {
        Cas(Engine::Plain { undefined: false })
    }

    /// Takes an expression in.
    pub fn form(&mut self, expr: &Expr) -> Form {
        match &mut self.0 {
            #[cfg(feature = "symbolica")]
            Engine::Symbolica(vocabulary) => Known::of(vocabulary, expr).into(),
            Engine::Plain { undefined } => Plain::of(expr, undefined).into(),
        }
    }

    /// Gives an expression back, in an order of terms that does not depend on
    /// what was asked before.
    #[must_use]
    pub fn expr(&self, form: &Form) -> Expr {
        match (&self.0, &form.0) {
            #[cfg(feature = "symbolica")]
            (Engine::Symbolica(vocabulary), Kind::Symbolica(known)) => known.expr(vocabulary),
            #[cfg(feature = "symbolica")]
            (Engine::Plain { .. }, Kind::Symbolica(_)) => unreachable!("{ONE_ALGEBRA}"),
            (_, Kind::Plain(plain)) => plain.0.clone(),
        }
    }

    /// Zero.
    #[must_use]
    pub fn zero(&self) -> Form {
        match self.0 {
            #[cfg(feature = "symbolica")]
            Engine::Symbolica(_) => Known::zero().into(),
            Engine::Plain { .. } => Plain::zero().into(),
        }
    }

    /// Partial derivative with respect to one symbol, all others held.
    pub fn derivative(&mut self, form: &Form, symbol: Symbol) -> Form {
        match (&mut self.0, &form.0) {
            #[cfg(feature = "symbolica")]
            (Engine::Symbolica(vocabulary), Kind::Symbolica(known)) => {
                known.derivative(vocabulary, symbol).into()
            }
            #[cfg(feature = "symbolica")]
            (Engine::Plain { .. }, Kind::Symbolica(_)) => unreachable!("{ONE_ALGEBRA}"),
            (_, Kind::Plain(plain)) => plain.derivative(symbol).into(),
        }
    }

    /// The cheapest of several equal forms, by operations of its tape.
    pub fn simplify(&mut self, form: &Form) -> Expr {
        simplify::cheapest(self, form)
    }

    /// The shorter of a form and what it is multiplied out: what it is derived from
    /// decides how long everything derived is before it is simplified.
    pub fn shorter(&mut self, form: &Form) -> Form {
        simplify::shorter(self, form)
    }

    /// With common factors cancelled, as far as the algebra can: as one quotient of
    /// polynomials by Symbolica. None beyond what that may cost.
    #[must_use]
    pub fn rational(&self, form: &Form) -> Option<Form> {
        simplify::may_be_joined(&self.expr(form)).then(|| match &form.0 {
            #[cfg(feature = "symbolica")]
            Kind::Symbolica(known) => known.rational().into(),
            Kind::Plain(_) => form.clone(),
        })
    }

    /// Multiplied out, with sin^2 + cos^2 put together; as it stands beyond what that may
    /// cost.
    pub fn expand(&mut self, form: &Form) -> Form {
        if simplify::may_be_expanded(&self.expr(form)) {
            simplify::expanded(self, form)
        } else {
            form.clone()
        }
    }

    /// Whether a form is zero, whatever its symbols are.
    #[must_use]
    pub fn is_zero(&self, form: &Form) -> bool {
        form.is_zero() || identity::is_zero(&self.expr(form))
    }

    /// The sum of many forms; adding them one by one would copy the sum each time.
    #[must_use]
    pub fn sum(&self, forms: Vec<Form>) -> Form {
        match self.0 {
            #[cfg(feature = "symbolica")]
            Engine::Symbolica(_) => Known::sum(forms.into_iter().map(Form::into_known)).into(),
            Engine::Plain { .. } => Plain::sum(forms.into_iter().map(Form::into_plain)).into(),
        }
    }

    /// A form by the symbols of its terms.
    #[must_use]
    pub fn terms(&self, form: &Form) -> Terms {
        Terms::of(self, form)
    }

    /// Whether a form since the last question divided by zero or took the logarithm of
    /// zero; such a form stands for nothing.
    pub fn was_undefined(&mut self) -> bool {
        std::mem::take(match &mut self.0 {
            #[cfg(feature = "symbolica")]
            Engine::Symbolica(vocabulary) => &mut vocabulary.undefined,
            Engine::Plain { undefined } => undefined,
        })
    }
}

/// Nobody takes forms from one session to another.
#[cfg(feature = "symbolica")]
const ONE_ALGEBRA: &str = "the forms of a session are of its algebra";

impl Form {
    /// Whether the form is zero as it stands.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        match &self.0 {
            #[cfg(feature = "symbolica")]
            Kind::Symbolica(known) => known.is_zero(),
            Kind::Plain(plain) => plain.0.is_zero(),
        }
    }

    /// What is multiplied out.
    fn expand(&self) -> Form {
        match &self.0 {
            #[cfg(feature = "symbolica")]
            Kind::Symbolica(known) => known.expand().into(),
            Kind::Plain(plain) => Plain(plain::expand(&plain.0)).into(),
        }
    }

    /// The terms of a sum, or the form alone.
    fn terms(&self) -> Vec<Form> {
        of_form!(self, form => form.terms())
    }

    #[cfg(feature = "symbolica")]
    fn into_known(self) -> Known {
        match self.0 {
            Kind::Symbolica(known) => known,
            Kind::Plain(_) => unreachable!("{ONE_ALGEBRA}"),
        }
    }

    fn into_plain(self) -> Plain {
        match self.0 {
            Kind::Plain(plain) => plain,
            #[cfg(feature = "symbolica")]
            Kind::Symbolica(_) => unreachable!("{ONE_ALGEBRA}"),
        }
    }
}

/// An operation on two forms of one algebra.
macro_rules! operation {
    ($trait:ident, $method:ident, $($doc:literal)?) => {
        impl std::ops::$trait for &Form {
            type Output = Form;
            $(#[doc = $doc])?
            fn $method(self, other: &Form) -> Form {
                match (&self.0, &other.0) {
                    #[cfg(feature = "symbolica")]
                    (Kind::Symbolica(a), Kind::Symbolica(b)) => a.$method(b).into(),
                    (Kind::Plain(a), Kind::Plain(b)) => a.$method(b).into(),
                    #[cfg(feature = "symbolica")]
                    _ => unreachable!("{ONE_ALGEBRA}"),
                }
            }
        }
    };
}

operation!(Add, add,);
operation!(Sub, sub,);
operation!(Mul, mul,);
operation!(Div, div, "The divisor must not be zero.");

impl std::ops::Neg for &Form {
    type Output = Form;
    fn neg(self) -> Form {
        of_form!(self, form => form.neg().into())
    }
}
