//! The straight line, from spec text to a program ready to be emitted.
//!
//! ```text
//! spec text -> SceneSpec -> LagrangianSystem -> EquationsOfMotion
//!   -> EquationsOfMotion of what is needed -> Linearization -> Program -> emitted Rust
//! ```

use std::path::Path;

use crate::cas::{Cas, session};
use crate::density::FieldEquations;
use crate::diagnostic::Diagnostics;
use crate::lagrange::{self, EquationsOfMotion};
use crate::linearize::{Linearization, linearize};
use crate::program::Program;
use crate::reduce::{FreezeError, Keep, reduce};
use crate::system::LagrangianSystem;
use crate::{density, lower, scene, spec};

/// A scene file to its program, of the whole scene or of what its outputs need.
///
/// # Errors
/// With file, line, span and hint for whatever is wrong in the spec.
pub fn generate(scene: &Path, keep: Keep) -> Result<Program, Diagnostics> {
    compile(check(scene)?, keep)
}

/// A checked scene to its program.
///
/// # Errors
/// As [`generate`].
pub fn compile(system: LagrangianSystem, keep: Keep) -> Result<Program, Diagnostics> {
    let keep = most(&system, keep);
    let linear = session(move |cas| {
        let equations = lagrange::derive(cas, &system);
        let needed = reduce(cas, &equations, keep)?;
        Ok::<_, FreezeError>(Linear::of(cas, &needed))
    })??;
    Ok(linear.lower())
}

/// What may be left out of a system: what a field holds on to is not seen in the
/// machine's own equations.
fn most(system: &LagrangianSystem, keep: Keep) -> Keep {
    if system.fields.is_empty() { keep } else { Keep::All }
}

/// Equations with their derivatives, of the machine and of its fields.
struct Linear {
    machine: Linearization,
    fields: Vec<FieldEquations>,
}

impl Linear {
    fn of(cas: &mut Cas, equations: &EquationsOfMotion) -> Self {
        let fields = density::derive(cas, &equations.system);
        Linear { machine: linearize(cas, equations), fields }
    }

    fn lower(&self) -> Program {
        let mut program = lower::lower(&self.machine);
        let fields = self.machine.equations.system.fields.iter().zip(&self.fields);
        program.fields =
            fields.map(|(field, equations)| density::lower(field, equations)).collect();
        program
    }
}

/// A scene's programs, of the whole and after each step of reduction.
#[derive(Debug, Clone)]
pub struct Stages {
    /// Nothing left out.
    pub whole: Program,
    /// After each step that changed anything, that step and what is left.
    pub steps: Vec<(Keep, Program)>,
}

impl Stages {
    /// The last of them.
    #[must_use]
    pub fn needed(&self) -> &Program {
        self.steps.last().map_or(&self.whole, |(_, program)| program)
    }
}

/// Equations of a whole scene to its programs, step by step up to `keep`.
///
/// # Errors
/// As [`generate`].
pub fn stages(equations: EquationsOfMotion, keep: Keep) -> Result<Stages, Diagnostics> {
    let keep = most(&equations.system, keep);
    let (whole, steps) = session(move |cas| {
        let mut steps: Vec<(Keep, EquationsOfMotion)> = Vec::new();
        for step in Keep::STEPS.into_iter().filter(|step| *step <= keep) {
            let reduced = reduce(cas, &equations, step)?;
            if *steps.last().map_or(&equations, |(_, last)| last) != reduced {
                steps.push((step, reduced));
            }
        }
        let linear: Vec<_> =
            steps.iter().map(|(step, reduced)| (*step, Linear::of(cas, reduced))).collect();
        Ok::<_, FreezeError>((Linear::of(cas, &equations), linear))
    })??;
    let steps = steps.iter().map(|(step, linear)| (*step, linear.lower()));
    Ok(Stages { whole: whole.lower(), steps: steps.collect() })
}

/// A scene file to one Lagrangian system, names and dimensions checked.
///
/// # Errors
/// As [`generate`].
pub fn check(scene: &Path) -> Result<LagrangianSystem, Diagnostics> {
    let spec = spec::load_scene(scene)?;
    scene::compose(&spec)
}

/// A scene file to its equations of motion, for people to read.
///
/// # Errors
/// As [`generate`].
pub fn derive(scene: &Path) -> Result<EquationsOfMotion, Diagnostics> {
    let system = check(scene)?;
    Ok(session(move |cas| lagrange::derive(cas, &system))?)
}
