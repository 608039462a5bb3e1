//! Drawing as SVG.

use std::cmp::Ordering;

use machinist_codegen::spec::PortKind;
use maud::{Markup, html};

use super::arrange::places;
use super::symbol::outline;
use super::{Link, Net, Part, Schematic, Tie};

/// Size of a part, and distances between parts.
const WIDTH: f64 = 112.0;
const HEIGHT: f64 = 66.0;
const ACROSS: f64 = 168.0;
const DOWN: f64 = 92.0;
const MARGIN: f64 = 12.0;
/// Size of a symbol, and its distance from the top of the part.
const SYMBOL: [f64; 2] = [48.0, 28.0];
const TOP: f64 = 9.0;
/// Depth by which a line hangs below the parts that it joins.
const SAG: f64 = 20.0;
/// Smallest scale to which wide drawings are reduced.
const SMALLEST: f64 = 0.65;
/// Number of letters of a name that fit.
const LETTERS: usize = 15;
/// Largest number of parts that is drawn.
const MOST: usize = 80;

/// Draws a machine, or returns a sentence if it is too large.
pub fn drawing(schematic: &Schematic) -> Markup {
    if schematic.parts.len() > MOST {
        return html! {
            p.muted { "The machine has " (schematic.parts.len()) " parts, too many to be drawn." }
        };
    }
    let plan = Plan::of(schematic);
    let [width, height] = plan.size(schematic);
    html! {
        svg.schematic viewBox={ "0 0 " (width) " " (height) } width=(width) height=(height)
            style={ "min-width: " (SMALLEST * width) "px" } role="img" aria-label="drawing of the machine's parts and joints" {
            @for link in &schematic.links { (plan.link(link)) }
            @for net in &plan.nets { (net.drawn()) }
            @for (index, (part, place)) in schematic.parts.iter().zip(&plan.corners).enumerate() {
                (drawn(index, part, *place))
            }
        }
    }
}

/// Renders a legend of the kinds of lines that occur.
pub fn legend(schematic: &Schematic) -> Markup {
    let kinds = PortKind::ALL.into_iter();
    let occurs = |kind: PortKind| schematic.nets.iter().any(|net| net.kind == kind);
    let ties = [(Tie::Signal, "signal"), (Tie::Constraint, "constraint")];
    let tied = |tie: Tie| schematic.links.iter().any(|link| link.what == tie);
    let lines: Vec<(&str, &str)> = kinds
        .filter(|(_, kind)| occurs(*kind))
        .map(|(name, _)| (name, name))
        .chain(ties.into_iter().filter(|(tie, _)| tied(*tie)).map(|(tie, name)| (name, class(tie))))
        .collect();
    html! {
        ul.legend {
            @for (name, class) in lines {
                li {
                    svg.schematic viewBox="0 0 18 10" aria-hidden="true" {
                        path class=(class) d="M0 5H18" {}
                    }
                    (name)
                }
            }
        }
    }
}

fn class(tie: Tie) -> &'static str {
    match tie {
        Tie::Signal => "signal",
        Tie::Constraint => "constraint",
    }
}

fn drawn(index: usize, part: &Part, [x, y]: [f64; 2]) -> Markup {
    let name = shortened(&part.name);
    let scale = [x + (WIDTH - SYMBOL[0]) / 2.0, y + TOP];
    let below = if part.symbol.is_some() { HEIGHT - 11.0 } else { HEIGHT / 2.0 + 4.0 };
    html! {
        g data-part=(index) {
            title { (part.name) ": " (part.title) }
            rect x=(x) y=(y) width=(WIDTH) height=(HEIGHT) rx="6" {}
            @if let Some(symbol) = part.symbol {
                path.symbol transform={ "translate(" (scale[0]) " " (scale[1]) ")" }
                    d=(outline(symbol)) {}
            }
            text x=(x + WIDTH / 2.0) y=(y + below) { (name) }
        }
    }
}

fn shortened(name: &str) -> String {
    if name.chars().count() <= LETTERS {
        return name.to_owned();
    }
    let kept: String = name.chars().take(LETTERS - 1).collect();
    kept + "\u{2026}"
}

/// Positions of all elements.
struct Plan {
    /// Column and row of each part, and the resulting corner.
    places: Vec<(usize, usize)>,
    corners: Vec<[f64; 2]>,
    nets: Vec<Wires>,
}

/// Wires of a net, from its ports to a line in the gap between two columns.
struct Wires {
    kind: PortKind,
    title: String,
    /// Column to the left of the line, and position of the line.
    column: usize,
    bus: f64,
    ends: Vec<[f64; 2]>,
}

impl Plan {
    fn of(schematic: &Schematic) -> Self {
        let places = places(schematic);
        let corner = |(column, row): &(usize, usize)| {
            [MARGIN + *column as f64 * ACROSS, MARGIN + *row as f64 * DOWN]
        };
        let corners: Vec<[f64; 2]> = places.iter().map(corner).collect();
        let left = |net: &Net| net.ports.iter().map(|(part, _)| places[*part].0).min().unwrap_or(0);
        // A net leaves a part of its leftmost column to the right, and other parts to the left.
        let is_right = |net: &Net, part: usize| places[part].0 == left(net);
        let mean = |net: &Net| {
            let rows: usize = net.ports.iter().map(|(part, _)| places[*part].1).sum();
            rows as f64 / net.ports.len().max(1) as f64
        };
        let mut wires: Vec<Wires> = Vec::new();
        for net in &schematic.nets {
            let end = |(part, port): &(usize, String)| {
                let right = is_right(net, *part);
                let key = |net: &Net, port: &str| (mean(net), port.to_owned());
                let mut others: Vec<(f64, String)> = schematic
                    .nets
                    .iter()
                    .flat_map(|net| net.ports.iter().map(move |port| (net, port)))
                    .filter(|(net, (of, _))| of == part && is_right(net, *part) == right)
                    .map(|(net, (_, port))| key(net, port))
                    .collect();
                others.sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
                let own = key(net, port);
                let at = others.iter().position(|other| *other == own).unwrap_or(0);
                let [x, y] = corners[*part];
                let down = HEIGHT * (at + 1) as f64 / (others.len() + 1) as f64;
                [if right { x + WIDTH } else { x }, y + down]
            };
            let ends: Vec<[f64; 2]> = net.ports.iter().map(end).collect();
            let names = net.ports.iter().filter(|(_, port)| !port.is_empty());
            let names = names.map(|(part, port)| format!("{}.{port}", schematic.parts[*part].name));
            let title = names.collect::<Vec<_>>().join(" \u{2013} ");
            wires.push(Wires { kind: net.kind, title, column: left(net), bus: 0.0, ends });
        }
        give_way(&mut wires);
        Self { places, corners, nets: wires }
    }

    fn size(&self, schematic: &Schematic) -> [f64; 2] {
        let below = if schematic.links.is_empty() { 0.0 } else { SAG };
        let far = |axis: usize, size: f64| {
            let most = self.corners.iter().map(|corner| corner[axis]).fold(0.0, f64::max);
            most + size + MARGIN
        };
        let buses = self.nets.iter().map(|net| net.bus + MARGIN);
        [buses.fold(far(0, WIDTH), f64::max), far(1, HEIGHT) + below]
    }

    /// Draws a curve above or below the elements between two parts.
    fn link(&self, link: &Link) -> Markup {
        let [from, to] = [self.corners[link.from], self.corners[link.to]];
        let [(from_column, from_row), (to_column, to_row)] =
            [self.places[link.from], self.places[link.to]];
        let [start, end] = match to_column.cmp(&from_column) {
            Ordering::Less => [0.25, 0.75],
            Ordering::Equal => [0.5, 0.5],
            Ordering::Greater => [0.75, 0.25],
        };
        let (x0, x1) = (from[0] + start * WIDTH, to[0] + end * WIDTH);
        // Parts of one row are joined along their lower edges.
        let [y0, y1, between] = match to_row.cmp(&from_row) {
            Ordering::Less => [from[1], to[1] + HEIGHT, f64::midpoint(from[1], to[1] + HEIGHT)],
            Ordering::Equal => [from[1] + HEIGHT, to[1] + HEIGHT, from[1] + HEIGHT + SAG],
            Ordering::Greater => [from[1] + HEIGHT, to[1], f64::midpoint(from[1] + HEIGHT, to[1])],
        };
        let d = format!("M{x0} {y0}C{x0} {between} {x1} {between} {x1} {y1}");
        html! { path class=(class(link.what)) d=(d) {} }
    }
}

/// Puts the lines of a gap beside each other.
fn give_way(wires: &mut [Wires]) {
    let places: Vec<(usize, bool)> =
        wires.iter().map(|net| (net.column, !net.is_straight())).collect();
    for (index, net) in wires.iter_mut().enumerate() {
        let in_gap = |other: &&(usize, bool)| **other == (net.column, true);
        let lanes = places.iter().filter(in_gap).count();
        let lane = places[..index].iter().filter(in_gap).count();
        let share = if places[index].1 { (lane + 1) as f64 / (lanes + 1) as f64 } else { 0.5 };
        net.bus = MARGIN + net.column as f64 * ACROSS + WIDTH + share * (ACROSS - WIDTH);
    }
}

impl Wires {
    fn is_straight(&self) -> bool {
        self.ends.iter().all(|end| (end[1] - self.ends[0][1]).abs() < 0.5)
    }

    fn drawn(&self) -> Markup {
        let heights = self.ends.iter().map(|end| end[1]);
        let (low, high) =
            (heights.clone().fold(f64::INFINITY, f64::min), heights.fold(0.0, f64::max));
        let stubs = self.ends.iter().map(|[x, y]| format!("M{x} {y}H{}", self.bus));
        let bus = format!("M{} {low}V{high}", self.bus);
        let path: String = stubs.chain((low < high).then_some(bus)).collect();
        let meets: Vec<f64> = self.ends.iter().map(|end| end[1]).collect();
        html! {
            g class=(self.kind.name()) {
                title { (self.title) }
                path d=(path) {}
                @if self.ends.len() > 2 {
                    @for y in meets { circle cx=(self.bus) cy=(y) r="3" {} }
                }
            }
        }
    }
}
