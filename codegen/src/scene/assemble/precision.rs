//! Approximations allowed by the scene: parameters that runs may change, and units that may be
//! rigid.

use crate::scene::assemble::Assembler;
use crate::scene::layout::{Local, Scope, find_instance};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Spanned};
use crate::spec::{did_you_mean, quoted};
use machinist_model::Freeze;

impl Assembler<'_> {
    /// Reports, for each parameter, whether runs may change it. All may, if the scene lists none.
    /// Parameters of the scene come first.
    pub(super) fn tunable(&mut self) -> Vec<bool> {
        let Some(names) = &self.spec.tunable else { return vec![true; self.values.len()] };
        let mut tunable = vec![false; self.values.len()];
        for name in names {
            match self.tunable_parameter(name) {
                Ok(index) if tunable[index] => {
                    let message = format!("parameter {} is listed twice", quoted(&name.value));
                    self.mistakes.push(Mistake::new(
                        Code::DuplicateName,
                        name.span,
                        message,
                        "listed again",
                    ));
                }
                Ok(index) => tunable[index] = true,
                Err(mistake) => self.mistakes.push(*mistake),
            }
        }
        tunable
    }

    /// Returns the instances that are approximated as rigid, each known and named once.
    pub(super) fn freeze(&mut self) -> Freeze {
        let mut freeze = Freeze { tolerance: self.spec.freeze_tolerance, ..Freeze::default() };
        for name in &self.spec.rigid {
            if let Err(mistake) = find_instance(self.spec, &name.value, name.span) {
                self.mistakes.push(*mistake);
            } else if freeze.rigid.contains(&name.value) {
                let message = format!("{} is frozen twice", quoted(&name.value));
                self.mistakes.push(Mistake::new(Code::DuplicateName, name.span, message, "again"));
            } else {
                freeze.rigid.push(name.value.clone());
            }
        }
        freeze
    }

    fn tunable_parameter(&self, path: &Spanned<String>) -> Result<usize, Box<Mistake>> {
        let (scope, names, name) = match path.value.rsplit_once('.') {
            None => (Scope::Scene, &self.layout.scene, path.value.as_str()),
            Some((instance, name)) => {
                let instance = find_instance(self.spec, instance, path.span)?;
                let unit = self.spec.instances[instance].unit;
                (Scope::Instance(instance), &self.layout.units[unit], name)
            }
        };
        if let Some(Local::Parameter(index)) = names.get(name) {
            if let Some(id) = self.layout.parameter(scope, index) {
                return Ok(id.0 as usize);
            }
            let message = format!("{} is given by an expression", quoted(&path.value));
            let mistake = Mistake::new(Code::WrongKindOfName, path.span, message, "follows others");
            return Err(Box::new(mistake.help("list the parameters that it depends on")));
        }
        let known =
            names.iter().filter(|known| matches!(names.get(known), Some(Local::Parameter(_))));
        let message = format!("{} is not a parameter", quoted(&path.value));
        let label = if names.get(name).is_some() { "not a parameter" } else { "unknown" };
        let help = match scope {
            Scope::Scene if names.get(name).is_none() => {
                let help = did_you_mean(name, known);
                format!("{help}\na parameter of a unit is written \"instance.name\"")
            }
            _ => did_you_mean(name, known),
        };
        Err(Box::new(
            Mistake::new(Code::WrongKindOfName, path.span, message, label).help(help.trim_start()),
        ))
    }
}
