//! Dry friction with exact sticking, `[friction.NAME]`. It is translated to a mode, a constraint
//! while it sticks, a force while it slides, and events between them.
//!
//! Excluded: its target and its losses, which follow from its speed; [`crate::scene`] derives
//! them.

use std::collections::BTreeMap;

use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span, Spanned};
use crate::spec::dimension::{Dimension, Unit};
use crate::spec::event;
use crate::spec::expression::{Ast, Literal, Node};
use crate::spec::fields::{Fields, Findings};
use crate::spec::names::{self, quoted};
use crate::spec::toml::{Entry, Tree};
use crate::spec::{
    ConstraintSpec, Declared, DefinitionSpec, EventSpec, Formula, FrictionSpec, Openings, StateSpec,
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
/// Mode: no friction, or not yet determined.
pub const OPEN: i32 = machinist_contract::Constraint::OPEN as i32;

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
    let written: Vec<_> =
        entries.filter_map(|entry| Written::read(entry, fields.found())).collect();
    let mut frictions = Vec::with_capacity(written.len());
    let mut owners = BTreeMap::new();
    for written in written {
        let name = written.name.clone();
        if let Some(owner) = owners.insert(written.prefix.clone(), name.value.clone()) {
            let message =
                format!("frictions {} and {} share a prefix", quoted(&owner), quoted(&name.value));
            let mistake = Mistake::new(
                Code::DuplicateName,
                name.span,
                message,
                "its parts would have the same names",
            );
            let help = "give each a `prefix` of its own, or leave it out: the name is the prefix";
            fields.found().mistakes.push(mistake.help(help));
            continue;
        }
        frictions.push(written.write_out(&mut lists));
    }
    frictions
}

/// Friction as written.
struct Written {
    name: Spanned<String>,
    /// Prefix of the names of its parts.
    prefix: String,
    /// Sliding speed.
    speed: Ast,
    /// Magnitude of the force while sliding.
    sliding: Limits,
    /// Breakaway force, if it differs.
    breakaway: Option<Limits>,
    /// Speed below which it sticks initially.
    sticking_speed: Ast,
    /// Force below which there is no friction; `None` if the contact never opens.
    idle: Option<Ast>,
    unit: Declared,
    doc: String,
}

/// Magnitudes of a force.
enum Limits {
    /// The same for both directions of sliding.
    Both(Ast),
    /// One for each direction.
    Each { forward: Ast, backward: Ast },
    /// For forward sliding; backward, the contact cannot slide.
    OneWay(Ast),
}

/// A direction of sliding.
struct Way {
    /// The mode.
    mode: i32,
    /// Suffix of the names of its events.
    suffix: &'static str,
    /// Suffix of the names of its magnitudes, if they differ by direction.
    of_limits: &'static str,
    word: &'static str,
}

const BACKWARD: Way = Way { mode: BACK, suffix: "back", of_limits: "_backward", word: "backward" };
const FORWARD: Way = Way { mode: FORTH, suffix: "forth", of_limits: "_forward", word: "forward" };

impl Limits {
    fn read(fields: &mut Fields<'_>, key: &'static str, is_required: bool) -> Option<Self> {
        let tree = if is_required { fields.require(key) } else { fields.take(key) }?;
        if !matches!(tree.value, Tree::Table(_)) {
            return fields.as_expression(tree, key).map(Self::Both);
        }
        let mut each = Fields::open(tree, format!("`{key}` by direction"), fields.found());
        let forward = each.required_expression("forward");
        let backward = each.expression("backward");
        each.close();
        let forward = forward?;
        Some(match backward {
            Some(backward) => Self::Each { forward, backward },
            None => Self::OneWay(forward),
        })
    }

    /// Returns the magnitude for a direction.
    fn of(&self, way: &Way) -> &Ast {
        match self {
            Self::Each { backward, .. } if way.mode == BACK => backward,
            Self::Both(of) | Self::Each { forward: of, .. } | Self::OneWay(of) => of,
        }
    }
}

impl Written {
    fn read(entry: &Entry, found: &mut Findings) -> Option<Self> {
        let what = format!("friction {}", quoted(&entry.key.value));
        let mut fields = Fields::open(&entry.value, what, found);
        let speed = fields.required_expression("speed");
        let sliding = Limits::read(&mut fields, "sliding", true);
        let breakaway = Limits::read(&mut fields, "breakaway", false);
        let sticking_speed = fields.expression("sticking_speed");
        let idle = fields.expression("idle");
        let always = fields.flag("always");
        let prefix = fields.take("prefix").and_then(|tree| fields.as_text(tree, "prefix"));
        let unit = fields.unit();
        let doc = fields.text("doc");
        if let Some(prefix) = prefix.as_ref().filter(|prefix| !prefix.value.is_empty())
            && let Err(mistake) = names::check(prefix)
        {
            fields.found().mistakes.push(mistake);
        }
        let name = entry.key.clone();
        let is_one_way = |limits: &Option<Limits>| matches!(limits, Some(Limits::OneWay(_)));
        if let Some(Limits::Each { .. } | Limits::OneWay(_)) = breakaway
            && is_one_way(&breakaway) != is_one_way(&sliding)
            && let Some(tree) = fields.take("breakaway")
        {
            let message = "`sliding` and `breakaway` have different directions";
            let mistake =
                Mistake::new(Code::ConflictingKeys, tree.span, message, "of other directions");
            let help = "give both in both directions, or both in `forward` alone";
            fields.found().mistakes.push(mistake.help(help));
        }
        let never_opens = always || is_one_way(&sliding);
        if let Some(idle) = idle.as_ref().filter(|_| never_opens) {
            let message = format!("friction {} never opens", quoted(&name.value));
            let mistake = Mistake::new(Code::NoEffect, idle.span, message, "never reached");
            let help = "leave out `idle`, or `always`; a contact that slides one way never opens";
            fields.found().mistakes.push(mistake.help(help));
        }
        fields.close();
        let unit = unit?;
        let of_speed = Dimension::POWER.over(unit.unit.dimension).unwrap_or(Dimension::ONE);
        let slow = part(SLOW, of_speed, name.span);
        let idle = idle.unwrap_or_else(|| part(IDLE, unit.unit.dimension, name.span));
        Some(Self {
            prefix: prefix.map_or_else(|| format!("{}_", name.value), |prefix| prefix.value),
            name,
            speed: speed?,
            sliding: sliding?,
            breakaway,
            sticking_speed: sticking_speed.unwrap_or(slow),
            idle: (!never_opens).then_some(idle),
            unit,
            doc,
        })
    }

    fn write_out(self, lists: &mut Lists<'_>) -> FrictionSpec {
        lists.states.push(self.mode());
        let (helpers, events) = (self.helpers(), self.events());
        let names = helpers.iter().map(|helper| &helper.name);
        let names = names.chain(events.iter().map(|event| &event.name));
        let parts = names.map(|name| name.value.clone()).collect();
        let opens = self.called("opens_").value;
        let opens =
            events.iter().map(|event| &event.name.value).filter(|name| name.starts_with(&opens));
        let openings =
            Openings { closes: self.called("closes").value, opens: opens.cloned().collect() };
        lists.helpers.extend(helpers);
        lists.constraints.push(self.grip());
        lists.events.extend(events);
        let [slide, grip] = ["slide", "grip"].map(|suffix| self.ast(suffix));
        let force = sum([slide.clone(), grip]);
        let force = self.definition(self.name.clone(), force, &self.doc);
        let limits = self.limits_as_written();
        FrictionSpec { speed: self.speed, slide, force, limits, parts, openings }
    }

    fn limits_as_written(&self) -> Vec<(String, Ast)> {
        let all = [("sliding", Some(&self.sliding)), ("sticking", self.breakaway.as_ref())];
        let all = all.into_iter().filter_map(|(what, limits)| Some((what, limits?)));
        let cases = all.flat_map(|(what, limits)| {
            let of = |way: &Way| (format!("{what} {}", way.word), limits.of(way).clone());
            match limits {
                Limits::Both(limit) => vec![(what.to_owned(), limit.clone())],
                Limits::Each { .. } => vec![of(&FORWARD), of(&BACKWARD)],
                Limits::OneWay(_) => vec![of(&FORWARD)],
            }
        });
        cases.collect()
    }

    fn mode(&self) -> StateSpec {
        let initial = Spanned { value: Literal::of_integer(OPEN.into()), span: self.name.span };
        let doc = match (&self.sliding, &self.idle) {
            (Limits::OneWay(_), _) => "0 locked, 1 sliding forward, 2 undetermined",
            (_, None) => "-1 sliding backward, 0 sticking, 1 sliding forward, 2 undetermined",
            (_, Some(_)) => "-1 sliding backward, 0 sticking, 1 sliding forward, 2 open",
        };
        event::mode_called(self.called("slip"), Some(Formula::Number(initial)), doc.to_owned())
    }

    /// Returns the directions in which it slides.
    fn ways(&self) -> &'static [Way] {
        match self.sliding {
            Limits::OneWay(_) => &[FORWARD],
            _ => &[BACKWARD, FORWARD],
        }
    }

    /// Reports whether magnitudes differ by direction.
    fn is_directed(&self) -> bool {
        let directed = |limits: &Limits| !matches!(limits, Limits::Both(_));
        directed(&self.sliding) || self.breakaway.as_ref().is_some_and(directed)
    }

    /// Returns the directions with magnitudes of their own.
    fn limited(&self) -> &'static [Way] {
        if self.is_directed() { self.ways() } else { &[FORWARD] }
    }

    /// Returns one of its magnitudes by its name.
    fn limit(&self, of: &str, way: &Way) -> Ast {
        let suffix = if self.is_directed() { way.of_limits } else { "" };
        self.ast(&format!("{of}{suffix}"))
    }

    /// Returns the magnitudes of its forces, and the force while sliding.
    fn helpers(&self) -> Vec<DefinitionSpec> {
        let mut helpers = Vec::new();
        for way in self.limited() {
            let [suffix, word] = if self.is_directed() {
                [way.of_limits.to_owned(), format!(", {}", way.word)]
            } else {
                [const { String::new() }; 2]
            };
            let breakaway = match &self.breakaway {
                None => self.limit("sliding", way),
                // The breakaway force is at least the sliding force, so sliding continues after
                // breakaway.
                Some(breakaway) => {
                    let breakaway = breakaway.of(way).clone();
                    let span = breakaway.span;
                    call("max", vec![breakaway, self.limit("sliding", way)], span)
                }
            };
            let sliding = self.sliding.of(way).clone();
            for (name, ast, doc) in [
                ("sliding", sliding, "magnitude of the sliding friction"),
                ("breakaway", breakaway, "largest friction while sticking"),
            ] {
                let name = self.called(&format!("{name}{suffix}"));
                helpers.push(self.definition(name, ast, &format!("{doc}{word}")));
            }
        }
        let below = |value: i32| less(self.ast("slip"), self.number(value));
        let mut cases = Vec::new();
        if let [backward, _] = self.ways() {
            cases.extend([below(STUCK), self.limit("sliding", backward)]);
        }
        cases.extend([below(FORTH), self.number(0)]);
        cases.extend([below(OPEN), negative(self.limit("sliding", &FORWARD)), self.number(0)]);
        let slide = call("piecewise", cases, self.name.span);
        helpers.push(self.definition(self.called("slide"), slide, "friction while sliding"));
        helpers
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
        let (rising, falling) = (Direction::Rising, Direction::Falling);
        let ways = self.ways();
        let begins = "friction sets in: sliding or sticking";
        let holds = self.idle.as_ref().map(|idle| {
            let limits = self.limited().iter().map(|way| (false, self.limit("sliding", way)));
            let terms = limits.chain([(true, idle.clone())]).collect();
            Ast { span: self.sliding.of(&FORWARD).span, node: Node::Sum(terms) }
        });
        let closes = (holds.clone().unwrap_or_else(|| self.number(1)), rising);
        let mut events = vec![self.event("closes", closes, OPEN, self.begins(), begins)];
        if let Some(holds) = holds {
            let modes = ways.iter().map(|way| (way.suffix, way.mode));
            for (suffix, from) in [("stuck", STUCK)].into_iter().chain(modes) {
                let (name, guard) = (format!("opens_{suffix}"), (holds.clone(), falling));
                let to = self.number(OPEN);
                events.push(self.event(&name, guard, from, to, "friction ends"));
            }
        }
        for way in ways {
            let direction = if way.mode == BACK { rising } else { falling };
            let (name, guard) = (format!("ends_{}", way.suffix), (self.speed.clone(), direction));
            let doc = format!("{} sliding ends", way.word);
            events.push(self.event(&name, guard, way.mode, self.number(STUCK), &doc));
        }
        for way in ways {
            let (grip, breakaway) = (self.ast("grip"), self.limit("breakaway", way));
            let guard = if way.mode == BACK {
                (sum([grip, negative(breakaway)]), rising)
            } else {
                (sum([grip, breakaway]), falling)
            };
            let (name, doc) =
                (format!("breaks_{}", way.suffix), format!("breakaway, {}", way.word));
            events.push(self.event(&name, guard, STUCK, self.number(way.mode), &doc));
        }
        events
    }

    /// Returns the initial mode from the speed s: (sign(s - slow) + sign(s + slow))/2, or with
    /// one direction (sign(s - slow) + 1)/2.
    fn begins(&self) -> Ast {
        let sign = |by: Ast| call("sign", vec![sum([self.speed.clone(), by])], self.name.span);
        let slow = self.sticking_speed.clone();
        let other = match self.sliding {
            Limits::OneWay(_) => self.number(1),
            _ => sign(slow.clone()),
        };
        let twice = sum([sign(negative(slow)), other]);
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
        Spanned { value: format!("{}{suffix}", self.prefix), span: self.name.span }
    }

    fn ast(&self, suffix: &str) -> Ast {
        // Mistakes in the magnitudes refer to their own text.
        let span = match suffix {
            "sliding_backward" => self.sliding.of(&BACKWARD).span,
            "sliding" | "sliding_forward" => self.sliding.of(&FORWARD).span,
            _ => self.name.span,
        };
        Ast { span, node: Node::Name(None, self.called(suffix).value) }
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

fn call(function: &str, arguments: Vec<Ast>, span: Span) -> Ast {
    Ast { span, node: Node::Call(function.to_owned(), span, arguments) }
}
