//! Outlines of symbols, 48 wide and 28 high.

use machinist_codegen::spec::Symbol;

/// Returns the outline as an SVG path.
pub(super) fn outline(symbol: Symbol) -> &'static str {
    match symbol {
        Symbol::Inertia => "M2 14H14M34 14H46M14 2H34V26H14Z",
        Symbol::Mass => "M12 4H36V22H12ZM4 26H44M16 22V26M32 22V26",
        Symbol::Body => "M14 6a6 6 0 1 0 1 11L33 24a6 6 0 1 0 1-11Z",
        Symbol::Spring => "M2 14H10l3-9 5 18 5-18 5 18 5-18 3 9H46",
        Symbol::Damper => "M2 14H18M34 5H18V23H34M46 14H28M28 8V20",
        Symbol::SpringDamper => {
            "M2 14H8M8 6V22M40 6V22M40 14H46M8 6H13l2-4 4 8 4-8 4 8 4-8 2 4H40M8 22H20M30 17H20V27H30M40 22H26M26 19V25"
        }
        Symbol::Backlash => "M2 14H18M18 6V22M30 6V22M30 14H46M21 3H18V6M27 25H30V22",
        Symbol::Gear => {
            "M10 14a8 8 0 1 0 16 0a8 8 0 1 0-16 0M26 14a5 5 0 1 0 10 0a5 5 0 1 0-10 0M18 14h.1M31 14h.1"
        }
        Symbol::Planetary => {
            "M11 14a13 13 0 1 0 26 0a13 13 0 1 0-26 0M20 14a4 4 0 1 0 8 0a4 4 0 1 0-8 0M20.500 6a3.500 3.500 0 1 0 7 0a3.500 3.500 0 1 0-7 0M20.500 22a3.500 3.500 0 1 0 7 0a3.500 3.500 0 1 0-7 0"
        }
        Symbol::Belt => {
            "M5 14a7 7 0 1 0 14 0a7 7 0 1 0-14 0M32 14a5 5 0 1 0 10 0a5 5 0 1 0-10 0M12 7L37 9M12 21L37 19"
        }
        Symbol::Rope => "M2 14c5-8 9-8 12 0s7 8 11 0s7-8 10 0s6 6 11 0",
        Symbol::Wheel => {
            "M14 13a10 10 0 1 0 20 0a10 10 0 1 0-20 0M24 13h.1M4 25H44M8 25l-3 3M18 25l-3 3M28 25l-3 3M38 25l-3 3"
        }
        Symbol::Screw => {
            "M2 14H10M38 14H46M10 8H38V20H10ZM10 20l4-12M17 20l4-12M24 20l4-12M31 20l4-12"
        }
        Symbol::Lever => "M4 18L44 6M24 12l-6 12h12Z",
        Symbol::Cam => {
            "M12 18a8 8 0 1 0 14 3C32 15 30 9 24 10c-6 0-11 3-12 8M19 18h.1M27 9V2M22 2H32"
        }
        Symbol::Joint => "M2 20H18M30 14L46 4M18 14V26M30 8V20M18 14L30 20M18 26L30 8",
        Symbol::Shaft => {
            "M4 9H44M4 19H44M4 9c-3 3-3 7 0 10M44 9c3 3 3 7 0 10M10 19l8-10M20 19l8-10M30 19l8-10"
        }
        Symbol::Motor => "M12 14a12 12 0 1 0 24 0a12 12 0 1 0-24 0M36 14H46M19 19V9l5 6 5-6V19",
        Symbol::Clutch => "M2 14H19M19 3V25M29 3V25M29 14H46M22 8h4M22 20h4",
        Symbol::Brake => "M2 14H24M24 4V24M30 4V11M30 17V24M30 7H40M30 21H40M40 4V24",
        Symbol::Freewheel => "M2 14H16M16 4V24M32 4V24M32 14H46M20 9l8 5-8 5Z",
        Symbol::Friction => "M12 4H36V17H12ZM4 20l4-3 4 3 4-3 4 3 4-3 4 3 4-3 4 3 4-3 4 3M4 25H44",
        Symbol::Stop => "M4 14H28M24 9l5 5-5 5M34 2V26M34 6l7-4M34 12l7-4M34 18l7-4M34 24l7-4",
        Symbol::Ground => "M24 2V14M10 14H38M12 22l5-8M20 22l5-8M28 22l5-8M36 22l4-8",
        Symbol::Force => "M4 14H40M33 7l8 7-8 7",
        Symbol::Motion => "M6 4V24M6 14H36M29 8l8 6-8 6M42 4V24",
        Symbol::Fan => {
            "M24 14c-4-6-4-11 0-12s4 6 0 12c6-3 11-2 11 2s-6 3-11-2c-1 7-4 11-8 10s0-8 8-10"
        }
        Symbol::Cylinder => "M4 5H34V23H4ZM16 5V23M16 14H46",
        Symbol::Controller => "M10 3H38V25H10ZM14 20c5 0 4-11 9-11s4 4 11 3M2 14H10M38 14H46",
        Symbol::Resistor => "M2 14H10M38 14H46M10 8H38V20H10Z",
        Symbol::Inductor => "M2 16H8c0-12 8-12 8 0c0-12 8-12 8 0c0-12 8-12 8 0c0-12 8-12 8 0H46",
        Symbol::Capacitor => "M2 14H21M21 3V25M27 3V25M27 14H46",
        Symbol::VoltageSource => {
            "M2 14H12M36 14H46M12 14a12 12 0 1 0 24 0a12 12 0 1 0-24 0M16 14c3-7 6-7 8 0s5 7 8 0"
        }
        Symbol::CurrentSource => {
            "M2 14H12M36 14H46M12 14a12 12 0 1 0 24 0a12 12 0 1 0-24 0M17 14H31M26 9l5 5-5 5"
        }
    }
}
