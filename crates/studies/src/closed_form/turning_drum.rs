//! The four-link bobbin holder over a drum that begins to turn, in the angles of post and plate and
//! the speed of the bobbin, by hand.
//!
//! ```text
//! M q'' + M' q' - grad(q' M q')/2 = -grad V + N grad gap + Q grad stop_gap + F A_q t + [0, -d a N]
//! J w' = -r F + d (a + k) N                     F = P - d Pn
//! slip s = d u(t) - t A_q q' + r w              |P| <= f N, and P = f N sign(s) while it slips
//! ```
//!
//! with A the axle of the bobbin, t the direction across the centres, d the direction of the drum.
//! The classical Runge-Kutta method integrates phases between events, which bisection finds.
//!
//! Source: winder study, section 3; equations by hand.

use nalgebra::{Matrix2, Vector2};

use super::bobbin_holder::HOLDER;
use super::holder_oscillation::{SWINGING_HOLDER, SwingingHolder, Ways};

/// Holder, drum and bobbin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurningDrum {
    /// Post, plate, strut and contacts.
    pub holder: SwingingHolder,
    /// d: 1 if the drum drags the bobbin to the left, -1 to the right.
    pub direction: f64,
    /// Final speed of the surface of the drum \[m/s\].
    pub speed: f64,
    /// Time in which the drum speeds up \[s\].
    pub ramp: f64,
    /// f, coefficient of friction.
    pub friction: f64,
    /// Pn, tension of the thread \[N\].
    pub tension: f64,
    /// a, coefficient of support friction times its radius \[m\].
    pub support_arm: f64,
    /// k, arm of rolling friction \[m\].
    pub rolling_arm: f64,
    /// J, moment of inertia of the bobbin \[kg m^2\].
    pub inertia: f64,
}

/// The machine of the scene `drives/winder_turning_drum`.
pub const TURNING_DRUM: TurningDrum = TurningDrum {
    holder: SWINGING_HOLDER,
    direction: 1.0,
    speed: 3.75,
    ramp: 0.1,
    friction: 0.18,
    tension: 0.6,
    support_arm: 4e-4,
    rolling_arm: 6e-4,
    inertia: 1.3e-3,
};

/// Angles of post and plate, their rates, the speed of the bobbin.
type State = [f64; 5];

/// Contacts that are closed, and the direction of slip, or `None` while the bobbin follows the drum.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Phase {
    is_on_drum: bool,
    is_on_stop: bool,
    is_speeding_up: bool,
    slip: Option<f64>,
}

/// Forces and accelerations at an instant.
struct Instant {
    rate: State,
    /// N of a closed contact and Q of a closed stop, and their guards \[N\].
    pushes: [f64; 2],
    guards: [f64; 2],
    /// s \[m/s\].
    slip: f64,
    /// P \[N\].
    friction: f64,
}

/// Largest step \[s\]; contacts vibrate with 1000 1/s, and errors are 1e-8 rad.
const STEP: f64 = 5e-5;

impl TurningDrum {
    /// Computes the angles of post and plate \[rad\] and the speed of the bobbin \[rad/s\] from rest
    /// with the post lifted by an angle, at multiples of `interval` \[s\].
    #[must_use]
    pub fn motion(&self, lift: f64, interval: f64, samples: usize) -> Vec<[f64; 3]> {
        let [post, plate] = HOLDER.lifted(lift).working_angles();
        // The stop is where the unlifted post rests.
        let mut state = [post, plate, 0.0, 0.0, 0.0];
        let touching =
            Phase { is_on_drum: true, is_on_stop: false, is_speeding_up: true, slip: None };
        let mut phase = self.with_grip(0.0, &state, touching);
        let steps = (interval / STEP).ceil();
        let mut motion = Vec::new();
        for sample in 0..samples {
            let start = interval * sample as f64;
            motion.push([state[0], state[1], state[4]]);
            for step in 0..steps as usize {
                let time = start + interval * step as f64 / steps;
                self.advance(time, interval / steps, &mut state, &mut phase);
            }
        }
        motion
    }

    /// Makes one step, in parts where a phase ends.
    fn advance(&self, mut time: f64, step: f64, state: &mut State, phase: &mut Phase) {
        let mut rest = step;
        while rest > 0.0 {
            let end = self.stepped(time, rest, state, *phase);
            if self.margins(time + rest, &end, *phase).iter().all(|margin| *margin >= 0.0) {
                *state = end;
                return;
            }
            let (mut low, mut high) = (0.0, rest);
            while high - low > 1e-14 {
                let middle = f64::midpoint(low, high);
                let end = self.stepped(time, middle, state, *phase);
                let margins = self.margins(time + middle, &end, *phase);
                if margins.iter().all(|margin| *margin >= 0.0) {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            *state = self.stepped(time, high, state, *phase);
            (time, rest) = (time + high, rest - high);
            let [drum, stop, ramp, grip] = self.margins(time, state, *phase);
            phase.is_on_drum ^= drum < 0.0;
            phase.is_on_stop ^= stop < 0.0;
            phase.is_speeding_up ^= ramp < 0.0;
            if grip < 0.0 {
                *phase = self.with_grip(time, state, *phase);
                if phase.slip.is_none() {
                    let slip = self.instant(time, state, *phase).slip;
                    state[4] -= slip / self.radius(state);
                }
            }
        }
    }

    /// Returns what is below zero once contact, stop, the ramp or grip have changed.
    fn margins(&self, time: f64, state: &State, phase: Phase) -> [f64; 4] {
        let Instant { pushes, guards, slip, friction, .. } = self.instant(time, state, phase);
        let closed = |is_closed: bool, guard: f64| if is_closed { guard } else { -guard };
        let grip = match phase.slip {
            Some(direction) => direction * slip,
            None => self.friction * pushes[0] - friction.abs(),
        };
        let ramp = if phase.is_speeding_up { self.ramp - time } else { 0.0 };
        [closed(phase.is_on_drum, guards[0]), closed(phase.is_on_stop, guards[1]), ramp, grip]
    }

    /// Returns the phase in which the bobbin sticks if friction suffices.
    fn with_grip(&self, time: f64, state: &State, phase: Phase) -> Phase {
        let sticking = Phase { slip: None, ..phase };
        let Instant { friction, pushes, .. } = self.instant(time, state, sticking);
        if friction.abs() < self.friction * pushes[0] {
            sticking
        } else {
            Phase { slip: Some(friction.signum()), ..phase }
        }
    }

    fn stepped(&self, time: f64, step: f64, state: &State, phase: Phase) -> State {
        let slope =
            |share: f64, state: &State| self.instant(time + share * step, state, phase).rate;
        let moved = |slope: &State, share: f64| -> State {
            std::array::from_fn(|k| state[k] + share * step * slope[k])
        };
        let first = slope(0.0, state);
        let second = slope(0.5, &moved(&first, 0.5));
        let third = slope(0.5, &moved(&second, 0.5));
        let fourth = slope(1.0, &moved(&third, 1.0));
        std::array::from_fn(|k| {
            state[k] + step / 6.0 * (first[k] + 2.0 * (second[k] + third[k]) + fourth[k])
        })
    }

    /// Returns the radius of the compressed package at K.
    fn radius(&self, state: &State) -> f64 {
        let ways = self.holder.ways([state[0], state[1]]);
        ways.gap.value + self.holder.holder.radii[0]
    }

    /// Returns A_q t, the speed of A across the centres by each angle.
    fn across(&self, ways: &Ways) -> Vector2<f64> {
        let way = (ways.bobbin.at - Vector2::from(self.holder.holder.drum)).normalize();
        let across = Vector2::new(-way.y, way.x);
        Vector2::from(ways.bobbin.slopes.map(|slope| across.dot(&slope)))
    }

    fn instant(&self, time: f64, state: &State, phase: Phase) -> Instant {
        let angles = Vector2::new(state[0], state[1]);
        let (rates, speed) = (Vector2::new(state[2], state[3]), state[4]);
        let ways = self.holder.ways(angles.into());
        let (stiffness, damping) = (self.holder.contact_stiffness, self.holder.contact_damping);
        let pushed = |gap: f64, slopes: Vector2<f64>, is_closed: bool| {
            let push = -stiffness * gap - damping * slopes.dot(&rates);
            ((-stiffness * gap).min(push), if is_closed { push } else { 0.0 })
        };
        let drum = pushed(ways.gap.value, ways.gap.slopes, phase.is_on_drum);
        let stop = pushed(ways.stop_gap.value, ways.stop_gap.slopes, phase.is_on_stop);
        let ((drum_guard, normal), (stop_guard, stop)) = (drum, stop);

        // Central differences along both angles and along the motion.
        let h = 1e-5;
        let near = |step: Vector2<f64>| self.holder.ways((angles + step).into());
        let bends: [Matrix2<f64>; 2] = [Vector2::x(), Vector2::y()]
            .map(|axis: Vector2<f64>| (near(h * axis).mass - near(-h * axis).mass) / (2.0 * h));
        let turning = rates[0] * bends[0] + rates[1] * bends[1];
        let quadratic = Vector2::from(bends.map(|bend| rates.dot(&(bend * rates)) / 2.0));
        let along = |share: f64| self.across(&near(share * rates));
        let across = self.across(&ways);
        let across_rate = (along(h) - along(-h)) / (2.0 * h);

        let [spring, strut_damping] = [self.holder.holder.spring[0], self.holder.damping];
        let push = spring * ways.slide.value + strut_damping * ways.slide.slopes.dot(&rates);
        let couple = Vector2::new(0.0, -self.direction * self.support_arm * normal);
        let others = quadratic - turning * rates - ways.weights.slopes - push * ways.slide.slopes
            + normal * ways.gap.slopes
            + stop * ways.stop_gap.slopes
            + couple;
        let mass = ways.mass.try_inverse().unwrap_or_else(|| Matrix2::repeat(f64::NAN));
        let radius = ways.gap.value + self.holder.holder.radii[0];
        let resisting = self.direction * (self.support_arm + self.rolling_arm) * normal;
        let accelerations = |friction: f64| {
            let force = friction - self.direction * self.tension;
            let angles = mass * (others + force * across);
            (angles, (resisting - radius * force) / self.inertia)
        };

        let [surface, surface_rate] = if phase.is_speeding_up {
            [self.speed * time / self.ramp, self.speed / self.ramp]
        } else {
            [self.speed, 0.0]
        };
        let slip = self.direction * surface - across.dot(&rates) + radius * speed;
        let slip_rate = |friction: f64| {
            let (angles, turning) = accelerations(friction);
            self.direction * surface_rate - across.dot(&angles) - across_rate.dot(&rates)
                + ways.gap.slopes.dot(&rates) * speed
                + radius * turning
        };
        let friction = if let Some(direction) = phase.slip {
            direction * self.friction * normal
        } else {
            let free = slip_rate(0.0);
            free / (free - slip_rate(1.0))
        };
        let (angles, turning) = accelerations(friction);
        Instant {
            rate: [state[2], state[3], angles[0], angles[1], turning],
            pushes: [normal, stop],
            guards: [drum_guard, stop_guard],
            slip,
            friction,
        }
    }
}
