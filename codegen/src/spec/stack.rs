//! Stack space for recursion over nested expressions.

/// Stack size in bytes. Expressions nest some six hundred levels deep, and unoptimized frames
/// take several kilobytes.
const STACK: usize = 64 << 20;

/// Does `work` on a thread of its own with a stack of known size, so that the result does not
/// depend on the caller's stack (1 MiB on some systems).
///
/// # Errors
/// If the system grants no thread.
pub fn with_room<T: Send>(work: impl FnOnce() -> T + Send) -> std::io::Result<T> {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, work)?;
        thread.join().map_err(|panic| std::panic::resume_unwind(panic))
    })
}
