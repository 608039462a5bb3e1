//! Cubic tables as functions of one number: the interval by bisection, then its cubic, with the
//! same operations as [`CubicTable`](machinist_contract::CubicTable).

use wasm_encoder::{BlockType, Function as Body, InstructionSink, MemArg, MemArgTarget, ValType};

use super::TableKey;
use crate::Table;
use crate::evaluate::interpolate;
use crate::straight::{Step, Straight};

/// Locals: the argument, then those of the search.
const X: u32 = 0;
const LOW: u32 = 1;
const HIGH: u32 = 2;
const MIDDLE: u32 = 3;
/// Distance from the first knot of the interval.
const U: u32 = 4;

/// Returns the tables that programs read, with the orders of their derivatives.
pub(super) fn used<'a>(programs: impl Iterator<Item = &'a Straight>) -> Vec<TableKey> {
    let steps = programs.flat_map(|straight| &straight.steps);
    let mut keys: Vec<TableKey> = steps
        .filter_map(|step| match *step {
            Step::Table(table, order, _) => Some((table, order)),
            _ => None,
        })
        .collect();
    keys.sort_by_key(|(table, order)| (table.0, *order));
    keys.dedup();
    keys
}

/// Returns the function of a table, or its derivative, whose numbers begin at the byte `place`.
pub(super) fn body(table: &Table, order: u32, place: usize) -> Body {
    let mut body = Body::new([(3, ValType::I32), (1, ValType::F64)]);
    let mut sink = body.instructions();
    let ends = [f64::NEG_INFINITY, f64::INFINITY].map(|end| interpolate(table, order, end));
    if let Some(last) = table.knots.last() {
        // NaN is treated as a value beyond the last knot.
        sink.local_get(X).f64_const((*last).into()).f64_lt().i32_eqz();
        sink.if_(BlockType::Empty).f64_const(ends[1].into()).return_().end();
        search(&mut sink, table.knots.len(), place);
        sink.local_get(LOW).i32_eqz();
        sink.if_(BlockType::Empty).f64_const(ends[0].into()).return_().end();
        let cubics = place + 8 * table.knots.len();
        sink.local_get(X);
        // LOW - 1 is the interval; its knot is one number before that of LOW.
        sink.local_get(LOW).i32_const(1).i32_sub().local_tee(LOW);
        sink.i32_const(3).i32_shl().f64_load(at(place)).f64_sub().local_set(U);
        sink.local_get(LOW).i32_const(5).i32_shl().local_set(LOW);
        polynomial(&mut sink, order, cubics);
    } else {
        sink.f64_const(0.0.into());
    }
    sink.end();
    body
}

fn at(byte: usize) -> MemArg {
    MemArg { offset: byte as u64, align: 3, target: MemArgTarget::default(), ordering: None }
}

/// Stores the number of knots that are not above the argument in `LOW`.
fn search(sink: &mut InstructionSink<'_>, knots: usize, place: usize) {
    sink.i32_const(knots as i32).local_set(HIGH);
    sink.loop_(BlockType::Empty);
    sink.local_get(LOW).local_get(HIGH).i32_add().i32_const(1).i32_shr_u().local_set(MIDDLE);
    sink.local_get(X).local_get(MIDDLE).i32_const(3).i32_shl().f64_load(at(place)).f64_lt();
    sink.if_(BlockType::Empty);
    sink.local_get(MIDDLE).local_set(HIGH);
    sink.else_();
    sink.local_get(MIDDLE).i32_const(1).i32_add().local_set(LOW);
    sink.end();
    sink.local_get(LOW).local_get(HIGH).i32_lt_u().br_if(0);
    sink.end();
}

/// Computes a derivative of the cubic whose coefficients are `LOW` bytes behind `cubics`.
fn polynomial(sink: &mut InstructionSink<'_>, order: u32, cubics: usize) {
    // Factors of the coefficients, from the highest to the last.
    let factors: &[f64] = match order {
        0 => &[1.0; 4],
        1 => &[3.0, 2.0, 1.0],
        2 => &[6.0, 2.0],
        3 => &[6.0],
        _ => &[],
    };
    if factors.is_empty() {
        sink.f64_const(0.0.into());
    }
    for (index, factor) in factors.iter().enumerate() {
        if index > 0 {
            sink.local_get(U).f64_mul();
        }
        sink.local_get(LOW).f64_load(at(cubics + 8 * (3 - index)));
        // A product with one changes nothing.
        sink.f64_const((*factor).into()).f64_mul();
        if index > 0 {
            sink.f64_add();
        }
    }
}
