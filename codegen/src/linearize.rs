//! Partial derivatives of the equations of motion with respect to state,
//! parameters and time.

use crate::cas::{Cas, Form};
use crate::expr::{CoordinateId, Expr, FirstOrderId, ParameterId, Symbol};
use crate::lagrange::EquationsOfMotion;
use crate::system::LagrangianSystem;

/// Derivatives of M, f, h and of the energies, structural nonzeros only.
///
/// Excluded: the solution for q'' and its derivatives; those are put together on
/// the tape, where the factorization of M is shared:
/// `d(q'')/ds = M^-1 (df/ds - (dM/ds) q'')`.
#[derive(Debug, Clone, PartialEq)]
pub struct Linearization {
    /// What was linearized.
    pub equations: EquationsOfMotion,
    /// With respect to the state \[q, q', z\], in order.
    pub state: Vec<Partials>,
    /// With respect to the parameters, in order.
    pub parameters: Vec<Partials>,
    /// With respect to time.
    pub time: Partials,
}

/// Partial derivatives with respect to one symbol.
#[derive(Debug, Clone, PartialEq)]
pub struct Partials {
    /// The symbol.
    pub symbol: Symbol,
    /// (row, column, dM/ds) of the upper triangle.
    pub mass_matrix: Vec<(usize, usize, Expr)>,
    /// (row, df/ds).
    pub forcing: Vec<(usize, Expr)>,
    /// (row, dh/ds).
    pub rates: Vec<(usize, Expr)>,
    /// dE/ds of T + V + stored energy.
    pub energy: Expr,
    /// d(2 T - q' dT/dq')/ds.
    pub time_momentum: Expr,
}

/// The symbols of the state \[q, q', z\], in order.
pub fn state_symbols(system: &LagrangianSystem) -> impl Iterator<Item = Symbol> + use<> {
    let coordinates = (0..system.coordinates.len() as u32).map(CoordinateId);
    let states = (0..system.first_order.len() as u32).map(FirstOrderId);
    coordinates
        .clone()
        .map(Symbol::Coordinate)
        .chain(coordinates.map(Symbol::Velocity))
        .chain(states.map(Symbol::FirstOrder))
}

/// Differentiates everything by everything, structural zeros left out.
pub fn linearize(cas: &mut Cas, equations: &EquationsOfMotion) -> Linearization {
    let system = &equations.system;
    let forms = Forms::new(cas, equations);
    let parameters = (0..system.parameters.len() as u32).map(ParameterId).map(Symbol::Parameter);
    Linearization {
        state: state_symbols(system).map(|symbol| forms.partials(cas, symbol)).collect(),
        parameters: parameters.map(|symbol| forms.partials(cas, symbol)).collect(),
        time: forms.partials(cas, Symbol::Time),
        equations: equations.clone(),
    }
}

/// The equations taken in once, to be differentiated many times.
struct Forms {
    mass_matrix: Vec<Vec<Form>>,
    forcing: Vec<Form>,
    rates: Vec<Form>,
    energy: Form,
    time_momentum: Form,
}

impl Forms {
    fn new(cas: &mut Cas, equations: &EquationsOfMotion) -> Self {
        let [kinetic, potential, stored] = equations.energy.each_ref().map(|e| cas.form(e));
        let rows = equations.mass_matrix.iter();
        Forms {
            mass_matrix: rows.map(|row| row.iter().map(|e| cas.form(e)).collect()).collect(),
            forcing: equations.forcing.iter().map(|e| cas.form(e)).collect(),
            rates: equations.rates.iter().map(|e| cas.form(e)).collect(),
            energy: &(&kinetic + &potential) + &stored,
            time_momentum: cas.form(&equations.time_momentum),
        }
    }

    fn partials(&self, cas: &mut Cas, symbol: Symbol) -> Partials {
        let mut mass_matrix = Vec::new();
        for (i, row) in self.mass_matrix.iter().enumerate() {
            for (j, entry) in row.iter().enumerate().skip(i) {
                mass_matrix.extend(nonzero(cas, entry, symbol).map(|expr| (i, j, expr)));
            }
        }
        let mut by_row = |forms: &[Form]| {
            let rows = forms.iter().enumerate();
            rows.filter_map(|(i, form)| nonzero(cas, form, symbol).map(|e| (i, e))).collect()
        };
        let forcing = by_row(&self.forcing);
        let rates = by_row(&self.rates);
        let energy = cas.derivative(&self.energy, symbol);
        let time_momentum = cas.derivative(&self.time_momentum, symbol);
        Partials {
            symbol,
            mass_matrix,
            forcing,
            rates,
            energy: cas.expr(&energy),
            time_momentum: cas.expr(&time_momentum),
        }
    }
}

fn nonzero(cas: &mut Cas, form: &Form, symbol: Symbol) -> Option<Expr> {
    let derivative = cas.derivative(form, symbol);
    (!derivative.is_zero()).then(|| cas.simplify(&derivative))
}
