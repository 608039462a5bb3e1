//! Start, end and output times of a run, at the values of the spec.

use crate::scene::assemble::Assembler;
use crate::scene::evaluate::evaluate;
use crate::scene::layout::Scope;
use crate::scene::resolve::Wanted;
use crate::scene::typed::Uses;
use crate::spec::code::Code;
use crate::spec::diagnostic::Mistake;
use crate::spec::dimension::Dimension;
use crate::spec::{Formula, SamplingSpec};
use machinist_algebra::expr::ParameterId;

impl Assembler<'_> {
    pub(super) fn span_of_run(&mut self) {
        let run = &self.spec.run;
        self.run.from =
            run.from.as_ref().map_or(0.0, |from| self.time(from, "the start of the run"));
        if let SamplingSpec::Listed(times) = &run.sampling {
            self.listed(times);
            return;
        }
        let Some(end) = &run.until else { return };
        let (from, until) = (self.run.from, self.time(end, "the end of the run"));
        // Written so that NaN is rejected.
        if !(from.is_finite() && until.is_finite() && until > from) {
            let label = if until <= from { "too early" } else { "not a time" };
            let mistake =
                Mistake::new(Code::InvalidRun, end.span(), "a run must end after its start", label);
            self.mistakes.push(mistake.help(format!("it goes from {from} s to {until} s")));
        }
        self.run.until = until;
        match &run.sampling {
            SamplingSpec::Ratios(points, first) => self.at_ratios(*points, first),
            SamplingSpec::Even(points) => self.run.points = *points,
            SamplingSpec::Listed(_) => {}
        }
    }

    fn time(&mut self, formula: &Formula, what: &str) -> f64 {
        let wanted = Wanted::new(Dimension::TIME, what).of(Uses::PARAMETERS);
        let resolved = self.resolver.formula(formula, Scope::Scene, &wanted);
        let expr = self.note(resolved);
        evaluate(&expr, &|id: ParameterId| self.values[id.0 as usize])
    }

    fn listed(&mut self, formulas: &[Formula]) {
        let mut times = Vec::with_capacity(formulas.len());
        let mut before = f64::NEG_INFINITY;
        for formula in formulas {
            let time = self.time(formula, "a time of the run");
            if !(time.is_finite() && time >= self.run.from && time > before) {
                let message = "the times of a run must increase from its start";
                let mistake = Mistake::new(Code::InvalidRun, formula.span(), message, "too early");
                let help = format!("this is at {time} s, the start at {} s", self.run.from);
                self.mistakes.push(mistake.help(help));
                return;
            }
            times.push(time);
            before = time;
        }
        (self.run.until, self.run.points, self.run.times) = (before, times.len(), times);
    }

    /// Adds the start, and times since then that grow by a constant ratio up to the end.
    fn at_ratios(&mut self, points: usize, formula: &Formula) {
        let first = self.time(formula, "the first time after the start");
        let (from, until) = (self.run.from, self.run.until);
        if !(first > 0.0 && first < until - from) {
            let message = "`first` must be after the start and before the end";
            let mistake =
                Mistake::new(Code::InvalidRun, formula.span(), message, "not within the run");
            self.mistakes.push(mistake.help(format!("it is {first} s of {} s", until - from)));
            return;
        }
        let ratios = (points - 2) as f64;
        let time = |index: usize| {
            let share = index as f64 / ratios;
            from + first * ((until - from) / first).powf(share)
        };
        let between = (0..points - 2).map(time).map(|time| time.min(until));
        let mut times: Vec<f64> = std::iter::once(from).chain(between).chain([until]).collect();
        // Ratios may be closer to one than doubles resolve.
        times.dedup();
        (self.run.points, self.run.times) = (times.len(), times);
    }
}
