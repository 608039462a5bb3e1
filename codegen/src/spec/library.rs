//! The units that come with Machinist.

/// A unit that comes with Machinist.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LibraryUnit {
    /// What scenes call it, with its folder: `rotational/gear`.
    pub name: &'static str,
    /// Its spec.
    pub text: &'static str,
    /// A scene of a few lines that uses it; standard parts have one.
    pub example: Option<&'static str>,
}

macro_rules! unit {
    ($name:literal) => {
        LibraryUnit {
            name: $name,
            text: include_str!(concat!("../../../specs/units/", $name, ".toml")),
            example: None,
        }
    };
}

macro_rules! part {
    ($name:literal) => {
        LibraryUnit {
            name: $name,
            text: include_str!(concat!("../../../specs/units/", $name, ".toml")),
            example: Some(include_str!(concat!("../../../specs/scenes/parts/", $name, ".toml"))),
        }
    };
}

/// All of them; the one list there is. Standard parts are in folders by kind, and have
/// examples.
pub const LIBRARY: &[LibraryUnit] = &[
    unit!("bobbin_holder"),
    unit!("bouncer"),
    unit!("cloth_fell_contact"),
    unit!("coupling"),
    unit!("friction_slider"),
    unit!("friction_slider_smooth"),
    unit!("imposed_drive"),
    unit!("induction_motor"),
    unit!("induction_motor_as_printed"),
    unit!("induction_motor_stationary"),
    unit!("loom_shaft"),
    unit!("one_sided_contact"),
    unit!("planar_body"),
    unit!("point_mass"),
    unit!("pressed_bobbin"),
    unit!("reed"),
    unit!("rotor"),
    unit!("saw_shaft"),
    unit!("shaft"),
    unit!("spring_damper"),
    unit!("sprung_mass"),
    unit!("stop"),
    unit!("stop_smooth"),
    unit!("technological_load"),
    unit!("three_pendulums"),
    unit!("three_pendulums_relative"),
    unit!("winding_pair"),
    unit!("yarn_layer"),
    unit!("yarn_layer_cubic"),
    unit!("yarn_layer_one_sided"),
    part!("control/lag"),
    part!("control/pi_controller"),
    part!("electrical/capacitor"),
    part!("electrical/current_source"),
    part!("electrical/dc_motor"),
    part!("electrical/ground"),
    part!("electrical/inductor"),
    part!("electrical/pmsm"),
    part!("electrical/resistor"),
    part!("electrical/voltage_source"),
    part!("planar/anchor"),
    part!("planar/body"),
    part!("planar/circle_contact"),
    part!("planar/line_contact"),
    part!("planar/link"),
    part!("planar/on_circle"),
    part!("planar/on_line"),
    part!("planar/particle"),
    part!("planar/point"),
    part!("planar/prismatic"),
    part!("planar/revolute"),
    part!("planar/rod"),
    part!("planar/slot"),
    part!("planar/spring_damper"),
    part!("rotational/backlash"),
    part!("rotational/bearing_friction"),
    part!("rotational/belt"),
    part!("rotational/brake"),
    part!("rotational/cardan"),
    part!("rotational/clutch"),
    part!("rotational/damper"),
    part!("rotational/differential"),
    part!("rotational/fixed"),
    part!("rotational/gear"),
    part!("rotational/gearbox"),
    part!("rotational/inertia"),
    part!("rotational/nonlinear_spring"),
    part!("rotational/one_way_clutch"),
    part!("rotational/planetary"),
    part!("rotational/rack"),
    part!("rotational/screw"),
    part!("rotational/smooth_friction"),
    part!("rotational/spring"),
    part!("rotational/spring_damper"),
    part!("rotational/unbalance"),
    part!("rotational/wheel"),
    part!("sources/angle"),
    part!("sources/eddy_brake"),
    part!("sources/fan"),
    part!("sources/force"),
    part!("sources/linear_speed"),
    part!("sources/position"),
    part!("sources/pump"),
    part!("sources/relative_force"),
    part!("sources/relative_torque"),
    part!("sources/speed"),
    part!("sources/torque"),
    part!("translational/brake"),
    part!("translational/damper"),
    part!("translational/elastic_gap"),
    part!("translational/end_stops"),
    part!("translational/fixed"),
    part!("translational/friction"),
    part!("translational/gear"),
    part!("translational/lever"),
    part!("translational/mass"),
    part!("translational/nonlinear_spring"),
    part!("translational/rope"),
    part!("translational/sliding_mass"),
    part!("translational/smooth_friction"),
    part!("translational/spring"),
    part!("translational/spring_damper"),
];
