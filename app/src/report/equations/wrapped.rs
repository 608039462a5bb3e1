//! Line breaks of formulas in LaTeX.
//!
//! Browsers do not wrap MathML. A long formula becomes several short ones, which a browser wraps
//! like words. Breaks come before the signs of sums first, then between factors. Wide fractions,
//! roots and brackets are opened: `a/b` with a wide `a` becomes `(a)/b`.

/// Width of a formula that stays in one piece, in letters. A telephone shows that many in a line.
const WIDTH: f64 = 34.0;
/// Width of an index or exponent relative to letters.
const SMALL: f64 = 0.7;

/// Operators between terms and factors.
const OPERATORS: [&str; 3] = [" + ", " - ", " \\, "];

/// Part of a formula.
#[derive(Debug, Clone, PartialEq)]
enum Node {
    /// Sign of a sum, `+` or `-` between terms.
    Sign(char),
    /// Gap between factors.
    Gap,
    /// Letters, or a command without arguments.
    Plain(String),
    /// Command whose arguments are short: `\dot{x}`, `\mathrm{load}`.
    Command(String, Vec<Vec<Node>>),
    /// Index or exponent.
    Script(char, Vec<Node>),
    Braces(Vec<Node>),
    Fraction(Vec<Node>, Vec<Node>),
    Root(Vec<Node>),
    /// Brackets that grow with their content, with their delimiters.
    Brackets(String, Vec<Node>, String),
    /// Value, condition and other value.
    Cases(Vec<Vec<Node>>),
}

/// Splits a formula into pieces that each fit a line. What cannot be read as a formula stays in
/// one piece.
pub fn pieces(latex: &str) -> Vec<String> {
    let mut reader = Reader { rest: latex };
    let read = reader.nodes(&[]).filter(|_| reader.rest.is_empty());
    match read {
        Some(nodes) if width(&nodes) > WIDTH => {
            let mut pieces = Pieces::default();
            pieces.sum(&nodes);
            pieces.done
        }
        _ => vec![latex.to_owned()],
    }
}

struct Reader<'a> {
    rest: &'a str,
}

impl Reader<'_> {
    /// Reads up to one of these ends, which it skips; `None` at anything unknown.
    fn nodes(&mut self, ends: &[&str]) -> Option<Vec<Node>> {
        let mut nodes = Vec::new();
        loop {
            if ends.is_empty() && self.rest.is_empty() {
                return Some(nodes);
            }
            if ends.iter().any(|end| self.skip(end)) {
                return Some(nodes);
            }
            if self.is_at_space() {
                self.rest = &self.rest[1..];
            } else {
                nodes.push(self.node()?);
            }
        }
    }

    fn skip(&mut self, start: &str) -> bool {
        let rest = self.rest.strip_prefix(start);
        self.rest = rest.unwrap_or(self.rest);
        rest.is_some()
    }

    /// Returns whether the next character is a space that is not part of an operator.
    fn is_at_space(&self) -> bool {
        let is_operator = OPERATORS.iter().any(|operator| self.rest.starts_with(operator));
        self.rest.starts_with(' ') && !is_operator
    }

    /// Reads one node.
    fn node(&mut self) -> Option<Node> {
        let nodes = [Node::Sign('+'), Node::Sign('-'), Node::Gap];
        let mut known = OPERATORS.into_iter().zip(nodes);
        if let Some((_, node)) = known.find(|(operator, _)| self.skip(operator)) {
            return Some(node);
        }
        if self.skip("\\frac") {
            return Some(Node::Fraction(self.argument()?, self.argument()?));
        }
        if self.skip("\\sqrt") {
            return Some(Node::Root(self.argument()?));
        }
        if self.skip("\\begin{cases} ") {
            let ends: [&[&str]; 4] = [&[" & "], &[" \\\\ "], &[" & "], &[" \\end{cases}"]];
            let parts = ends.map(|ends| self.nodes(ends));
            let [value, condition, other, _] = parts;
            return Some(Node::Cases(vec![value?, condition?, other?]));
        }
        if self.skip("\\left") {
            let open = self.delimiter()?;
            let inside = self.nodes(&["\\right"])?;
            return Some(Node::Brackets(open, inside, self.delimiter()?));
        }
        let first = self.rest.chars().next()?;
        match first {
            '{' => Some(Node::Braces(self.argument()?)),
            '}' | '&' => None,
            '^' | '_' => {
                self.rest = &self.rest[1..];
                let inside =
                    if self.rest.starts_with('{') { self.argument()? } else { vec![self.node()?] };
                Some(Node::Script(first, inside))
            }
            '\\' => self.command(),
            letter => {
                self.rest = &self.rest[letter.len_utf8()..];
                Some(Node::Plain(letter.to_string()))
            }
        }
    }

    fn argument(&mut self) -> Option<Vec<Node>> {
        if self.skip("{") { self.nodes(&["}"]) } else { None }
    }

    /// Reads `(`, `|`, `\lfloor` and the like.
    fn delimiter(&mut self) -> Option<String> {
        self.skip(" ");
        match self.node()? {
            Node::Plain(text) => Some(text),
            _ => None,
        }
    }

    fn command(&mut self) -> Option<Node> {
        let after = &self.rest[1..];
        let letters = after.find(|c: char| !c.is_ascii_alphabetic()).unwrap_or(after.len());
        // A command of one character that is no letter: `\,`, `\_`.
        let length = 1 + letters.max(after.chars().next().map_or(1, char::len_utf8));
        let (name, rest) = self.rest.split_at(length);
        self.rest = rest;
        if matches!(name, "\\mathrm" | "\\text") {
            // Words within are no formula.
            let end = self.rest.find('}')?;
            let (words, rest) = self.rest.split_at(end + 1);
            self.rest = rest;
            return Some(Node::Plain(format!("{name}{words}")));
        }
        let mut arguments = Vec::new();
        while self.rest.starts_with('{') {
            arguments.push(self.argument()?);
        }
        Some(if arguments.is_empty() {
            Node::Plain(name.to_owned())
        } else {
            Node::Command(name.to_owned(), arguments)
        })
    }
}

/// Estimates the width of nodes in letters.
fn width(nodes: &[Node]) -> f64 {
    let widest = |parts: &[&[Node]]| parts.iter().map(|part| width(part)).fold(0.0, f64::max);
    let node = |node: &Node| match node {
        Node::Sign(_) => 2.0,
        Node::Gap => 0.3,
        Node::Plain(text) => match text.split_once('{') {
            Some((_, words)) => words.len() as f64 - 1.0,
            None if matches!(text.as_str(), "\\sin" | "\\cos" | "\\tan" | "\\exp" | "\\tanh") => {
                3.0
            }
            None => 1.0,
        },
        Node::Command(_, arguments) => arguments.iter().map(|argument| width(argument)).sum(),
        Node::Script(_, inside) => SMALL * width(inside),
        Node::Braces(inside) => width(inside),
        Node::Fraction(above, below) => widest(&[above, below]),
        Node::Root(inside) | Node::Brackets(_, inside, _) => 1.0 + width(inside),
        Node::Cases(parts) => {
            let [value, condition, other] = &parts[..] else { return 0.0 };
            4.0 + widest(&[value, other]) + width(condition)
        }
    };
    nodes.iter().map(node).sum()
}

/// Writes nodes as LaTeX.
fn latex(nodes: &[Node]) -> String {
    let node = |node: &Node| match node {
        Node::Sign(sign) => format!(" {sign} "),
        Node::Gap => " \\, ".to_owned(),
        // A letter may follow a command.
        Node::Plain(text) if text.ends_with(|c: char| c.is_ascii_alphabetic()) => {
            format!("{text} ")
        }
        Node::Plain(text) => text.clone(),
        Node::Command(name, arguments) => {
            let arguments = arguments.iter().map(|argument| format!("{{{}}}", latex(argument)));
            format!("{name}{}", arguments.collect::<String>())
        }
        Node::Script(kind, inside) => format!("{kind}{{{}}}", latex(inside)),
        Node::Braces(inside) => format!("{{{}}}", latex(inside)),
        Node::Fraction(above, below) => format!("\\frac{{{}}}{{{}}}", latex(above), latex(below)),
        Node::Root(inside) => format!("\\sqrt{{{}}}", latex(inside)),
        Node::Brackets(open, inside, close) => {
            format!("\\left{open} {} \\right{close}", latex(inside))
        }
        Node::Cases(parts) => match &parts[..] {
            [value, condition, other] => format!(
                "\\begin{{cases}} {} & {} \\\\ {} & \\text{{else}} \\end{{cases}}",
                latex(value),
                latex(condition),
                latex(other)
            ),
            _ => String::new(),
        },
    };
    nodes.iter().map(node).collect()
}

/// Pieces of a formula; the last one is being written.
#[derive(Default)]
struct Pieces {
    done: Vec<String>,
}

impl Pieces {
    fn push(&mut self, text: &str) {
        match self.done.last_mut() {
            Some(last) => last.push_str(text),
            None => self.done.push(text.to_owned()),
        }
    }

    fn cut(&mut self) {
        if self.done.last().is_some_and(|last| !last.is_empty()) {
            self.done.push(String::new());
        }
    }

    /// Writes a sum, with breaks before its signs if it is wide.
    fn sum(&mut self, nodes: &[Node]) {
        if width(nodes) <= WIDTH {
            return self.push(&latex(nodes));
        }
        let mut term = Vec::new();
        for node in nodes {
            if let Node::Sign(sign) = node {
                self.product(&std::mem::take(&mut term));
                self.cut();
                // An empty group makes the sign one between two terms.
                self.push(&format!("{{}} {sign} "));
            } else {
                term.push(node.clone());
            }
        }
        self.product(&term);
    }

    /// Writes a product, with breaks between its factors if it is wide.
    fn product(&mut self, nodes: &[Node]) {
        if width(nodes) <= WIDTH {
            return self.push(&latex(nodes));
        }
        for (index, factor) in nodes.split(|node| *node == Node::Gap).enumerate() {
            if index > 0 {
                self.cut();
                self.push("\\, ");
            }
            if width(factor) <= WIDTH {
                self.push(&latex(factor));
            } else {
                for node in factor {
                    self.opened(node);
                }
            }
        }
    }

    /// Writes a node whose content may be broken.
    fn opened(&mut self, node: &Node) {
        if width(std::slice::from_ref(node)) <= WIDTH {
            return self.push(&latex(std::slice::from_ref(node)));
        }
        match node {
            Node::Braces(inside) => {
                for node in inside {
                    self.opened(node);
                }
            }
            Node::Brackets(open, inside, close) => self.bracketed(open, inside, close),
            Node::Root(inside) => {
                self.bracketed("(", inside, ")");
                self.push("^{1/2}");
            }
            Node::Fraction(above, below) => {
                self.operand(above);
                self.cut();
                self.push("{} / ");
                self.operand(below);
            }
            Node::Cases(parts) => {
                let [value, condition, other] = &parts[..] else { return };
                self.push("\\{ ");
                self.sum(value);
                self.cut();
                self.push("\\text{ if } ");
                self.sum(condition);
                self.push("\\text{,}");
                self.cut();
                self.push("\\text{ else } ");
                self.sum(other);
                self.push(" \\}");
            }
            other => self.push(&latex(std::slice::from_ref(other))),
        }
    }

    /// Writes one side of a fraction, in brackets unless it is a single part.
    fn operand(&mut self, nodes: &[Node]) {
        match nodes {
            [Node::Brackets(open, inside, close)] => self.bracketed(open, inside, close),
            [_] => self.push(&latex(nodes)),
            _ if width(nodes) <= WIDTH && !nodes.iter().any(is_operator) => {
                self.push(&latex(nodes));
            }
            _ => self.bracketed("(", nodes, ")"),
        }
    }

    fn bracketed(&mut self, open: &str, inside: &[Node], close: &str) {
        if width(inside) <= WIDTH {
            return self.push(&format!("\\left{open} {} \\right{close}", latex(inside)));
        }
        // Brackets on different lines do not grow with their content.
        let size = if inside.iter().any(is_tall) { "\\Bigl" } else { "" };
        let end = if inside.iter().any(is_tall) { "\\Bigr" } else { "" };
        self.push(&format!("{size}{open} "));
        self.sum(inside);
        self.push(&format!(" {end}{close}"));
    }
}

fn is_operator(node: &Node) -> bool {
    matches!(node, Node::Sign(_) | Node::Gap)
}

fn is_tall(node: &Node) -> bool {
    match node {
        Node::Fraction(..) | Node::Cases(_) => true,
        Node::Braces(inside) | Node::Brackets(_, inside, _) | Node::Root(inside) => {
            inside.iter().any(is_tall)
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the text without spaces and empty groups.
    fn packed(latex: &str) -> String {
        latex.replace("{} ", "").split_whitespace().collect()
    }

    #[test]
    fn short_formulas_stay_whole() {
        for latex in [r"\frac{1}{2} \, k \, {x}^{2}", "-m \\, g", r"a\_b", "}{"] {
            assert_eq!(pieces(latex), [latex]);
        }
    }

    #[test]
    fn sums_break_before_their_signs_and_lose_nothing() {
        let terms: Vec<String> =
            (1..9).map(|k| format!(r"J_{{\mathrm{{part{k}}}}} \, \omega")).collect();
        let latex = terms.join(" + ");
        let found = pieces(&latex);
        assert_eq!(found.len(), 8);
        assert_eq!(packed(&found.concat()), packed(&latex));
        assert!(found[1..].iter().all(|piece| piece.starts_with("{} + ")), "{found:?}");
    }

    #[test]
    fn wide_fractions_roots_and_cases_are_opened() {
        let sum =
            (1..9).map(|k| format!(r"l_{k} \, \cos\left(\varphi_{k}\right)")).collect::<Vec<_>>();
        let sum = sum.join(" - ");
        let cases = [
            (format!(r"\frac{{{sum}}}{{m}}"), "(", "/ m"),
            (format!(r"\sqrt{{{sum}}}"), "(", ")^{1/2}"),
            (format!(r"{{\left({sum}\right)}}^{{2}}"), "(", ")^{2}"),
            (
                format!(r"\begin{{cases}} {sum} & x < 0 \\ 1 & \text{{else}} \end{{cases}}"),
                "\\{",
                "\\}",
            ),
        ];
        for (latex, first, last) in cases {
            let found = pieces(&latex);
            let whole = packed(&found.concat());
            assert!(found.len() >= 8, "{found:?}");
            assert!(whole.starts_with(first) && whole.ends_with(&packed(last)), "{whole}");
            assert_eq!(whole.matches("varphi").count(), 8, "{whole}");
        }
    }

    #[test]
    fn no_piece_is_wider_than_a_line_unless_it_is_one_symbol() {
        let factor =
            |k: usize| format!(r"\left(r_{{\mathrm{{a{k}}}}} + \frac{{x_{k}}}{{y_{k}}}\right)");
        let latex = (0..30).map(factor).collect::<Vec<_>>().join(" \\, ");
        let found = pieces(&latex);
        assert!(found.len() >= 20);
        for piece in &found {
            let mut reader = Reader { rest: piece };
            let nodes = reader.nodes(&[]).unwrap_or_else(|| panic!("{piece}"));
            assert!(width(&nodes) <= WIDTH + 4.0, "{piece}");
        }
    }
}
