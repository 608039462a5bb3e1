//! Symbols of units in drawings.

use crate::spec::names::did_you_mean;

/// Symbol of a kind of part in schematics of machines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symbol {
    /// A rotating part with inertia.
    Inertia,
    /// A sliding part with mass.
    Mass,
    /// A body that moves in a plane.
    Body,
    /// A spring.
    Spring,
    /// A damper.
    Damper,
    /// A spring and a damper in parallel.
    SpringDamper,
    /// A spring with play.
    Backlash,
    /// Two meshing gear wheels.
    Gear,
    /// A planetary gear.
    Planetary,
    /// Two pulleys with a belt.
    Belt,
    /// A rope or a yarn.
    Rope,
    /// A wheel or a pinion on a line.
    Wheel,
    /// A screw.
    Screw,
    /// A lever.
    Lever,
    /// A cam and its follower.
    Cam,
    /// A flexible joint.
    Joint,
    /// An elastic shaft.
    Shaft,
    /// A motor.
    Motor,
    /// Two discs that can be pressed together.
    Clutch,
    /// A disc that can be braked.
    Brake,
    /// A freewheel, which turns one way only.
    Freewheel,
    /// Dry friction.
    Friction,
    /// An end stop.
    Stop,
    /// The ground.
    Ground,
    /// A force or a torque.
    Force,
    /// A prescribed motion.
    Motion,
    /// A fan or a pump.
    Fan,
    /// A cylinder with its piston.
    Cylinder,
    /// A controller.
    Controller,
    /// A resistor.
    Resistor,
    /// An inductor.
    Inductor,
    /// A capacitor.
    Capacitor,
    /// A source of voltage.
    VoltageSource,
    /// A source of current.
    CurrentSource,
}

impl Symbol {
    /// All symbols by name.
    pub const ALL: [(&'static str, Self); 34] = [
        ("inertia", Self::Inertia),
        ("mass", Self::Mass),
        ("body", Self::Body),
        ("spring", Self::Spring),
        ("damper", Self::Damper),
        ("spring_damper", Self::SpringDamper),
        ("backlash", Self::Backlash),
        ("gear", Self::Gear),
        ("planetary", Self::Planetary),
        ("belt", Self::Belt),
        ("rope", Self::Rope),
        ("wheel", Self::Wheel),
        ("screw", Self::Screw),
        ("lever", Self::Lever),
        ("cam", Self::Cam),
        ("joint", Self::Joint),
        ("shaft", Self::Shaft),
        ("motor", Self::Motor),
        ("clutch", Self::Clutch),
        ("brake", Self::Brake),
        ("freewheel", Self::Freewheel),
        ("friction", Self::Friction),
        ("stop", Self::Stop),
        ("ground", Self::Ground),
        ("force", Self::Force),
        ("motion", Self::Motion),
        ("fan", Self::Fan),
        ("cylinder", Self::Cylinder),
        ("controller", Self::Controller),
        ("resistor", Self::Resistor),
        ("inductor", Self::Inductor),
        ("capacitor", Self::Capacitor),
        ("voltage_source", Self::VoltageSource),
        ("current_source", Self::CurrentSource),
    ];

    /// Returns the symbol of a name.
    ///
    /// # Errors
    /// Suggested names.
    pub(super) fn of(name: &str) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|(known, _)| *known == name);
        found
            .map(|(_, symbol)| symbol)
            .ok_or_else(|| did_you_mean(name, Self::ALL.into_iter().map(|(known, _)| known)))
    }
}
