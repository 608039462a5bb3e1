//! Derivatives of the stages of a step.

use std::fmt::Write as _;

use machinist_contract::fixed_step::{ROSENBROCK_GAMMA, StepMethod};

use super::super::expression::literal;
use super::super::layout::statement;
use super::super::{Scene, implicit};
use super::{EstimatorOptions, Sizes};
use crate::emit::EmitError;

/// Fills in the stages of the method, with or without derivatives by parameters.
pub(super) fn filled_in(
    scene: &Scene<'_>,
    options: &EstimatorOptions,
    text: &str,
) -> Result<String, EmitError> {
    let model = scene.model;
    let directions = Sizes::of(scene, options).directions;
    let pattern = &model.parameter_jacobian.pattern.entries;
    let reads_parameters = directions > 0 && !pattern.is_empty();
    let along: Vec<usize> = (options.estimated.iter().copied())
        .chain(options.disturbed.iter().map(|(parameter, _)| *parameter))
        .collect();
    let slots = pattern.iter().map(|(_, parameter)| {
        let slot = along.iter().position(|along| *along == *parameter as usize);
        slot.unwrap_or(along.len()).to_string()
    });
    let slots = statement(&slots.collect::<Vec<_>>().join(", "), 8);
    let (argument, by_parameters, along_parameters) = if reads_parameters {
        (
            "                        const scene_real_t by_parameters[SCENE_PARAMETER_JACOBIAN_NONZEROS],\n                        \
             const scene_real_t dp[SCENE_DIRECTIONS],\n",
            "    scene_real_t by_parameters[STAGES][SCENE_PARAMETER_JACOBIAN_NONZEROS];\n",
            format!(
                "    for (k = 0u; k < SCENE_PARAMETER_JACOBIAN_NONZEROS; ++k) {{\n        \
                 /* The place of each derivative among the directions; {directions}: none. */\n        \
                 static const unsigned short places[SCENE_PARAMETER_JACOBIAN_NONZEROS] = {{\n{slots}        }};\n        \
                 if (places[k] < {directions}u) {{\n            \
                 const size_t row = scene_parameter_jacobian_rows[k];\n            \
                 slope[row] = slope[row] + by_parameters[k] * dp[places[k]];\n        }}\n    }}\n"
            ),
        )
    } else {
        ("", "", String::new())
    };
    let passed = |stage: usize| {
        if reads_parameters { format!("by_parameters[{stage}], dp,") } else { String::new() }
    };
    let text = text
        .replace("BY_PARAMETERS_ARGUMENT\n", argument)
        .replace("SLOPE_BY_PARAMETERS\n", &along_parameters);
    let parameters =
        Parameters { declared: by_parameters, passed: &passed, are_read: reads_parameters };
    match scene.options.method {
        StepMethod::Rosenbrock2 => implicit_stages(scene, &parameters, &text),
        method => Ok(explicit_stages(method, &parameters, &text)),
    }
}

/// Code for the derivatives by parameters at the stages.
struct Parameters<'a> {
    /// Declaration of their values.
    declared: &'a str,
    /// Returns the arguments of a stage.
    passed: &'a dyn Fn(usize) -> String,
    are_read: bool,
}

/// Fills in the stages of a Rosenbrock method.
fn implicit_stages(
    scene: &Scene<'_>,
    parameters: &Parameters<'_>,
    text: &str,
) -> Result<String, EmitError> {
    let Parameters { declared, passed, are_read } = parameters;
    let at = |stage: usize, time: &str, state: &str| {
        let call = format!(
            "    scene_parameter_jacobian({time}, {state}, &machine->p, &machine->c, \
             by_parameters[{stage}]);\n"
        );
        if *are_read { call } else { String::new() }
    };
    let gamma = literal(ROSENBROCK_GAMMA, scene.options.real, "estimator")?.text;
    let places = implicit::elimination(scene).borrowed().places;
    Ok(text
        .replace("PARAMETERS_AT_START\n", &at(0, "time", "start"))
        .replace("PARAMETERS_AT_SECOND\n", &at(1, "time + h", "&stage"))
        .replace("BY_PARAMETERS\n", declared)
        .replace("STAGE_0 ", &format!("{} ", passed(0)))
        .replace("STAGE_1 ", &format!("{} ", passed(1)))
        .replace("UNUSED\n", "")
        .replace("[STAGES]", "[2]")
        .replace("GAMMA", &gamma)
        .replace("PLACES", &places.to_string())
        .replace(",  ", ", "))
}

/// Fills in the stages of an explicit method.
fn explicit_stages(method: StepMethod, parameters: &Parameters<'_>, text: &str) -> String {
    let Parameters { declared, passed, are_read } = parameters;
    let lengths: &[(&str, &str, &str)] = match method {
        StepMethod::Heun => &[("h", "time + h", "R(1.0)")],
        _ => &[
            ("half", "time + half", "R(2.0)"),
            ("half", "time + half", "R(2.0)"),
            ("h", "time + h", "R(1.0)"),
        ],
    };
    let last = match method {
        StepMethod::Heun => "half",
        _ => "h / R(6.0)",
    };
    let jacobians = |stage: usize, time: &str| {
        let mut text = format!(
            "    scene_rate_jacobian({time}, &stage, &machine->p, &machine->c, by_state[{stage}]);\n"
        );
        if *are_read {
            let _ = writeln!(
                text,
                "    scene_parameter_jacobian({time}, &stage, &machine->p, &machine->c, \
                 by_parameters[{stage}]);"
            );
        }
        text
    };
    let mut of_stages = jacobians(0, "time");
    let mut slopes = String::new();
    let mut before = "time";
    for (index, (length, time, weight)) in lengths.iter().enumerate() {
        let stage = index + 1;
        let _ = writeln!(
            of_stages,
            "    scene_rate({before}, &stage, &machine->p, &machine->c, &slope_of);\n    \
             ahead(&stage, start, {length}, &slope_of);"
        );
        of_stages.push_str(&jacobians(stage, time));
        let _ = writeln!(
            slopes,
            "        along(x, own, {length}, slope);\n        \
             slope_along(by_state[{stage}], {} x, slope);\n        \
             along(sum, sum, {weight}, slope);",
            passed(stage)
        );
        before = time;
    }
    let _ = writeln!(slopes, "        along(own, own, {last}, sum);");
    let unused = if *are_read { "" } else { "        (void)dp;\n" };
    text.replace("STAGE_JACOBIANS\n", &of_stages)
        .replace("STAGE_SLOPES\n", &format!("{slopes}{unused}"))
        .replace("STAGE_0 ", &format!("{} ", passed(0)))
        .replace("BY_PARAMETERS\n", declared)
        .replace("STAGES", &(lengths.len() + 1).to_string())
        .replace(",  ", ", ")
}
