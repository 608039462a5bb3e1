//! The text of this crate, for who compiles an emitted scene without Cargo.

/// Files of this crate: path below `src`, text.
pub const SOURCES: &[(&str, &str)] = &[
    ("lib.rs", include_str!("lib.rs")),
    ("contract.rs", include_str!("contract.rs")),
    ("digits.rs", include_str!("digits.rs")),
    ("dual.rs", include_str!("dual.rs")),
    ("elements.rs", include_str!("elements.rs")),
    ("emitted.rs", include_str!("emitted.rs")),
    ("exponential.rs", include_str!("exponential.rs")),
    ("functions.rs", include_str!("functions.rs")),
    ("include.rs", include_str!("include.rs")),
    ("pair.rs", include_str!("pair.rs")),
    ("real.rs", include_str!("real.rs")),
    ("side_by_side.rs", include_str!("side_by_side.rs")),
    ("simulator.rs", include_str!("simulator.rs")),
    ("sine.rs", include_str!("sine.rs")),
    ("sources.rs", include_str!("sources.rs")),
    ("table.rs", include_str!("table.rs")),
    ("field.rs", include_str!("field.rs")),
    ("field_scene.rs", include_str!("field_scene.rs")),
    ("implicit.rs", include_str!("implicit.rs")),
    ("linear.rs", include_str!("linear.rs")),
    ("taylor.rs", include_str!("taylor.rs")),
];
