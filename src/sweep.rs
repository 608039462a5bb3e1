//! Runs of many variants of one machine, in lanes and on threads.
//!
//! Taylor's method runs variants side by side, each with its own parameters, steps and jumps: eight
//! with emitted code, two with a JIT-compiled model. `auto` does the same as long as it stays with
//! Taylor's method. Other methods run one variant after another. Threads share the variants. None
//! of this changes a result: to the last bit, every variant equals a run of its own, for any number
//! of threads.

use machinist_contract::{F64x2, SideBySide, Simulator};

use crate::error::{SimulateError, StopCause};
use crate::lanes::{F64x8, Lanes};
use crate::method::Method;
#[cfg(feature = "implicit")]
use crate::method::auto::in_lanes::goes_in_lanes;
use crate::method::taylor::LEAST_RTOL;
use crate::method::taylor::variants::{self, Ended, Outcome};
use crate::simulate::{Simulation, parameter_defaults};
use crate::threads;
use crate::trajectory::ColumnKind;

/// Number of variants that a thread takes at a time.
const CHUNK: usize = 64;

/// A machine that threads can share.
pub trait Sweepable: Sync {
    /// Returns the simulator for single runs.
    fn single(&self) -> &dyn Simulator<f64>;
    /// Returns the simulator for runs in lanes, if there is one.
    fn in_lanes(&self) -> Option<InLanes<'_>>;
}

/// A simulator that runs several variants at a time.
#[derive(Clone, Copy)]
pub enum InLanes<'a> {
    /// Two lanes.
    Two(&'a dyn SideBySide<F64x2>),
    /// Eight lanes.
    Eight(&'a dyn SideBySide<F64x8>),
}

/// Implements the trait for every emitted machine.
impl<S: Simulator<f64> + Simulator<F64x8> + Sync> Sweepable for S {
    fn single(&self) -> &dyn Simulator<f64> {
        self
    }
    fn in_lanes(&self) -> Option<InLanes<'_>> {
        Some(InLanes::Eight(self))
    }
}

/// Runs of one machine with different parameters.
///
/// ```
/// use machinist::{Method, Sweep};
/// use machinist_scenes::scenes::saw_gin::SawGin;
///
/// let stiffnesses: Vec<f64> = (1..=20).map(|k| 2e3 * f64::from(k)).collect();
/// let runs = Sweep::new(&SawGin)
///     .each(|run| run.until(0.1).points(2).rtol(1e-8).method(Method::Taylor))
///     .vary("coupling.stiffness", &stiffnesses)?
///     .run();
/// assert_eq!(runs.len(), 20);
/// for run in runs {
///     let run = run?;
///     println!("{:?}", run.states.last());
/// }
/// # Ok::<(), machinist::SimulateError>(())
/// ```
///
/// [`Sweep::run_each`] keeps a number of each variant instead of its whole run. Two parameters make
/// a grid, in which the last one varies fastest:
///
/// ```
/// use machinist::sweep::Wanted;
/// use machinist::{SimulateError, Sweep};
/// use machinist_scenes::scenes::two_mass::TwoMass;
///
/// // Least and greatest value of the first output, the twist of the coupling.
/// let extremes = Wanted { places: vec![0], extremes: true };
/// let twists = Sweep::new(&TwoMass)
///     .each(|run| run.until(0.2))
///     .vary("coupling.stiffness", &[1e4, 4e4])?
///     .vary("load_torque", &[500.0, 1000.0])?
///     .run_each(|_, run| run.map(|run| extremes.values(&run)));
/// let greatest = twists.into_iter().map(|twists| Ok(twists?[1]));
/// let greatest: Vec<f64> = greatest.collect::<Result<_, SimulateError>>()?;
/// assert_eq!(greatest.len(), 4);
/// assert!(greatest[0] < greatest[1] && greatest[2] < greatest[0]);
/// # Ok::<(), SimulateError>(())
/// ```
#[must_use = "a sweep does nothing until it is `run`"]
pub struct Sweep<'a> {
    machine: &'a dyn Sweepable,
    each: Box<dyn Fn(Simulation<'a>) -> Simulation<'a> + Sync + 'a>,
    of_variant: Box<dyn Fn(Simulation<'a>) -> Simulation<'a> + Sync + 'a>,
    variants: Vec<Vec<f64>>,
    threads: usize,
}

/// Results of one variant.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct VariantRun {
    /// Output times \[s\].
    pub times: Vec<f64>,
    /// Times of events \[s\].
    pub events: Vec<f64>,
    /// State at every output time.
    pub states: Vec<Vec<f64>>,
    /// Outputs at every output time.
    pub outputs: Vec<Vec<f64>>,
    /// Number of accepted steps.
    pub steps: u64,
}

impl VariantRun {
    /// Returns the values of a place over the output times: of an output, or of a state, whose
    /// indices are beyond those of the outputs.
    pub fn values_of(&self, place: usize) -> impl DoubleEndedIterator<Item = f64> + '_ {
        let outputs = self.outputs.first().map_or(0, Vec::len);
        let (rows, column) =
            if place < outputs { (&self.outputs, place) } else { (&self.states, place - outputs) };
        rows.iter().map(move |row| row[column])
    }

    /// Returns the last values of places, place after place.
    #[must_use]
    pub fn last(&self, places: &[usize], count: usize) -> Vec<Vec<f64>> {
        let skipped = self.times.len().saturating_sub(count);
        places.iter().map(|place| self.values_of(*place).skip(skipped).collect()).collect()
    }
}

/// Selection of results that are kept for each variant.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wanted {
    /// Indices of outputs; indices beyond the outputs stand for states.
    pub places: Vec<usize>,
    /// True to keep the least and the greatest value over the output times instead of the last
    /// value.
    pub extremes: bool,
}

impl Wanted {
    /// Returns the selected values, one for each place, or two with `extremes`.
    #[must_use]
    pub fn values(&self, run: &VariantRun) -> Vec<f64> {
        let values = self.places.iter().flat_map(|place| {
            if self.extremes {
                let least = run.values_of(*place).fold(f64::INFINITY, f64::min);
                let greatest = run.values_of(*place).fold(f64::NEG_INFINITY, f64::max);
                vec![least, greatest]
            } else {
                run.values_of(*place).next_back().into_iter().collect()
            }
        });
        values.collect()
    }
}

impl<'a> Sweep<'a> {
    /// Creates a sweep with one variant, which has the settings of the spec.
    pub fn new(machine: &'a dyn Sweepable) -> Self {
        let single = machine.single();
        Self {
            machine,
            each: Box::new(|simulation| simulation),
            of_variant: Box::new(|simulation| simulation),
            variants: vec![parameter_defaults(single)],
            threads: 0,
        }
    }

    /// Adjusts the settings of every run: end, tolerance, method, output times.
    pub fn each(mut self, adjust: impl Fn(Simulation<'a>) -> Simulation<'a> + Sync + 'a) -> Self {
        self.each = Box::new(adjust);
        self
    }

    /// Combines every present variant with each of these values of a parameter, in its SI unit. Two
    /// calls make a grid in which the last parameter varies fastest.
    ///
    /// # Errors
    /// [`SimulateError::UnknownParameter`], with the nearest known name.
    pub fn vary(mut self, name: &str, values: &[f64]) -> Result<Self, SimulateError> {
        let index = Simulation::new(self.machine.single()).parameter_index(name)?;
        let varied = self.variants.iter().flat_map(|variant| {
            values.iter().map(move |value| {
                let mut variant = variant.clone();
                variant[index] = *value;
                variant
            })
        });
        self.variants = varied.collect();
        Ok(self)
    }

    /// Sets the variants, each a full list of parameters.
    pub fn variants(mut self, variants: Vec<Vec<f64>>) -> Self {
        self.variants = variants;
        self
    }

    /// Sets what depends on the parameters of a variant, such as the end of its run; the number of
    /// output times must be that of all.
    pub fn of_variant(
        mut self,
        adjust: impl Fn(Simulation<'a>) -> Simulation<'a> + Sync + 'a,
    ) -> Self {
        self.of_variant = Box::new(adjust);
        self
    }

    /// Sets the number of threads; 0, the default, stands for the number of processors.
    pub fn threads(mut self, threads: usize) -> Self {
        self.threads = threads;
        self
    }

    /// Runs all variants and returns results in their order.
    #[must_use]
    pub fn run(&self) -> Vec<Result<VariantRun, SimulateError>> {
        self.run_each(|_, run| run)
    }

    /// Runs all variants and returns what `take` makes of the simulation and the results of each, in
    /// their order. Only the results of a few variants are in memory at a time.
    #[must_use]
    pub fn run_each<T: Send>(
        &self,
        take: impl Fn(&Simulation<'a>, Result<VariantRun, SimulateError>) -> T + Sync,
    ) -> Vec<T> {
        let chunks: Vec<_> = self.variants.chunks(CHUNK).collect();
        // A sweep runs even if threads cannot be created.
        let pool = threads::pool(self.threads);
        let runs = threads::each(pool.as_ref(), chunks.len(), |at| {
            let runs = self.run_chunk(chunks[at]).into_iter().zip(chunks[at]);
            let taken = runs.map(|(run, variant)| take(&self.simulation(variant), run));
            taken.collect::<Vec<T>>()
        });
        runs.into_iter().flatten().collect()
    }

    fn run_chunk(&self, chunk: &[Vec<f64>]) -> Vec<Result<VariantRun, SimulateError>> {
        let simulation = (self.each)(Simulation::new(self.machine.single()));
        let Some(method) = self.of_lanes(&simulation) else {
            return chunk.iter().map(|parameters| one(&self.simulation(parameters))).collect();
        };
        let in_lanes = match self.machine.in_lanes() {
            None => None,
            Some(InLanes::Two(machine)) => self.run_in_lanes(chunk, method, machine),
            Some(InLanes::Eight(machine)) => self.run_in_lanes(chunk, method, machine),
        };
        in_lanes.unwrap_or_else(|| {
            chunk.iter().map(|parameters| one(&self.simulation(parameters))).collect()
        })
    }

    /// Returns the method if variants can run in lanes.
    fn of_lanes(&self, simulation: &Simulation<'a>) -> Option<Method> {
        let single = self.machine.single();
        match simulation.method_and_step_rtol().ok()? {
            // Lanes do not monitor events or switching surfaces.
            (Method::Taylor, rtol) => {
                let is_smooth =
                    single.events() + single.kinks() == 0 && !single.taylor()?.has_corners();
                (rtol >= LEAST_RTOL && is_smooth).then_some(Method::Taylor)
            }
            #[cfg(feature = "implicit")]
            (Method::Auto, rtol) if rtol >= LEAST_RTOL && simulation.may_go_in_lanes() => {
                goes_in_lanes(single, rtol).then_some(Method::Auto)
            }
            _ => None,
        }
    }

    fn simulation(&self, parameters: &[f64]) -> Simulation<'a> {
        let run = Simulation::new(self.machine.single()).with_small_states_held(false);
        (self.of_variant)((self.each)(run).parameters(parameters))
    }

    /// Runs a chunk in lanes; returns `None` if the machine has no Taylor series.
    fn run_in_lanes<R: Lanes>(
        &self,
        chunk: &[Vec<f64>],
        method: Method,
        machine: &dyn SideBySide<R>,
    ) -> Option<Vec<Result<VariantRun, SimulateError>>> {
        let series = machine.taylor()?;
        let mut results: Vec<Option<Result<VariantRun, SimulateError>>> = vec![None; chunk.len()];
        let patience = (self.each)(Simulation::new(self.machine.single())).patience();
        let mut ready = Vec::with_capacity(chunk.len());
        let mut variants: Vec<usize> = (0..chunk.len()).collect();
        let mut of_all = None;
        variants.retain(|index| {
            let simulation = self.simulation(&chunk[*index]);
            results[*index] = Some(match simulation.variant_for(method) {
                Ok(variant) => {
                    let rtol = variant.tolerance.rtol;
                    // All lanes take steps of one order.
                    if of_all.get_or_insert(rtol).to_bits() == rtol.to_bits() {
                        ready.push(variant);
                        return true;
                    }
                    one(&simulation)
                }
                Err(error) => Err(error),
            });
            false
        });
        let Some(rtol) = of_all else { return Some(results.into_iter().flatten().collect()) };
        let mut overseer = method.overseer(machine, rtol);
        if let Some(overseer) = &mut overseer {
            let leaving = overseer.leaving(&ready);
            for (index, _) in variants.iter().zip(&leaving).filter(|(_, leaves)| **leaves) {
                results[*index] = Some(one(&self.simulation(&chunk[*index])));
            }
            let mut stays = leaving.iter().map(|leaves| !leaves);
            variants.retain(|_| stays.next() == Some(true));
            let mut stays = leaving.iter().map(|leaves| !leaves);
            ready.retain(|_| stays.next() == Some(true));
        }
        let times: Vec<Vec<f64>> = ready.iter().map(|variant| variant.times.clone()).collect();
        let mut ended = |number: usize, ended| {
            let parameters = &chunk[variants[number]];
            let result = match ended {
                Ended::Through(outcome) => Ok(self.finished(parameters, &times[number], &outcome)),
                // Here `auto` would change the method, and its message says more on the cause.
                Ended::Stopped(stopped)
                    if method == Method::Auto
                        && !matches!(stopped.cause, StopCause::TooSlow { .. }) =>
                {
                    one(&self.simulation(parameters))
                }
                Ended::Stopped(stopped) => Err(SimulateError::Stopped {
                    scene: self.machine.single().name().to_owned(),
                    method: method.name(),
                    time: stopped.time,
                    cause: stopped.cause,
                    kept: None,
                }),
            };
            results[variants[number]] = Some(result);
        };
        let ready = &mut ready.into_iter();
        variants::integrate((machine, series), rtol, patience, overseer, ready, &mut ended);
        Some(results.into_iter().flatten().collect())
    }

    fn finished(&self, parameters: &[f64], times: &[f64], outcome: &Outcome) -> VariantRun {
        let machine = self.machine.single();
        let shape = machine.shape();
        let states: Vec<Vec<f64>> =
            outcome.rows.chunks_exact(shape.states().max(1)).map(<[f64]>::to_vec).collect();
        let outputs = times.iter().zip(&states).map(|(time, state)| {
            let mut outputs = vec![0.0; shape.outputs];
            machine.outputs(*time, state, parameters, &mut outputs);
            outputs
        });
        VariantRun {
            outputs: outputs.collect(),
            states,
            steps: outcome.work.steps,
            times: times.to_vec(),
            // Machines with events do not run in lanes.
            events: Vec::new(),
        }
    }
}

/// Runs one simulation and returns its results as those of a variant.
///
/// # Errors
/// As for [`Simulation::run`].
pub fn one(simulation: &Simulation<'_>) -> Result<VariantRun, SimulateError> {
    let run = simulation.run()?;
    let rows = |kind: ColumnKind| {
        let columns: Vec<_> = run.of_kind(kind).collect();
        let row = |index: usize| columns.iter().map(|column| column.values[index]).collect();
        (0..run.times.len()).map(row).collect()
    };
    Ok(VariantRun {
        states: rows(ColumnKind::State),
        outputs: rows(ColumnKind::Output),
        steps: run.work.steps,
        events: run.switches.iter().map(|switch| switch.time).collect(),
        times: run.times,
    })
}

/// Runs all variants of a machine that threads cannot share, as with fields: each chunk makes its
/// own machine.
///
/// # Errors
/// The first error of `make`.
pub fn each_on_its_own<S, E: Send>(
    variants: &[Vec<f64>],
    threads: usize,
    make: impl Fn() -> Result<S, E> + Sync,
    run: impl Fn(&S, &[f64]) -> Result<VariantRun, SimulateError> + Sync,
) -> Result<Vec<Result<VariantRun, SimulateError>>, E> {
    /// Small chunks, because making a machine takes part of the time of a run.
    const CHUNK: usize = 16;
    let of_chunk = |chunk: &[Vec<f64>]| {
        let machine = make()?;
        Ok(chunk.iter().map(|variant| run(&machine, variant)).collect::<Vec<_>>())
    };
    let chunks: Vec<_> = variants.chunks(CHUNK).collect();
    let pool = threads::pool(threads);
    let runs = threads::each(pool.as_ref(), chunks.len(), |at| of_chunk(chunks[at]));
    let runs: Result<Vec<_>, E> = runs.into_iter().collect();
    Ok(runs?.into_iter().flatten().collect())
}
