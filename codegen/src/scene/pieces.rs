//! `piecewise`: pieces of one dimension, and conditions between them.

use crate::scene::layout::Scope;
use crate::scene::resolve::{Resolved, Resolver};
use crate::scene::typed::{Typed, Uses, integer, select_less};
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span};
use crate::spec::dimension::{Angular, Dimension};
use crate::spec::expression::{Ast, Node};
use machinist_algebra::expr::{Expr, Symbol};

impl Resolver<'_> {
    pub(super) fn piecewise(
        &mut self,
        arguments: &[Ast],
        span: Span,
        scope: Scope,
        allowed: Uses,
    ) -> Resolved {
        let mut parts: Vec<Typed> = Vec::new();
        let mut conditions = Vec::new();
        for pair in arguments.chunks(2) {
            let [condition, value] = pair else { continue };
            let Node::Less(t, at) = &condition.node else {
                let mistake = Mistake::new(
                    Code::WrongArguments,
                    condition.span,
                    "expected a condition",
                    "not `a < b`",
                );
                return Err(Box::new(mistake.help("write piecewise(t < t1, a, x < x2, b, c)")));
            };
            conditions.push(self.condition(t, at, scope, allowed)?);
            parts.push(self.piece(value, &parts, scope, allowed)?);
        }
        if let Some(last) = arguments.last() {
            parts.push(self.piece(last, &parts, scope, allowed)?);
        }
        let bounds = conditions.iter().flat_map(|(time, at)| [time, at]);
        let mut typed = Typed::over(&parts.iter().chain(bounds).collect::<Vec<_>>());
        typed.depth += conditions.len();
        typed.dimension = parts.iter().find_map(|part| part.dimension);
        let angular = parts.iter().map(|part| part.angular).reduce(Angular::plus);
        typed.angular = angular.unwrap_or_default();
        if typed.depth > 400 {
            let message = "piecewise has too many pieces";
            return Err(Box::new(
                Mistake::new(Code::TooLarge, span, message, "here").help("use a table"),
            ));
        }
        let mut values = parts.into_iter().map(|part| part.expr).rev();
        let last = values.next().unwrap_or_else(|| integer(0));
        typed.expr =
            conditions.into_iter().rev().zip(values).fold(last, |otherwise, ((time, at), then)| {
                select_less(time.expr, at.expr, then, otherwise)
            });
        Ok(typed)
    }

    /// Resolves a value of the same dimension as those before it.
    fn piece(&mut self, ast: &Ast, before: &[Typed], scope: Scope, allowed: Uses) -> Resolved {
        let value = self.resolve(ast, scope, allowed)?;
        if let Some(known) = before.iter().find(|part| part.dimension.is_some()) {
            Self::agree(ast.span, known, &value)?;
        }
        Ok(value)
    }

    /// Resolves a condition. It is `t < at` with `at` of parameters only, where the solver stops;
    /// or `mode < number` for whole numbers, evaluated as `mode < number - 1/2`; or a comparison
    /// of values of one dimension, whose difference becomes a guard.
    pub(super) fn condition(
        &mut self,
        t: &Ast,
        at: &Ast,
        scope: Scope,
        allowed: Uses,
    ) -> Result<(Typed, Typed), Box<Mistake>> {
        let time = self.resolve(t, scope, allowed)?;
        if self.is_mode(&time.expr) {
            return self.mode_condition(time, at, scope);
        }
        let at_time = self.resolve(at, scope, allowed)?;
        if time.expr != Expr::Symbol(Symbol::Time) || at_time.uses != Uses::default() {
            Self::agree(at.span, &time, &at_time)?;
            return Ok((time, at_time));
        }
        if let Some(dimension) = at_time.dimension
            && dimension != Dimension::TIME
        {
            let message = format!("a time must be in s, but this is in {dimension}");
            let mistake =
                Mistake::new(Code::DimensionMismatch, at.span, message, format!("in {dimension}"));
            return Err(Box::new(mistake.help("write the unit of a number in brackets: 0.1 [s]")));
        }
        if !self.discontinuities.contains(&at_time.expr) {
            self.discontinuities.push(at_time.expr.clone());
        }
        Ok((time, at_time))
    }

    /// Reports whether an expression is a mode.
    pub(super) fn is_mode(&self, expr: &Expr) -> bool {
        let Expr::Symbol(Symbol::FirstOrder(id)) = expr else { return false };
        let spec = self.spec;
        let states = spec.instances.iter().flat_map(|instance| &spec.units[instance.unit].states);
        states
            .chain(&spec.states)
            .enumerate()
            .any(|(index, state)| index == id.0 as usize && state.is_mode)
    }

    fn mode_condition(
        &mut self,
        mode: Typed,
        at: &Ast,
        scope: Scope,
    ) -> Result<(Typed, Typed), Box<Mistake>> {
        let bound = self.resolve(at, scope, Uses::PARAMETERS)?;
        let Expr::Number(number) = &bound.expr else {
            let message = "a mode must be compared with an integer";
            return Err(Box::new(Mistake::new(
                Code::WrongArguments,
                at.span,
                message,
                "not a number",
            )));
        };
        if !number.is_integer() || bound.dimension.is_some_and(|d| d != Dimension::ONE) {
            let message = "a mode must be compared with an integer";
            return Err(Box::new(Mistake::new(
                Code::WrongArguments,
                at.span,
                message,
                "not an integer",
            )));
        }
        let half = num_rational::BigRational::new(1.into(), 2.into());
        let between = Typed { expr: Expr::Number(number - half), ..bound };
        Ok((mode, between))
    }
}
