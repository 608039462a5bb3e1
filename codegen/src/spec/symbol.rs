//! What a unit is drawn as.

use crate::spec::names::did_you_mean;

/// A picture for a kind of part, in schematics of machines.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symbol {
    /// Something that turns and has inertia.
    Inertia,
    /// Something that slides and has mass.
    Mass,
    /// A body that moves in a plane.
    Body,
    /// A spring.
    Spring,
    /// A damper.
    Damper,
    /// Both beside each other.
    SpringDamper,
    /// A spring with play.
    Backlash,
    /// Two wheels that mesh.
    Gear,
    /// Wheels within wheels.
    Planetary,
    /// Two pulleys and what runs around them.
    Belt,
    /// A rope or a yarn.
    Rope,
    /// A wheel or a pinion on a line.
    Wheel,
    /// A screw.
    Screw,
    /// A lever.
    Lever,
    /// A cam and what follows it.
    Cam,
    /// A joint that bends.
    Joint,
    /// An elastic shaft.
    Shaft,
    /// A motor.
    Motor,
    /// Two discs that can be pressed together.
    Clutch,
    /// A disc that can be held.
    Brake,
    /// What turns one way only.
    Freewheel,
    /// What rubs.
    Friction,
    /// What something runs against.
    Stop,
    /// What holds.
    Ground,
    /// A force or a torque.
    Force,
    /// A motion that is imposed.
    Motion,
    /// A fan or a pump.
    Fan,
    /// A cylinder with its piston.
    Cylinder,
    /// What measures and commands.
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
    /// All of them by name.
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

    /// The symbol of a name.
    ///
    /// # Errors
    /// Names that may be meant.
    pub(super) fn of(name: &str) -> Result<Self, String> {
        let found = Self::ALL.into_iter().find(|(known, _)| *known == name);
        found
            .map(|(_, symbol)| symbol)
            .ok_or_else(|| did_you_mean(name, Self::ALL.into_iter().map(|(known, _)| known)))
    }
}
