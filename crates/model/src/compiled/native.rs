//! Machine code of a program. This is the only module that calls it.

#![allow(unsafe_code, reason = "machine code made here is called here, with checked lengths")]

use std::cell::RefCell;
use std::io;
use std::mem::MaybeUninit;
use std::sync::{Arc, OnceLock};

use cranelift_codegen::Context;
use cranelift_codegen::control::ControlPlane;
use cranelift_codegen::isa::{self, OwnedTargetIsa};
use cranelift_codegen::settings::{self, Configurable as _};
use memmap2::{Mmap, MmapMut};
use target_lexicon::Triple;

use super::schedule::Schedule;
use super::translate::Translator;
use crate::Table;
use crate::straight::{Region, Straight};

/// Signature of a piece of a program: time, state, parameters, values that fields hand over,
/// constants, motion, results, workspace.
type Piece = unsafe extern "C" fn(
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *const f64,
    *mut f64,
    *mut MaybeUninit<f64>,
);

/// Signature of a program of one piece that does not read the motion and has its workspace on the
/// stack: time of the first lane and of the last, results, state, values that fields hand over,
/// parameters, constants.
type Short =
    unsafe extern "C" fn(f64, f64, *mut f64, *const f64, *const f64, *const f64, *const f64);

#[derive(Debug)]
enum Pieces {
    Short(Short),
    Long(Vec<Piece>),
}

/// Largest workspace that is kept on the stack.
const ON_STACK: usize = 256;

/// Alignment of pieces: lines of the processor's cache, and enough for the literals behind the
/// code.
const ALIGNMENT: u32 = 64;

/// Regions that a program reads, with the lanes of each number next to each other.
#[derive(Debug, Clone, Copy)]
pub struct Regions<'a> {
    /// Time.
    pub time: &'a [f64],
    /// The state.
    pub state: &'a [f64],
    /// Parameters.
    pub parameters: &'a [f64],
    /// Values that fields hand over.
    pub handed: &'a [f64],
    /// Constants computed before.
    pub constants: &'a [f64],
    /// Results of the motion.
    pub motion: &'a [f64],
}

/// Machine code of a program.
pub struct Code {
    pieces: Pieces,
    /// Required lengths of the regions.
    needs: [usize; Region::COUNT],
    /// Length of the workspace.
    room: usize,
    /// Length of a row, if the program walks through rows from the parameters to the state.
    walks: Option<usize>,
    /// Memory of the code and the tables it points at; both live as long as the code.
    _memory: Mmap,
    _tables: Arc<[Table]>,
}

impl std::fmt::Debug for Code {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Code").field("pieces", &self.pieces).finish_non_exhaustive()
    }
}

/// Largest number of steps for which Cranelift looks for equal operations, loads among them.
///
/// Tapes share equal operations already, so that long programs gain nothing from the search, which
/// takes most of their compile time. Short programs become a fifth faster, and the search takes a
/// millisecond.
const BRIEF: usize = 64;

/// Returns whether machine code is supported on this target.
#[must_use]
pub fn is_available() -> bool {
    host(0).is_some()
}

/// Returns the target for programs of `steps` steps, or `None` if there is no backend for it.
fn host(steps: usize) -> Option<&'static OwnedTargetIsa> {
    static BRIEFLY: OnceLock<Option<OwnedTargetIsa>> = OnceLock::new();
    static AT_LENGTH: OnceLock<Option<OwnedTargetIsa>> = OnceLock::new();
    let is_brief = steps <= BRIEF;
    let made = || {
        let mut flags = settings::builder();
        let verifies = if cfg!(debug_assertions) { "true" } else { "false" };
        let chosen = [
            ("opt_level", if is_brief { "speed" } else { "none" }),
            ("enable_verifier", verifies),
            ("is_pic", "false"),
            ("unwind_info", "false"),
            // Frames larger than a guard page touch each of their pages.
            ("enable_probestack", "true"),
            ("probestack_strategy", "inline"),
        ];
        for (name, value) in chosen {
            flags.set(name, value).ok()?;
        }
        let mut isa = isa::lookup(Triple::host()).ok()?;
        #[cfg(target_arch = "x86_64")]
        enable_what_is_there(&mut isa).ok()?;
        let isa = isa.finish(settings::Flags::new(flags)).ok()?;
        // Machine code made here expects this layout of numbers.
        let is_known = cfg!(all(target_endian = "little", target_pointer_width = "64"));
        is_known.then_some(isa)
    };
    let isa = if is_brief { &BRIEFLY } else { &AT_LENGTH };
    isa.get_or_init(made).as_ref()
}

/// Enables the instruction sets of this processor that arithmetic uses.
#[cfg(target_arch = "x86_64")]
fn enable_what_is_there(isa: &mut isa::Builder) -> Result<(), settings::SetError> {
    let features = [
        (std::is_x86_feature_detected!("sse3"), "has_sse3"),
        (std::is_x86_feature_detected!("ssse3"), "has_ssse3"),
        (std::is_x86_feature_detected!("sse4.1"), "has_sse41"),
        (std::is_x86_feature_detected!("sse4.2"), "has_sse42"),
        (std::is_x86_feature_detected!("avx"), "has_avx"),
        (std::is_x86_feature_detected!("avx2"), "has_avx2"),
    ];
    for (_, name) in features.into_iter().filter(|(is_there, _)| *is_there) {
        isa.enable(name)?;
    }
    Ok(())
}

/// Returns new memory with the code, executable and no longer writable.
fn executable(code: &[u8]) -> io::Result<Mmap> {
    let mut memory = MmapMut::map_anon(code.len())?;
    memory.copy_from_slice(code);
    let memory = memory.make_exec()?;
    // No thread may continue with instructions that it fetched before.
    #[cfg(not(target_arch = "x86_64"))]
    {
        // SAFETY: the memory is valid for the duration of the call.
        unsafe { icache::clear_cache(memory.as_ptr().cast(), memory.len()) }
            .map_err(io::Error::other)?;
        icache::pipeline_flush_mt().map_err(io::Error::other)?;
    }
    Ok(memory)
}

impl Code {
    /// Compiles a program for numbers of 1 or 2 lanes. Returns `None` if that is not possible.
    pub fn new(straight: &Straight, tables: &Arc<[Table]>, lanes: usize) -> Option<Self> {
        let _span = tracing::debug_span!("compile", steps = straight.steps.len(), lanes).entered();
        let isa = host(straight.steps.len())?;
        let schedule = Schedule::new(straight, lanes);
        let needs = straight.needs().map(|need| need * lanes);
        let is_short = schedule.pieces.len() == 1
            && schedule.room * lanes <= ON_STACK
            && needs[Region::Motion as usize] == 0
            && needs[Region::Time as usize] <= lanes
            && straight.middles.is_none();
        let translator = Translator { straight, schedule: &schedule, lanes, tables, is_short };
        let mut context = Context::new();
        let (mut code, mut starts) = (Vec::new(), Vec::new());
        for index in 0..schedule.pieces.len() {
            context.clear();
            translator.translate(index, &mut context.func, &**isa);
            let compiled = context.compile(&**isa, &mut ControlPlane::default()).ok()?;
            // Functions are called by address, so no relocations remain.
            if !compiled.buffer.relocs().is_empty() || compiled.buffer.alignment > ALIGNMENT {
                return None;
            }
            code.resize(code.len().next_multiple_of(ALIGNMENT as usize), 0);
            starts.push(code.len());
            code.extend_from_slice(compiled.code_buffer());
        }
        let memory = executable(&code).ok()?;
        let address = |start: &usize| memory[*start..].as_ptr();
        let pieces = if let (true, [start]) = (is_short, &*starts) {
            // SAFETY: the function was compiled with this signature, for the calling convention of
            // the target.
            Pieces::Short(unsafe { std::mem::transmute::<*const u8, Short>(address(start)) })
        } else {
            // SAFETY: as above.
            let piece = |start| unsafe { std::mem::transmute::<*const u8, Piece>(address(start)) };
            Pieces::Long(starts.iter().map(piece).collect())
        };
        Some(Self {
            pieces,
            needs,
            room: schedule.room * lanes,
            walks: straight.middles.map(|middles| middles.row * lanes),
            _memory: memory,
            _tables: tables.clone(),
        })
    }

    /// Runs the program.
    ///
    /// # Panics
    /// If a region is shorter than the program's accesses to it.
    #[inline(always)]
    pub fn run(&self, read: &Regions<'_>, results: &mut [f64]) {
        let Regions { time, state, parameters, handed, constants, motion } = *read;
        let [of_time, of_state, of_parameters, of_handed, of_constants, of_motion, of_results] =
            self.needs;
        let is_there = time.len() >= of_time
            && state.len() >= of_state
            && parameters.len() >= of_parameters
            && handed.len() >= of_handed
            && constants.len() >= of_constants
            && motion.len() >= of_motion
            && results.len() >= of_results
            && self.walks.is_none_or(|row| is_walk(parameters, state, row));
        if !is_there {
            self.refuse(read, results.len());
        }
        match &self.pieces {
            Pieces::Short(short) => {
                let (Some(&first), Some(&last)) = (time.first(), time.last()) else {
                    self.refuse(read, results.len())
                };
                // SAFETY: as in `call`.
                unsafe {
                    short(
                        first,
                        last,
                        results.as_mut_ptr(),
                        state.as_ptr(),
                        handed.as_ptr(),
                        parameters.as_ptr(),
                        constants.as_ptr(),
                    );
                }
            }
            Pieces::Long(pieces) if self.room <= ON_STACK => {
                let mut room = [const { MaybeUninit::uninit() }; ON_STACK];
                Self::call(pieces, read, results, &mut room);
            }
            Pieces::Long(pieces) => self.run_in_much_room(pieces, read, results),
        }
    }

    #[inline(never)]
    fn run_in_much_room(&self, pieces: &[Piece], read: &Regions<'_>, results: &mut [f64]) {
        ROOM.with_borrow_mut(|room| {
            if room.len() < self.room {
                room.resize(self.room, MaybeUninit::uninit());
            }
            Self::call(pieces, read, results, room);
        });
    }

    #[cold]
    fn refuse(&self, read: &Regions<'_>, results: usize) -> ! {
        let Regions { time, state, parameters, handed, constants, motion } = *read;
        let [time, state, parameters, handed, constants, motion] =
            [time, state, parameters, handed, constants, motion].map(<[f64]>::len);
        let lengths = [time, state, parameters, handed, constants, motion, results];
        panic!("there are {lengths:?} numbers of {:?} that are read and written", self.needs);
    }

    #[inline(always)]
    fn call(
        pieces: &[Piece],
        read: &Regions<'_>,
        results: &mut [f64],
        room: &mut [MaybeUninit<f64>],
    ) {
        let Regions { time, state, parameters, handed, constants, motion } = *read;
        for piece in pieces {
            // SAFETY: the code accesses no entry beyond `needs` and `room`, which the caller has
            // compared with the lengths. If it walks, it accesses nothing beyond the rows from the
            // parameters to the state, which all lie within the parameters. It reads from the
            // workspace only what it has written, and no write overlaps data that is read later.
            unsafe {
                piece(
                    time.as_ptr(),
                    state.as_ptr(),
                    parameters.as_ptr(),
                    handed.as_ptr(),
                    constants.as_ptr(),
                    motion.as_ptr(),
                    results.as_mut_ptr(),
                    room.as_mut_ptr(),
                );
            }
        }
    }
}

/// A short program that is called repeatedly with the same lengths. They were checked once, so that
/// each call only compares them for equality.
#[derive(Debug)]
pub struct Again {
    short: Short,
    /// Lengths of state, parameters, constants and results.
    lengths: [usize; 4],
    /// Number of parameters before the values that fields hand over, which are part of the
    /// parameters.
    own: usize,
    /// Code that the piece is part of.
    _code: Arc<Code>,
}

impl Again {
    /// Prepares calls with the same lengths as these. Returns `None` if the program is not short,
    /// or if it reads or writes more than the lengths allow.
    pub fn new(code: &Arc<Code>, read: &Regions<'_>, results: usize) -> Option<Self> {
        let Pieces::Short(short) = code.pieces else { return None };
        let Regions { time, state, parameters, handed, constants, motion } = *read;
        let own = if handed.is_empty() {
            0
        } else {
            let before = handed.as_ptr().addr().checked_sub(parameters.as_ptr().addr())?;
            before / size_of::<f64>()
        };
        let [time, state, all, handed, constants, motion] =
            [time, state, parameters, handed, constants, motion].map(<[f64]>::len);
        let lengths = [time, state, all, handed, constants, motion, results];
        let is_enough = code.needs.iter().zip(&lengths).all(|(need, length)| need <= length);
        (is_enough && own + handed <= all).then(|| Self {
            short,
            lengths: [state, all, constants, results],
            own,
            _code: code.clone(),
        })
    }

    /// Runs the program and returns true if the lengths are as before; otherwise does nothing.
    /// `time` is that of the first lane and of the last. `given` is the state, the parameters
    /// followed by the values that fields hand over, and the constants, with the lanes of each
    /// number next to each other.
    #[inline(always)]
    pub fn run(&self, time: [f64; 2], given: [&[f64]; 3], results: &mut [f64]) -> bool {
        let [state, parameters, constants] = given;
        // Compared one by one: arrays are compared in memory, to which they would have to be
        // written.
        let [of_state, of_parameters, of_constants, of_results] = self.lengths;
        let is_as_before = state.len() == of_state
            && parameters.len() == of_parameters
            && constants.len() == of_constants
            && results.len() == of_results;
        if is_as_before {
            let handed = parameters.as_ptr().wrapping_add(self.own);
            // SAFETY: as in `Code::call`; the lengths are those that `needs` has been
            // compared with, and the code lives as long as this.
            unsafe {
                (self.short)(
                    time[0],
                    time[1],
                    results.as_mut_ptr(),
                    state.as_ptr(),
                    handed,
                    parameters.as_ptr(),
                    constants.as_ptr(),
                );
            }
        }
        is_as_before
    }
}

/// Returns whether the state is a row within the parameters. Then all rows from the second up to
/// the state, and as many down from the one before it, are within the parameters too.
#[inline(always)]
fn is_walk(parameters: &[f64], state: &[f64], row: usize) -> bool {
    let distance = state.as_ptr().addr().wrapping_sub(parameters.as_ptr().addr());
    let (row, all) = (row * size_of::<f64>(), size_of_val(parameters));
    distance < all && all - distance >= row
}

thread_local! {
    /// Workspace of long programs, which grows to the largest that any of them needs.
    static ROOM: RefCell<Vec<MaybeUninit<f64>>> = const { RefCell::new(Vec::new()) };
}
