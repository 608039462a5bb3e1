//! Poincare sections: states once in a period of the excitation.

use super::{CycleError, CycleSettings};
use crate::simulate::Simulation;

/// Values of columns at the returns of one run, column after column.
pub type Section = Vec<Vec<f64>>;

impl CycleSettings {
    /// Sets a run to its time to settle and `returns` periods, with an output time in each period.
    /// The last `returns` of them are those of the section.
    ///
    /// # Errors
    /// As for [`CycleSettings::period_of`]; [`CycleError::BadSetting`] for an unknown period or fewer
    /// than 2 returns.
    pub fn sectioned<'s>(
        &self,
        run: Simulation<'s>,
        returns: usize,
    ) -> Result<Simulation<'s>, CycleError> {
        if returns < 2 {
            return Err(CycleError::BadSetting(format!(
                "{returns} returns: at least 2 are needed"
            )));
        }
        let Some(period) = self.period_of(&run)? else {
            let what = "sections need the period of an excitation".to_owned();
            return Err(CycleError::BadSetting(what));
        };
        let periods = (self.settle / period).ceil() + (returns - 1) as f64;
        let from = run.start_time();
        Ok(run.until(from + periods * period).points(periods as usize + 1))
    }
}

/// Returns the number of periods after which each section repeats, up to half of its returns.
///
/// `same` is the difference that counts as a return, over the range of a column in all sections.
#[must_use]
pub fn repeats(sections: &[Option<&Section>], same: f64) -> Vec<Option<usize>> {
    let found = || sections.iter().flatten();
    let range = |column: usize| {
        let values = found().flat_map(|section| section[column].iter().copied());
        let (least, greatest) = values
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), value| (a.min(value), b.max(value)));
        greatest - least
    };
    let ranges: Vec<f64> = (0..found().next().map_or(0, |one| one.len())).map(range).collect();
    let repeat = |section: &Section| {
        let returns = section.first().map_or(0, Vec::len);
        (1..=returns / 2).find(|period| {
            section.iter().zip(&ranges).all(|(values, range)| {
                let pairs = values.iter().zip(&values[*period..]);
                pairs.into_iter().all(|(a, b)| (a - b).abs() <= same * range)
            })
        })
    };
    sections.iter().map(|section| section.and_then(repeat)).collect()
}
