//! Partial derivatives of the equations of motion with respect to state,
//! parameters and time.

use crate::cas::{Cas, Form};
use crate::expr::{Expr, HandedId, ParameterId, Symbol};
use crate::mechanics::lagrange::EquationsOfMotion;
use crate::mechanics::state::Motion;

/// Derivatives of M, f, h and of the energies, structural nonzeros only.
///
/// Excluded: the solution for q'' and its derivatives; those are put together on
/// the tape, where the factorization of M is shared:
/// `d(q'')/ds = M^-1 (df/ds - (dM/ds) q'')`.
#[derive(Debug, Clone, PartialEq)]
pub struct Linearization {
    /// What was linearized.
    pub equations: EquationsOfMotion,
    /// With respect to the entries of the state, in order.
    pub state: Vec<Partials>,
    /// With respect to the parameters, then to what fields hand over, in order.
    pub parameters: Vec<Partials>,
    /// With respect to time.
    pub time: Partials,
}

/// Partial derivatives with respect to one symbol.
#[derive(Debug, Clone, PartialEq)]
pub struct Partials {
    /// The symbol.
    pub symbol: Symbol,
    /// (row, column, dM/ds) of the upper triangle of M, bordered by G^T.
    pub mass_matrix: Vec<(usize, usize, Expr)>,
    /// (row, df/ds), and dgamma/ds below it.
    pub forcing: Vec<(usize, Expr)>,
    /// (entry of the state, dy'/ds) of positions and first-order states.
    pub rates: Vec<(usize, Expr)>,
    /// dE/ds of T + V + stored energy.
    pub energy: Expr,
    /// d(2 T - q' dT/dq')/ds.
    pub time_momentum: Expr,
    /// dg/ds of each guard; empty with respect to parameters.
    pub guards: Vec<Expr>,
}

/// Differentiates everything by everything, structural zeros left out.
pub fn linearize(cas: &mut Cas, equations: &EquationsOfMotion) -> Linearization {
    let system = &equations.system;
    let forms = Forms::new(cas, equations);
    let parameters = (0..system.parameters.len() as u32).map(ParameterId).map(Symbol::Parameter);
    let handed = (0..system.handed.len() as u32).map(HandedId).map(Symbol::Handed);
    Linearization {
        state: equations.layout.symbols().map(|symbol| forms.partials(cas, symbol)).collect(),
        parameters: parameters.chain(handed).map(|symbol| forms.partials(cas, symbol)).collect(),
        time: forms.partials(cas, Symbol::Time),
        equations: equations.clone(),
    }
}

/// The equations taken in once, to be differentiated many times.
struct Forms {
    mass_matrix: Vec<Vec<Form>>,
    forcing: Vec<Form>,
    /// y' of positions and first-order states, by entry of the state.
    rates: Vec<(usize, Form)>,
    energy: Form,
    time_momentum: Form,
    guards: Vec<Form>,
}

impl Forms {
    fn new(cas: &mut Cas, equations: &EquationsOfMotion) -> Self {
        let [kinetic, potential, stored] = equations.energy.each_ref().map(|e| cas.form(e));
        let (matrix, right_side) = equations.bordered();
        let rows = matrix.iter();
        let entries = equations.layout.states.iter().enumerate();
        let rates = entries.filter_map(|(entry, state)| match &state.motion {
            Motion::Position { rate, .. } => Some((entry, rate)),
            Motion::FirstOrder(id) => Some((entry, &equations.rates[id.0 as usize])),
            Motion::Velocity(_) => None,
        });
        let rates = rates.map(|(entry, rate)| (entry, cas.form(rate))).collect();
        Forms {
            mass_matrix: rows.map(|row| row.iter().map(|e| cas.form(e)).collect()).collect(),
            forcing: right_side.iter().map(|e| cas.form(e)).collect(),
            rates,
            energy: &(&kinetic + &potential) + &stored,
            time_momentum: cas.form(&equations.time_momentum),
            guards: equations.events.iter().map(|event| cas.form(&event.guard)).collect(),
        }
    }

    fn partials(&self, cas: &mut Cas, symbol: Symbol) -> Partials {
        let mut mass_matrix = Vec::new();
        for (i, row) in self.mass_matrix.iter().enumerate() {
            for (j, entry) in row.iter().enumerate().skip(i) {
                mass_matrix.extend(nonzero(cas, entry, symbol).map(|expr| (i, j, expr)));
            }
        }
        let mut nonzeros = |row: usize, form| nonzero(cas, form, symbol).map(|e| (row, e));
        let rows = self.forcing.iter().enumerate();
        let forcing = rows.filter_map(|(row, form)| nonzeros(row, form)).collect();
        let rates = self.rates.iter();
        let rates = rates.filter_map(|(entry, form)| nonzeros(*entry, form)).collect();
        let energy = cas.derivative(&self.energy, symbol);
        let time_momentum = cas.derivative(&self.time_momentum, symbol);
        let is_parameter = matches!(symbol, Symbol::Parameter(_) | Symbol::Handed(_));
        let guards = self.guards.iter().filter(|_| !is_parameter).map(|guard| {
            let slope = cas.derivative(guard, symbol);
            cas.simplify(&slope)
        });
        let guards = guards.collect();
        Partials {
            symbol,
            guards,
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
