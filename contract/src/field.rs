//! Fields: what a scene with distributed parameters offers, and the loops over the
//! elements of a field, which know nothing of the scene.
//!
//! A field u(x, t), 0 <= x <= l, is given by densities of T, V, D and Q. What a scene
//! emits are functions at one point ([`FieldScene`]):
//!
//! ```text
//! m   = d2T/du_t2
//! f_0 = dL/du   - dD/du_t  + Q
//! f_1 = dL/du_x - dD/du_xt
//! ```
//!
//! An element of length h and order p has p + 1 nodes at the Gauss-Lobatto points, at
//! which its energies are integrated too ([`Rule`]). Virtual work gives
//!
//! ```text
//! M_i u_i'' = F_i
//! M_i = sum over elements of h w_i m(x_i)
//! F_i = sum over elements of h w_i f_0(x_i) + sum over points q of w_q f_1(x_q) l_i'(q)
//! ```
//!
//! with l_i' on the unit interval. M is diagonal, and errors of smooth solutions and of
//! frequencies fall with h^(2p).
//!
//! Nodes at which the machine takes hold of the field are coordinates of the machine.
//! The field hands M_i and F_i of such a node to the machine as two of its parameters,
//! and the slopes on both sides of it as two more.
//!
//! Source: Maday, Patera, "Spectral element methods for the incompressible
//! Navier-Stokes equations", 1989; Cohen, "Higher-order numerical methods for
//! transient wave equations", 2002, on the mass at the nodes.

pub use crate::elements::{Element, Elements, Rule, Segment};
use crate::{Quantity, Real, Simulator};

/// Highest order of an element.
pub const MAX_ORDER: usize = 16;

/// Points of an element at most.
pub const MAX_POINTS: usize = MAX_ORDER + 1;

/// Parameters that a field hands to the machine at each attachment: inertia of the
/// node, force on it, slopes before and after it.
pub const HANDED: usize = 4;

/// u, u_x, u_t and u_xt at a point.
pub type FieldPoint<R> = [R; 4];

/// Where on its field an attachment is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FieldPlace {
    /// At x = 0.
    Start,
    /// Between both ends.
    Inside,
    /// At x = l.
    End,
}

/// A place at which the machine takes hold of a field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldAttachment {
    /// Index of the machine's coordinate; none where the field is held at zero.
    pub coordinate: Option<u32>,
    /// Where it is.
    pub place: FieldPlace,
    /// Its x in the spec \[m\].
    pub at: f64,
    /// The first of the [`HANDED`] parameters that the field sets.
    pub handed: u32,
}

/// Names, structure and defaults of a field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldDescription<'a> {
    /// u.
    pub value: Quantity<'a>,
    /// u_t.
    pub rate: Quantity<'a>,
    /// u_x.
    pub slope: Quantity<'a>,
    /// Typical sizes of u and u_t.
    pub scale: [f64; 2],
    /// Whether u = 0 at x = 0 and at x = l.
    pub fixed: [bool; 2],
    /// l in the spec \[m\].
    pub length: f64,
    /// Attachments in the order of their x.
    pub attachments: &'a [FieldAttachment],
    /// Parameters on which anything of the field depends.
    pub parameters: &'a [u32],
    /// Elements unless told otherwise.
    pub elements: usize,
    /// Their order unless told otherwise.
    pub order: usize,
}

/// How a number at a point of a field varies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variation {
    /// It is zero.
    Zero,
    /// Parameters alone decide it.
    Constant,
    /// It depends on motion, place or time.
    Varying,
}

/// What is known of the forces of a field before any number is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ForceStructure {
    /// Whether f_0 and f_1 are linear in u, u_x, u_t and u_xt, without anything else, and
    /// the same at all times.
    pub linear: bool,
    /// Whether f_0 depends on u, u_t, x and t only and f_1 on u_x and u_xt only.
    pub local: bool,
    /// f_0 and f_1.
    pub forces: [Variation; 2],
    /// Derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt.
    pub derivatives: [Variation; 8],
}

impl ForceStructure {
    /// That of any forces.
    pub const UNKNOWN: Self = Self {
        linear: false,
        local: false,
        forces: [Variation::Varying; 2],
        derivatives: [Variation::Varying; 8],
    };

    /// Whether the force on a node depends on u, and whether on u_t, of itself or of the
    /// other nodes of its elements.
    #[must_use]
    pub fn reaches(&self, itself: bool) -> [bool; 2] {
        let of_others = |by: usize| [1, 4, 5].iter().any(|entry| self.is_there(by + entry));
        [0, 2].map(|by| of_others(by) || (itself && self.is_there(by)))
    }

    fn is_there(&self, derivative: usize) -> bool {
        self.derivatives[derivative] != Variation::Zero
    }
}

/// A scene with fields: a machine, and functions at a point of each field. As a
/// [`Simulator`] it is the machine alone, with what the fields hand over among its
/// parameters, after all others.
///
/// `p` holds all parameters of the machine; x is in \[m\]. Slices have the lengths
/// stated, with k the number of [`FieldDescription::parameters`].
///
/// # Panics
/// If there is no field of the number, or a slice has another length than stated.
pub trait FieldScene<R: Real>: Simulator<R> + Sync {
    /// Number of fields.
    fn fields(&self) -> usize;
    /// The `index`-th field.
    fn field(&self, index: usize) -> FieldDescription<'_>;
    /// m.
    fn field_inertia(&self, index: usize, x: R, p: &[R]) -> R;
    /// dm/dx, then dm/dp; 1 + k.
    fn field_inertia_gradient(&self, index: usize, x: R, p: &[R], gradient: &mut [R]);
    /// \[f_0, f_1\].
    fn field_force(&self, index: usize, time: R, x: R, point: &FieldPoint<R>, p: &[R]) -> [R; 2];
    /// Derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt.
    fn field_force_jacobian(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        p: &[R],
    ) -> [R; 8];
    /// Derivatives of f_0 and f_1 with respect to x, then to t, then to p; 2 (2 + k).
    fn field_force_gradient(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        p: &[R],
        gradient: &mut [R],
    );
    /// Kinetic and potential energy a length \[J/m\].
    fn field_energy(&self, index: usize, time: R, x: R, point: &FieldPoint<R>, p: &[R]) -> [R; 2];
    /// Rate of the potential energy, power supplied and power dissipated, a length
    /// \[W/m\].
    fn field_power(&self, index: usize, time: R, x: R, point: &FieldPoint<R>, p: &[R]) -> [R; 3];
    /// x of the attachments, then l.
    fn field_places(&self, index: usize, p: &[R], places: &mut [R]);
    /// Their derivatives with respect to p, row by row.
    fn field_places_gradient(&self, index: usize, p: &[R], gradient: &mut [R]);
    /// u and u_t at the start.
    fn field_initial(&self, index: usize, x: R, p: &[R]) -> [R; 2];

    /// Whether the machine's Jacobian or time derivative depends on forces that fields hand
    /// over, as where inertia moves.
    fn jacobian_reads_forces(&self) -> bool {
        true
    }
    /// What is known of its forces. Where they are local, each may be asked for alone, at
    /// many points in one call: by the functions below, which mean nothing for any other
    /// field. Slices are as long as there are points.
    fn force_structure(&self, _index: usize) -> ForceStructure {
        ForceStructure::UNKNOWN
    }
    /// m at many places.
    fn field_inertias(&self, index: usize, x: &[R], p: &[R], inertias: &mut [R]) {
        for (inertia, x) in inertias.iter_mut().zip(x) {
            *inertia = self.field_inertia(index, *x, p);
        }
    }
    /// f_0 where x, u and u_t are these.
    fn field_forces_on_values(
        &self,
        index: usize,
        time: R,
        [x, u, u_t]: [&[R]; 3],
        p: &[R],
        forces: &mut [R],
    ) {
        let zero = R::literal(0.0);
        for (((force, x), u), u_t) in forces.iter_mut().zip(x).zip(u).zip(u_t) {
            *force = self.field_force(index, time, *x, &[*u, zero, *u_t, zero], p)[0];
        }
    }
    /// df_0/du and df_0/du_t.
    fn field_forces_on_values_jacobian(
        &self,
        index: usize,
        time: R,
        [x, u, u_t]: [&[R]; 3],
        p: &[R],
        [by_u, by_u_t]: [&mut [R]; 2],
    ) {
        let zero = R::literal(0.0);
        let points = x.iter().zip(u).zip(u_t);
        for (((x, u), u_t), (by_u, by_u_t)) in points.zip(by_u.iter_mut().zip(by_u_t)) {
            let by = self.field_force_jacobian(index, time, *x, &[*u, zero, *u_t, zero], p);
            (*by_u, *by_u_t) = (by[0], by[2]);
        }
    }
    /// df_0/dt; `gradient` is room for one of [`FieldScene::field_force_gradient`].
    fn field_forces_on_values_by_time(
        &self,
        index: usize,
        time: R,
        [x, u, u_t]: [&[R]; 3],
        p: &[R],
        (gradient, by_time): (&mut [R], &mut [R]),
    ) {
        let zero = R::literal(0.0);
        for (((by_time, x), u), u_t) in by_time.iter_mut().zip(x).zip(u).zip(u_t) {
            self.field_force_gradient(index, time, *x, &[*u, zero, *u_t, zero], p, gradient);
            *by_time = gradient[2];
        }
    }
    /// f_1 where u_x and u_xt are these.
    fn field_forces_on_slopes(
        &self,
        index: usize,
        [u_x, u_xt]: [&[R]; 2],
        p: &[R],
        forces: &mut [R],
    ) {
        let zero = R::literal(0.0);
        for ((force, u_x), u_xt) in forces.iter_mut().zip(u_x).zip(u_xt) {
            *force = self.field_force(index, zero, zero, &[zero, *u_x, zero, *u_xt], p)[1];
        }
    }
    /// df_1/du_x and df_1/du_xt.
    fn field_forces_on_slopes_jacobian(
        &self,
        index: usize,
        [u_x, u_xt]: [&[R]; 2],
        p: &[R],
        [by_u_x, by_u_xt]: [&mut [R]; 2],
    ) {
        let zero = R::literal(0.0);
        for ((u_x, u_xt), (by_u_x, by_u_xt)) in
            u_x.iter().zip(u_xt).zip(by_u_x.iter_mut().zip(by_u_xt))
        {
            let by = self.field_force_jacobian(index, zero, zero, &[zero, *u_x, zero, *u_xt], p);
            (*by_u_x, *by_u_xt) = (by[5], by[7]);
        }
    }
}

/// What an emitted scene says to a number that none of its fields has.
///
/// # Panics
/// Always.
#[cold]
pub fn no_field(index: usize) -> ! {
    panic!("there is no field of number {index}")
}
