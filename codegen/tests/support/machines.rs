//! Specs of machines of any size, for measurements of derivation.

use std::fmt::Write as _;

/// Returns the frame of a scene with these outputs.
fn scene(name: &str, units: &str, outputs: &str) -> String {
    format!(
        "[scene]\nname = \"{name}\"\ntitle = \"{name}\"\nsource = \"Textbook.\"\n\n{units}\n\
         [outputs]\n{outputs}\n\n[run]\nuntil = 1.0\npoints = 11\nrtol = 1e-6\nmethod = \"dop853\"\n"
    )
}

/// Returns bodies in a plane that attract each other: V = -sum m_i m_j/r_ij.
pub fn bodies(count: usize) -> String {
    let (mut coordinates, mut parameters, mut starts) =
        (String::new(), String::new(), String::new());
    let (mut kinetic, mut potential) = (Vec::new(), Vec::new());
    for i in 0..count {
        let _ = write!(coordinates, "x{i} = {{ unit = \"m\" }}\ny{i} = {{ unit = \"m\" }}\n");
        let mass = 1.0 + 0.1 * i as f64;
        let _ = writeln!(parameters, "m{i} = {{ value = {mass}, unit = \"kg\" }}");
        let angle = 6.3 * i as f64 / count as f64;
        let (x, y) = (angle.cos(), angle.sin());
        let _ = write!(starts, "\"sky.x{i}\" = {x:.3}\n\"sky.y{i}\" = {y:.3}\n");
        kinetic.push(format!("m{i}*(x{i}_dot^2 + y{i}_dot^2)/2"));
        for j in 0..i {
            potential.push(format!("m{j}*m{i}/sqrt((x{i} - x{j})^2 + (y{i} - y{j})^2)"));
        }
    }
    let text = format!(
        "[units.sky]\nunit = \"sky\"\n\n[define.sky.coordinates]\n{coordinates}\n\
         [define.sky.parameters]\n{parameters}gravity = {{ value = 1.0, unit = \"N m^2/kg^2\" }}\n\n\
         [define.sky.energy]\nkinetic = \"{}\"\npotential = \"-gravity*({})\"\n",
        kinetic.join(" + "),
        potential.join(" + ")
    );
    let outputs = "x = \"sky.x1\"\ny = \"sky.y1\"\n";
    scene("bodies", &format!("{text}\n[initial]\n{starts}"), outputs)
}

/// Returns rotors in series on couplings, each a unit of its own.
pub fn rotors(count: usize) -> String {
    let mut units = String::new();
    for i in 0..count {
        let _ = write!(
            units,
            "[units.r{i}]\nunit = \"rotor\"\nparameters = {{ inertia = {} }}\n\n",
            1.0 + 0.01 * i as f64
        );
    }
    for i in 1..count {
        let before = i - 1;
        let _ = write!(
            units,
            "[units.c{i}]\nunit = \"coupling\"\n\n[[joints]]\nconnect = [\"r{before}.shaft\", \
             \"c{i}.driving\"]\n\n[[joints]]\nconnect = [\"c{i}.driven\", \"r{i}.shaft\"]\n\n"
        );
    }
    units.push_str("[initial]\n\"r0.omega\" = 1.0\n");
    scene("rotors", &units, &format!("last = \"r{}.omega\"\n", count - 1))
}

/// Returns rotors without joints.
pub fn uncoupled(count: usize) -> String {
    let mut units = String::new();
    let mut outputs = String::new();
    for i in 0..count {
        let _ = write!(
            units,
            "[units.r{i}]\nunit = \"rotor\"\n\n[[forces]]\nport = \"r{i}.shaft\"\nexpression = \
             \"{} [N m s/rad]*(1 [rad/s] - r{i}.omega)\"\n\n",
            1.0 + 0.01 * i as f64
        );
        let _ = writeln!(outputs, "o{i} = \"r{i}.omega\"");
    }
    scene("uncoupled", &units, &outputs)
}

/// Returns a pendulum of `count` links, by absolute angles.
pub fn pendulum(count: usize) -> String {
    let (mut kinetic, mut potential) = (Vec::new(), Vec::new());
    let (mut x, mut y) = (Vec::new(), Vec::new());
    let (mut coordinates, mut starts) = (String::new(), String::new());
    for i in 0..count {
        let _ = writeln!(coordinates, "a{i} = {{ unit = \"rad\" }}");
        let _ = writeln!(starts, "\"p.a{i}\" = 0.1");
        x.push(format!("length*cos(a{i})*a{i}_dot"));
        y.push(format!("length*sin(a{i})*a{i}_dot"));
        kinetic.push(format!("mass*(({})^2 + ({})^2)/2", x.join(" + "), y.join(" + ")));
        let left = count - i;
        potential.push(format!("{left}*mass*gravity*length*cos(a{i})"));
    }
    let text = format!(
        "[units.p]\nunit = \"links\"\n\n[define.links.coordinates]\n{coordinates}\n\
         [define.links.parameters]\nmass = {{ value = 1.0, unit = \"kg\" }}\n\
         length = {{ value = 1.0, unit = \"m\" }}\ngravity = {{ value = 9.81, unit = \"m/s^2\" }}\n\n\
         [define.links.energy]\nkinetic = \"{}\"\npotential = \"-({})\"\n\n[initial]\n{starts}",
        kinetic.join(" + "),
        potential.join(" + ")
    );
    scene("pendulum", &text, "a = \"p.a0\"\n")
}
