//! Vectors in expressions: each is three expressions, of which scalar functions make one.
//!
//! A vector is written by `position(frame)`, `velocity(frame)`, `omega(frame)`, `x_axis(frame)`,
//! `y_axis(frame)`, `z_axis(frame)`, `vector(x, y, z)`, `cross(u, v)`, `in_frame(u, frame)` or
//! `der(u)`, by sums, and by products with one vector. Components are along the axes of the world, or
//! of a frame after `in_frame`. Dimensions are checked component by component.

use crate::scene::layout::{Local, Scope};
use crate::scene::resolve::{Resolved, Resolver};
use crate::scene::typed::Uses;
use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span};
use crate::spec::expression::{Ast, Node};
use crate::spec::quoted;

/// Functions that give vectors, as they are written.
const VECTORS: [&str; 10] = [
    "position(frame)",
    "velocity(frame)",
    "omega(frame)",
    "x_axis(frame)",
    "y_axis(frame)",
    "z_axis(frame)",
    "vector(x, y, z)",
    "cross(u, v)",
    "in_frame(u, frame)",
    "der(u)",
];

const AXES: [&str; 3] = ["x", "y", "z"];

/// Reports whether a function gives a vector. `der` does if its argument is one.
pub(super) fn gives_vector(function: &str) -> bool {
    let names = VECTORS.iter().filter_map(|written| written.split('(').next());
    function != "der" && names.into_iter().any(|name| name == function)
}

/// Reports whether an expression is a vector.
pub(super) fn is_vector(ast: &Ast) -> bool {
    match &ast.node {
        Node::Call(function, _, arguments) if function == "der" => arguments.iter().any(is_vector),
        Node::Call(function, ..) => gives_vector(function),
        Node::Negative(of) => is_vector(of),
        Node::Sum(terms) => terms.iter().any(|(_, term)| is_vector(term)),
        Node::Product(factors) => factors.iter().any(|(_, factor)| is_vector(factor)),
        _ => false,
    }
}

impl Resolver<'_> {
    /// Resolves a scalar function of vectors; `None` for another function.
    pub(super) fn of_vectors(
        &mut self,
        function: &str,
        arguments: &[Ast],
        span: Span,
        scope: Scope,
        allowed: Uses,
    ) -> Option<Resolved> {
        let written = match (function, arguments) {
            ("dot", [u, v]) => self.dot(u, v, span),
            ("norm", [u]) => self.dot(u, u, span).map(|square| Ast {
                span,
                node: Node::Call("sqrt".to_owned(), span, vec![square]),
            }),
            ("x_of" | "y_of" | "z_of", [u]) => {
                let axis = AXES.iter().position(|axis| function.starts_with(axis));
                self.component(u, axis.unwrap_or_default())
            }
            (name, _) if gives_vector(name) => Err(Box::new(a_vector(span))),
            ("der", [u]) if is_vector(u) => Err(Box::new(a_vector(span))),
            _ => return None,
        };
        // Products of free vectors are the same for each joint that carries all their frames. Seen by the
        // outermost one, they depend on the joints between these frames alone.
        let carrier = free(function, arguments).and_then(|frames| self.carrier_of(&frames, scope));
        let before = std::mem::replace(&mut self.carrier, carrier);
        let resolved = written.and_then(|ast| self.resolve(&ast, scope, allowed));
        self.carrier = before;
        Some(resolved)
    }

    /// Returns the outermost joint that carries all of some frames, unless it is the world.
    fn carrier_of(&mut self, frames: &[&Ast], scope: Scope) -> Option<usize> {
        let found: Option<Vec<_>> =
            frames.iter().map(|frame| self.frame_of(frame, scope)).collect();
        let found = found?;
        let spatial = self.spatial(found.first()?.0, frames[0].span).ok()?;
        spatial.common_carrier(&found)
    }

    /// Returns the instance and the index of a frame by its name.
    fn frame_of(&self, ast: &Ast, scope: Scope) -> Option<(usize, usize)> {
        let Node::Name(path, name) = &ast.node else { return None };
        let instance = match (path, scope) {
            (None, Scope::Instance(own)) => own,
            (Some(path), _) => self.instance(path, ast.span, scope).ok()?,
            _ => return None,
        };
        let names = &self.layout.units[self.spec.instances[instance].unit];
        match names.get(&format!("{name}_x"))? {
            Local::Frame(index, _) => Some((instance, index)),
            _ => None,
        }
    }

    fn dot(&mut self, u: &Ast, v: &Ast, span: Span) -> Result<Ast, Box<Mistake>> {
        let mut terms = Vec::new();
        for axis in 0..3 {
            terms.push((false, self.product_of((u, axis), (v, axis), span)?));
        }
        Ok(Ast { span, node: Node::Sum(terms) })
    }

    fn product_of(
        &mut self,
        (u, i): (&Ast, usize),
        (v, j): (&Ast, usize),
        span: Span,
    ) -> Result<Ast, Box<Mistake>> {
        let factors = vec![(false, self.component(u, i)?), (false, self.component(v, j)?)];
        Ok(Ast { span, node: Node::Product(factors) })
    }

    /// Returns a component of a vector as an expression.
    fn component(&mut self, ast: &Ast, axis: usize) -> Result<Ast, Box<Mistake>> {
        // Components of nested products are written out: their number counts as that of terms.
        self.spend(1, ast.span)?;
        self.descend(ast.span, 0)?;
        self.level += 1;
        let component = self.component_of(ast, axis);
        self.level -= 1;
        component
    }

    fn component_of(&mut self, ast: &Ast, axis: usize) -> Result<Ast, Box<Mistake>> {
        let span = ast.span;
        let of = |node: Node| Ok(Ast { span, node });
        match &ast.node {
            Node::Negative(u) => of(Node::Negative(Box::new(self.component(u, axis)?))),
            Node::Sum(terms) => {
                let mut all = Vec::new();
                for (is_negative, term) in terms {
                    all.push((*is_negative, self.component(term, axis)?));
                }
                of(Node::Sum(all))
            }
            Node::Product(factors) => {
                let is_factor = |(divides, factor): &&(bool, Ast)| !divides && is_vector(factor);
                if factors.iter().filter(|(_, factor)| is_vector(factor)).count() != 1
                    || factors.iter().filter(is_factor).count() != 1
                {
                    let message = "a product of vectors is written `dot(u, v)` or `cross(u, v)`";
                    let label = "not one vector among factors";
                    return Err(Box::new(Mistake::new(Code::InvalidVector, span, message, label)));
                }
                let mut all = Vec::new();
                for (divides, factor) in factors {
                    let factor = if is_vector(factor) {
                        self.component(factor, axis)?
                    } else {
                        factor.clone()
                    };
                    all.push((*divides, factor));
                }
                of(Node::Product(all))
            }
            Node::Call(function, name, arguments) => match (function.as_str(), &arguments[..]) {
                ("vector", parts @ [_, _, _]) => Ok(parts[axis].clone()),
                ("position", [frame]) => named(frame, AXES[axis]),
                ("velocity", [frame]) => named(frame, &format!("v_{}", AXES[axis])),
                ("omega", [frame]) => named(frame, &format!("omega_{}", AXES[axis])),
                ("x_axis" | "y_axis" | "z_axis", [frame]) => {
                    named(frame, &format!("r_{}{}", AXES[axis], &function[..1]))
                }
                ("cross", [u, v]) => {
                    let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
                    let ahead = self.product_of((u, j), (v, k), span)?;
                    let back = self.product_of((u, k), (v, j), span)?;
                    of(Node::Sum(vec![(false, ahead), (true, back)]))
                }
                ("in_frame", [u, frame]) => {
                    let axis = format!("{}_axis", AXES[axis]);
                    let call = Node::Call(axis, *name, vec![frame.clone()]);
                    self.dot(u, &Ast { span: frame.span, node: call }, span)
                }
                ("der", [u]) if is_vector(u) => {
                    let rate = vec![self.component(u, axis)?];
                    of(Node::Call("der".to_owned(), *name, rate))
                }
                _ => Err(Box::new(no_vector(span))),
            },
            _ => Err(Box::new(no_vector(span))),
        }
    }
}

/// Returns the frames of a product of free vectors; `None` if it depends on the axes or the origin of the
/// world.
fn free<'a>(function: &str, arguments: &'a [Ast]) -> Option<Vec<&'a Ast>> {
    let mut frames = Vec::new();
    let vectors = match (function, arguments) {
        ("dot" | "norm", vectors) => vectors,
        (_, [Ast { node: Node::Call(inner, _, parts), .. }]) if inner == "in_frame" => {
            frames.extend(parts.get(1));
            parts.get(..1)?
        }
        _ => return None,
    };
    vectors.iter().all(|vector| weight(vector, &mut frames) == Some(0)).then_some(frames)
}

/// Returns the number of positions in a sum of positions and axes, less those subtracted, and adds their
/// frames; `None` for another vector.
fn weight<'a>(ast: &'a Ast, frames: &mut Vec<&'a Ast>) -> Option<i32> {
    match &ast.node {
        Node::Negative(of) => Some(-weight(of, frames)?),
        Node::Sum(terms) => terms.iter().try_fold(0, |sum, (is_negative, term)| {
            let own = weight(term, frames)?;
            Some(if *is_negative { sum - own } else { sum + own })
        }),
        Node::Call(function, _, parts) => match (function.as_str(), &parts[..]) {
            ("position", [frame]) => {
                frames.push(frame);
                Some(1)
            }
            ("x_axis" | "y_axis" | "z_axis", [frame]) => {
                frames.push(frame);
                Some(0)
            }
            ("cross", [u, v]) => {
                let is_free = weight(u, frames)? == 0 && weight(v, frames)? == 0;
                is_free.then_some(0)
            }
            _ => None,
        },
        _ => None,
    }
}

/// Returns the name of a part of the motion of a frame, which is written as a name.
fn named(frame: &Ast, end: &str) -> Result<Ast, Box<Mistake>> {
    let Node::Name(instance, name) = &frame.node else {
        let message = "a frame is given by its name";
        return Err(Box::new(Mistake::new(Code::InvalidVector, frame.span, message, "not a name")));
    };
    let node = Node::Name(instance.clone(), format!("{name}_{end}"));
    Ok(Ast { span: frame.span, node })
}

fn no_vector(span: Span) -> Mistake {
    let known = VECTORS.map(quoted).join(", ");
    Mistake::new(Code::InvalidVector, span, "this is not a vector", "a number")
        .help(format!("vectors are {known}"))
}

fn a_vector(span: Span) -> Mistake {
    let help = "write `dot(u, v)`, `norm(u)`, `x_of(u)`, `y_of(u)` or `z_of(u)`";
    Mistake::new(Code::InvalidVector, span, "a vector is not a value", "three components")
        .help(help)
}
