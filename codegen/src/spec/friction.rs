//! Dry friction with exact sticking, `[friction.NAME]`. It is translated to a mode, a constraint
//! while it sticks, a force while it slides, and events between them.
//!
//! Excluded: its target and its losses, which follow from its speed; [`crate::scene`] derives
//! them.

use crate::spec::diagnostic::{Span, Spanned};
use crate::spec::dimension::{Dimension, Unit};
use crate::spec::event;
use crate::spec::expression::{Ast, Literal, Node};
use crate::spec::fields::{Fields, Findings};
use crate::spec::names::quoted;
use crate::spec::toml::Entry;
use crate::spec::{
    ConstraintSpec, Declared, DefinitionSpec, EventSpec, Formula, FrictionSpec, StateSpec,
};
use machinist_model::Direction;
use num_bigint::BigInt;
use num_rational::BigRational;

/// Mode: slides backwards.
const BACK: i32 = -1;
/// Mode: sticks.
const STUCK: i32 = 0;
/// Mode: slides forwards.
const FORTH: i32 = 1;
/// Mode: no friction.
const OPEN: i32 = 2;

/// Reciprocal of the default speed below which friction sticks initially, in SI units.
const SLOW: i64 = 1_000_000_000;
/// Reciprocal of the force below which friction is inactive, in SI units.
const IDLE: i64 = 1_000_000_000_000;

/// Lists of a unit or a scene that friction adds to.
pub struct Lists<'a> {
    pub states: &'a mut Vec<StateSpec>,
    pub helpers: &'a mut Vec<DefinitionSpec>,
    pub constraints: &'a mut Vec<ConstraintSpec>,
    pub events: &'a mut Vec<EventSpec>,
}

/// Reads `[friction]` of a unit or a scene.
pub fn all(fields: &mut Fields<'_>, mut lists: Lists<'_>) -> Vec<FrictionSpec> {
    let entries = fields.named("friction").iter();
    let written = entries.filter_map(|entry| Written::read(entry, fields.found()));
    written.map(|written| written.write_out(&mut lists)).collect()
}

/// Friction as written.
struct Written {
    name: Spanned<String>,
    /// Sliding speed.
    speed: Ast,
    /// Magnitude of the force while sliding.
    sliding: Ast,
    /// Breakaway force, if it differs.
    breakaway: Option<Ast>,
    /// Speed below which it sticks initially.
    sticking_speed: Ast,
    unit: Declared,
    doc: String,
}

impl Written {
    fn read(entry: &Entry, found: &mut Findings) -> Option<Self> {
        let what = format!("friction {}", quoted(&entry.key.value));
        let mut fields = Fields::open(&entry.value, what, found);
        let speed = fields.required_expression("speed");
        let sliding = fields.required_expression("sliding");
        let breakaway = fields.expression("breakaway");
        let sticking_speed = fields.expression("sticking_speed");
        let unit = fields.unit();
        let doc = fields.text("doc");
        fields.close();
        let (name, unit) = (entry.key.clone(), unit?);
        let of_speed = Dimension::POWER.over(unit.unit.dimension).unwrap_or(Dimension::ONE);
        let slow = part(SLOW, of_speed, name.span);
        Some(Self {
            name,
            speed: speed?,
            sliding: sliding?,
            breakaway,
            sticking_speed: sticking_speed.unwrap_or(slow),
            unit,
            doc,
        })
    }

    fn write_out(self, lists: &mut Lists<'_>) -> FrictionSpec {
        lists.states.push(self.mode());
        lists.helpers.extend(self.helpers());
        lists.constraints.push(self.grip());
        lists.events.extend(self.events());
        let [slide, grip] = ["slide", "grip"].map(|suffix| self.ast(self.called(suffix)));
        let force = sum([slide.clone(), grip]);
        let force = self.definition(self.name.clone(), force, &self.doc);
        FrictionSpec { speed: self.speed, slide, force }
    }

    fn mode(&self) -> StateSpec {
        let initial = Spanned { value: Literal::of_integer(OPEN.into()), span: self.name.span };
        let doc = "-1 sliding backward, 0 sticking, 1 sliding forward, 2 open";
        event::mode_called(self.called("slip"), Some(Formula::Number(initial)), doc.to_owned())
    }

    /// Returns the magnitudes of its forces, and the force while sliding.
    fn helpers(&self) -> [DefinitionSpec; 3] {
        let sliding = || self.ast(self.called("sliding"));
        let breakaway = match &self.breakaway {
            None => sliding(),
            // The breakaway force is at least the sliding force, so sliding continues after
            // breakaway.
            Some(breakaway) => call("max", [breakaway.clone(), sliding()], breakaway.span),
        };
        let back = less(self.ast(self.called("slip")), self.number(STUCK));
        let stuck = less(self.ast(self.called("slip")), self.number(FORTH));
        let forth = less(self.ast(self.called("slip")), self.number(OPEN));
        let [zero, open] = [self.number(0), self.number(0)];
        let cases = [back, sliding(), stuck, zero, forth, negative(sliding()), open];
        let slide = call("piecewise", cases, self.name.span);
        let what = [
            ("sliding", self.sliding.clone(), "magnitude of the sliding friction"),
            ("breakaway", breakaway, "largest friction while sticking"),
            ("slide", slide, "friction while sliding"),
        ];
        what.map(|(suffix, ast, doc)| self.definition(self.called(suffix), ast, doc))
    }

    fn grip(&self) -> ConstraintSpec {
        ConstraintSpec {
            name: self.called("grip"),
            expression: self.speed.clone(),
            when: self.when(STUCK),
            doc: "zero slip speed while sticking".to_owned(),
            friction: Some(self.name.clone()),
        }
    }

    fn events(&self) -> Vec<EventSpec> {
        let idle = part(IDLE, self.unit.unit.dimension, self.sliding.span);
        let holds = || sum([self.ast(self.called("sliding")), negative(idle.clone())]);
        let [grip, breakaway] = ["grip", "breakaway"].map(|suffix| self.ast(self.called(suffix)));
        let above = sum([grip.clone(), negative(breakaway.clone())]);
        let below = sum([grip, breakaway]);
        let begins = "friction sets in: sliding or sticking";
        let opens = "friction ends";
        let (rising, falling) = (Direction::Rising, Direction::Falling);
        let mut events = vec![
            self.event("closes", (holds(), rising), OPEN, self.begins(), begins),
            self.event("opens_stuck", (holds(), falling), STUCK, self.number(OPEN), opens),
            self.event("opens_back", (holds(), falling), BACK, self.number(OPEN), opens),
            self.event("opens_forth", (holds(), falling), FORTH, self.number(OPEN), opens),
        ];
        for (suffix, direction, from, doc) in [
            ("ends_back", rising, BACK, "backward sliding ends"),
            ("ends_forth", falling, FORTH, "forward sliding ends"),
        ] {
            let guard = (self.speed.clone(), direction);
            events.push(self.event(suffix, guard, from, self.number(STUCK), doc));
        }
        for (suffix, guard, to, doc) in [
            ("breaks_back", (above, rising), BACK, "breakaway, backward"),
            ("breaks_forth", (below, falling), FORTH, "breakaway, forward"),
        ] {
            events.push(self.event(suffix, guard, STUCK, self.number(to), doc));
        }
        events
    }

    /// Returns the initial mode from the speed: (sign(s - slow) + sign(s + slow))/2.
    fn begins(&self) -> Ast {
        let sign = |by: Ast| call("sign", [sum([self.speed.clone(), by])], self.name.span);
        let slow = self.sticking_speed.clone();
        let twice = sum([sign(negative(slow.clone())), sign(slow)]);
        let factors = vec![(false, twice), (true, self.number(2))];
        Ast { span: self.name.span, node: Node::Product(factors) }
    }

    fn event(
        &self,
        suffix: &str,
        (guard, direction): (Ast, Direction),
        from: i32,
        to: Ast,
        doc: &str,
    ) -> EventSpec {
        let set = vec![(self.called("slip"), Formula::Expression(to))];
        let (name, when) = (self.called(suffix), self.when(from));
        EventSpec { name, guard, direction, when, set, doc: doc.to_owned() }
    }

    fn when(&self, value: i32) -> Vec<(Spanned<String>, i32)> {
        vec![(self.called("slip"), value)]
    }

    fn definition(&self, name: Spanned<String>, expression: Ast, doc: &str) -> DefinitionSpec {
        DefinitionSpec { name, expression, unit: self.unit.clone(), doc: doc.to_owned() }
    }

    /// Returns the name of one of its parts.
    fn called(&self, suffix: &str) -> Spanned<String> {
        Spanned { value: format!("{}_{suffix}", self.name.value), span: self.name.span }
    }

    fn ast(&self, name: Spanned<String>) -> Ast {
        // Mistakes in the magnitudes refer to their own text.
        let span = if name.value.ends_with("_sliding") { self.sliding.span } else { name.span };
        Ast { span, node: Node::Name(None, name.value) }
    }

    fn number(&self, value: i32) -> Ast {
        let literal = Literal::of_integer(value.into());
        Ast { span: self.name.span, node: Node::Number(literal, None) }
    }
}

/// Returns the reciprocal of a large number with a dimension, in SI units.
fn part(of: i64, dimension: Dimension, span: Span) -> Ast {
    let literal = Literal(BigRational::new(BigInt::from(1), BigInt::from(of)));
    Ast { span, node: Node::Number(literal, Some(Unit { dimension, rad: 0 })) }
}

fn sum<const N: usize>(terms: [Ast; N]) -> Ast {
    let span = terms[0].span;
    Ast { span, node: Node::Sum(terms.into_iter().map(|term| (false, term)).collect()) }
}

fn negative(of: Ast) -> Ast {
    Ast { span: of.span, node: Node::Negative(Box::new(of)) }
}

fn less(a: Ast, b: Ast) -> Ast {
    Ast { span: a.span, node: Node::Less(Box::new(a), Box::new(b)) }
}

fn call<const N: usize>(function: &str, arguments: [Ast; N], span: Span) -> Ast {
    Ast { span, node: Node::Call(function.to_owned(), span, arguments.into()) }
}
