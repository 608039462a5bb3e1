//! Result of a search for a better design, for people and for programs.

use machinist::fit::Bounds;
use machinist::improve::{End, Improvement};
use machinist_contract::Simulator;
use serde::Serialize;

use super::{Goal, Searched, before, units};
use crate::cli::amount::quantity_of;
use crate::cli::output::{columns, notes_told};
use crate::cli::scene::Scene;
use crate::failure::Failure;
use crate::number::{exact, number};

/// Dimensionless multiplier below which a limit counts as inactive.
const HOLDS: f64 = 1e-6;
/// Relative distance above which a limit counts as inactive.
const NEAR: f64 = 1e-4;

/// Complete result.
#[derive(Debug, Serialize)]
pub struct Answer {
    pub scene: String,
    pub title: String,
    /// Reason why the search ended.
    pub end: &'static str,
    pub steps: usize,
    pub runs: usize,
    pub objective: Objective,
    pub parameters: Vec<Varied>,
    pub limits: Vec<Limit>,
    /// Number of variants that could not be simulated, and the reason of the first.
    pub failed: usize,
    pub why_failed: Option<String>,
    /// Notes of the run of the design found.
    pub notes: Vec<String>,
}

#[derive(Debug, Serialize)]
pub struct Objective {
    pub expression: String,
    pub unit: String,
    pub is_greatest: bool,
    /// Null if the start cannot be simulated.
    pub before: Option<f64>,
    pub after: f64,
}

#[derive(Debug, Serialize)]
pub struct Varied {
    pub name: String,
    pub unit: String,
    pub start: f64,
    pub value: f64,
    pub bounds: Option<[f64; 2]>,
    pub is_at_bound: bool,
    /// Improvement of the objective for each unit by which the bound is relaxed; null if no bound
    /// is active.
    pub cost: Option<f64>,
}

#[derive(Debug, Serialize)]
pub struct Limit {
    pub expression: String,
    pub unit: String,
    /// Left and right side.
    pub before: Option<[f64; 2]>,
    pub after: [f64; 2],
    pub is_met: bool,
    /// True if the limit is active.
    pub is_active: bool,
    /// Improvement of the objective for each unit by which the limit is relaxed.
    pub cost: f64,
}

impl Answer {
    pub(super) fn new(
        improvement: &Improvement<'_>,
        goal: &Goal<'_>,
        limits: &[String],
        searched: &Searched,
        simulator: &dyn Simulator<f64>,
    ) -> Result<Self, Failure> {
        let Searched { found, sizes, lost, runs } = searched;
        let values = improvement.values(&found.at);
        let after = improvement.numbers_at(&values)?;
        let before = before(improvement);
        let costs = improvement.costs(found, sizes);
        let limit = |k: usize| {
            let (left, right) = after.sides[k];
            let value = found.evaluation.constraints[k][0].value;
            // Multipliers of violated limits are the price of the violation.
            let is_active = found.is_feasible() && found.multipliers[k] > HOLDS && value > -NEAR;
            Limit {
                expression: limits[k].clone(),
                unit: units::of(&goal.inequalities[k].left, simulator),
                before: before.as_ref().map(|before| before.sides[k].into()),
                after: [left, right],
                is_met: found.evaluation.constraints[k][0].value <= 1e-7,
                is_active,
                cost: if is_active { costs[k] } else { 0.0 },
            }
        };
        let varied = |k: usize| {
            let (unknown, value) = (&improvement.unknowns[k], values[k]);
            let Bounds { low, high } = unknown.bounds;
            let is_at_bound = value <= low || value >= high;
            let cost = found.of_bounds[k].abs() * sizes.objective / unknown.slope(value).abs();
            Varied {
                name: unknown.name.clone(),
                unit: unit_of(simulator, &unknown.name),
                start: unknown.start,
                value,
                bounds: (low.is_finite() || high.is_finite()).then_some([low, high]),
                is_at_bound,
                cost: (is_at_bound && found.is_feasible()).then_some(cost),
            }
        };
        let sign = if goal.is_greatest { -1.0 } else { 1.0 };
        Ok(Self {
            scene: simulator.name().to_owned(),
            title: simulator.title().to_owned(),
            end: match found.end {
                End::Interrupted => "interrupted",
                _ if !found.is_feasible() => "limits are not met",
                End::Converged | End::Infeasible => "converged",
                End::Steps => "ended by the number of steps",
                End::Stuck => "stuck",
            },
            steps: found.steps,
            runs: *runs,
            objective: Objective {
                expression: goal.objective_text.to_owned(),
                unit: units::of(&goal.objective, simulator),
                is_greatest: goal.is_greatest,
                before: before.as_ref().map(|before| sign * before.objective),
                after: sign * after.objective,
            },
            parameters: (0..values.len()).map(varied).collect(),
            limits: (0..limits.len()).map(limit).collect(),
            failed: found.failed.0 + lost.0,
            why_failed: found.failed.1.clone().or_else(|| lost.1.clone()),
            notes: after.notes,
        })
    }

    /// Returns the values found.
    pub fn values(&self) -> Vec<f64> {
        self.parameters.iter().map(|varied| varied.value).collect()
    }

    /// Formats the result for people.
    pub fn describe(&self, scene: &Scene) -> String {
        let shown = |value: f64| number(value, 7);
        let Objective { expression, unit, is_greatest, before, after } = &self.objective;
        let unit = if unit == "1" { String::new() } else { format!(" {unit}") };
        let best = if *is_greatest { "greatest" } else { "least" };
        let before = before.map_or("a start that cannot be simulated".to_owned(), shown);
        let mut text = format!(
            "{}: {} ({})\n{best} {expression}: {}{unit}, from {before}\n{} after {} steps, {} \
             runs{}\n\n",
            self.scene,
            self.title,
            scene.how(),
            shown(*after),
            self.end,
            self.steps,
            self.runs,
            notes_told(&self.notes, "--json"),
        );
        text.push_str(&columns(&self.parameter_rows(), 2));
        if !self.limits.is_empty() {
            text.push('\n');
            text.push_str(&columns(&self.limit_rows(), 1));
        }
        let told = self.limits.iter().filter(|limit| limit.is_active).map(|limit| {
            let by = if limit.unit == "1" { String::new() } else { format!(" {}", limit.unit) };
            let cost = number(limit.cost, 4);
            format!("\n{} costs {cost}{unit} for each 1{by}\n", limit.expression)
        });
        text.extend(told);
        let held = self.parameters.iter().filter_map(|varied| Some((varied, varied.cost?)));
        text.extend(held.map(|(varied, cost)| {
            let by = if varied.unit == "1" { String::new() } else { format!(" {}", varied.unit) };
            let (name, cost) = (&varied.name, number(cost, 4));
            format!("\nThe bound of {name} costs {cost}{unit} for each 1{by}\n")
        }));
        if let Some(why) = &self.why_failed {
            let count = self.failed;
            text.extend([format!("\n{count} variants could not be simulated; the first: {why}\n")]);
        }
        text
    }

    fn parameter_rows(&self) -> Vec<[String; 5]> {
        let header = ["", "unit", "before", "improved", "bounds"].map(str::to_owned);
        let row = |varied: &Varied| {
            let bounds = match varied.bounds {
                Some([low, high]) => {
                    let at = if varied.is_at_bound { ", at it" } else { "" };
                    format!("{} .. {}{at}", exact(low), exact(high))
                }
                None => "none".to_owned(),
            };
            let values = [exact(varied.start), number(varied.value, 8)];
            let [start, value] = values;
            [varied.name.clone(), varied.unit.clone(), start, value, bounds]
        };
        std::iter::once(header).chain(self.parameters.iter().map(row)).collect()
    }

    fn limit_rows(&self) -> Vec<[String; 5]> {
        let header = ["subject to", "before", "improved", "limit", ""].map(str::to_owned);
        let shown = |value: f64| number(value, 6);
        let row = |limit: &Limit| {
            let state = match (limit.is_met, limit.is_active) {
                (false, _) => "not met",
                (true, true) => "holds",
                (true, false) => "",
            };
            [
                limit.expression.clone(),
                limit.before.map_or_else(String::new, |[left, _]| shown(left)),
                shown(limit.after[0]),
                shown(limit.after[1]),
                state.to_owned(),
            ]
        };
        std::iter::once(header).chain(self.limits.iter().map(row)).collect()
    }
}

fn unit_of(simulator: &dyn Simulator<f64>, name: &str) -> String {
    quantity_of(simulator, name).map_or("1", |quantity| quantity.unit).to_owned()
}
