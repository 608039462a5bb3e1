//! Machines with switches at random, as specs: masses on springs that are pushed, with parts of many
//! kinds between them. Every other one has masses that change with place, so that it is not linear
//! between its switches. A seed always gives the same machine.

use std::fmt::Write as _;

use fastrand::Rng;

/// A machine while it is put together.
struct Draft {
    random: Rng,
    masses: usize,
    parameters: String,
    count: usize,
    forces: String,
    more: String,
    /// First-order state of a unit, which only one part may have.
    has_lag: bool,
}

/// Kinds of parts, by name.
type Part = fn(&mut Draft, usize);
const PARTS: [(&str, Part); 29] = [
    ("drag", drag),
    ("play", play),
    ("stop", stop),
    ("one-sided stop", one_sided_stop),
    ("dry friction", dry_friction),
    ("relay", relay),
    ("switching line", switching_line),
    ("hysteresis", hysteresis),
    ("pulse width", pulse_width),
    ("modulated pulse width", modulated),
    ("quantizer", quantizer),
    ("encoder that acts", encoder),
    ("counter", counter),
    ("saturation", saturation),
    ("step in time", step),
    ("ramp in time", ramp),
    ("impact", impact),
    ("saw tooth", saw_tooth),
    ("declared friction", declared_friction),
    ("brake", brake),
    ("square wave", square_wave),
    ("stairs", stairs),
    ("dead zone of speed", dead_zone),
    ("two springs", two_springs),
    ("rectifier", rectifier),
    ("thermostat", thermostat),
    ("lag with a limit", limited_lag),
    ("preload", preload),
    ("bell", bell),
];

impl Draft {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.random.f64()
    }

    /// Returns the name of a new parameter between two values, evenly by factors.
    fn parameter(&mut self, low: f64, high: f64, unit: &str) -> String {
        let value = low * (high / low).powf(self.random.f64());
        self.valued(value, unit)
    }

    fn valued(&mut self, value: f64, unit: &str) -> String {
        let name = format!("p{}", self.count);
        self.count += 1;
        writeln!(self.parameters, "{name} = {{ value = {value:.6e}, unit = \"{unit}\" }}")
            .expect("text");
        name
    }

    fn push(&mut self, mass: usize, force: &str) {
        write!(
            self.forces,
            "[[define.body.forces]]\ncoordinate = \"x{mass}\"\nexpression = \"{force}\"\n"
        )
        .expect("text");
    }

    fn event(&mut self, name: &str, guard: &str, direction: &str, rest: &str) {
        write!(
            self.more,
            "[define.body.events.{name}]\nguard = \"{guard}\"\ndirection = \"{direction}\"\n{rest}\n"
        )
        .expect("text");
    }

    fn mode(&mut self, name: &str) {
        write!(self.more, "[define.body.modes.{name}]\ninitial = 0\n").expect("text");
    }

    fn any(&mut self) -> usize {
        self.random.usize(..self.masses)
    }
}

fn drag(draft: &mut Draft, i: usize) {
    let c = draft.parameter(0.05, 2.0, "kg/m");
    draft.push(i, &format!("-{c}*v{i}*abs(v{i})"));
}

fn play(draft: &mut Draft, i: usize) {
    let (k, g) = (draft.parameter(10.0, 500.0, "N/m"), draft.parameter(0.02, 0.4, "m"));
    draft.push(i, &format!("-{k}*(max(x{i} - {g}, 0) + min(x{i} + {g}, 0))"));
}

fn stop(draft: &mut Draft, i: usize) {
    let k = draft.parameter(50.0, 2000.0, "N/m");
    let (c, d) = (draft.parameter(0.5, 20.0, "N s/m"), draft.parameter(0.02, 0.5, "m"));
    draft.push(i, &format!("-piecewise(x{i} < {d}, 0, {k}*(x{i} - {d}) + {c}*v{i})"));
}

fn one_sided_stop(draft: &mut Draft, i: usize) {
    let k = draft.parameter(50.0, 2000.0, "N/m");
    let (c, d) = (draft.parameter(0.5, 20.0, "N s/m"), draft.parameter(0.02, 0.5, "m"));
    draft.push(i, &format!("-max(piecewise(x{i} < {d}, 0, {k}*(x{i} - {d}) + {c}*v{i}), 0)"));
}

fn dry_friction(draft: &mut Draft, i: usize) {
    let f = draft.parameter(0.05, 2.0, "N");
    draft.push(i, &format!("-{f}*sign(v{i})"));
}

fn relay(draft: &mut Draft, i: usize) {
    let f = draft.parameter(0.1, 5.0, "N");
    let at = draft.between(-0.3, 0.3);
    let at = draft.valued(at, "m");
    draft.push(i, &format!("-{f}*sign(x{i} - {at})"));
}

fn switching_line(draft: &mut Draft, i: usize) {
    let (f, l) = (draft.parameter(0.1, 5.0, "N"), draft.parameter(0.003, 0.3, "s"));
    draft.push(i, &format!("-{f}*sign(x{i} + {l}*v{i})"));
}

fn hysteresis(draft: &mut Draft, i: usize) {
    let (f, wide, mode) = (draft.parameter(0.2, 5.0, "N"), draft.between(0.05, 0.3), draft.count);
    let low = draft.between(-0.3, 0.0);
    let (low, high) = (draft.valued(low, "m"), draft.valued(low + wide, "m"));
    draft.mode(&format!("m{mode}"));
    let rest =
        |from: u8| format!("when = {{ m{mode} = {from} }}\nset = {{ m{mode} = {} }}", 1 - from);
    draft.event(&format!("on{mode}"), &format!("x{i} - {high}"), "rising", &rest(0));
    draft.event(&format!("off{mode}"), &format!("x{i} - {low}"), "falling", &rest(1));
    let on = draft.any();
    draft.push(on, &format!("piecewise(m{mode} < 1, {f}, -{f})"));
}

fn pulse_width(draft: &mut Draft, i: usize) {
    let (f, period) = (draft.parameter(0.2, 5.0, "N"), draft.parameter(0.05, 1.0, "s"));
    let share = draft.between(0.1, 0.9);
    draft.push(i, &format!("{f}*piecewise(mod(t, {period}) < {share:.4}*{period}, 1, 0)"));
}

fn modulated(draft: &mut Draft, i: usize) {
    let (f, period) = (draft.parameter(0.2, 5.0, "N"), draft.parameter(0.05, 1.0, "s"));
    let (duty, long) = (draft.between(0.3, 0.7), draft.parameter(0.3, 3.0, "m"));
    let duty = format!("min(max({duty:.4} - x{i}/{long}, 0), 1)");
    draft.push(i, &format!("{f}*piecewise(mod(t, {period})/{period} < {duty}, 1, 0)"));
}

fn quantizer(draft: &mut Draft, i: usize) {
    let (k, q) = (draft.parameter(5.0, 100.0, "N/m"), draft.parameter(0.01, 0.2, "m"));
    draft.push(i, &format!("-{k}*{q}*round(x{i}/{q})"));
}

fn encoder(draft: &mut Draft, i: usize) {
    let (f, long, mode) =
        (draft.parameter(0.2, 3.0, "N"), draft.parameter(0.02, 0.1, "m"), draft.count);
    let lines = draft.random.u32(2..9);
    draft.mode(&format!("n{mode}"));
    let rest = format!("set = {{ n{mode} = \"n{mode} + 1\" }}");
    draft.event(&format!("tick{mode}"), &format!("sin(x{i}/{long}) - 0.5"), "rising", &rest);
    let on = draft.any();
    draft.push(on, &format!("piecewise(mod(n{mode}, {}) < {lines}, {f}, -{f})", 2 * lines));
}

fn counter(draft: &mut Draft, i: usize) {
    let (long, mode) = (draft.parameter(0.001, 0.01, "m"), draft.count);
    draft.mode(&format!("n{mode}"));
    let rest = format!("set = {{ n{mode} = \"n{mode} + 1\" }}");
    draft.event(&format!("count{mode}"), &format!("sin(x{i}/{long})"), "rising", &rest);
}

fn saturation(draft: &mut Draft, i: usize) {
    let k = draft.parameter(5.0, 200.0, "N/m");
    let (c, f) = (draft.parameter(0.1, 10.0, "N s/m"), draft.parameter(0.1, 5.0, "N"));
    draft.push(i, &format!("min(max(-({k}*x{i} + {c}*v{i}), -{f}), {f})"));
}

fn step(draft: &mut Draft, i: usize) {
    let (f, at) = (draft.parameter(0.3, 3.0, "N"), draft.parameter(0.2, 4.0, "s"));
    draft.push(i, &format!("{f}*step(t, {at})"));
}

fn ramp(draft: &mut Draft, i: usize) {
    let f = draft.parameter(0.3, 3.0, "N");
    let (at, long) = (draft.parameter(0.2, 3.0, "s"), draft.parameter(0.01, 2.0, "s"));
    draft.push(i, &format!("{f}*min(max((t - {at})/{long}, 0), 1)"));
}

fn impact(draft: &mut Draft, i: usize) {
    let (at, share, name) = (draft.parameter(0.3, 0.7, "m"), draft.between(0.4, 0.95), draft.count);
    let rest = format!("set = {{ v{i} = \"-{share:.4}*v{i}\" }}");
    draft.event(&format!("hit{name}"), &format!("x{i} - {at}"), "rising", &rest);
}

fn saw_tooth(draft: &mut Draft, i: usize) {
    let (f, period) = (draft.parameter(0.2, 3.0, "N"), draft.parameter(0.05, 1.0, "s"));
    let (at, long, of) = (draft.between(0.4, 0.6), draft.parameter(1.0, 4.0, "m"), draft.any());
    let is_below = format!("mod(t, {period})/{period} < {at:.4} + x{of}/{long}");
    draft.push(i, &format!("piecewise({is_below}, {f}, -{f})"));
}

fn declared_friction(draft: &mut Draft, i: usize) {
    if draft.more.contains(&format!("speed = \"v{i}\"")) {
        return play(draft, i);
    }
    let (f, name) = (draft.parameter(0.05, 2.0, "N"), draft.count);
    let more =
        if draft.random.bool() { format!("breakaway = \"1.3*{f}\"\n") } else { String::new() };
    write!(
        draft.more,
        "[define.body.friction.rub{name}]\nspeed = \"v{i}\"\nsliding = \"{f}\"\nunit = \"N\"\n{more}"
    )
    .expect("text");
}

fn brake(draft: &mut Draft, i: usize) {
    let (c, at, mode) =
        (draft.parameter(0.5, 10.0, "N s/m"), draft.parameter(0.5, 3.0, "s"), draft.count);
    draft.mode(&format!("m{mode}"));
    let rest = format!("when = {{ m{mode} = 0 }}\nset = {{ m{mode} = 1 }}");
    draft.event(&format!("brake{mode}"), &format!("t - {at}"), "rising", &rest);
    draft.push(i, &format!("-piecewise(m{mode} < 1, 0, {c}*v{i})"));
}

fn square_wave(draft: &mut Draft, i: usize) {
    let (f, w) = (draft.parameter(0.2, 3.0, "N"), draft.parameter(2.0, 40.0, "rad/s"));
    draft.push(i, &format!("{f}*sign(sin({w}*t))"));
}

fn stairs(draft: &mut Draft, i: usize) {
    let (f, period) = (draft.parameter(0.1, 1.0, "N"), draft.parameter(0.2, 2.0, "s"));
    draft.push(i, &format!("{f}*floor(t/{period})"));
}

fn dead_zone(draft: &mut Draft, i: usize) {
    let (c, g) = (draft.parameter(0.5, 20.0, "N s/m"), draft.parameter(0.02, 0.5, "m/s"));
    draft.push(i, &format!("-{c}*(max(v{i} - {g}, 0) + min(v{i} + {g}, 0))"));
}

fn two_springs(draft: &mut Draft, i: usize) {
    let (soft, hard) = (draft.parameter(5.0, 50.0, "N/m"), draft.parameter(50.0, 800.0, "N/m"));
    let f = draft.parameter(0.5, 5.0, "N");
    draft.push(i, &format!("-max({soft}*x{i}, {hard}*x{i} - {f})"));
}

fn rectifier(draft: &mut Draft, i: usize) {
    let (f, w) = (draft.parameter(0.2, 3.0, "N"), draft.parameter(2.0, 40.0, "rad/s"));
    draft.push(i, &format!("{f}*abs(sin({w}*t))"));
}

fn lag(draft: &mut Draft, i: usize, rate: &str) {
    draft.has_lag = true;
    write!(draft.more, "[define.body.states.z]\nunit = \"N\"\nrate = \"{rate}\"\n").expect("text");
    draft.push(i, "z");
}

fn thermostat(draft: &mut Draft, i: usize) {
    if draft.has_lag {
        return hysteresis(draft, i);
    }
    let (u, tau, mode) =
        (draft.parameter(0.5, 4.0, "N"), draft.parameter(0.05, 2.0, "s"), draft.count);
    draft.mode(&format!("m{mode}"));
    let rest =
        |from: u8| format!("when = {{ m{mode} = {from} }}\nset = {{ m{mode} = {} }}", 1 - from);
    draft.event(&format!("on{mode}"), &format!("z - 0.7*{u}"), "rising", &rest(0));
    draft.event(&format!("off{mode}"), &format!("z - 0.3*{u}"), "falling", &rest(1));
    lag(draft, i, &format!("(piecewise(m{mode} < 1, {u}, 0) - z)/{tau}"));
}

fn limited_lag(draft: &mut Draft, i: usize) {
    if draft.has_lag {
        return saturation(draft, i);
    }
    let k = draft.parameter(5.0, 50.0, "N/m");
    let (f, tau, of) =
        (draft.parameter(0.3, 4.0, "N"), draft.parameter(0.02, 1.0, "s"), draft.any());
    lag(draft, i, &format!("(min(max(-{k}*x{of}, -{f}), {f}) - z)/{tau}"));
}

fn preload(draft: &mut Draft, i: usize) {
    let f = draft.parameter(0.3, 5.0, "N/m");
    let long = draft.parameter(0.3, 3.0, "m");
    draft.push(i, &format!("-{f}*{long}*sign(x{i})"));
}

fn bell(draft: &mut Draft, i: usize) {
    let (f, wide) = (draft.parameter(0.3, 4.0, "N"), draft.parameter(0.005, 0.05, "m"));
    draft.push(i, &format!("{f}*exp(-(x{i}/{wide})^2)"));
}

/// A machine as text.
pub struct Machine {
    /// Kinds of its parts.
    #[allow(dead_code, reason = "only named where a failure is shown")]
    pub parts: Vec<&'static str>,
    pub spec: String,
}

/// Returns the machine of a seed: every kind of part comes in turn, with up to two others.
pub fn machine(seed: u64) -> Machine {
    let random = Rng::with_seed(0x6d61_6368 ^ seed.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    let mut draft = Draft {
        random,
        masses: 1,
        parameters: String::new(),
        count: 0,
        forces: String::new(),
        more: String::new(),
        has_lag: false,
    };
    draft.masses = draft.random.usize(1..=2);
    let mut uneven = Rng::with_seed(seed);
    let mut kinetic = Vec::new();
    let (mut potential, mut dissipation) = (Vec::new(), Vec::new());
    for i in 0..draft.masses {
        let m = draft.parameter(0.3, 3.0, "kg");
        let (k, c) = (draft.parameter(2.0, 60.0, "N/m"), draft.parameter(0.02, 1.0, "N s/m"));
        let share =
            if uneven.bool() { format!("*(1.2 + cos(x{i}/(1 [m])))/2.2") } else { String::new() };
        kinetic.push(format!("{m}{share}*v{i}^2/2"));
        potential.push(format!("{k}*x{i}^2/2"));
        dissipation.push(format!("{c}*v{i}^2/2"));
    }
    if draft.masses > 1 {
        let k = draft.parameter(1.0, 60.0, "N/m");
        potential.push(format!("{k}*(x0 - x1)^2/2"));
    }
    let (f, w) = (draft.parameter(0.5, 5.0, "N"), draft.parameter(0.7, 9.0, "rad/s"));
    let on = draft.any();
    draft.push(on, &format!("{f}*sin({w}*t)"));
    let mut parts = Vec::new();
    for more in 0..draft.random.usize(1..=3) {
        let next = if more == 0 { seed as usize } else { draft.random.usize(..) };
        let (name, put) = PARTS[next % PARTS.len()];
        let i = draft.any();
        put(&mut draft, i);
        parts.push(name);
    }
    let spec = written(&mut draft, seed, &[kinetic, potential, dissipation]);
    Machine { parts, spec }
}

fn written(draft: &mut Draft, seed: u64, energies: &[Vec<String>; 3]) -> String {
    let masses = draft.masses;
    let coordinates =
        (0..masses).map(|i| format!("x{i} = {{ unit = \"m\", velocity = \"v{i}\" }}\n"));
    let coordinates: String = coordinates.collect();
    let mut initial = String::new();
    for i in 0..masses {
        let (x, v) = (draft.between(-0.6, 0.15), draft.between(-1.5, 1.5));
        writeln!(initial, "\"body.x{i}\" = {x:.6}\n\"body.v{i}\" = {v:.6}").expect("text");
    }
    let [kinetic, potential, dissipation] = energies.each_ref().map(|terms| terms.join(" + "));
    let until = draft.between(3.0, 6.0);
    let Draft { parameters, forces, more, .. } = draft;
    format!(
        "[scene]\nname = \"switched_{seed}\"\n[define.body.coordinates]\n{coordinates}\
         [define.body.parameters]\n{parameters}[define.body.energy]\nkinetic = \"{kinetic}\"\n\
         potential = \"{potential}\"\ndissipation = \"{dissipation}\"\n{forces}{more}\
         [units.body]\nunit = \"body\"\n[initial]\n{initial}[run]\nuntil = {until:.4}\n\
         points = 101\nrtol = 1e-8\nmethod = \"dop853\"\n"
    )
}
