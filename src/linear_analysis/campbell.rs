//! Campbell diagram: natural frequencies over a parameter.

use machinist_contract::Simulator;
use num_complex::Complex64;
use serde::Serialize;

use super::operating_point::{Place, operating_point};
use super::{LinearError, Linearization, Mode, ModeKind, Point, position};
use crate::error::did_you_mean;
use crate::simulate::Simulation;
use crate::sorting::sort_ascending;

/// Natural frequencies of a machine over a parameter, each followed from value to value, and their
/// intersections with orders of a speed.
///
/// W. Campbell, The protection of steam-turbine disk wheels from axial vibration, Trans. ASME 46,
/// 1924.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Campbell {
    /// Name of the parameter, or `speed`.
    pub parameter: String,
    /// True if the diagram is over a speed on which the machine does not depend, instead of a
    /// parameter.
    pub is_over_speed: bool,
    /// Unit of the parameter.
    pub unit: String,
    /// Values of the parameter.
    pub values: Vec<f64>,
    /// Speed to which orders refer \[rad/s\], at each value, if there is one.
    pub speeds: Option<Vec<f64>>,
    /// Oscillations, in ascending order of frequency.
    pub branches: Vec<Branch>,
    /// Intersections with orders, in ascending order of the parameter.
    pub critical: Vec<Critical>,
    /// Intervals in which motions grow, oscillations or not, in ascending order of the parameter.
    pub growing: Vec<Growing>,
}

/// An oscillation, followed over the parameter by its shape and its frequency.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Branch {
    /// Name of the coordinate or first-order state that moves most at the first value.
    pub moves: String,
    /// Frequencies of the damped motion \[rad/s\]; NaN where there is no oscillation.
    pub frequencies: Vec<f64>,
    /// Damping ratios; NaN where there is no oscillation.
    pub damping_ratios: Vec<f64>,
}

/// An intersection of an order of the speed with a natural frequency.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Critical {
    /// Ratio of frequency to speed.
    pub order: f64,
    /// Index of the branch.
    pub branch: usize,
    /// Value of the parameter.
    pub value: f64,
    /// Frequency \[rad/s\].
    pub frequency: f64,
    /// Damping ratio.
    pub damping_ratio: f64,
}

/// An interval of the parameter in which undisturbed motions grow.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Growing {
    /// Start of the interval: the first value, or found between two values.
    pub from: f64,
    /// End of the interval, likewise.
    pub to: f64,
    /// Names of the coordinates or first-order states that move most in these motions.
    pub moves: Vec<String>,
    /// Largest growth rate at any of the values, the real part of the eigenvalue \[1/s\].
    pub fastest: f64,
    /// Value of the parameter with the largest growth rate.
    pub at: f64,
}

impl Growing {
    /// Creates an interval that begins at or before a value, without motions yet.
    fn new(from: f64, value: f64) -> Self {
        Self { from, to: value, moves: Vec::new(), fastest: 0.0, at: value }
    }

    /// Adds the growing motions at a value: growth rates, and the coordinates that move most.
    fn include(&mut self, value: f64, growing: &[(f64, String)]) {
        for (growth, moves) in growing {
            if *growth > self.fastest {
                (self.fastest, self.at) = (*growth, value);
            }
            if !self.moves.contains(moves) {
                self.moves.push(moves.clone());
            }
        }
    }
}

/// Settings of a Campbell diagram.
#[derive(Debug, Clone, PartialEq)]
pub struct Variation<'a> {
    /// Name of the parameter.
    pub parameter: &'a str,
    /// Values of the parameter, increasing.
    pub values: &'a [f64],
    /// Operating point at each value.
    pub place: Place,
    /// Name of a parameter or state in rad/s; `None` stands for the parameter itself if it is in
    /// rad/s.
    pub speed: Option<&'a str>,
    /// Orders of the speed.
    pub orders: &'a [f64],
}

/// Computes natural frequencies over a parameter.
///
/// # Errors
/// [`LinearError`] if a name is unknown, or if the operating point or the eigenmodes at a value are
/// not found.
pub fn campbell(run: &Simulation<'_>, variation: &Variation<'_>) -> Result<Campbell, LinearError> {
    let simulator = run.simulator();
    let varied = run.parameter_index(variation.parameter)?;
    let speed = speed(simulator, variation)?;
    let machine = Machine { run, variation, speed };
    let mut branches: Vec<Followed> = Vec::new();
    let (mut speeds, mut growths) = (Vec::new(), Vec::new());
    for (index, value) in variation.values.iter().enumerate() {
        let mut found = machine.at(*value)?;
        speeds.extend(found.speed);
        growths.push(std::mem::take(&mut found.growing));
        follow(&mut branches, index, found);
    }
    sort_ascending(&mut branches, Followed::first);
    let critical = machine.critical(&branches, &speeds)?;
    let count = variation.values.len();
    Ok(Campbell {
        parameter: variation.parameter.to_owned(),
        is_over_speed: false,
        unit: simulator.parameter(varied).unit.to_owned(),
        values: variation.values.to_vec(),
        speeds: speed.is_some().then_some(speeds),
        branches: branches.iter().map(|branch| branch.whole(count)).collect(),
        critical,
        growing: machine.growing(&growths),
    })
}

/// Computes natural frequencies over a speed on which the machine does not depend. It is linearized
/// once: each frequency is the same at all speeds and intersects an order at the speed of frequency
/// over order.
///
/// # Errors
/// As for [`campbell`].
pub fn campbell_over_speeds(
    run: &Simulation<'_>,
    place: Place,
    speeds: &[f64],
    orders: &[f64],
) -> Result<Campbell, LinearError> {
    let simulator = run.simulator();
    let Found { oscillations: mut found, growing: growths, .. } =
        Found::at(simulator, operating_point(run, place)?, None)?;
    sort_ascending(&mut found, |one| one.frequency);
    let mut critical = Vec::new();
    let ends = [speeds.first(), speeds.last()].map(|end| end.copied().unwrap_or(f64::NAN));
    for order in orders {
        for (branch, Oscillation { frequency, damping_ratio, .. }) in found.iter().enumerate() {
            let (frequency, damping_ratio) = (*frequency, *damping_ratio);
            let value = frequency / order;
            if ends[0] <= value && value <= ends[1] {
                critical.push(Critical { order: *order, branch, value, frequency, damping_ratio });
            }
        }
    }
    sort_ascending(&mut critical, |meeting| meeting.value);
    let growing = (!growths.is_empty()).then(|| {
        let mut stretch = Growing { to: ends[1], ..Growing::new(ends[0], ends[0]) };
        stretch.include(ends[0], &growths);
        stretch
    });
    let branch = |one: &Oscillation| Branch {
        moves: one.moves.clone(),
        frequencies: vec![one.frequency; speeds.len()],
        damping_ratios: vec![one.damping_ratio; speeds.len()],
    };
    Ok(Campbell {
        parameter: "speed".to_owned(),
        is_over_speed: true,
        unit: "rad/s".to_owned(),
        values: speeds.to_vec(),
        speeds: Some(speeds.to_vec()),
        branches: found.iter().map(branch).collect(),
        critical,
        growing: growing.into_iter().collect(),
    })
}

/// Source of a speed.
#[derive(Debug, Clone, Copy)]
enum Speed {
    Parameter(usize),
    State(usize),
    Output(usize),
}

fn speed(
    simulator: &dyn Simulator<f64>,
    variation: &Variation<'_>,
) -> Result<Option<Speed>, LinearError> {
    const UNIT: &str = "rad/s";
    let shape = simulator.shape();
    let of_parameter = |name| position(name, shape.parameters, |i| simulator.parameter(i));
    let Some(name) = variation.speed else {
        let own = of_parameter(variation.parameter);
        let own = own.filter(|index| simulator.parameter(*index).unit == UNIT);
        return Ok(own.map(Speed::Parameter));
    };
    let of_state = || {
        let index = position(name, shape.states(), |index| simulator.state(index))?;
        Some((Speed::State(index), simulator.state(index).unit))
    };
    let of_output = || {
        let index = position(name, shape.outputs, |index| simulator.output(index))?;
        Some((Speed::Output(index), simulator.output(index).unit))
    };
    let found = match of_parameter(name) {
        Some(index) => Some((Speed::Parameter(index), simulator.parameter(index).unit)),
        None => of_state().or_else(of_output),
    };
    match found {
        Some((speed, UNIT)) => Ok(Some(speed)),
        Some((_, unit)) => {
            Err(LinearError::NoSpeed { name: name.to_owned(), why: format!("is in {unit}") })
        }
        None => {
            let parameters = (0..shape.parameters).map(|i| simulator.parameter(i).name);
            let states = (0..shape.states()).map(|i| simulator.state(i).name);
            let outputs = (0..shape.outputs).map(|i| simulator.output(i).name);
            let hint = did_you_mean(name, parameters.chain(states).chain(outputs));
            let why = format!("is no parameter, state or output{hint}");
            Err(LinearError::NoSpeed { name: name.to_owned(), why })
        }
    }
}

/// Oscillations at a value, and growing motions with growth rate and the coordinate that moves
/// most.
struct Found {
    speed: Option<f64>,
    growing: Vec<(f64, String)>,
    oscillations: Vec<Oscillation>,
}

impl Found {
    fn at(
        simulator: &dyn Simulator<f64>,
        point: Point,
        speed: Option<f64>,
    ) -> Result<Self, LinearError> {
        let linearization = Linearization::at(simulator, point)?;
        let (names, coordinates) = (linearization.motion_names(), simulator.shape().coordinates);
        let modes = linearization.modes()?;
        let oscillations = modes.iter().filter(|mode| is_seen(mode));
        let oscillations = oscillations.map(|mode| oscillation(mode, coordinates, &names));
        let growing = modes.iter().filter(|mode| mode.grows());
        let growing = growing.map(|mode| (mode.real, leading(mode, coordinates, &names)));
        Ok(Self { speed, growing: growing.collect(), oscillations: oscillations.collect() })
    }
}

/// An oscillation with its shape in shares, which do not depend on units: |x_i|^2 is the share of
/// each coordinate and first-order state.
#[derive(Debug, Clone)]
struct Oscillation {
    frequency: f64,
    damping_ratio: f64,
    shape: Vec<Complex64>,
    moves: String,
}

struct Machine<'a> {
    run: &'a Simulation<'a>,
    variation: &'a Variation<'a>,
    speed: Option<Speed>,
}

impl Machine<'_> {
    fn at(&self, value: f64) -> Result<Found, LinearError> {
        let run = self.run.clone().parameter(self.variation.parameter, value)?;
        let point = operating_point(&run, self.variation.place)?;
        let speed = self.speed.map(|speed| match speed {
            Speed::Parameter(index) => point.parameters[index],
            Speed::State(index) => point.state[index],
            Speed::Output(index) => self.output(index, &point),
        });
        Found::at(self.run.simulator(), point, speed)
    }

    fn output(&self, index: usize, point: &Point) -> f64 {
        let simulator = self.run.simulator();
        let mut outputs = vec![0.0; simulator.shape().outputs];
        simulator.outputs(point.time, &point.state, &point.parameters, &mut outputs);
        outputs[index]
    }

    /// Returns the intervals of neighbouring values at each of which motions grow.
    fn growing(&self, growths: &[Vec<(f64, String)>]) -> Vec<Growing> {
        let values = self.variation.values;
        let mut stretches: Vec<Growing> = Vec::new();
        for (index, growing) in growths.iter().enumerate() {
            if growing.is_empty() {
                continue;
            }
            let value = values[index];
            let before = index.checked_sub(1);
            if before.is_none_or(|before| growths[before].is_empty()) {
                let from = before.map_or(value, |before| self.onset(values[before], value));
                stretches.push(Growing::new(from, value));
            }
            let Some(stretch) = stretches.last_mut() else { continue };
            stretch.include(value, growing);
            let next = values.get(index + 1).filter(|_| growths[index + 1].is_empty());
            stretch.to = next.map_or(value, |next| self.onset(*next, value));
        }
        stretches
    }

    /// Bisects between a value without growth and one with growth.
    fn onset(&self, mut still: f64, mut growing: f64) -> f64 {
        const ROUNDS: usize = 30;
        for _ in 0..ROUNDS {
            let middle = still + (growing - still) / 2.0;
            match self.at(middle) {
                Ok(found) if found.growing.is_empty() => still = middle,
                Ok(_) => growing = middle,
                Err(_) => break,
            }
        }
        growing
    }

    /// Finds the intersections of branches with orders of the speed, to rounding.
    fn critical(
        &self,
        branches: &[Followed],
        speeds: &[f64],
    ) -> Result<Vec<Critical>, LinearError> {
        let mut critical = Vec::new();
        if speeds.is_empty() {
            return Ok(critical);
        }
        for order in self.variation.orders {
            for (index, branch) in branches.iter().enumerate() {
                for pair in branch.places.windows(2) {
                    let [(from, before), (to, after)] = pair else { continue };
                    let beyond = |place: &usize, of: &Oscillation| {
                        of.frequency - order * speeds[*place].abs()
                    };
                    let ends = [beyond(from, before), beyond(to, after)];
                    // A branch that begins on an order belongs to the next interval.
                    if *to == from + 1 && (ends[0] < 0.0) != (ends[1] < 0.0) {
                        let bounds = [self.variation.values[*from], self.variation.values[*to]];
                        let (value, there) = self.meeting(*order, bounds, ends, before)?;
                        critical.push(Critical {
                            order: *order,
                            branch: index,
                            value,
                            frequency: there.frequency,
                            damping_ratio: there.damping_ratio,
                        });
                    }
                }
            }
        }
        sort_ascending(&mut critical, |speed| speed.value);
        Ok(critical)
    }

    /// Finds the intersection between two values where an oscillation is slower than an order and
    /// where it is faster.
    fn meeting(
        &self,
        order: f64,
        [mut low, mut high]: [f64; 2],
        [mut at_low, mut at_high]: [f64; 2],
        like: &Oscillation,
    ) -> Result<(f64, Oscillation), LinearError> {
        const ROUNDS: usize = 60;
        let mut there = like.clone();
        let mut value = low;
        for round in 0..ROUNDS {
            // Secant steps with occasional bisections prevent a fixed end.
            let share = if round % 3 == 2 { 0.5 } else { at_low / (at_low - at_high) };
            let next = low + share * (high - low);
            let found = self.at(next)?;
            let nearest = found.oscillations.iter().min_by(|a, b| {
                there.distance(a, there.frequency).total_cmp(&there.distance(b, there.frequency))
            });
            let (Some(nearest), Some(speed)) = (nearest, found.speed) else { break };
            let moved = (next - value).abs();
            (value, there) = (next, nearest.clone());
            let beyond = there.frequency - order * speed.abs();
            if beyond == 0.0 || moved <= 4.0 * f64::EPSILON * value.abs() {
                break;
            }
            if (beyond < 0.0) == (at_low < 0.0) {
                (low, at_low) = (value, beyond);
            } else {
                (high, at_high) = (value, beyond);
            }
        }
        Ok((value, there))
    }
}

/// Excludes double eigenvalues at critical damping, which rounding turns into slow oscillations.
fn is_seen(mode: &Mode) -> bool {
    const ROUNDING: f64 = 1e-6;
    mode.kind == ModeKind::Oscillation && mode.imaginary > ROUNDING * mode.natural_frequency()
}

fn oscillation(mode: &Mode, coordinates: usize, names: &[String]) -> Oscillation {
    let places = (0..coordinates).chain(2 * coordinates..names.len());
    let shape = places.zip(&mode.shares).map(|(place, share)| {
        let [re, im] = mode.shape[place];
        let size = re.hypot(im);
        let direction = if size > 0.0 { Complex64::new(re, im) / size } else { Complex64::ONE };
        direction * share.sqrt()
    });
    Oscillation {
        frequency: mode.imaginary,
        damping_ratio: mode.damping_ratio(),
        shape: shape.collect(),
        moves: leading(mode, coordinates, names),
    }
}

/// Returns the name of the coordinate or state with the largest share.
fn leading(mode: &Mode, coordinates: usize, names: &[String]) -> String {
    let places = (0..coordinates).chain(2 * coordinates..names.len());
    let most = places.zip(&mode.shares).max_by(|a, b| a.1.total_cmp(b.1));
    most.map_or_else(String::new, |(place, _)| names[place].clone())
}

impl Oscillation {
    /// Returns the distance to another oscillation, given the expected frequency: by shape (modal
    /// assurance criterion, 1 for equal shapes) and by frequency.
    fn distance(&self, other: &Oscillation, expected: f64) -> f64 {
        let products = self.shape.iter().zip(&other.shape).map(|(a, b)| a.conj() * b);
        let alike = products.sum::<Complex64>().norm_sqr();
        let apart = (other.frequency - expected).abs() / (other.frequency + expected.abs());
        (1.0 - alike) + apart
    }
}

/// Part of a branch: indices of values with the oscillations there.
struct Followed {
    places: Vec<(usize, Oscillation)>,
}

impl Followed {
    fn first(&self) -> f64 {
        self.places.first().map_or(f64::NAN, |(_, oscillation)| oscillation.frequency)
    }

    /// Returns the frequency expected next, by linear extrapolation.
    fn expected(&self) -> f64 {
        match &self.places[..] {
            [.., (i, a), (j, b)] if *j == i + 1 => 2.0 * b.frequency - a.frequency,
            [.., (_, last)] => last.frequency,
            [] => f64::NAN,
        }
    }

    fn whole(&self, count: usize) -> Branch {
        let mut branch = Branch {
            moves: self.places.first().map_or_else(String::new, |(_, first)| first.moves.clone()),
            frequencies: vec![f64::NAN; count],
            damping_ratios: vec![f64::NAN; count],
        };
        for (place, oscillation) in &self.places {
            branch.frequencies[*place] = oscillation.frequency;
            branch.damping_ratios[*place] = oscillation.damping_ratio;
        }
        branch
    }
}

/// Continues branches with the oscillations at a value, the most similar pairs first.
fn follow(branches: &mut Vec<Followed>, index: usize, found: Found) {
    /// Distance above which an oscillation is another one.
    const UNLIKE: f64 = 0.8;
    let mut left: Vec<Option<Oscillation>> = found.oscillations.into_iter().map(Some).collect();
    let mut pairs = Vec::new();
    for (branch, followed) in branches.iter().enumerate() {
        let Some((last, known)) = followed.places.last() else { continue };
        if last + 1 != index {
            continue;
        }
        for (place, oscillation) in left.iter().enumerate() {
            let Some(oscillation) = oscillation else { continue };
            pairs.push((known.distance(oscillation, followed.expected()), branch, place));
        }
    }
    sort_ascending(&mut pairs, |(distance, ..)| *distance);
    for (distance, branch, place) in pairs {
        let is_taken = branches[branch].places.last().is_some_and(|(last, _)| *last == index);
        if distance > UNLIKE || is_taken {
            continue;
        }
        if let Some(oscillation) = left[place].take() {
            branches[branch].places.push((index, oscillation));
        }
    }
    let new = left.into_iter().flatten();
    branches.extend(new.map(|oscillation| Followed { places: vec![(index, oscillation)] }));
}
