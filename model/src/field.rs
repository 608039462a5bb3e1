//! Fields of a machine: one tape for each function at a point.

use machinist_contract::field::{FieldAttachment, FieldPlace, ForceStructure, Variation};
use serde::{Deserialize, Serialize};

use crate::{Dependence, Name, NodeId, Op, Place, Quantity, Tape};

/// f_0 and f_1 of a field where they have nothing in common.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct LocalForces {
    /// f_0.
    pub on_value: Tape,
    /// df_0/du and df_0/du_t.
    pub on_value_jacobian: Tape,
    /// df_0/dt.
    pub on_value_by_time: Tape,
    /// f_1.
    pub on_slope: Tape,
    /// df_1/du_x and df_1/du_xt.
    pub on_slope_jacobian: Tape,
}

/// A port on a field whose u is a coordinate of the machine.
///
/// The machine's part of the node is like any other: it has an inertia and a force,
/// both of which the field computes and hands over.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Attachment {
    /// Its name.
    pub name: Name,
    /// The coordinate; none where the field is held at zero.
    pub coordinate: Option<u32>,
    /// Where that is.
    pub place: Place,
    /// x in the spec \[m\].
    pub x: f64,
    /// The first of the numbers that the field hands over: inertia of the node, force on
    /// it, u_x before it and after it.
    pub handed: u32,
}

impl Attachment {
    /// As simulators describe it, which take what is handed over behind so many
    /// parameters.
    #[must_use]
    pub fn described(&self, parameters: usize) -> FieldAttachment {
        FieldAttachment {
            coordinate: self.coordinate,
            place: match self.place {
                Place::Start => FieldPlace::Start,
                Place::Inside => FieldPlace::Inside,
                Place::End => FieldPlace::End,
            },
            at: self.x,
            handed: parameters as u32 + self.handed,
        }
    }
}

/// What is computed at a point of a field u(x, t). The state of the tapes is \[u, u_x,
/// u_t, u_xt, x\]; forces come in twos, on u and on u_x.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FieldModel {
    /// u, u_x, u_t, u_xt and x.
    pub quantities: [Quantity; 5],
    /// Typical sizes of u and u_t.
    pub scale: [f64; 2],
    /// Its length in the spec \[m\].
    pub length: f64,
    /// Whether the field is held at zero at its start and end.
    pub fixed: [bool; 2],
    /// Elements unless a run says otherwise.
    pub elements: usize,
    /// Order of the elements.
    pub order: usize,
    /// Places at which the machine takes hold of the field, by x.
    pub attachments: Vec<Attachment>,
    /// Parameters that the densities or the places on the field depend on.
    pub parameters: Vec<u32>,
    /// m, of x.
    pub inertia: Tape,
    /// dm/dx, then dm/dp of `parameters`.
    pub inertia_gradient: Tape,
    /// Forces.
    pub force: Tape,
    /// Whether forces are linear in u, u_x, u_t and u_xt, without anything else, and
    /// the same at all times.
    pub is_linear: bool,
    /// Forces one by one, if f_0 depends on neither u_x nor u_xt, and f_1 on nothing but
    /// these and parameters.
    pub local: Option<LocalForces>,
    /// Their derivatives with respect to u, u_x, u_t, u_xt, row by row.
    pub force_jacobian: Tape,
    /// Twos of their derivatives with respect to x, t, and `parameters`.
    pub force_gradient: Tape,
    /// Kinetic, potential.
    pub energy: Tape,
    /// Rate of the potential, power supplied, power dissipated.
    pub power: Tape,
    /// x of the attachments, then the length.
    pub places: Tape,
    /// Their derivatives with respect to `parameters`, row by row.
    pub places_gradient: Tape,
    /// u and u_t at the start, of x.
    pub initial: Tape,
}

impl FieldModel {
    /// Entries of the state of its tapes: u, u_x, u_t, u_xt and x.
    pub const STATES: usize = 5;

    /// What its tapes tell of its forces.
    #[must_use]
    pub fn structure(&self) -> ForceStructure {
        ForceStructure {
            linear: self.is_linear,
            local: self.local.is_some(),
            forces: variations(&self.force),
            derivatives: variations(&self.force_jacobian),
        }
    }

    /// Its functions by name.
    #[must_use]
    pub fn functions(&self) -> Vec<(&'static str, &Tape)> {
        let mut functions = vec![
            ("inertia", &self.inertia),
            ("inertia_gradient", &self.inertia_gradient),
            ("force", &self.force),
            ("force_jacobian", &self.force_jacobian),
            ("force_gradient", &self.force_gradient),
            ("energy", &self.energy),
            ("power", &self.power),
            ("places", &self.places),
            ("places_gradient", &self.places_gradient),
            ("initial", &self.initial),
        ];
        if let Some(local) = &self.local {
            functions.extend([
                ("on_value", &local.on_value),
                ("on_value_jacobian", &local.on_value_jacobian),
                ("on_value_by_time", &local.on_value_by_time),
                ("on_slope", &local.on_slope),
                ("on_slope_jacobian", &local.on_slope_jacobian),
            ]);
        }
        functions
    }
}

/// How the results of a tape vary; N of them. x counts as motion.
fn variations<const N: usize>(tape: &Tape) -> [Variation; N] {
    let dependence = Dependence::of(tape);
    let of = |id: &NodeId| match tape[*id].op {
        Op::Literal(0.0) => Variation::Zero,
        _ if dependence.on_anything(*id) => Variation::Varying,
        _ => Variation::Constant,
    };
    std::array::from_fn(|index| tape.results.get(index).map_or(Variation::Varying, of))
}
