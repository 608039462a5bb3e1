//! Machines of the tests of periodic motions, also of those by two algebras.

/// Block on a spring that hardens, driven: x'' + 2 zeta x' + x + x^3 = F cos(omega t).
pub const DUFFING: &str = r#"
    [scene]
    name = "duffing"
    [units.block]
    unit = "block"
    [outputs]
    x = "block.x"
    [run]
    until = 200.0
    points = 2
    rtol = 1e-11
    method = "dop853"
    [define.block.coordinates.x]
    unit = "m"
    velocity = "v"
    [define.block.parameters]
    damping = { value = 0.1, unit = "N s/m" }
    force = { value = 0.3, unit = "N" }
    frequency = { value = 0.6, unit = "rad/s" }
    [define.block.energy]
    kinetic = "1 [kg]*v^2/2"
    potential = "1 [N/m]*x^2/2 + 1 [N/m^3]*x^4/4"
    dissipation = "damping*v^2/2"
    [[define.block.forces]]
    coordinate = "x"
    expression = "force*cos(frequency*t)"
"#;

/// Oscillator with dry friction, driven, by `sign` or by `[friction.guide]`.
pub fn rubbing(friction: &str) -> String {
    format!(
        r#"
        [scene]
        name = "rubbing"
        [units.block]
        unit = "block"
        [outputs]
        x = "block.x"
        [run]
        until = 300.0
        points = 2
        rtol = 1e-10
        method = "dop853"
        [define.block.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.block.parameters]
        force = {{ value = 1.0, unit = "N" }}
        friction = {{ value = 0.3, unit = "N" }}
        frequency = {{ value = 0.7, unit = "rad/s" }}
        [define.block.energy]
        kinetic = "1 [kg]*v^2/2"
        potential = "1 [N/m]*x^2/2"
        [[define.block.forces]]
        coordinate = "x"
        expression = "force*cos(frequency*t)"
        {friction}
        "#
    )
}

pub const BY_MODES: &str = r#"
    [define.block.friction.guide]
    speed = "v"
    sliding = "friction"
    unit = "N"
"#;
pub const BY_SIGN: &str = r#"
    [[define.block.forces]]
    coordinate = "x"
    expression = "-friction*sign(v)"
"#;

/// A disc on a shaft, with own parameters, energies and forces.
pub fn rotor(own: &str) -> String {
    format!(
        r#"
        [scene]
        name = "rotor"
        [units.disc]
        unit = "disc"
        [initial]
        "disc.x" = 0.1
        [outputs]
        way = {{ expression = "sqrt(disc.x^2 + disc.y^2)", unit = "m" }}
        [run]
        until = 400.0
        points = 2
        rtol = 1e-11
        method = "dop853"
        [define.disc.coordinates.x]
        unit = "m"
        [define.disc.coordinates.y]
        unit = "m"
        {own}
        "#
    )
}

/// Jeffcott rotor with unbalance in a bearing with play: an annular stop of radius `PLAY`.
pub const JEFFCOTT: &str = r#"
    [define.disc.parameters]
    speed = { value = 0.5, unit = "rad/s" }
    [define.disc.helpers.depth]
    expression = "max(sqrt(x^2 + y^2) - 1 [m], 0)"
    unit = "m"
    [define.disc.energy]
    kinetic = "1 [kg]*(x_dot^2 + y_dot^2)/2"
    potential = "1 [N/m]*(x^2 + y^2)/2 + 2 [N/m]*depth^2/2"
    dissipation = "0.1 [N s/m]*(x_dot^2 + y_dot^2)/2"
    [[define.disc.forces]]
    coordinate = "x"
    expression = "0.3 [kg m]*speed^2*cos(speed*t)"
    [[define.disc.forces]]
    coordinate = "y"
    expression = "0.3 [kg m]*speed^2*sin(speed*t)"
"#;

/// Oscillator with a stop: x'' + 2 zeta x' + x = F cos(w t), reset at x = 1 with a restitution.
pub const STOPPED: &str = r#"
        [scene]
        name = "grazing"
        [units.block]
        unit = "block"
        [outputs]
        x = "block.x"
        [run]
        until = 300.0
        points = 2
        rtol = 1e-11
        method = "dop853"
        [define.block.coordinates.x]
        unit = "m"
        velocity = "v"
        [define.block.parameters]
        force = { value = 0.3, unit = "N" }
        frequency = { value = 0.6, unit = "rad/s" }
        [define.block.energy]
        kinetic = "1 [kg]*v^2/2"
        potential = "1 [N/m]*x^2/2"
        dissipation = "0.2 [N s/m]*v^2/2"
        [[define.block.forces]]
        coordinate = "x"
        expression = "force*cos(frequency*t)"
        [define.block.events.impact]
        guard = "1 [m] - x"
        direction = "falling"
        set = { v = "-0.7*v" }
        "#;
