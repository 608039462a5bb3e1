//! Partial derivatives of the equations of motion with respect to state,
//! parameters and time.

use std::collections::{BTreeSet, HashMap};

use crate::mechanics::lagrange::EquationsOfMotion;
use crate::mechanics::state::Motion;
use machinist_algebra::cas::{Cas, Form, Terms};
use machinist_algebra::expr::{ConstraintId, Expr, HandedId, ParameterId, Symbol};

/// Derivatives of M, f, h and of the energies, structural nonzeros only.
///
/// Excluded: the solution for q'' and its derivatives. They are formed on the tape, where the
/// factorization of M is shared: `d(q'')/ds = M^-1 (df/ds - (dM/ds) q'')`.
#[derive(Debug, Clone, PartialEq)]
pub struct Linearization {
    /// The equations that were linearized.
    pub equations: EquationsOfMotion,
    /// Derivatives by the entries of the state, in order.
    pub state: Vec<Partials>,
    /// Derivatives by the parameters, then by the numbers that fields pass, in order.
    pub parameters: Vec<Partials>,
    /// Derivatives by time.
    pub time: Partials,
    /// Derivatives of f by the constraint forces that forces depend on.
    pub reactions: Vec<Reaction>,
    /// Derivatives of the rates of first-order states by constraint forces: a row of (entry of the
    /// state, dh/dlambda) for each constraint. Empty if no rate depends on such a force.
    pub rates_by_forces: Vec<Vec<(usize, Expr)>>,
    /// Derivatives of the guards by the constraint forces, a row for each constraint. Empty if no
    /// guard depends on such a force.
    pub guards_by_forces: Vec<Vec<Expr>>,
}

/// df/dlambda of one constraint: f is linear in lambda for given signs.
#[derive(Debug, Clone, PartialEq)]
pub struct Reaction {
    /// The constraint.
    pub constraint: ConstraintId,
    /// (row, df/dlambda)
    pub forcing: Vec<(usize, Expr)>,
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

/// Differentiates all equations by all symbols, without structural zeros.
pub fn linearize(cas: &mut Cas, equations: &EquationsOfMotion) -> Linearization {
    let system = &equations.system;
    let forms = Forms::new(cas, equations);
    let parameters = (0..system.parameters.len() as u32).map(ParameterId).map(Symbol::Parameter);
    let handed = (0..system.handed.len() as u32).map(HandedId).map(Symbol::Handed);
    Linearization {
        state: equations.layout.symbols().map(|symbol| forms.partials(cas, symbol)).collect(),
        parameters: parameters.chain(handed).map(|symbol| forms.partials(cas, symbol)).collect(),
        time: forms.partials(cas, Symbol::Time),
        reactions: forms.reactions(cas),
        rates_by_forces: forms.rates_by_forces(cas, equations),
        guards_by_forces: forms.guards_by_forces(cas, equations),
        equations: equations.clone(),
    }
}

/// The equations, read once and differentiated many times, each only by its own symbols.
struct Forms {
    /// Upper triangle of M, bordered by G^T: row, column, entry.
    mass_matrix: Vec<(usize, usize, Form)>,
    forcing: Vec<Form>,
    /// y' of positions and first-order states, by entry of the state.
    rates: Vec<(usize, Form)>,
    energy: Terms,
    time_momentum: Terms,
    guards: Vec<Form>,
    /// Places of each symbol in M, f and the rates.
    places: HashMap<Symbol, Places>,
}

/// Indices of the forms that contain a symbol.
#[derive(Default)]
struct Places {
    mass_matrix: Vec<usize>,
    forcing: Vec<usize>,
    rates: Vec<usize>,
}

impl Forms {
    fn new(cas: &mut Cas, equations: &EquationsOfMotion) -> Self {
        let mut places: HashMap<Symbol, Places> = HashMap::new();
        let mut mention = |expr: &Expr, of: fn(&mut Places) -> &mut Vec<usize>, place: usize| {
            for symbol in expr.symbols() {
                of(places.entry(symbol).or_default()).push(place);
            }
        };
        let [kinetic, potential, stored] = equations.energy.each_ref().map(|e| cas.form(e));
        let given = equations.at_given_accelerations();
        let (matrix, right_side) = given.as_ref().unwrap_or(equations).bordered();
        let mut mass_matrix = Vec::new();
        for (i, row) in matrix.rows().enumerate() {
            for (j, entry) in row.iter().filter(|(j, entry)| *j >= i && !entry.is_zero()) {
                mention(entry, |places| &mut places.mass_matrix, mass_matrix.len());
                mass_matrix.push((i, *j, cas.form(entry)));
            }
        }
        let mut forcing = Vec::new();
        for (row, expr) in right_side.iter().enumerate() {
            mention(expr, |places| &mut places.forcing, row);
            forcing.push(cas.form(expr));
        }
        let mut rates = Vec::new();
        for (entry, state) in equations.layout.states.iter().enumerate() {
            let rate = match &state.motion {
                Motion::Position { rate, .. } => rate,
                Motion::FirstOrder(id) => &equations.rates[id.0 as usize],
                Motion::Velocity(_) => continue,
            };
            mention(rate, |places| &mut places.rates, rates.len());
            rates.push((entry, cas.form(rate)));
        }
        let energy = &(&kinetic + &potential) + &stored;
        let time_momentum = cas.form(&equations.time_momentum);
        Forms {
            mass_matrix,
            forcing,
            rates,
            energy: cas.terms(&energy),
            time_momentum: cas.terms(&time_momentum),
            guards: equations.events.iter().map(|event| cas.form(&event.guard)).collect(),
            places,
        }
    }

    fn reactions(&self, cas: &mut Cas) -> Vec<Reaction> {
        let read: BTreeSet<ConstraintId> = self
            .places
            .iter()
            .filter_map(|(symbol, places)| match symbol {
                Symbol::Multiplier(id) if !places.forcing.is_empty() => Some(*id),
                _ => None,
            })
            .collect();
        let reactions = read.into_iter().map(|constraint| Reaction {
            constraint,
            forcing: self.partials(cas, Symbol::Multiplier(constraint)).forcing,
        });
        reactions.collect()
    }

    fn rates_by_forces(
        &self,
        cas: &mut Cas,
        equations: &EquationsOfMotion,
    ) -> Vec<Vec<(usize, Expr)>> {
        let forces = (0..equations.constraints.len() as u32).map(ConstraintId);
        let forces: Vec<Symbol> = forces.map(Symbol::Multiplier).collect();
        let is_read = |force| self.places.get(force).is_some_and(|places| !places.rates.is_empty());
        if !forces.iter().any(is_read) {
            return Vec::new();
        }
        forces.into_iter().map(|force| self.partials(cas, force).rates).collect()
    }

    fn guards_by_forces(&self, cas: &mut Cas, equations: &EquationsOfMotion) -> Vec<Vec<Expr>> {
        let is_force = |symbol| matches!(symbol, Symbol::Multiplier(_));
        if !equations.events.iter().any(|event| event.guard.mentions(is_force)) {
            return Vec::new();
        }
        let forces = (0..equations.constraints.len() as u32).map(ConstraintId);
        let slopes = forces.map(|id| {
            let slope = |guard| {
                let slope = cas.derivative(guard, Symbol::Multiplier(id));
                cas.simplify(&slope)
            };
            self.guards.iter().map(slope).collect()
        });
        slopes.collect()
    }

    fn partials(&self, cas: &mut Cas, symbol: Symbol) -> Partials {
        let none = Places::default();
        let places = self.places.get(&symbol).unwrap_or(&none);
        let entries = places.mass_matrix.iter().map(|place| &self.mass_matrix[*place]);
        let mass_matrix = entries
            .filter_map(|(i, j, entry)| nonzero(cas, entry, symbol).map(|expr| (*i, *j, expr)))
            .collect();
        let mut nonzeros = |row: usize, form| nonzero(cas, form, symbol).map(|e| (row, e));
        let rows = places.forcing.iter();
        let forcing = rows.filter_map(|row| nonzeros(*row, &self.forcing[*row])).collect();
        let rates = places.rates.iter().map(|place| &self.rates[*place]);
        let rates = rates.filter_map(|(entry, form)| nonzeros(*entry, form)).collect();
        let energy = self.energy.derivative(cas, symbol);
        let time_momentum = self.time_momentum.derivative(cas, symbol);
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
