//! Fields of a machine: one tape for each function at a point.

use machinist_contract::field::{FieldAttachment, FieldPlace, ForceStructure, Variation};
use serde::{Deserialize, Serialize};

use crate::{Dependence, Name, NodeId, Op, Place, Quantity, Tape};

/// f_0 and f_1 of a field, for fields in which they share no argument.
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
/// The machine's part of the node is like any other: it has an inertia and a force, both of which
/// the field computes and hands over.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Attachment {
    /// Its name.
    pub name: Name,
    /// Coordinate; `None` if the field is held at zero.
    pub coordinate: Option<u32>,
    /// Place on the field.
    pub place: Place,
    /// x in the spec \[m\].
    pub x: f64,
    /// Index of the first number that the field hands over. They are the inertia of the node, the
    /// force on it, and u_x before and after it.
    pub handed: u32,
}

impl Attachment {
    /// Returns the attachment as simulators describe it, with the values that are handed over
    /// behind the parameters, whose number is `parameters`.
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

/// Functions at a point of a field u(x, t). The state of the tapes is \[u, u_x, u_t, u_xt, x\];
/// forces come in pairs, on u and on u_x.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FieldModel {
    /// u, u_x, u_t, u_xt and x.
    pub quantities: [Quantity; 5],
    /// Typical sizes of u and u_t.
    pub scale: [f64; 2],
    /// Length in the spec \[m\].
    pub length: f64,
    /// True for each end, start and end, at which the field is held at zero.
    pub fixed: [bool; 2],
    /// Default number of elements.
    pub elements: usize,
    /// Order of the elements.
    pub order: usize,
    /// Points at which the machine is attached to the field, by x.
    pub attachments: Vec<Attachment>,
    /// Parameters on which the densities or the places on the field depend.
    pub parameters: Vec<u32>,
    /// m, a function of x.
    pub inertia: Tape,
    /// dm/dx, then dm/dp of `parameters`.
    pub inertia_gradient: Tape,
    /// Forces.
    pub force: Tape,
    /// True if forces are homogeneous and linear in u, u_x, u_t and u_xt, and the same at all
    /// times.
    pub is_linear: bool,
    /// Forces as separate tapes, if f_0 depends on neither u_x nor u_xt, and f_1 only on these and
    /// parameters.
    pub local: Option<LocalForces>,
    /// Derivatives of the forces by u, u_x, u_t and u_xt, row by row.
    pub force_jacobian: Tape,
    /// Derivatives of the forces by x, t and `parameters`, in pairs.
    pub force_gradient: Tape,
    /// Kinetic and potential energy.
    pub energy: Tape,
    /// Rate of the potential energy, power supplied, power dissipated.
    pub power: Tape,
    /// x of the attachments, then the length.
    pub places: Tape,
    /// Derivatives of the places by `parameters`, row by row.
    pub places_gradient: Tape,
    /// u and u_t at the start, functions of x.
    pub initial: Tape,
}

impl FieldModel {
    /// Number of entries of the state of its tapes: u, u_x, u_t, u_xt and x.
    pub const STATES: usize = 5;

    /// Returns the structure of its forces, as its tapes show it.
    #[must_use]
    pub fn structure(&self) -> ForceStructure {
        ForceStructure {
            linear: self.is_linear,
            local: self.local.is_some(),
            forces: variations(&self.force),
            derivatives: variations(&self.force_jacobian),
        }
    }

    /// Returns its functions by name.
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

/// Returns how the `N` results of a tape vary. x counts as motion.
fn variations<const N: usize>(tape: &Tape) -> [Variation; N] {
    let dependence = Dependence::of(tape);
    let of = |id: &NodeId| match tape[*id].op {
        Op::Literal(0.0) => Variation::Zero,
        _ if dependence.on_anything(*id) => Variation::Varying,
        _ => Variation::Constant,
    };
    std::array::from_fn(|index| tape.results.get(index).map_or(Variation::Varying, of))
}
