//! Composition of units into one checked system.
//!
//! Excluded: text, which [`crate::spec`] has read, and calculus, which is part of the derivation.
//! The result has no names to resolve, no joints and no dimensions.

pub(crate) mod along;
mod assemble;
mod attachments;
mod bodies;
mod closing;
mod drawing;
mod evaluate;
mod frame_part;
mod frames;
mod functions;
mod joints;
mod layout;
mod lookup;
mod loops;
mod massless;
mod motion_laws;
mod names;
mod parameters;
mod pieces;
mod ports;
mod reactions;
mod resolve;
pub mod scatter;
mod spline;
pub mod system;
mod tables;
mod typed;
mod vectors;

pub(crate) use evaluate::evaluate;

use std::collections::BTreeSet;

use crate::scene::system::LagrangianSystem;
use crate::spec::SceneSpec;
use crate::spec::diagnostic::{Diagnostic, Diagnostics, Mistake};
use crate::spec::stack;
use machinist_algebra::expr::ParameterId;

/// Checks a scene and composes its units: instances get their parameters and inputs, joined
/// coordinates become one, energies are summed, forces act by virtual work.
///
/// # Errors
/// All mistakes in the spec that its text alone does not show, each at the wrong term or name;
/// see "What is checked" of the spec language.
pub fn compose(spec: &SceneSpec) -> Result<LagrangianSystem, Diagnostics> {
    stack::with_room(|| join(spec)).map_err(|_| Diagnostic::no_thread())?
}

fn join(spec: &SceneSpec) -> Result<LagrangianSystem, Diagnostics> {
    // Coordinates of joints that close loops are left out, unless something mentions them. This
    // shows only when all expressions are resolved.
    let mut kept = BTreeSet::new();
    loop {
        let mut missed = BTreeSet::new();
        let joined = joined(spec, &kept, &mut missed);
        if missed.is_subset(&kept) {
            return joined;
        }
        kept.append(&mut missed);
    }
}

/// Composes a scene whose joints keep some coordinates; `missed` receives others that it needs.
fn joined(
    spec: &SceneSpec,
    kept: &BTreeSet<usize>,
    missed: &mut BTreeSet<usize>,
) -> Result<LagrangianSystem, Diagnostics> {
    let mut mistakes = Vec::new();
    let mut layout = layout::Layout::new(spec, &mut mistakes);
    let values = parameters::values(spec, &layout, &mut mistakes);
    stop_at(spec, &mistakes)?;
    let parameter = |id: ParameterId| values[id.0 as usize];
    attachments::locate(spec, &mut layout, &parameter, &mut mistakes);
    stop_at(spec, &mistakes)?;
    joints::identify(spec, &mut layout, &parameter, kept, &mut mistakes);
    stop_at(spec, &mistakes)?;
    let system = assemble::assemble(spec, &layout, &values, &mut mistakes);
    *missed = layout.missed();
    stop_at(spec, &mistakes)?;
    Ok(system)
}

fn stop_at(spec: &SceneSpec, mistakes: &[Mistake]) -> Result<(), Diagnostics> {
    if mistakes.is_empty() { Ok(()) } else { Err(spec.sources.diagnostics(mistakes)) }
}
