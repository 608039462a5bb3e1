//! Motion of a system from its energies alone, by numbers that carry derivatives.
//!
//! ```text
//! d/dt dL/dq' - dL/dq + dD/dq' - Q - G^T lambda = 0        L = T - V
//! ```
//!
//! L is evaluated along the motion q + q' s, z + h s, t + s, and in the direction of one
//! velocity. The mixed derivative is d/dt dL/dq' without its part in q'', whose factor is the
//! mixed derivative by two velocities. A constraint is evaluated along the motion twice; its
//! mixed derivative is g'' without its part in q''.

use machinist_algebra::expr::{ConstraintId, CoordinateId, FirstOrderId, Symbol};
use machinist_contract::Real;

use super::formula::{Formula, pi};
use super::hyper::Hyper;
use super::least::least;
use super::rounded::{Rounded, product, sum};
use super::solve::inverse;
use crate::scene::system::LagrangianSystem;
use machinist_model::Table;

/// Time, positions, velocities, first-order states and parameters of a system.
#[derive(Debug, Clone)]
pub struct Place<R> {
    /// t.
    pub time: R,
    /// q, then the part w of each quaternion.
    pub q: Vec<R>,
    /// q'.
    pub v: Vec<R>,
    /// z.
    pub z: Vec<R>,
    /// p.
    pub parameters: Vec<R>,
}

impl<R: Real> Place<R> {
    /// Returns a place where only parameters have values.
    pub fn of_parameters(parameters: Vec<R>) -> Self {
        let time = R::literal(f64::NAN);
        Self { time, q: Vec::new(), v: Vec::new(), z: Vec::new(), parameters }
    }
}

/// Motion of a system at a place.
#[derive(Debug, Clone)]
pub struct Motion<R> {
    /// q''.
    pub accelerations: Vec<Rounded<R>>,
    /// lambda; 0 for a constraint that does not hold.
    pub multipliers: Vec<Rounded<R>>,
    /// h.
    pub rates: Vec<Rounded<R>>,
}

/// Constraint forces as forces read them.
struct Reactions<R> {
    multipliers: Vec<Rounded<R>>,
    /// -1 or 1.
    signs: Vec<Rounded<R>>,
}

impl<R: Real> Reactions<R> {
    /// Returns multipliers of zero, or of one for a constraint, with signs, true for negative ones.
    fn new(count: usize, signs: Option<&[bool]>, of: Option<usize>) -> Self {
        let unit = |k: usize| Rounded::literal(if of == Some(k) { 1.0 } else { 0.0 });
        let is_negative = |k: usize| signs.is_some_and(|signs| signs[k]);
        let sign = |k: usize| Rounded::literal(if is_negative(k) { -1.0 } else { 1.0 });
        Reactions {
            multipliers: (0..count).map(unit).collect(),
            signs: (0..count).map(sign).collect(),
        }
    }
}

/// A constraint of a machine.
#[derive(Debug, Clone)]
struct Held<R> {
    formula: Formula<Rounded<R>>,
    is_of_positions: bool,
    when: Vec<(FirstOrderId, i32)>,
    is_dropped: bool,
}

/// A system prepared for evaluation.
#[derive(Debug, Clone)]
pub struct Machine<R> {
    /// Conversion to the nearest `f64`.
    pub to_f64: fn(R) -> f64,
    tables: Vec<Table>,
    coordinates: usize,
    /// Indices in q of w, x, y and z of each quaternion. Velocities at the indices of x, y and z are
    /// rates of rotation.
    quaternions: Vec<[usize; 4]>,
    lagrangian: Formula<Rounded<R>>,
    dissipation: Formula<Rounded<R>>,
    forces: Vec<Formula<Rounded<R>>>,
    /// True if forces depend on constraint forces.
    reads_reactions: bool,
    rates: Vec<Formula<Rounded<R>>>,
    is_mode: Vec<bool>,
    constraints: Vec<Held<R>>,
    /// True if redundant constraints share forces with the others.
    shares_redundant: bool,
    /// Potentials of springs that are approximated as rigid.
    rigid: Vec<Formula<Rounded<R>>>,
}

/// Direction of a derivative.
#[derive(Clone, Copy)]
enum Direction<'a, R> {
    Nowhere,
    /// In the direction of one symbol.
    One(Symbol),
    /// Along the motion of one velocity.
    Of(usize),
    /// Along the motion, with these rates of first-order states.
    Motion(&'a [Rounded<R>]),
}

impl<R: Real> Machine<R> {
    /// Prepares a system without fields; `to_f64` returns the nearest `f64`.
    pub fn new(system: &LagrangianSystem, to_f64: fn(R) -> f64) -> Self {
        let [kinetic, potential] = system.energies();
        let mut lagrangian = Formula::new(&kinetic);
        lagrangian.add(&potential, -1.0);
        let held = system.constraints.iter().map(|constraint| Held {
            formula: Formula::new(&constraint.expr),
            is_of_positions: constraint.is_of_positions,
            when: constraint.when.clone(),
            is_dropped: constraint.is_dropped,
        });
        let quaternions = system.orientations.iter().map(|one| {
            let [x, y, z] = one.vector;
            [one.scalar, x, y, z].map(|id| id.0 as usize)
        });
        let is_rigid = |instance: &String| system.freeze.rigid.contains(instance);
        let springs = system.springs.iter().filter(|spring| is_rigid(&spring.instance));
        Self {
            to_f64,
            tables: system.tables.clone(),
            coordinates: system.coordinates.len(),
            quaternions: quaternions.collect(),
            lagrangian,
            dissipation: Formula::new(&system.dissipation),
            forces: system.generalized_force.iter().map(|q| Formula::new(&q.total)).collect(),
            reads_reactions: system
                .generalized_force
                .iter()
                .any(|q| q.total.mentions(|symbol| matches!(symbol, Symbol::Multiplier(_)))),
            rates: system.first_order.iter().map(|z| Formula::new(&z.rate)).collect(),
            is_mode: system.first_order.iter().map(|z| z.is_mode).collect(),
            constraints: held.collect(),
            shares_redundant: system.shares_redundant,
            rigid: springs.map(|spring| Formula::new(&spring.potential)).collect(),
        }
    }

    /// Returns q'', lambda and h; `None` if the equations do not determine them.
    pub fn motion(&self, place: &Place<R>) -> Option<Motion<R>> {
        /// Bound of the number of times that signs of constraint forces are taken from a solution.
        const TRIES: usize = 64;
        // Where several combinations fulfil the equations, the motion is that which friction grows
        // into from none.
        let mut motion = self.motion_at_signs(place, None)?;
        if !self.reads_reactions {
            motion.multipliers = self.shared(place, motion.multipliers)?;
            return Some(self.with_rates(place, motion));
        }
        let mut signs = self.negative(&motion);
        for _ in 0..TRIES {
            motion = self.motion_at_signs(place, Some(&signs))?;
            let found = self.negative(&motion);
            if found == signs {
                return Some(self.with_rates(place, motion));
            }
            signs = found;
        }
        None
    }

    /// Returns constraint forces shared with redundant constraints, if the scene asks for that: the
    /// least of all with the same effect.
    fn shared(&self, place: &Place<R>, forces: Vec<Rounded<R>>) -> Option<Vec<Rounded<R>>> {
        let is_redundant = |k: &usize| self.constraints[*k].is_dropped;
        let (redundant, others): (Vec<usize>, Vec<usize>) =
            (0..forces.len()).partition(is_redundant);
        if !self.shares_redundant || redundant.is_empty() {
            return Some(forces);
        }
        let kept: Vec<usize> =
            others.into_iter().filter(|k| self.constraints[*k].when.is_empty()).collect();
        let [own, more] = [&kept, &redundant]
            .map(|rows| rows.iter().map(|k| self.normal(*k, place)).collect::<Vec<_>>());
        let whole: Vec<Rounded<R>> = kept.iter().map(|k| forces[*k]).collect();
        let (own, others) = least(&own, &more, &whole, self.to_f64)?;
        let mut shared = forces;
        for (k, force) in kept.iter().zip(own).chain(redundant.iter().zip(others)) {
            shared[*k] = force;
        }
        Some(shared)
    }

    /// Returns a motion with the rates of first-order states, which may read constraint forces.
    fn with_rates(&self, place: &Place<R>, motion: Motion<R>) -> Motion<R> {
        let rates = self.rates.iter().map(|rate| self.value(rate, place, Some(&motion))).collect();
        Motion { rates, ..motion }
    }

    /// Returns the constraints whose forces are negative.
    fn negative(&self, motion: &Motion<R>) -> Vec<bool> {
        motion.multipliers.iter().map(|force| (self.to_f64)(force.value) < 0.0).collect()
    }

    /// Returns the motion with forces by given signs of constraint forces, true for negative ones, or
    /// without those that depend on constraint forces.
    fn motion_at_signs(&self, place: &Place<R>, signs: Option<&[bool]>) -> Option<Motion<R>> {
        let n = self.coordinates;
        let rates: Vec<Rounded<R>> =
            self.rates.iter().map(|rate| self.value(rate, place, None)).collect();
        let mut matrix = self.masses(place);
        let holding = self.holding(place, &matrix);
        let normals = self.normals(place)?;
        let order = n + holding.len() + normals.len();
        matrix.resize(order, Vec::new());
        for row in &mut matrix {
            row.resize(order, R::literal(0.0));
        }
        let count = self.constraints.len();
        let none = Reactions::new(count, signs, None);
        let mut right: Vec<Rounded<R>> =
            (0..n).map(|i| self.force(i, place, &rates, &none)).collect();
        let mut border = |row: usize, normal: &[R]| {
            for (j, entry) in normal.iter().enumerate() {
                (matrix[row][j], matrix[j][row]) = (*entry, -*entry);
            }
        };
        for (row, (k, normal)) in (n..).zip(&holding) {
            border(row, normal);
            right.push(self.bend(*k, place, &rates));
        }
        for (row, normal) in (n + holding.len()..).zip(&normals) {
            border(row, normal);
            right.push(Rounded::literal(0.0));
        }
        for (column, (k, _)) in (n..).zip(&holding).filter(|_| signs.is_some()) {
            let unit = Reactions::new(count, signs, Some(*k));
            for (i, line) in matrix.iter_mut().enumerate().take(n) {
                let slope = self.force(i, place, &rates, &unit).value - right[i].value;
                line[column] = line[column] - slope;
            }
        }
        let alone = self.sizes_alone(&matrix, &right);
        let inverse = inverse(matrix, self.to_f64)?;
        let solved = |row: usize| {
            let Rounded { value, size } = product(&inverse[row], &right);
            Rounded { value, size: size + R::literal(alone[row]) }
        };
        let mut multipliers = vec![Rounded::literal(0.0); self.constraints.len()];
        for (row, (k, _)) in (n..).zip(&holding) {
            multipliers[*k] = solved(row);
        }
        Some(Motion { accelerations: (0..n).map(solved).collect(), multipliers, rates })
    }

    /// Returns the constraints that hold and have a force, with their rows of G. Constraints that
    /// always hold come first, then those that hold in modes, without redundant ones.
    fn holding(&self, place: &Place<R>, masses: &[Vec<R>]) -> Vec<(usize, Vec<R>)> {
        /// Bound of the rounding error that remains of a row of length 1.
        const NOTHING: f64 = 1e-9;
        let mass = |i: usize| self.size(masses[i][i]);
        let scale = |i: usize| if mass(i) > 0.0 { mass(i).sqrt().recip() } else { 1.0 };
        let is_modal = |k: &usize| !self.constraints[*k].when.is_empty();
        let held = (0..self.constraints.len()).filter(|k| self.holds(*k, place));
        let (modal, always): (Vec<usize>, Vec<usize>) = held.partition(is_modal);
        let (mut found, mut basis) = (Vec::new(), Vec::<Vec<f64>>::new());
        for k in always.into_iter().chain(modal) {
            let normal = self.normal(k, place);
            let entries = normal.iter().enumerate();
            let mut left: Vec<f64> =
                entries.map(|(i, entry)| (self.to_f64)(*entry) * scale(i)).collect();
            let whole = length(&left);
            for direction in basis.iter().chain(&basis) {
                let along: f64 = left.iter().zip(direction).map(|(a, b)| a * b).sum();
                left.iter_mut().zip(direction).for_each(|(a, b)| *a -= along * b);
            }
            let rest = length(&left);
            if is_modal(&k) && rest <= NOTHING * whole {
                continue;
            }
            basis.push(left.into_iter().map(|entry| entry / rest).collect());
            found.push((k, normal));
        }
        found
    }

    /// Returns the accelerations that the forces on each coordinate would cause alone, and the
    /// force of each constraint if there were no other. They are the size of the terms that a
    /// solution is computed from, even if these cancel.
    fn sizes_alone(&self, matrix: &[Vec<R>], right: &[Rounded<R>]) -> Vec<f64> {
        let n = self.coordinates;
        let entry = |i: usize, j: usize| self.size(matrix[i][j]);
        let mass = |i: usize| if entry(i, i) > 0.0 { entry(i, i) } else { f64::INFINITY };
        let mut alone: Vec<f64> = (0..n).map(|i| self.size(right[i].size) / mass(i)).collect();
        for row in n..right.len() {
            let pull: f64 =
                (0..n).map(|i| entry(row, i) * self.size(right[i].size) / mass(i)).sum();
            let give: f64 = (0..n).map(|i| entry(row, i).powi(2) / mass(i)).sum();
            let force = if give > 0.0 { (self.size(right[row].size) + pull) / give } else { 0.0 };
            alone.push(force);
            for (i, size) in alone.iter_mut().enumerate().take(n) {
                *size += entry(row, i) * force / mass(i);
            }
        }
        alone
    }

    /// Evaluates an expression at a place, and with the motion there if it is given.
    pub fn value(
        &self,
        formula: &Formula<Rounded<R>>,
        place: &Place<R>,
        motion: Option<&Motion<R>>,
    ) -> Rounded<R> {
        let at = |symbol| Hyper::constant(get(symbol, place, motion));
        sum(formula.terms.iter().map(|term| term.value(&self.tables, &at).value))
    }

    /// Returns g of a constraint on positions, and g' of any; `None` if it does not hold.
    pub fn held(&self, constraint: usize, place: &Place<R>) -> Option<[Rounded<R>; 2]> {
        if !self.holds(constraint, place) {
            return None;
        }
        let Held { formula, is_of_positions, .. } = &self.constraints[constraint];
        let value = self.value(formula, place, None);
        if !is_of_positions {
            return Some([Rounded::literal(0.0), value]);
        }
        let directions = [Direction::Motion(&[]), Direction::Nowhere];
        let rate = self.each(formula, place, directions).map(|term| signed(term.a, 1.0));
        Some([value, sum(rate)])
    }

    fn holds(&self, constraint: usize, place: &Place<R>) -> bool {
        let held = &self.constraints[constraint];
        !held.is_dropped
            && held.when.iter().all(|(FirstOrderId(mode), value)| {
                let mode = (self.to_f64)(place.z[*mode as usize]);
                (mode - f64::from(*value)).abs() < 0.5
            })
    }

    /// Returns M, with each entry computed by itself: its symmetry is not assumed.
    fn masses(&self, place: &Place<R>) -> Vec<Vec<R>> {
        let n = self.coordinates;
        (0..n).map(|i| (0..n).map(|j| self.mass(i, j, place)).collect()).collect()
    }

    /// Returns d2L/dq_i' dq_j'.
    fn mass(&self, i: usize, j: usize, place: &Place<R>) -> R {
        let directions = [i, j].map(|i| Direction::One(velocity(i)));
        let terms = self.each(&self.lagrangian, place, directions);
        sum(terms.map(|term| signed(term.ab, 1.0))).value
    }

    /// Returns dL/dq_i - d/dt dL/dq_i' - dD/dq_i' + Q_i, without q''.
    fn force(
        &self,
        i: usize,
        place: &Place<R>,
        h: &[Rounded<R>],
        reactions: &Reactions<R>,
    ) -> Rounded<R> {
        let by = |symbol| [Direction::One(symbol), Direction::Nowhere];
        let slopes = self.each(&self.lagrangian, place, [Direction::Of(i), Direction::Nowhere]);
        let along = [Direction::One(velocity(i)), Direction::Motion(h)];
        let momentum = self.each(&self.lagrangian, place, along);
        let losses = self.each(&self.dissipation, place, by(velocity(i)));
        let parts = slopes.map(|term| signed(term.a, 1.0));
        let parts = parts.chain(momentum.map(|term| signed(term.ab, -1.0)));
        let parts = parts.chain(losses.map(|term| signed(term.a, -1.0)));
        let at = |symbol| {
            Hyper::constant(match symbol {
                Symbol::Multiplier(ConstraintId(k)) => reactions.multipliers[k as usize],
                Symbol::Unloaded(ConstraintId(k)) => reactions.signs[k as usize],
                _ => get(symbol, place, None),
            })
        };
        let terms = self.forces[i].terms.iter();
        let given = terms.map(|term| term.value(&self.tables, &at).value);
        let parts = parts.chain([sum(given)]);
        sum(parts.chain(self.gyroscopic(i, place)))
    }

    /// Returns the terms of p x omega, with p = dL/domega, for a rate of rotation.
    fn gyroscopic(&self, i: usize, place: &Place<R>) -> Vec<Rounded<R>> {
        let found = self.quaternions.iter().find(|parts| parts[1..].contains(&i));
        let Some([_, axes @ ..]) = found else { return Vec::new() };
        let number = axes.iter().position(|axis| *axis == i).unwrap_or_default();
        let (j, k) = (axes[(number + 1) % 3], axes[(number + 2) % 3]);
        let momentum = |axis: usize| {
            let by = [Direction::One(velocity(axis)), Direction::Nowhere];
            sum(self.each(&self.lagrangian, place, by).map(|term| signed(term.a, 1.0)))
        };
        let omega = |axis: usize| Rounded::new(place.v[axis]);
        vec![momentum(j) * omega(k), -(momentum(k) * omega(j))]
    }

    /// Returns the rate of a position.
    pub fn rate_of_position(&self, index: usize, place: &Place<R>) -> Rounded<R> {
        self.position_along(index, place, &|velocity| Rounded::new(place.v[velocity]))
            .unwrap_or(Rounded::literal(0.0))
    }

    /// Returns the rate of a position at given velocities: of a quaternion q, that of q omega/2.
    fn position_along(
        &self,
        index: usize,
        place: &Place<R>,
        velocity: &dyn Fn(usize) -> Rounded<R>,
    ) -> Option<Rounded<R>> {
        let Some(parts) = self.quaternions.iter().find(|parts| parts.contains(&index)) else {
            return (index < self.coordinates).then(|| velocity(index));
        };
        let part = |number: usize| place.q.get(parts[number]).copied().map(Rounded::new);
        let (w, x, y, z) = (part(0)?, part(1)?, part(2)?, part(3)?);
        let [a, b, c] = [1, 2, 3].map(|part| velocity(parts[part]));
        let doubled = match parts.iter().position(|part| *part == index) {
            Some(0) => -(x * a + y * b + z * c),
            Some(1) => w * a + y * c - z * b,
            Some(2) => w * b + z * a - x * c,
            _ => w * c + x * b - y * a,
        };
        Some(doubled * Rounded::literal(0.5))
    }

    /// Returns a constraint's row of G.
    fn normal(&self, constraint: usize, place: &Place<R>) -> Vec<R> {
        let Held { formula, is_of_positions, .. } = &self.constraints[constraint];
        let slope = |i| {
            let one = if *is_of_positions { Direction::Of(i) } else { Direction::One(velocity(i)) };
            let terms = self.each(formula, place, [one, Direction::Nowhere]);
            sum(terms.map(|term| signed(term.a, 1.0))).value
        };
        (0..self.coordinates).map(slope).collect()
    }

    /// Returns gamma: -g'' without its part in q''.
    fn bend(&self, constraint: usize, place: &Place<R>, h: &[Rounded<R>]) -> Rounded<R> {
        let Held { formula, is_of_positions, .. } = &self.constraints[constraint];
        let along = Direction::Motion(h);
        if *is_of_positions {
            let terms = self.each(formula, place, [along, along]);
            sum(terms.map(|term| signed(term.ab, -1.0)))
        } else {
            let terms = self.each(formula, place, [along, Direction::Nowhere]);
            sum(terms.map(|term| signed(term.a, -1.0)))
        }
    }

    /// Returns the constraint normals that replace rigid springs: dV/dq is normal to the
    /// directions that remain free, wherever the spring is not relaxed.
    pub fn normals(&self, place: &Place<R>) -> Option<Vec<Vec<R>>> {
        let normal = |spring: &Formula<Rounded<R>>| {
            let mut away = place.clone();
            for (i, q) in away.q.iter_mut().enumerate() {
                *q = R::literal(0.37 + 0.23 * i as f64);
            }
            let slope = |i| {
                let by = [Direction::One(coordinate(i)), Direction::Nowhere];
                sum(self.each(spring, &away, by).map(|term| signed(term.a, 1.0))).value
            };
            let slopes: Vec<R> = (0..self.coordinates).map(slope).collect();
            let pivot = slopes.iter().copied().find(|slope| self.size(*slope) > 0.0)?;
            Some(slopes.into_iter().map(|slope| slope / pivot).collect())
        };
        self.rigid.iter().map(normal).collect()
    }

    /// Evaluates all terms that change in the given directions.
    fn each<'a>(
        &'a self,
        formula: &'a Formula<Rounded<R>>,
        place: &'a Place<R>,
        directions: [Direction<'a, R>; 2],
    ) -> impl Iterator<Item = Hyper<Rounded<R>>> + 'a {
        let part = move |symbol, direction| self.part(symbol, direction, place);
        let terms = formula.terms.iter().filter(move |term| {
            directions.iter().all(|direction| {
                matches!(direction, Direction::Nowhere)
                    || term.mentions(|symbol| part(symbol, *direction).is_some())
            })
        });
        terms.map(move |term| {
            let at = |symbol| Hyper {
                value: get(symbol, place, None),
                a: part(symbol, directions[0]),
                b: part(symbol, directions[1]),
                ab: None,
            };
            term.value(&self.tables, &at)
        })
    }

    /// Returns the rate of change of a symbol in a direction.
    fn part(
        &self,
        symbol: Symbol,
        direction: Direction<'_, R>,
        place: &Place<R>,
    ) -> Option<Rounded<R>> {
        let one = Rounded::literal(1.0);
        match (direction, symbol) {
            (Direction::One(asked), symbol) => (asked == symbol).then_some(one),
            (Direction::Motion(_), Symbol::Time) => Some(one),
            (Direction::Motion(_), Symbol::Coordinate(id)) => {
                place.v.first()?;
                self.position_along(id.0 as usize, place, &|index| Rounded::new(place.v[index]))
            }
            (Direction::Of(asked), Symbol::Coordinate(id)) => {
                let zero = Rounded::literal(0.0);
                let unit = |index: usize| if index == asked { one } else { zero };
                let parts = self.quaternions.iter();
                let of = parts.filter(|parts| parts.contains(&(id.0 as usize))).flatten();
                let moves = id.0 as usize == asked || of.into_iter().any(|part| *part == asked);
                if moves { self.position_along(id.0 as usize, place, &unit) } else { None }
            }
            (Direction::Motion(h), Symbol::FirstOrder(FirstOrderId(k))) => {
                let moves = !self.is_mode[k as usize];
                h.get(k as usize).copied().filter(|_| moves)
            }
            _ => None,
        }
    }

    fn size(&self, value: R) -> f64 {
        (self.to_f64)(value).abs()
    }
}

fn length(vector: &[f64]) -> f64 {
    vector.iter().map(|entry| entry * entry).sum::<f64>().sqrt()
}

fn signed<R: Real>(part: Option<Rounded<R>>, sign: f64) -> Rounded<R> {
    let part = part.unwrap_or(Rounded::literal(0.0));
    if sign < 0.0 { -part } else { part }
}

fn coordinate(i: usize) -> Symbol {
    Symbol::Coordinate(CoordinateId(i as u32))
}

fn velocity(i: usize) -> Symbol {
    Symbol::Velocity(CoordinateId(i as u32))
}

/// Returns the value of a symbol; NaN if it has none there.
fn get<R: Real>(symbol: Symbol, place: &Place<R>, motion: Option<&Motion<R>>) -> Rounded<R> {
    let entry = |all: &[R], index: u32| all.get(index as usize).copied().map(Rounded::new);
    let solved = |of: fn(&Motion<R>) -> &Vec<Rounded<R>>, index: u32| {
        motion.and_then(|motion| of(motion).get(index as usize)).copied()
    };
    let value = match symbol {
        Symbol::Pi => Some(Rounded::new(pi())),
        Symbol::Time => Some(Rounded::new(place.time)),
        Symbol::Coordinate(CoordinateId(i)) => entry(&place.q, i),
        Symbol::Velocity(CoordinateId(i)) => entry(&place.v, i),
        Symbol::FirstOrder(FirstOrderId(k)) => entry(&place.z, k),
        Symbol::Parameter(id) => entry(&place.parameters, id.0),
        Symbol::Acceleration(CoordinateId(i)) => solved(|motion| &motion.accelerations, i),
        Symbol::Multiplier(ConstraintId(k)) | Symbol::Unloaded(ConstraintId(k)) => {
            solved(|motion| &motion.multipliers, k)
        }
        Symbol::Handed(_) | Symbol::Helper(_) => None,
    };
    value.unwrap_or(Rounded::literal(f64::NAN))
}
