//! The only room that names Symbolica.
//!
//! Takes [`Expr`] in and gives [`Expr`] back; in between stands [`Form`], an
//! expression of the computer algebra system that nobody else looks into.
//!
//! Without a key Symbolica may run in one thread of one process of a machine at
//! a time. So everything goes through [`session`]: one thread of this process
//! runs every session, and it holds an advisory file lock from its first session
//! to the end of the process, so that other processes wait for it.

mod convert;
mod functions;
mod lock;
mod simplify;
mod terms;

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::{OnceLock, mpsc};

use symbolica::atom::{Atom, AtomCore};

use crate::expr::{Expr, Symbol, identity};
use functions::Vocabulary;
pub use terms::Terms;

/// Why a session could not be held.
#[derive(Debug, thiserror::Error, miette::Diagnostic)]
pub enum CasError {
    /// The lock that keeps processes apart could not be taken.
    #[error("cannot take the lock on Symbolica at {path}")]
    #[diagnostic(help("the folder must exist and be writable"))]
    Lock {
        /// Where the lock file is.
        path: std::path::PathBuf,
        /// What the system said.
        #[source]
        source: std::io::Error,
    },
    /// The thread that runs the sessions is gone.
    #[error("the thread that runs Symbolica has ended")]
    Gone,
}

/// The computer algebra system during a session.
pub struct Cas {
    vocabulary: Vocabulary,
}

/// An expression within a session. Not for other threads.
#[derive(Clone)]
pub struct Form(Atom);

/// Symbolica greets on standard output unless told not to by its documented
/// switch; we say what it would say on standard error instead.
fn keep_standard_output_clean() {
    #[expect(unsafe_code, reason = "the switch is an environment variable")]
    // SAFETY: Rust's own readers of the environment are locked against this
    // writer, and nothing here calls C code that reads it.
    unsafe {
        std::env::set_var("SYMBOLICA_HIDE_BANNER", "1");
    }
    if std::env::var_os(GREETED).is_none() {
        eprintln!(
            "machinist: deriving with Symbolica, for non-commercial use without a key of your \
             own; see docs/licensing.md"
        );
    }
}

/// The environment variable of processes whose parent has said on whose terms they derive.
pub const GREETED: &str = "MACHINIST_GREETED";

/// Bytes of stack of the thread that runs the sessions: expressions nest some six hundred
/// levels deep, and their derivatives deeper.
const STACK: usize = 256 << 20;

type Job = Box<dyn FnOnce(&mut Cas) -> Box<dyn Any + Send> + Send>;
type Reply = std::thread::Result<Box<dyn Any + Send>>;

/// Runs `job` on the one thread that may use Symbolica and waits for its result. Who has
/// to wait for this process is told `purpose`, such as the name of a scene.
///
/// # Errors
/// If the lock shared by all processes of the machine cannot be taken.
///
/// # Panics
/// With the panic of `job`, if it panics.
pub fn session<T, F>(purpose: &str, job: F) -> Result<T, CasError>
where
    T: Send + 'static,
    F: FnOnce(&mut Cas) -> T + Send + 'static,
{
    type Request = (String, Job, mpsc::Sender<Result<Reply, CasError>>);
    static WORKER: OnceLock<mpsc::Sender<Request>> = OnceLock::new();
    let worker = WORKER.get_or_init(|| {
        let (sender, receiver) = mpsc::channel::<Request>();
        let work = move || {
            let mut cas: Option<Cas> = None;
            for (purpose, job, reply) in receiver {
                let answer = Cas::started(&mut cas, &purpose)
                    .map(|cas| catch_unwind(AssertUnwindSafe(|| job(cas))));
                // The asker may be gone; then nobody needs the answer.
                let _ = reply.send(answer);
            }
        };
        // Without a thread its end of the channel is gone, which the asker is told.
        let _ = std::thread::Builder::new().stack_size(STACK).spawn(work);
        sender
    });
    let (sender, receiver) = mpsc::channel();
    #[cfg(test)]
    let job = crate::faults::carried(job);
    let job: Job = Box::new(move |cas| Box::new(job(cas)));
    worker.send((purpose.to_owned(), job, sender)).map_err(|_| CasError::Gone)?;
    match receiver.recv().map_err(|_| CasError::Gone)?? {
        Ok(value) => value.downcast::<T>().map(|value| *value).map_err(|_| CasError::Gone),
        Err(panic) => resume_unwind(panic),
    }
}

impl Cas {
    /// Starts the system at the first session.
    fn started<'a>(cas: &'a mut Option<Cas>, purpose: &str) -> Result<&'a mut Cas, CasError> {
        if cas.is_none() {
            lock::hold_for_this_process(purpose)?;
            keep_standard_output_clean();
            *cas = Some(Cas { vocabulary: Vocabulary::new() });
        }
        cas.as_mut().ok_or(CasError::Gone)
    }

    /// Takes an expression in.
    pub fn form(&mut self, expr: &Expr) -> Form {
        Form(convert::to_atom(&mut self.vocabulary, expr))
    }

    /// Gives an expression back, in an order of terms that does not depend on
    /// what was asked before.
    #[must_use]
    pub fn expr(&self, form: &Form) -> Expr {
        convert::to_expr(&self.vocabulary, form.0.as_view())
    }

    /// Zero.
    #[must_use]
    pub fn zero(&self) -> Form {
        Form(Atom::new())
    }

    /// Partial derivative with respect to one symbol, all others held.
    pub fn derivative(&mut self, form: &Form, symbol: Symbol) -> Form {
        let variable = self.vocabulary.variable(symbol);
        Form(form.0.derivative(variable))
    }

    /// The cheapest of several equal forms, by operations of its tape.
    pub fn simplify(&mut self, form: &Form) -> Expr {
        simplify::cheapest(&mut self.vocabulary, &form.0)
    }

    /// The shorter of a form and what it is multiplied out: what it is derived from
    /// decides how long everything derived is before it is simplified.
    pub fn shorter(&mut self, form: &Form) -> Form {
        Form(simplify::shorter(&mut self.vocabulary, &form.0))
    }

    /// As one quotient of polynomials, common factors cancelled; none beyond what that
    /// may cost.
    #[must_use]
    pub fn rational(&self, form: &Form) -> Option<Form> {
        let is_small = simplify::may_be_factored(&self.expr(form));
        is_small.then(|| Form(form.0.together().cancel()))
    }

    /// Multiplied out, with sin^2 + cos^2 put together; as it stands beyond what that may
    /// cost.
    pub fn expand(&mut self, form: &Form) -> Form {
        if simplify::may_be_expanded(&self.expr(form)) {
            Form(simplify::trigonometric(&mut self.vocabulary, &form.0.expand()))
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
        Form(convert::sum(forms.into_iter().map(|form| form.0).collect()))
    }

    /// A form by the symbols of its terms.
    #[must_use]
    pub fn terms(&self, form: &Form) -> Terms {
        Terms::of(self, form)
    }

    /// Whether a form since the last question divided by zero or took the logarithm of
    /// zero; such a form stands for nothing.
    pub fn was_undefined(&mut self) -> bool {
        std::mem::take(&mut self.vocabulary.undefined)
    }
}

impl Form {
    /// Whether the form is zero as it stands.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }
}

impl std::ops::Add for &Form {
    type Output = Form;
    fn add(self, other: &Form) -> Form {
        Form(&self.0 + &other.0)
    }
}

impl std::ops::Sub for &Form {
    type Output = Form;
    fn sub(self, other: &Form) -> Form {
        Form(&self.0 - &other.0)
    }
}

impl std::ops::Mul for &Form {
    type Output = Form;
    fn mul(self, other: &Form) -> Form {
        Form(&self.0 * &other.0)
    }
}

impl std::ops::Div for &Form {
    type Output = Form;
    /// The divisor must not be zero.
    fn div(self, other: &Form) -> Form {
        Form(&self.0 / &other.0)
    }
}

impl std::ops::Neg for &Form {
    type Output = Form;
    fn neg(self) -> Form {
        Form(-&self.0)
    }
}
