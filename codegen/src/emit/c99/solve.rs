//! The motion that several functions share, and solutions for matrices by its factors.

use std::fmt::Write as _;

use machinist_contract::implicit::LANES;
use machinist_model::{Solve, SparsityPattern, operations};

use super::Scene;
use super::body::{Body, body};
use super::functions::{Emitted, arguments, broken_head, counted, state_variables, unread};
use super::layout::{statement, statements};
use super::names::Namer;
use crate::emit::EmitError;

const SUBSTITUTE: &str = include_str!("snippets/substitute.c");

/// Motion that several functions share, computed by a separate function.
pub(super) struct Motion {
    body: Body,
    /// The member of `struct motion` for each result.
    members: Vec<String>,
    /// Number of factors, which form one member.
    factors: usize,
}

impl Motion {
    /// Returns the motion of a scene, if it has one.
    pub(super) fn of(scene: &Scene<'_>) -> Result<Option<Self>, EmitError> {
        let Some(motion) = &scene.model.motion else { return Ok(None) };
        let body = body(&scene.hoisted.motion, &scene.scope("motion"), true)?;
        let mut namer = Namer::for_members();
        let member = |result: &String| {
            let is_name = result.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
            let is_name = is_name && !result.starts_with(|c: char| c.is_ascii_digit());
            namer.claim(if is_name { result } else { "result" })
        };
        let mut members: Vec<String> = body.results.iter().map(member).collect();
        for (place, &factor) in motion.factors.iter().enumerate() {
            members[factor as usize] = format!("factors[{place}]");
        }
        Ok(Some(Self { body, members, factors: motion.factors.len() }))
    }

    /// Returns the expressions of its results in other functions.
    pub(super) fn results(&self) -> Vec<String> {
        self.members.iter().map(|name| format!("m.{name}")).collect()
    }
}

/// Returns the function that computes the motion.
pub(super) fn function(scene: &Scene<'_>, motion: &Motion) -> Emitted {
    let Motion { body: Body { statements: lines, results, reads, .. }, members, .. } = motion;
    let mut text = state_variables(scene, reads);
    text.push_str(&unread([
        ("time", !reads.time),
        ("state", reads.state.is_empty()),
        ("p", !reads.parameters),
        ("c", !reads.constants),
    ]));
    text.push_str(&statements(lines));
    for (name, result) in members.iter().zip(results) {
        text.push_str(&statement(&format!("m->{name} = {result};"), 4));
    }
    let doc = format!(
        "Accelerations, factors of the linear equations they solve, and whatever else several \
         functions need. {}",
        counted(operations(&scene.hoisted.motion))
    );
    let head = broken_head(&format!("static void motion({}, struct motion *m)", arguments(scene)));
    Emitted { doc, head, body: text, is_local: true }
}

/// Returns the struct of the motion's results, and the code that solves with its factors.
pub(super) fn items(scene: &Scene<'_>) -> String {
    let Some(Motion { members, factors, .. }) = &scene.motion else { return String::new() };
    let real = scene.real();
    let mut text =
        String::from("/* What several functions need of the motion. */\nstruct motion {\n");
    if *factors > 0 {
        let _ = writeln!(text, "    {real} factors[{factors}];");
    }
    for name in members.iter().filter(|name| !name.starts_with("factors[")) {
        let _ = writeln!(text, "    {real} {name};");
    }
    text.push_str("};\n");
    let solves =
        scene.model.functions().filter_map(|row| Some((row.name, scene.model.solve(row.id)?)));
    let solves: Vec<String> = solves.map(|(name, solve)| tables(scene, name, solve)).collect();
    if !solves.is_empty() {
        let _ = write!(text, "\n{}\n{}", scene.filled(SUBSTITUTE), solves.join("\n"));
    }
    text
}

/// Returns the steps and places of a function that solves.
fn tables(scene: &Scene<'_>, function: &str, solve: &Solve) -> String {
    let index = scene.index_type();
    let mut terms = Vec::new();
    let steps: Vec<String> = solve
        .steps
        .iter()
        .map(|step| {
            let first = terms.len();
            terms.extend(step.terms.iter().map(|(factor, from)| format!("{{ {factor}, {from} }}")));
            let scale = step.scale.map_or(0, |scale| scale + 1);
            format!("{{ {}, {scale}, {first}, {} }}", step.row, terms.len())
        })
        .collect();
    let sides = solve.right_sides.iter();
    let sides: Vec<String> = sides.map(|(row, column)| format!("{{ {row}, {column} }}")).collect();
    let solved = solve.solved.iter();
    let solved: Vec<String> =
        solved.map(|(entry, row, column)| format!("{{ {entry}, {row}, {column} }}")).collect();
    let given: Vec<String> = solve.given.iter().map(u32::to_string).collect();
    let list = |kind: &str, name: &str, size: &str, items: &[String], none: &str| {
        // C does not allow an empty list.
        let items = if items.is_empty() { none.to_owned() } else { items.join(", ") };
        let items = statement(&items, 4);
        format!("static const {kind} {function}_{name}[]{size} = {{\n{items}}};\n")
    };
    let lists = [
        list("struct substitution", "steps", "", &steps, "{ 0, 0, 0, 0 }"),
        list(index, "terms", "[2]", &terms, "{ 0, 0 }"),
        list(index, "given", "", &given, "0"),
        list(index, "right_sides", "[2]", &sides, "{ 0, 0 }"),
        list(index, "solved", "[3]", &solved, "{ 0, 0, 0 }"),
    ];
    let [rows, columns] = [solve.rows, solve.columns];
    let counts = [steps.len(), given.len(), sides.len(), solved.len()].map(|n| format!("{n}u"));
    let [steps, given, sides, solved] = counts;
    format!(
        "{}static const struct solve {function}_solve = {{\n    {rows}u, {columns}u, \
         {function}_steps, {steps}, {function}_terms, {function}_given, {given},\n    \
         {function}_right_sides, {sides}, {function}_solved, {solved}\n}};\n",
        lists.concat()
    )
}

/// Returns the end of a function that solves.
pub(super) fn call(
    scene: &Scene<'_>,
    function: &str,
    solve: &Solve,
    pattern: &SparsityPattern,
    results: &[String],
) -> String {
    debug_assert!(solve.given.len() + solve.solved.len() <= pattern.entries.len());
    let real = scene.real();
    let mut text = String::new();
    for (index, result) in results.iter().enumerate() {
        text.push_str(&statement(&format!("inputs[{index}] = {result};"), 4));
    }
    let _ = writeln!(text, "    solve(&{function}_solve, m.factors, inputs, x, values);");
    let rows = solve.rows.max(1);
    let inputs = results.len().max(1);
    // Declared first, where readers expect the stack variables of a C function.
    format!("    {real} inputs[{inputs}];\n    {real} x[{rows}][{LANES}];\n{text}")
}
