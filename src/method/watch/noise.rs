//! Rounding errors of guards, due to rounding of the states that they compare, which may be far
//! larger than the guards.

/// Number of steps for which the estimates of a guard stay valid.
const FRESH: usize = 32;

/// Changes of guards by rounding of states.
pub(super) struct Noise {
    /// Scale of each state that is no mode; zero for the others, and for time.
    scales: Vec<f64>,
    /// Change of each guard if all states change by their sizes.
    slopes: Vec<f64>,
    /// Number of guards of events, which come first.
    events: usize,
    /// Steps since guards were evaluated.
    age: Option<usize>,
    /// Time at which they were \[s\].
    time: f64,
}

impl Noise {
    /// Returns estimates for guards of `events` and `kinks` and states of typical sizes `scales`.
    pub(super) fn new(events: usize, kinks: usize, mut scales: Vec<f64>) -> Self {
        scales.push(0.0);
        Self { scales, slopes: vec![0.0; events + kinks], events, age: None, time: 0.0 }
    }

    /// Returns the change of a guard if all states change by their sizes.
    pub(super) fn slope(&self, index: usize) -> f64 {
        self.slopes[index]
    }

    /// Starts another segment, where states may have other sizes.
    pub(super) fn restart(&mut self) {
        self.age = None;
    }

    /// Counts a step from a time. Returns whether guards should be evaluated: initially if there are
    /// events, where the rounding of time has doubled since, and occasionally while a guard is so
    /// small that it may be only rounding.
    pub(super) fn is_due(&mut self, time: f64, is_any_small: bool) -> bool {
        self.age = self.age.map(|age| age.saturating_add(1));
        let is_late = self.events > 0 && time.abs() > 2.0 * self.time.abs();
        let is_old = |age| is_late || age >= FRESH && is_any_small;
        self.age.map_or(self.events > 0 || is_any_small, is_old)
    }

    /// Evaluates `guards` around a state.
    pub(super) fn look(
        &mut self,
        (time, state): (f64, &[f64]),
        mut guards: impl FnMut(f64, &[f64], &mut [f64]),
    ) {
        const CHANGE: f64 = 1e-7;
        (self.age, self.time) = (Some(0), time);
        self.slopes.fill(0.0);
        let states = state.len();
        let [mut here, mut beside, mut change] = [(); 3].map(|()| vec![0.0; self.slopes.len()]);
        guards(time, state, &mut here);
        let mut point = [state, &[time]].concat();
        for (entry, scale) in self.scales.iter().enumerate() {
            let (at, own) = (point[entry], point[entry].abs());
            let size = own.max(*scale);
            if size == 0.0 {
                continue;
            }
            change.fill(f64::INFINITY);
            // A guard that jumps here is continuous on one side.
            for by in [CHANGE, -CHANGE] {
                point[entry] = at + by * size;
                guards(point[states], &point[..states], &mut beside);
                for ((change, here), beside) in change.iter_mut().zip(&here).zip(&beside) {
                    *change = change.min((beside - here).abs() / CHANGE);
                }
            }
            point[entry] = at;
            for (index, (slope, change)) in self.slopes.iter_mut().zip(&change).enumerate() {
                // What constraints hold at zero is rounded like states of typical size. Kinks count
                // only a state's own rounding, so that steps end close to them.
                let change = if index < self.events { *change } else { change * (own / size) };
                *slope += if change.is_finite() { change } else { 0.0 };
            }
        }
    }
}
