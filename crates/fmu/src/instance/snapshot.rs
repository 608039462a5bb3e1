//! Kept states of an instance and their serialization.

use serde::{Deserialize, Serialize};

use super::{Instance, Now, Phase, Refusal};

/// Copy of an instance's mutable data.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Snapshot {
    /// Token of the machine, and whether the interface is Model Exchange.
    of: (String, bool),
    now: Now,
}

impl Instance {
    /// Keeps the present state and returns its handle, which is never 0. A given handle is reused:
    /// its state is replaced.
    ///
    /// # Errors
    /// [`Refusal`] within a step, and for an unknown handle.
    pub fn keep(&mut self, handle: Option<usize>) -> Result<usize, Refusal> {
        if self.now.phase == Phase::Intermediate {
            let call = "fmi3GetFMUState";
            return Err(Refusal::OutOfOrder { call, phase: self.now.phase });
        }
        let handle = match handle {
            Some(handle) => {
                self.kept(handle)?;
                handle
            }
            None => self.new_handle(),
        };
        let of = (self.machine.token.clone(), self.is_exchange());
        self.kept.insert(handle, Snapshot { of, now: self.now.clone() });
        Ok(handle)
    }

    /// Restores a kept state.
    ///
    /// # Errors
    /// [`Refusal`] within a step, and for an unknown handle.
    pub fn return_to(&mut self, handle: usize) -> Result<(), Refusal> {
        if self.now.phase == Phase::Intermediate {
            let call = "fmi3SetFMUState";
            return Err(Refusal::OutOfOrder { call, phase: self.now.phase });
        }
        self.now = self.kept(handle)?.now.clone();
        Ok(())
    }

    /// Forgets a kept state.
    ///
    /// # Errors
    /// [`Refusal`] for an unknown handle.
    pub fn forget(&mut self, handle: usize) -> Result<(), Refusal> {
        self.kept(handle)?;
        self.kept.remove(&handle);
        Ok(())
    }

    /// Serializes a kept state to bytes that another instance of the same archive can read.
    ///
    /// # Errors
    /// [`Refusal`] for an unknown handle.
    pub fn write(&self, handle: usize) -> Result<Vec<u8>, Refusal> {
        let unwritable = |error| Refusal::Argument(format!("the state cannot be written: {error}"));
        postcard::to_stdvec(self.kept(handle)?).map_err(unwritable)
    }

    /// Deserializes a state, keeps it and returns its handle.
    ///
    /// # Errors
    /// [`Refusal`] for bytes that are not a state of an instance of this archive and interface.
    pub fn read(&mut self, bytes: &[u8]) -> Result<usize, Refusal> {
        let unreadable = |why: String| Refusal::Argument(format!("not an FMU state: {why}"));
        let (snapshot, rest): (Snapshot, _) =
            postcard::take_from_bytes(bytes).map_err(|error| unreadable(error.to_string()))?;
        if !rest.is_empty() {
            return Err(unreadable(format!("{} bytes are left over", rest.len())));
        }
        if snapshot.of != (self.machine.token.clone(), self.is_exchange()) {
            return Err(unreadable("it belongs to another archive or interface".to_owned()));
        }
        if !self.fits(&snapshot.now) {
            return Err(unreadable("its values do not fit the machine".to_owned()));
        }
        let handle = self.new_handle();
        self.kept.insert(handle, snapshot);
        Ok(handle)
    }

    fn new_handle(&mut self) -> usize {
        self.handles += 1;
        self.handles
    }

    fn kept(&self, handle: usize) -> Result<&Snapshot, Refusal> {
        let unknown = || Refusal::argument("this FMU state does not belong to this instance");
        self.kept.get(&handle).ok_or_else(unknown)
    }

    /// Returns whether the data are valid for this machine and interface.
    fn fits(&self, now: &Now) -> bool {
        let Now { phase, parameters, chosen, experiment, standing } = now;
        let is_finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
        let is_before = matches!(phase, Phase::Instantiated | Phase::Initialization);
        let is_of = match phase {
            Phase::Intermediate => false,
            Phase::ContinuousTime => self.is_exchange(),
            Phase::Step => !self.is_exchange(),
            _ => true,
        };
        parameters.len() == self.now.parameters.len()
            && is_finite(parameters)
            && chosen.len() == self.now.chosen.len()
            && chosen.iter().flatten().all(|value| value.is_finite())
            && experiment.from < experiment.until
            && is_finite(&[experiment.from, experiment.until])
            && experiment.rtol > 0.0
            && experiment.rtol <= 1.0
            && is_of
            && standing
                .as_ref()
                .map_or(is_before, |standing| standing.fits(self.machine.simulator()))
    }
}
