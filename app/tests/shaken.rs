//! A mass on a spring and damper that a force shakes.

pub const MASS: f64 = 2.0;
pub const STIFFNESS: f64 = 800.0;
pub const DAMPING: f64 = 8.0;

/// Returns its scene with a force, and what a test adds.
pub fn scene(force: &str, more: &str) -> String {
    format!(
        r#"
        [scene]
        name = "shaken"
        [units.body]
        unit = "translational/mass"
        parameters = {{ mass = {MASS} }}
        [units.spring]
        unit = "translational/spring_damper"
        parameters = {{ stiffness = {STIFFNESS}, damping = {DAMPING} }}
        [units.ground]
        unit = "translational/fixed"
        [units.shaker]
        unit = "sources/force"
        inputs = {{ force = "{force}" }}
        [[joints]]
        connect = ["body.b", "spring.a"]
        [[joints]]
        connect = ["spring.b", "ground.a"]
        [[joints]]
        connect = ["shaker.a", "body.a"]
        {more}
        "#
    )
}
