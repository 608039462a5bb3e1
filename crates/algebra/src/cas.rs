//! Algebra: derivatives, sums and products, and a choice of the cheapest of several equal forms.
//!
//! Takes and returns [`Expr`]. Intermediate results are [`Form`]s, opaque expressions of the
//! [`Algebra`] that a session was opened with.

pub mod arithmetic;
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
use crate::interrupt;
use plain::Plain;
use serde::{Deserialize, Serialize};
pub use session::{CasError, GREETED, session};
#[cfg(feature = "symbolica")]
use symbolica::{Known, Vocabulary};
pub use terms::Terms;

/// Algebra used for derivation.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[non_exhaustive]
pub enum Algebra {
    /// The computer algebra system Symbolica, which simplifies most. It waits for other processes
    /// on this machine that use it.
    #[cfg(feature = "symbolica")]
    Symbolica,
    /// Our own: normal forms, derivatives, expansion of products, common factors. The motion is the
    /// same, but some equations are less simplified. It takes no lock.
    #[default]
    Plain,
}

/// Largest number of coordinates for which Symbolica is worth its time: nobody reads the equations
/// of more.
const MANY: usize = 100;

impl Algebra {
    /// All algebras, the one that simplifies most first.
    pub const ALL: &[Self] = &[
        #[cfg(feature = "symbolica")]
        Algebra::Symbolica,
        Algebra::Plain,
    ];

    /// Returns the algebra that simplifies most, for equations that are emitted or read: Symbolica
    /// if the build has it, except for more than 100 coordinates.
    #[must_use]
    pub fn most_simplifying(coordinates: usize) -> Self {
        match Self::ALL {
            [first, ..] if coordinates <= MANY => *first,
            _ => Self::Plain,
        }
    }

    /// Returns its name.
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
        /// True if an expression without a value was taken in.
        undefined: bool,
    },
}

/// An expression within a session. It must not be used in other threads.
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

/// Evaluates the same expression for a form of either algebra.
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

    /// Converts an expression to a form.
    pub fn form(&mut self, expr: &Expr) -> Form {
        interrupt::check();
        match &mut self.0 {
            #[cfg(feature = "symbolica")]
            Engine::Symbolica(vocabulary) => Known::of(vocabulary, expr).into(),
            Engine::Plain { undefined } => Plain::of(expr, undefined).into(),
        }
    }

    /// Converts a form to an expression, in an order of terms that does not depend on earlier
    /// calls.
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

    /// Returns zero.
    #[must_use]
    pub fn zero(&self) -> Form {
        match self.0 {
            #[cfg(feature = "symbolica")]
            Engine::Symbolica(_) => Known::zero().into(),
            Engine::Plain { .. } => Plain::zero().into(),
        }
    }

    /// Returns the partial derivative by one symbol.
    pub fn derivative(&mut self, form: &Form, symbol: Symbol) -> Form {
        interrupt::check();
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

    /// Returns the cheapest of several equal forms, by the cost of its tape.
    pub fn simplify(&mut self, form: &Form) -> Expr {
        interrupt::check();
        simplify::cheapest(self, form)
    }

    /// Returns the shorter of a form and its expansion. The size of a form determines the size of
    /// its derivatives before they are simplified.
    pub fn shorter(&mut self, form: &Form) -> Form {
        interrupt::check();
        simplify::shorter(self, form)
    }

    /// Cancels common factors as far as the algebra can; Symbolica does it in one quotient of
    /// polynomials. Returns `None` if that may cost too much.
    #[must_use]
    pub fn rational(&self, form: &Form) -> Option<Form> {
        simplify::may_be_joined(&self.expr(form)).then(|| match &form.0 {
            #[cfg(feature = "symbolica")]
            Kind::Symbolica(known) => known.rational().into(),
            Kind::Plain(_) => form.clone(),
        })
    }

    /// Expands products and joins sin^2 + cos^2. Returns the form unchanged if that may cost too
    /// much.
    pub fn expand(&mut self, form: &Form) -> Form {
        interrupt::check();
        if simplify::may_be_expanded(&self.expr(form)) {
            simplify::expanded(self, form)
        } else {
            form.clone()
        }
    }

    /// Returns whether a form is zero for all values of its symbols.
    #[must_use]
    pub fn is_zero(&self, form: &Form) -> bool {
        interrupt::check();
        form.is_zero() || identity::is_zero(&self.expr(form))
    }

    /// Returns the sum of many forms; one-by-one addition would copy the sum each time.
    #[must_use]
    pub fn sum(&self, forms: Vec<Form>) -> Form {
        interrupt::check();
        match self.0 {
            #[cfg(feature = "symbolica")]
            Engine::Symbolica(_) => Known::sum(forms.into_iter().map(Form::into_known)).into(),
            Engine::Plain { .. } => Plain::sum(forms.into_iter().map(Form::into_plain)).into(),
        }
    }

    /// Returns the terms of a form, indexed by their symbols.
    #[must_use]
    pub fn terms(&self, form: &Form) -> Terms {
        Terms::of(self, form)
    }

    /// Returns whether a form since the last call divided by zero or took the logarithm of zero;
    /// such a form has no value.
    pub fn was_undefined(&mut self) -> bool {
        std::mem::take(match &mut self.0 {
            #[cfg(feature = "symbolica")]
            Engine::Symbolica(vocabulary) => &mut vocabulary.undefined,
            Engine::Plain { undefined } => undefined,
        })
    }
}

/// Message for forms that were moved from one session to another.
#[cfg(feature = "symbolica")]
const ONE_ALGEBRA: &str = "the forms of a session are of its algebra";

impl Form {
    /// Returns whether the form is the number zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        match &self.0 {
            #[cfg(feature = "symbolica")]
            Kind::Symbolica(known) => known.is_zero(),
            Kind::Plain(plain) => plain.0.is_zero(),
        }
    }

    /// Returns the form with its products expanded.
    fn expand(&self) -> Form {
        match &self.0 {
            #[cfg(feature = "symbolica")]
            Kind::Symbolica(known) => known.expand().into(),
            Kind::Plain(plain) => Plain(plain::expand(&plain.0)).into(),
        }
    }

    /// Returns the terms of a sum, or the form itself.
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

/// Implements an operation on two forms of one algebra.
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
