//! Models derived from specs, and the program's commands.

use std::ffi::OsString;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;

use machinist_app::Trouble;
use machinist_app::embedded::{self, Derived, Refused, Spec};
use machinist_model::file;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::failure::Failure;
use crate::patience::PERIOD;

/// Error or warning: code, file, line, column, number of characters, message, hint, report.
type Report = (String, String, usize, usize, usize, String, String, String);
/// Model file, if the spec has a model; errors or warnings.
type Answer<'py> = (Option<Bound<'py, PyBytes>>, Vec<Report>);

/// Derives the model of a spec file, or of a spec that comes with the package, by name. Returns
/// `None` for a name that is unknown. Raises what signal handlers raise, such as
/// `KeyboardInterrupt`.
#[pyfunction]
pub fn derive(
    py: Python<'_>,
    file: Option<PathBuf>,
    name: Option<String>,
    keep_all: bool,
) -> Result<Option<Answer<'_>>, Failure> {
    let spec = match (file, name) {
        (Some(file), _) => Spec::File(file),
        (None, Some(name)) => Spec::Named(name),
        (None, None) => return Err(Failure::input("a spec is a file or a name")),
    };
    match py.detach(|| derived(spec, keep_all))? {
        Ok(Derived { stamped, warnings }) => {
            let bytes = PyBytes::new(py, &file::write(&stamped));
            Ok(Some((Some(bytes), warnings.into_iter().map(report).collect())))
        }
        Err(Refused::Wrong(errors)) => Ok(Some((None, errors.into_iter().map(report).collect()))),
        Err(Refused::Unknown) => Ok(None),
        // Only a signal sets the flag, and its exception was returned above.
        Err(Refused::Interrupted) => Err(Failure::input("the derivation was interrupted")),
    }
}

/// Derives on another thread, while this one looks for signals.
fn derived(spec: Spec, keep_all: bool) -> PyResult<Result<Derived, Refused>> {
    let flag = Arc::new(AtomicBool::new(false));
    let is_interrupted = Arc::clone(&flag);
    let (sender, receiver) = channel();
    let work = thread::spawn(move || {
        // Nobody waits for the result of an interrupted derivation.
        let _ = sender.send(embedded::derive(&spec, keep_all, is_interrupted));
    });
    loop {
        match receiver.recv_timeout(PERIOD) {
            Ok(done) => return Ok(done),
            Err(RecvTimeoutError::Timeout) => {}
            Err(RecvTimeoutError::Disconnected) => {
                let panic = work.join().expect_err("a thread that ends sends its result");
                std::panic::resume_unwind(panic);
            }
        }
        let quiet = Python::attach(|py: Python<'_>| -> PyResult<()> { py.check_signals() });
        if let Err(raised) = quiet {
            flag.store(true, Ordering::Relaxed);
            return Err(raised);
        }
    }
}

fn report(trouble: Trouble) -> Report {
    let Trouble { code, file, line, column, length, message, help, text, .. } = trouble;
    (code, file, line, column, length, message, help, text)
}

/// Names of the machines of standard parts that come with the package, sorted.
#[pyfunction]
pub fn machine_names() -> Vec<&'static str> {
    let mut names: Vec<_> = embedded::machine_names().collect();
    names.sort_unstable();
    names
}

/// Runs the command of the program `machinist` that `arguments` ask for, and returns its exit code.
/// `again` is the command that starts the program: an executable and its first arguments.
#[pyfunction]
pub fn program(py: Python<'_>, again: (OsString, Vec<OsString>), arguments: Vec<OsString>) -> u8 {
    let name = OsString::from("machinist");
    let arguments: Vec<OsString> = std::iter::once(name).chain(arguments).collect();
    py.detach(|| embedded::run(again, &arguments))
}
