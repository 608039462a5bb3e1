//! The units and scenes that come with Machinist.

/// A unit that comes with Machinist.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LibraryUnit {
    /// Name in scenes, with its folder: `rotational/gear`.
    pub name: &'static str,
    /// Its spec.
    pub text: &'static str,
    /// A short example scene; every standard part has one.
    pub example: Option<&'static str>,
}

macro_rules! unit {
    ($name:literal) => {
        LibraryUnit {
            name: $name,
            text: include_str!(concat!(env!("MACHINIST_SPECS"), "/units/", $name, ".toml")),
            example: None,
        }
    };
}

macro_rules! part {
    ($name:literal) => {
        LibraryUnit {
            name: $name,
            text: include_str!(concat!(env!("MACHINIST_SPECS"), "/units/", $name, ".toml")),
            example: Some(include_str!(concat!(
                env!("MACHINIST_SPECS"),
                "/scenes/parts/",
                $name,
                ".toml"
            ))),
        }
    };
}

/// All units that come with Machinist. Standard parts are in folders by kind, and have examples.
pub const LIBRARY: &[LibraryUnit] = &[
    unit!("bouncer"),
    unit!("coupling"),
    unit!("friction_slider"),
    unit!("friction_slider_smooth"),
    unit!("one_sided_contact"),
    unit!("planar_body"),
    unit!("point_mass"),
    unit!("rotor"),
    unit!("shaft"),
    unit!("spring_damper"),
    unit!("sprung_mass"),
    unit!("stop"),
    unit!("stop_smooth"),
    unit!("three_pendulums"),
    unit!("three_pendulums_relative"),
    unit!("textile/bobbin_holder"),
    unit!("textile/bobbin_holder_as_printed"),
    unit!("textile/cloth_fell_contact"),
    unit!("textile/cloth_fell_one_sided"),
    unit!("textile/imposed_drive"),
    unit!("textile/induction_motor"),
    unit!("textile/induction_motor_as_printed"),
    unit!("textile/induction_motor_stationary"),
    unit!("textile/loom_shaft"),
    unit!("textile/pressed_bobbin"),
    unit!("textile/reed"),
    unit!("textile/saw_shaft"),
    unit!("textile/technological_load"),
    unit!("textile/winding_pair"),
    unit!("textile/yarn_layer"),
    unit!("textile/yarn_layer_as_printed"),
    unit!("textile/yarn_layer_cubic"),
    unit!("textile/yarn_layer_one_sided"),
    part!("control/lag"),
    part!("control/pi_controller"),
    part!("control/pid_controller"),
    part!("control/rate_limiter"),
    part!("control/relay"),
    part!("electrical/amplifier"),
    part!("electrical/battery"),
    part!("electrical/capacitor"),
    part!("electrical/chopper"),
    part!("electrical/converter"),
    part!("electrical/current_source"),
    part!("electrical/dc_machine"),
    part!("electrical/dc_motor"),
    part!("electrical/ground"),
    part!("electrical/heated_resistor"),
    part!("electrical/induction_motor"),
    part!("electrical/inductor"),
    part!("electrical/pmsm"),
    part!("electrical/pmsm_machine"),
    part!("electrical/rectifier"),
    part!("electrical/resistor"),
    part!("electrical/voltage_source"),
    part!("hydraulic/cylinder"),
    part!("hydraulic/valve"),
    part!("planar/anchor"),
    part!("planar/body"),
    part!("planar/circle_contact"),
    part!("planar/fixed"),
    part!("planar/four_bar"),
    part!("planar/line_contact"),
    part!("planar/link"),
    part!("planar/on_circle"),
    part!("planar/on_line"),
    part!("planar/particle"),
    part!("planar/point"),
    part!("planar/prismatic"),
    part!("planar/revolute"),
    part!("planar/rod"),
    part!("planar/rough_slot"),
    part!("planar/slider_crank"),
    part!("planar/slot"),
    part!("planar/spring_damper"),
    part!("rotational/backlash"),
    part!("rotational/bearing_friction"),
    part!("rotational/belt"),
    part!("rotational/brake"),
    part!("rotational/cam"),
    part!("rotational/cardan"),
    part!("rotational/chain"),
    part!("rotational/clutch"),
    part!("rotational/conveyor"),
    part!("rotational/crank_drive"),
    part!("rotational/damper"),
    part!("rotational/differential"),
    part!("rotational/dwell_cam"),
    part!("rotational/end_stops"),
    part!("rotational/fixed"),
    part!("rotational/fluid_coupling"),
    part!("rotational/gear"),
    part!("rotational/gear_drive"),
    part!("rotational/gearbox"),
    part!("rotational/gear_mesh"),
    part!("rotational/gear_pair"),
    part!("rotational/heated_friction"),
    part!("rotational/inertia"),
    part!("rotational/lossy_gear"),
    part!("rotational/lugre_friction"),
    part!("rotational/nonlinear_spring"),
    part!("rotational/one_way_clutch"),
    part!("rotational/planetary"),
    part!("rotational/rack"),
    part!("rotational/rigid_lossy_gear"),
    part!("rotational/rope_drum"),
    part!("rotational/screw"),
    part!("rotational/slipping_belt"),
    part!("rotational/smooth_friction"),
    part!("rotational/spring"),
    part!("rotational/spring_damper"),
    part!("rotational/table_cam"),
    part!("rotational/torque_limiter"),
    part!("rotational/unbalance"),
    part!("rotational/wheel"),
    part!("sources/angle"),
    part!("sources/crank_load"),
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
    part!("spatial/bar"),
    part!("spatial/bevel_gear"),
    part!("spatial/body"),
    part!("spatial/bushing"),
    part!("spatial/central_gravity"),
    part!("spatial/cylinder"),
    part!("spatial/cylindrical"),
    part!("spatial/force"),
    part!("spatial/free"),
    part!("spatial/motion"),
    part!("spatial/planar"),
    part!("spatial/prismatic"),
    part!("spatial/revolute"),
    part!("spatial/revolute_constraint"),
    part!("spatial/rod"),
    part!("spatial/rolling_wheel"),
    part!("spatial/rotation"),
    part!("spatial/screw"),
    part!("spatial/sphere"),
    part!("spatial/spherical"),
    part!("spatial/spherical_constraint"),
    part!("spatial/spring_damper"),
    part!("spatial/spur_gear"),
    part!("spatial/torque"),
    part!("spatial/translation"),
    part!("spatial/universal"),
    part!("spatial/universal_constraint"),
    part!("spatial/wheel_set"),
    part!("spatial/world"),
    part!("thermal/conductor"),
    part!("thermal/convection"),
    part!("thermal/heat_capacitor"),
    part!("translational/anchor"),
    part!("translational/brake"),
    part!("translational/capstan"),
    part!("translational/damper"),
    part!("translational/elastic_gap"),
    part!("translational/end_stops"),
    part!("translational/fixed"),
    part!("translational/friction"),
    part!("translational/gear"),
    part!("translational/hoisted_load"),
    part!("translational/lever"),
    part!("translational/long_mass"),
    part!("translational/lugre_friction"),
    part!("translational/mass"),
    part!("translational/nonlinear_spring"),
    part!("translational/rope"),
    part!("translational/sliding_mass"),
    part!("translational/smooth_friction"),
    part!("translational/spring"),
    part!("translational/spring_damper"),
    part!("translational/weight"),
];

/// A scene that comes with Machinist.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LibraryScene {
    /// Name in commands.
    pub name: &'static str,
    /// Label of its file in messages and headers: `scenes/saw_gin.toml`.
    pub label: &'static str,
    /// Its spec. All of its units come with Machinist.
    pub text: &'static str,
}

impl LibraryScene {
    /// Finds the scene of a name.
    #[must_use]
    pub fn find(name: &str) -> Option<&'static Self> {
        SCENES.iter().chain(MACHINES).find(|scene| scene.name == name)
    }
}

macro_rules! scene {
    ($name:literal) => {
        LibraryScene {
            name: $name,
            label: concat!("scenes/", $name, ".toml"),
            text: include_str!(concat!(env!("MACHINIST_SPECS"), "/scenes/", $name, ".toml")),
        }
    };
    (in $folder:literal, $name:literal) => {
        LibraryScene {
            name: $name,
            label: concat!($folder, "/", $name, ".toml"),
            text: include_str!(concat!(
                env!("MACHINIST_SPECS"),
                "/scenes/",
                $folder,
                "/",
                $name,
                ".toml"
            )),
        }
    };
    (bench $name:literal) => {
        LibraryScene {
            name: $name,
            label: concat!("bench/", $name, ".toml"),
            text: include_str!(concat!(env!("MACHINIST_SPECS"), "/scenes/bench/", $name, ".toml")),
        }
    };
}

/// Machines of standard parts that come with Machinist and are derived when they run: those in the
/// folders `drives` and `gallery` of `specs/scenes`.
pub const MACHINES: &[LibraryScene] = &[
    scene!(in "drives", "press"),
    scene!(in "drives", "shaft_crank"),
    scene!(in "drives", "winch"),
    scene!(in "drives", "winder_elastic_slip"),
    scene!(in "drives", "winder_turning_drum"),
    scene!(in "gallery", "bicycle"),
    scene!(in "gallery", "conveyor"),
    scene!(in "gallery", "crane"),
    scene!(in "gallery", "engine"),
    scene!(in "gallery", "motor"),
    scene!(in "gallery", "pendulum"),
    scene!(in "gallery", "pump"),
    scene!(in "gallery", "robot_arm"),
    scene!(in "gallery", "washing_machine"),
    scene!(in "gallery", "wind_turbine"),
];

/// All emitted scenes that come with Machinist: those in `specs/scenes` and in its folder `bench`.
pub const SCENES: &[LibraryScene] = &[
    scene!("bouncing_mass"),
    scene!("contact_oscillator"),
    scene!("contact_oscillator_smooth"),
    scene!("coulomb_oscillator"),
    scene!("four_bar"),
    scene!("loom_drive"),
    scene!("motor_run_up"),
    scene!("motor_stationary_axes"),
    scene!("pendulum_chain"),
    scene!("pendulum_constrained"),
    scene!("pendulum_relative"),
    scene!("reed_beat_up"),
    scene!("reed_beat_up_one_sided"),
    scene!("saw_gin"),
    scene!("saw_gin_as_printed"),
    scene!("saw_gin_shaft"),
    scene!("shaft_step_torque"),
    scene!("shaft_with_rotors"),
    scene!("slider_crank"),
    scene!("stick_slip"),
    scene!("stick_slip_smooth"),
    scene!("two_mass"),
    scene!("winder_full"),
    scene!("winder_holder_drop"),
    scene!("winder_linear"),
    scene!("winder_linear_as_printed"),
    scene!("winder_linkage"),
    scene!("winder_nonlinear"),
    scene!(bench "m1"),
    scene!(bench "m2"),
    scene!(bench "m3"),
    scene!(bench "m3_10"),
    scene!(bench "m4"),
    scene!(bench "m4_7"),
    scene!(bench "m5"),
    scene!(bench "m6_10"),
    scene!(bench "m6_2"),
    scene!(bench "m6_5"),
];
