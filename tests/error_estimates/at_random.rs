//! Specs of random machines with switches, tables, jumps and events.

use std::fmt::Write as _;

/// Random numbers and the text of a machine so far.
struct Writer {
    random: fastrand::Rng,
    masses: usize,
    text: String,
}

impl Writer {
    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.random.f64()
    }

    /// Returns a number of several decades, uniform in its logarithm.
    fn decades(&mut self, low: f64, high: f64) -> f64 {
        self.within(low.ln(), high.ln()).exp()
    }

    fn line(&mut self, line: &str) {
        writeln!(self.text, "{line}").expect("a string");
    }

    fn force(&mut self, on: usize, expression: &str) {
        self.line(&format!(
            "[[define.u.forces]]\ncoordinate = \"x{on}\"\nexpression = \"{expression}\""
        ));
    }

    /// Adds a force of a random kind on a mass; `number` makes names unique.
    fn element(&mut self, number: usize) {
        let on = self.random.usize(0..self.masses);
        let (size, width) = (self.decades(0.1, 4.0), self.within(0.03, 0.4));
        let (stiffness, period) = (self.decades(20.0, 1500.0), self.decades(0.05, 1.0));
        let duty = self.within(0.2, 0.8);
        match self.random.usize(0..13) {
            // Play, two-sided and one-sided.
            0 => self.force(
                on,
                &format!("-{stiffness} [N/m]*(max(x{on} - {width} [m], 0) + min(x{on} + {width} [m], 0))"),
            ),
            // A stop with a damper that may pull, and one that only pushes.
            1 | 2 => {
                let damped = format!("-{stiffness} [N/m]*(x{on} - {width} [m]) - {size} [N*s/m]*v{on}");
                let only_pushes = self.random.bool();
                let pushes = format!("piecewise(x{on} < {width} [m], 0 [N], {damped})");
                let force = if only_pushes { format!("min({pushes}, 0 [N])") } else { pushes };
                self.force(on, &force);
            }
            // Drag, smooth friction and a saturated controller.
            3 => self.force(on, &format!("-{size} [kg/m]*v{on}*abs(v{on})")),
            4 => self.force(on, &format!("-{size} [N]*tanh(v{on}/({} [m/s]))", 0.1 * width)),
            5 => self.force(
                on,
                &format!("max(-{size} [N], min({size} [N], -{stiffness} [N/m]*x{on} - {size} [N*s/m]*v{on}))"),
            ),
            // Supplies in pulses, by time and by state.
            6 => self.force(
                on,
                &format!("piecewise(mod(t, {period} [s]) < {} [s], {size} [N], 0 [N])", duty * period),
            ),
            7 => self.force(
                on,
                &format!("piecewise(mod(t/({period} [s]), 1) < {duty} + 0.3*tanh(x0/(1 [m])), {size} [N], -{size} [N])"),
            ),
            // A quantizer, a step and a ramp.
            8 => self.force(on, &format!("-{size} [N]*floor(x{on}/({width} [m]) + 0.5)")),
            9 => self.force(on, &format!("{size} [N]*step(t, {} [s])", 3.0 * duty)),
            10 => self.force(on, &format!("{size} [N]*min(max(t/({period} [s]) - 1, 0), 1)")),
            // A relay with hysteresis.
            11 => {
                let far = width + 0.1;
                for (event, way, guard, from) in [
                    ("on", "rising", format!("x{on} - {width} [m]"), 0),
                    ("off", "falling", format!("x{on} + {far} [m]"), 1),
                ] {
                    self.line(&format!(
                        "[define.u.events.{event}{number}]\nguard = \"{guard}\"\ndirection = \"{way}\"\n\
                         when = {{ m{number} = {from} }}\nset = {{ m{number} = {} }}",
                        1 - from
                    ));
                }
                self.line(&format!("[define.u.modes.m{number}]\ninitial = 0"));
                self.force(on, &format!("piecewise(m{number} < 1, {size} [N], -{size} [N])"));
            }
            // An impact.
            _ => self.line(&format!(
                "[define.u.events.hit{number}]\nguard = \"x{on} - {} [m]\"\ndirection = \"rising\"\n\
                 set = {{ v{on} = \"-{duty}*v{on}\" }}",
                width + 0.5
            )),
        }
    }
}

/// Returns the text of a machine: driven masses between springs and dampers, with elements of which
/// the force is not smooth. It has a trigonometric mass now and then, so that it is not linear between
/// its switches.
pub fn text(seed: u64) -> String {
    let mut random = fastrand::Rng::with_seed(seed);
    let masses = random.usize(1..4);
    let mut all = Writer { random, masses, text: String::new() };
    let (mut kinetic, mut potential, mut dissipation) = (vec![], vec![], vec![]);
    all.line(&format!("[scene]\nname = \"random_{seed}\"\n[units.u]\nunit = \"u\"\n[initial]"));
    for mass in 0..masses {
        let (place, speed) = (all.within(-0.5, 0.03), all.within(-1.0, 1.0));
        all.line(&format!("\"u.x{mass}\" = {place}\n\"u.v{mass}\" = {speed}"));
    }
    let until = all.within(3.0, 7.0);
    all.line(&format!("[run]\nuntil = {until}\npoints = 61\nrtol = 1e-6\nmethod = \"auto\""));
    for mass in 0..masses {
        all.line(&format!("[define.u.coordinates.x{mass}]\nunit = \"m\"\nvelocity = \"v{mass}\""));
        let inertia = all.decades(0.3, 3.0);
        let uneven = if all.random.bool() {
            format!("*(1.2 + cos(x{mass}/(1 [m])))")
        } else {
            String::new()
        };
        kinetic.push(format!("{inertia} [kg]{uneven}*v{mass}^2/2"));
        potential.push(format!("{} [N/m]*x{mass}^2/2", all.decades(2.0, 60.0)));
        dissipation.push(format!("{} [N*s/m]*v{mass}^2/2", all.decades(0.03, 1.0)));
        if mass > 0 {
            let before = mass - 1;
            potential.push(format!("{} [N/m]*(x{mass} - x{before})^2/2", all.decades(5.0, 80.0)));
        }
    }
    let energies = [("kinetic", kinetic), ("potential", potential), ("dissipation", dissipation)];
    let energies = energies.map(|(name, terms)| format!("{name} = \"{}\"", terms.join(" + ")));
    all.line(&format!("[define.u.energy]\n{}", energies.join("\n")));
    let (size, frequency) = (all.within(0.5, 4.0), all.decades(0.7, 9.0));
    all.force(0, &format!("{size} [N]*cos({frequency} [rad/s]*t)"));
    for number in 0..all.random.usize(1..5) {
        all.element(number);
    }
    all.text
}
