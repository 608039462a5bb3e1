//! Equations of motion of rigid bodies beside those of a Lagrangian.

use std::collections::BTreeMap;

use crate::scene::system::LagrangianSystem;
use crate::spatial::recursion;
use machinist_algebra::cas::{Cas, Form};
use machinist_algebra::expr::{CoordinateId, Expr, Matrix};

/// M and f of a whole system; see [`super::lagrange::EquationsOfMotion`].
pub(super) struct Equations {
    pub(super) mass_matrix: Matrix,
    pub(super) forcing: Vec<Expr>,
    pub(super) at_accelerations: Option<(Matrix, Vec<Expr>)>,
    pub(super) accelerations: Option<Vec<Expr>>,
}

/// Adds the rigid bodies of a system to the equations M q'' = f of its Lagrangian.
pub(super) fn with_bodies(
    cas: &mut Cas,
    system: &LagrangianSystem,
    mass_matrix: Matrix,
    forcing: Vec<Expr>,
) -> Equations {
    if system.mechanisms.is_empty() {
        return Equations { mass_matrix, forcing, at_accelerations: None, accelerations: None };
    }
    let accelerations = accelerations(system, &mass_matrix, &forcing);
    let mut entries: BTreeMap<(CoordinateId, CoordinateId), Vec<Expr>> = BTreeMap::new();
    let (mut at_rest, mut at_given) = (forcing.clone(), forcing);
    for mechanism in &system.mechanisms {
        for (place, entry) in mechanism.mass_matrix() {
            entries.entry(place).or_default().push(entry);
        }
        let bias = mechanism.inverse_dynamics(|_| None);
        let forces = mechanism.inverse_dynamics(recursion::acceleration);
        for (total, forces) in [(&mut at_rest, bias), (&mut at_given, forces)] {
            for (CoordinateId(row), force) in forces {
                let entry = &mut total[row as usize];
                let (before, force) = (cas.form(entry), cas.form(&force));
                *entry = cas.expr(&(&before - &force));
            }
        }
    }
    let whole = summed(cas, &mass_matrix, entries);
    Equations {
        mass_matrix: whole,
        forcing: at_rest,
        at_accelerations: Some((mass_matrix, at_given)),
        accelerations,
    }
}

/// Returns q'' by recursion along the trees, if they are all that moves: M and f of the Lagrangian
/// are then inertias and forces of their coordinates.
fn accelerations(
    system: &LagrangianSystem,
    mass_matrix: &Matrix,
    forcing: &[Expr],
) -> Option<Vec<Expr>> {
    let rows: Vec<_> = mass_matrix.rows().collect();
    let is_diagonal = rows.iter().enumerate().all(|(i, row)| row.iter().all(|(j, _)| i == *j));
    if !is_diagonal || !system.constraints.is_empty() {
        return None;
    }
    let mut found = BTreeMap::new();
    for mechanism in &system.mechanisms {
        let force = |CoordinateId(id)| forcing[id as usize].clone();
        let inertia = |CoordinateId(id)| {
            let (_, entry) = rows[id as usize].first()?;
            (!entry.is_zero()).then(|| entry.clone())
        };
        found.extend(mechanism.forward_dynamics(force, inertia)?);
    }
    (0..forcing.len() as u32).map(|id| found.remove(&CoordinateId(id))).collect()
}

/// Returns M with more entries, given by their lower triangle.
fn summed(
    cas: &mut Cas,
    mass_matrix: &Matrix,
    entries: BTreeMap<(CoordinateId, CoordinateId), Vec<Expr>>,
) -> Matrix {
    let mut lines: Vec<BTreeMap<usize, Expr>> =
        mass_matrix.rows().map(|row| row.iter().cloned().collect()).collect();
    for ((CoordinateId(row), CoordinateId(column)), parts) in entries {
        let (row, column) = (row as usize, column as usize);
        let mut parts: Vec<Form> = parts.iter().map(|part| cas.form(part)).collect();
        parts.extend(lines[row].get(&column).map(|entry| cas.form(entry)));
        let sum = cas.sum(parts);
        let entry = cas.expr(&sum);
        lines[column].insert(row, entry.clone());
        lines[row].insert(column, entry);
    }
    lines.into_iter().collect()
}
