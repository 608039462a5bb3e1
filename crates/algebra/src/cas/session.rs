//! Sessions, in which algebra runs.
//!
//! Without a license key, Symbolica may run in one thread of one process of a machine at a time.
//! Therefore one thread of this process runs all its sessions. It holds an advisory file lock from
//! its first session to the end of the process, so that other processes wait for it. Our own
//! algebra needs neither.
//!
//! **A process that has used Symbolica must not start other processes.** Symbolica closes its port
//! once a second, takes it again, and aborts the process if that fails. A child process holds a
//! copy of the open port until it executes its own program; meanwhile the port cannot be taken.

use std::any::Any;
use std::panic::resume_unwind;

use super::{Algebra, Cas};

/// Reason why a session failed.
#[derive(
    Debug, thiserror::Error, miette::Diagnostic, strum::IntoStaticStr, strum::VariantNames,
)]
#[strum(prefix = "algebra::", serialize_all = "kebab-case")]
#[non_exhaustive]
pub enum CasError {
    /// The lock shared by all processes could not be taken.
    #[error("cannot take the lock on Symbolica at {path}")]
    #[diagnostic(help("the folder must exist and be writable"))]
    Lock {
        /// Path of the lock file.
        path: std::path::PathBuf,
        /// Error of the system.
        #[source]
        source: std::io::Error,
    },
    /// A program that does not take the lock uses Symbolica.
    #[error(
        "another program uses Symbolica, which without a key runs once a machine: port {port} of \
         127.0.0.1 is taken"
    )]
    #[diagnostic(help("end that program, or derive by our own algebra: `--algebra plain`"))]
    InUse {
        /// Port by which Symbolica detects other users.
        port: u16,
    },
    /// The thread could not be started, or it has ended.
    #[error("the thread that runs the algebra has ended")]
    Gone,
}

impl CasError {
    /// Returns the code of this kind of error, which never changes; the book explains it.
    #[must_use]
    pub fn code(&self) -> &'static str {
        self.into()
    }
}

/// Environment variable of child processes, whose parent has already printed the notice on
/// licensing.
pub const GREETED: &str = "MACHINIST_GREETED";

/// Stack size in bytes of the thread that runs the sessions: expressions nest about six hundred
/// levels deep, and their derivatives deeper.
const STACK: usize = 256 << 20;

type Value = Box<dyn Any + Send>;
type Job = Box<dyn FnOnce(&mut Cas) -> Value + Send>;

/// Runs `job` in the thread of the algebra, and waits for its result. Processes that wait for this
/// one are shown `purpose`, such as the name of a scene.
///
/// # Errors
/// If the lock that Symbolica needs, shared by all processes of the machine, cannot be taken.
///
/// # Panics
/// With the panic of `job`, if it panics.
pub fn session<T, F>(purpose: &str, algebra: Algebra, job: F) -> Result<T, CasError>
where
    T: Send + 'static,
    F: FnOnce(&mut Cas) -> T + Send + 'static,
{
    #[cfg(feature = "faults")]
    let job = crate::faults::carried(job);
    let job = crate::interrupt::carried(job);
    let job: Job = Box::new(move |cas| Box::new(job(cas)));
    let done = match algebra {
        #[cfg(feature = "symbolica")]
        Algebra::Symbolica => guarded::run(purpose.to_owned(), job)?,
        Algebra::Plain => std::thread::Builder::new()
            .stack_size(STACK)
            .spawn(move || job(&mut Cas::plain()))
            .map_err(|_| CasError::Gone)?
            .join(),
    };
    #[cfg(not(feature = "symbolica"))]
    let _ = purpose;
    match done {
        Ok(value) => value.downcast::<T>().map(|value| *value).map_err(|_| CasError::Gone),
        Err(panic) => resume_unwind(panic),
    }
}

/// Sessions of an algebra that only one thread of the machine may use.
#[cfg(feature = "symbolica")]
mod guarded {
    use std::panic::{AssertUnwindSafe, catch_unwind};
    use std::sync::{OnceLock, mpsc};

    use super::{Cas, CasError, GREETED, Job, STACK, Value};
    use crate::cas::lock;

    type Reply = std::thread::Result<Value>;
    type Request = (String, Job, mpsc::Sender<Result<Reply, CasError>>);

    /// Runs a job in the one thread.
    pub(super) fn run(purpose: String, job: Job) -> Result<Reply, CasError> {
        static WORKER: OnceLock<mpsc::Sender<Request>> = OnceLock::new();
        let worker = WORKER.get_or_init(|| {
            let (sender, receiver) = mpsc::channel::<Request>();
            let work = move || {
                let mut cas: Option<Cas> = None;
                for (purpose, job, reply) in receiver {
                    let answer = started(&mut cas, &purpose)
                        .map(|cas| catch_unwind(AssertUnwindSafe(|| job(cas))));
                    // If the caller is gone, nobody needs the answer.
                    let _ = reply.send(answer);
                }
            };
            // If the thread cannot start, its end of the channel is dropped, which the caller
            // notices.
            let _ = std::thread::Builder::new().stack_size(STACK).spawn(work);
            sender
        });
        let (sender, receiver) = mpsc::channel();
        worker.send((purpose, job, sender)).map_err(|_| CasError::Gone)?;
        receiver.recv().map_err(|_| CasError::Gone)?
    }

    /// Starts Symbolica at the first session.
    fn started<'a>(cas: &'a mut Option<Cas>, purpose: &str) -> Result<&'a mut Cas, CasError> {
        if cas.is_none() {
            lock::hold_for_this_process(purpose)?;
            keep_standard_output_clean();
            *cas = Some(Cas::symbolica());
        }
        cas.as_mut().ok_or(CasError::Gone)
    }

    /// Suppresses Symbolica's greeting on standard output by its documented switch, and prints the
    /// same notice on standard error instead.
    fn keep_standard_output_clean() {
        #[expect(unsafe_code, reason = "the switch is an environment variable")]
        // SAFETY: Rust's own readers of the environment are locked against this writer, and nothing
        // here calls C code that reads it.
        unsafe {
            std::env::set_var("SYMBOLICA_HIDE_BANNER", "1");
        }
        if std::env::var_os(GREETED).is_none() {
            eprintln!(
                "machinist: deriving with Symbolica, for non-commercial use without a key of \
                 your own; see docs/licensing.md"
            );
        }
    }
}
