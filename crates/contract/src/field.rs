//! Fields: the interface of a scene with distributed parameters, and loops over the elements of a
//! field that are independent of the scene.
//!
//! A field u(x, t), 0 <= x <= l, is given by densities of T, V, D and Q. A scene emits functions
//! at one point ([`FieldScene`]):
//!
//! ```text
//! m   = d2T/du_t2
//! f_0 = dL/du   - dD/du_t  + Q
//! f_1 = dL/du_x - dD/du_xt
//! ```
//!
//! An element of length h and order p has p + 1 nodes at the Gauss-Lobatto points, where its
//! energies are integrated too ([`Rule`]). Virtual work gives
//!
//! ```text
//! M_i u_i'' = F_i
//! M_i = sum over elements of h w_i m(x_i)
//! F_i = sum over elements of h w_i f_0(x_i) + sum over points q of w_q f_1(x_q) l_i'(q)
//! ```
//!
//! with l_i' on the unit interval. M is diagonal. Errors of smooth solutions and of frequencies
//! decrease with h^(2p).
//!
//! Nodes at which the machine is attached to the field are coordinates of the machine. The field
//! passes M_i and F_i of such a node to the machine as two of its parameters, and the slopes on
//! both sides of it as two more.
//!
//! Source: Maday, Patera, "Spectral element methods for the incompressible Navier-Stokes
//! equations", 1989; for the mass at the nodes, Cohen, "Higher-order numerical methods for
//! transient wave equations", 2002.

pub use crate::elements::{Division, Element, Elements, Rule, Segment};
use crate::{Quantity, Real, Simulator};

/// Highest order of an element.
pub const MAX_ORDER: usize = 16;

/// Maximum number of points of an element.
pub const MAX_POINTS: usize = MAX_ORDER + 1;

/// Number of parameters that a field passes to the machine at each attachment: inertia of the
/// node, force on it, slopes before and after it.
pub const HANDED: usize = 4;

/// u, u_x, u_t and u_xt at a point.
pub type FieldPoint<R> = [R; 4];

/// Location of an attachment on its field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FieldPlace {
    /// At x = 0.
    Start,
    /// Between both ends.
    Inside,
    /// At x = l.
    End,
}

/// A point at which the machine is attached to a field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FieldAttachment {
    /// Index of the machine's coordinate; `None` if the field is fixed at zero.
    pub coordinate: Option<u32>,
    /// Location on the field.
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
    /// True at x = 0 and at x = l, respectively, if u = 0 there.
    pub fixed: [bool; 2],
    /// l in the spec \[m\].
    pub length: f64,
    /// Attachments, ordered by x.
    pub attachments: &'a [FieldAttachment],
    /// Parameters that the field depends on.
    pub parameters: &'a [u32],
    /// Default number of elements.
    pub elements: usize,
    /// Default order of the elements.
    pub order: usize,
}

/// Variability of a number at a point of a field.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variation {
    /// The number is zero.
    Zero,
    /// It depends on parameters only.
    Constant,
    /// It depends on motion, place or time.
    Varying,
}

/// Structure of a field's forces, known without evaluating them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ForceStructure {
    /// True if f_0 and f_1 are linear in u, u_x, u_t and u_xt, depend on nothing else and do not
    /// change with time.
    pub linear: bool,
    /// True if f_0 depends on u, u_t, x and t only and f_1 on u_x and u_xt only.
    pub local: bool,
    /// Variability of f_0 and f_1.
    pub forces: [Variation; 2],
    /// Variability of the derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt.
    pub derivatives: [Variation; 8],
}

impl ForceStructure {
    /// Structure that makes no assumption on the forces.
    pub const UNKNOWN: Self = Self {
        linear: false,
        local: false,
        forces: [Variation::Varying; 2],
        derivatives: [Variation::Varying; 8],
    };

    /// Returns whether the force on a node depends on u, and whether on u_t: of the node itself,
    /// or of the other nodes of its elements.
    #[must_use]
    pub fn reaches(&self, itself: bool) -> [bool; 2] {
        let of_others = |by: usize| [1, 4, 5].iter().any(|entry| self.is_there(by + entry));
        [0, 2].map(|by| of_others(by) || (itself && self.is_there(by)))
    }

    fn is_there(&self, derivative: usize) -> bool {
        self.derivatives[derivative] != Variation::Zero
    }
}

/// A scene with fields: a machine, and functions at a point of each field. As a [`Simulator`] it
/// is the machine alone; the parameters passed by fields come after all others.
///
/// `p` holds all parameters of the machine; x is in \[m\]. Slices have the stated lengths, with k
/// the number of [`FieldDescription::parameters`].
///
/// # Panics
/// If there is no field with this index, or a slice has a wrong length.
pub trait FieldScene<R: Real>: Simulator<R> + Sync {
    /// Returns the number of fields.
    fn fields(&self) -> usize;
    /// Returns the `index`-th field.
    fn field(&self, index: usize) -> FieldDescription<'_>;
    /// Computes m.
    fn field_inertia(&self, index: usize, x: R, p: &[R]) -> R;
    /// Computes dm/dx, then dm/dp; 1 + k values.
    fn field_inertia_gradient(&self, index: usize, x: R, p: &[R], gradient: &mut [R]);
    /// Computes \[f_0, f_1\].
    fn field_force(&self, index: usize, time: R, x: R, point: &FieldPoint<R>, p: &[R]) -> [R; 2];
    /// Computes the derivatives of f_0, then of f_1, with respect to u, u_x, u_t, u_xt.
    fn field_force_jacobian(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        p: &[R],
    ) -> [R; 8];
    /// Computes the derivatives of f_0 and f_1 with respect to x, then to t, then to p; 2 (2 + k)
    /// values.
    fn field_force_gradient(
        &self,
        index: usize,
        time: R,
        x: R,
        point: &FieldPoint<R>,
        p: &[R],
        gradient: &mut [R],
    );
    /// Computes kinetic and potential energy per length \[J/m\].
    fn field_energy(&self, index: usize, time: R, x: R, point: &FieldPoint<R>, p: &[R]) -> [R; 2];
    /// Computes the rate of the potential energy, power supplied and power dissipated, per length
    /// \[W/m\].
    fn field_power(&self, index: usize, time: R, x: R, point: &FieldPoint<R>, p: &[R]) -> [R; 3];
    /// Computes x of the attachments, then l.
    fn field_places(&self, index: usize, p: &[R], places: &mut [R]);
    /// Computes the derivatives of these places with respect to p, row by row.
    fn field_places_gradient(&self, index: usize, p: &[R], gradient: &mut [R]);
    /// Computes the initial u and u_t.
    fn field_initial(&self, index: usize, x: R, p: &[R]) -> [R; 2];

    /// Reports whether the machine's Jacobian or time derivative depends on forces passed by
    /// fields, as with variable inertia.
    fn jacobian_reads_forces(&self) -> bool {
        true
    }
    /// Returns the structure of the field's forces. If they are local, each can be computed
    /// alone, for many points in one call, by the functions below. Those are undefined for any
    /// other field. Slices have one entry per point.
    fn force_structure(&self, _index: usize) -> ForceStructure {
        ForceStructure::UNKNOWN
    }
    /// Computes m at many places.
    fn field_inertias(&self, index: usize, x: &[R], p: &[R], inertias: &mut [R]) {
        for (inertia, x) in inertias.iter_mut().zip(x) {
            *inertia = self.field_inertia(index, *x, p);
        }
    }
    /// Computes f_0 for given x, u and u_t.
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
    /// Computes df_0/du and df_0/du_t.
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
    /// Computes df_0/dt; `gradient` is workspace for one call of
    /// [`FieldScene::field_force_gradient`].
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
    /// Computes f_1 for given u_x and u_xt.
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
    /// Computes df_1/du_x and df_1/du_xt.
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

/// Panics for a field index that an emitted scene does not have.
///
/// # Panics
/// Always.
#[cold]
pub fn no_field(index: usize) -> ! {
    panic!("there is no field of number {index}")
}
