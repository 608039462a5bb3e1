//! What of guards is rounding of the states that they compare, which may be far larger.

/// How far rounding of states moves guards.
pub(super) struct Noise {
    /// The typical size of each state that is no mode; zero for others, and for time.
    scales: Vec<f64>,
    /// Of each guard, by how much it changes where all states change by their sizes.
    slopes: Vec<f64>,
    /// Guards of events, which come first.
    events: usize,
    /// Steps since guards were looked at.
    age: Option<usize>,
}

impl Noise {
    /// Of guards of `events` and of `kinks`, of states of typical sizes `scales`.
    pub(super) fn new(events: usize, kinks: usize, mut scales: Vec<f64>) -> Self {
        scales.push(0.0);
        Self { scales, slopes: vec![0.0; events + kinks], events, age: None }
    }

    /// By how much a guard changes where all states change by their sizes.
    pub(super) fn slope(&self, index: usize) -> f64 {
        self.slopes[index]
    }

    /// Counts a step; whether guards should be looked at: at first if there are events, and now
    /// and then while some guard is so small that it may be nothing but rounding.
    pub(super) fn is_due(&mut self, is_any_small: bool) -> bool {
        const FRESH: usize = 32;
        self.age = self.age.map(|age| age.saturating_add(1));
        self.age.map_or(self.events > 0 || is_any_small, |age| age >= FRESH && is_any_small)
    }

    /// Looks at `guards` about a state.
    pub(super) fn look(
        &mut self,
        (time, state): (f64, &[f64]),
        guards: impl Fn(f64, &[f64], &mut [f64]),
    ) {
        const CHANGE: f64 = 1e-7;
        self.age = Some(0);
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
            // A guard that jumps here goes on without a jump on one side.
            for by in [CHANGE, -CHANGE] {
                point[entry] = at + by * size;
                guards(point[states], &point[..states], &mut beside);
                for ((change, here), beside) in change.iter_mut().zip(&here).zip(&beside) {
                    *change = change.min((beside - here).abs() / CHANGE);
                }
            }
            point[entry] = at;
            for (index, (slope, change)) in self.slopes.iter_mut().zip(&change).enumerate() {
                // What constraints hold at zero is rounded as states of their typical sizes are;
                // of kinks only what a state has by itself is, so that steps end close to them.
                let change = if index < self.events { *change } else { change * (own / size) };
                *slope += if change.is_finite() { change } else { 0.0 };
            }
        }
    }
}
