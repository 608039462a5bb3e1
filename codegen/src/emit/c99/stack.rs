//! Bound of the stack of emitted functions, counted on their text.
//!
//! Along the deepest chain of calls, the bound adds the bytes of all arguments and of all variables
//! that the functions declare, in whatever block. Pointers and `size_t` count as eight bytes.
//! Compilers add return addresses and saved registers at each call, results that they compute ahead
//! of a loop, and the frames of functions of the C library.

mod text;

use std::collections::BTreeMap;

use text::{Declaration, Token, declaration, items, tokens};

/// Bound of the stack of a function.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StackBound {
    /// Bytes of arguments and variables, including those of the functions it calls.
    pub bytes: usize,
    /// Maximum number of functions that are open at a time, itself included.
    pub calls: usize,
}

impl std::fmt::Display for StackBound {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { bytes, calls } = self;
        let functions = if *calls == 1 { "function" } else { "nested functions" };
        write!(f, "at most {bytes} bytes in variables and arguments of {calls} {functions}")
    }
}

/// Bounds of the functions of a source, by name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StackBounds(BTreeMap<String, StackBound>);

impl StackBounds {
    /// Counts the functions that a source defines, with the types of its header.
    ///
    /// # Panics
    /// If the text is not emitted C: for a type or a size that it does not declare, or recursion.
    #[must_use]
    pub fn of(header: &str, source: &str) -> Self {
        let mut unit = Unit::default();
        for text in [header, source] {
            unit.add(text);
        }
        let mut bounds = BTreeMap::new();
        for name in unit.functions.keys() {
            unit.bound(name, &mut bounds);
        }
        Self(bounds.into_iter().filter_map(|(name, bound)| Some((name, bound?))).collect())
    }

    /// Returns the bound of a function, if the source defines it.
    #[must_use]
    pub fn function(&self, name: &str) -> Option<StackBound> {
        self.0.get(name).copied()
    }
}

/// Size and alignment of a type, in bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Layout {
    size: usize,
    alignment: usize,
}

/// A function: bytes of its arguments and variables, and the functions it calls.
#[derive(Debug, Default)]
struct Frame {
    bytes: usize,
    calls: Vec<String>,
}

/// Types, constants and functions of a translation unit.
#[derive(Debug, Default)]
struct Unit {
    types: BTreeMap<String, Layout>,
    constants: BTreeMap<String, Vec<Token>>,
    functions: BTreeMap<String, Frame>,
}

impl Unit {
    fn add(&mut self, text: &str) {
        let text = text::without_comments(text);
        for (name, value) in text::definitions(&text) {
            self.constants.insert(name, value);
        }
        for item in items(&tokens(&text)) {
            match item {
                text::Item::Structure { name, members } => {
                    let layout = self.structure(&members);
                    self.types.insert(name, layout);
                }
                text::Item::Function { name, arguments, body } => {
                    let frame = self.frame(&arguments, &body);
                    self.functions.insert(name, frame);
                }
            }
        }
    }

    /// Returns the layout of a struct from its members.
    fn structure(&self, members: &[Token]) -> Layout {
        let mut layout = Layout { size: 0, alignment: 1 };
        for members in members.split(|token| token.is(";")).filter(|one| !one.is_empty()) {
            let found = declaration(members).unwrap_or_else(|| panic!("a member: {members:?}"));
            let of_type = self.of_type(&found.kind);
            for variable in &found.variables {
                let Layout { size, alignment } = self.of_variable(of_type, variable);
                layout.size = layout.size.next_multiple_of(alignment) + size;
                layout.alignment = layout.alignment.max(alignment);
            }
        }
        Layout { size: layout.size.next_multiple_of(layout.alignment), ..layout }
    }

    fn frame(&self, arguments: &[Token], body: &[Token]) -> Frame {
        let mut frame = Frame::default();
        for argument in text::split_at_commas(arguments).filter(|one| !one.is_empty()) {
            let Some(found) = declaration(argument) else { continue };
            // Arrays are passed as pointers.
            let passed = |variable: &text::Variable| {
                let is_pointer = variable.is_pointer || !variable.sizes.is_empty();
                if is_pointer { POINTER } else { self.of_type(&found.kind) }
            };
            frame.bytes += found.variables.iter().map(|one| padded(passed(one))).sum::<usize>();
        }
        for statement in text::statements(body) {
            let Some(Declaration { is_static, kind, variables }) = declaration(statement) else {
                continue;
            };
            if is_static {
                continue;
            }
            let of_type = self.of_type(&kind);
            let sizes = variables.iter().map(|one| padded(self.of_variable(of_type, one)));
            frame.bytes += sizes.sum::<usize>();
        }
        frame.bytes = frame.bytes.next_multiple_of(POINTER.size);
        let called = body.windows(2).filter(|pair| pair[0].is_word() && pair[1].is("("));
        frame.calls = called.map(|pair| pair[0].text().to_owned()).collect();
        frame
    }

    fn of_type(&self, name: &str) -> Layout {
        let size = match name {
            "char" | "signed char" | "unsigned char" => 1,
            "uint16_t" => 2,
            "int" | "unsigned int" | "uint32_t" | "float" => 4,
            "double" | "uint64_t" | "size_t" => 8,
            "void" => 0,
            _ => return *self.types.get(name).unwrap_or_else(|| panic!("the type `{name}`")),
        };
        Layout { size, alignment: size.max(1) }
    }

    fn of_variable(&self, of_type: Layout, variable: &text::Variable) -> Layout {
        let one = if variable.is_pointer { POINTER } else { of_type };
        // A pointer to an array.
        let sizes = if variable.points_to_array { &[][..] } else { &variable.sizes[..] };
        let count: usize = sizes.iter().map(|size| text::value(size, &self.constants)).product();
        Layout { size: one.size * count, ..one }
    }

    /// Adds the bound of a function; `None` stands for one that is being added.
    fn bound(&self, name: &str, bounds: &mut BTreeMap<String, Option<StackBound>>) -> StackBound {
        if let Some(found) = bounds.get(name) {
            return found.unwrap_or_else(|| panic!("the emitted function `{name}` is recursive"));
        }
        bounds.insert(name.to_owned(), None);
        let Frame { bytes, calls } = &self.functions[name];
        let own = calls.iter().filter(|callee| self.functions.contains_key(*callee));
        let called = own.map(|callee| self.bound(callee, bounds)).collect::<Vec<_>>();
        let most = |of: fn(&StackBound) -> usize| called.iter().map(of).max().unwrap_or(0);
        let bound =
            StackBound { bytes: bytes + most(|one| one.bytes), calls: 1 + most(|one| one.calls) };
        bounds.insert(name.to_owned(), Some(bound));
        bound
    }
}

const POINTER: Layout = Layout { size: 8, alignment: 8 };

/// Returns the bytes of a variable, of which compilers align small ones to four.
fn padded(layout: Layout) -> usize {
    layout.size.next_multiple_of(4)
}

#[cfg(test)]
mod tests {
    use super::{StackBound, StackBounds};

    const HEADER: &str = "
        #define A_STATES 3u
        typedef struct {
            double x; /* a remark; with { and } */
            signed char side[A_STATES];
        } a_state_t;
        #ifdef __cplusplus
        extern \"C\" {
        #endif
        void a_step(a_state_t *state, double h);
    ";

    const SOURCE: &str = "
        #define SADDLE (A_STATES + 1u)
        struct table {
            uint32_t count;
            const double (*rows)[4];
        };
        static const double numbers[2] = { 1.0, 2.0 };
        static double inner(const double from[A_STATES], size_t k)
        {
            static const int twice[2] = { 2, 4 };
            const double y = from[k] * (double)twice[0];
            return y;
        }
        static double other(double x)
        {
            return sin(x);
        }
        void a_step(a_state_t *state, double h)
        {
            double a[SADDLE][2], b = inner(numbers, 1u), *c = &b;
            int k;
            for (k = 0; k < 3; ++k) {
                const struct table t = { 1u, 0 };
                a_state_t trial = *state;
                switch (k) {
                case 0: {
                    float f;
                    break;
                }
                default:
                    break;
                }
            }
            *c = other(inner(a[0], 2u));
        }
    ";

    #[test]
    fn variables_and_arguments_add_up_along_the_deepest_chain() {
        let bounds = StackBounds::of(HEADER, SOURCE);
        let inner = StackBound { bytes: 8 + 8 + 8, calls: 1 };
        assert_eq!(bounds.function("inner"), Some(inner));
        assert_eq!(bounds.function("other"), Some(StackBound { bytes: 8, calls: 1 }));
        // state, h; a, b, c; k and f; t; trial.
        let own = (8 + 8) + (64 + 8 + 8) + (4 + 4) + 16 + 16;
        let step = StackBound { bytes: own + inner.bytes, calls: 2 };
        assert_eq!(bounds.function("a_step"), Some(step));
        assert_eq!(bounds.function("sin"), None);
        assert_eq!(
            step.to_string(),
            "at most 160 bytes in variables and arguments of 2 nested functions"
        );
    }

    #[test]
    #[should_panic(expected = "is recursive")]
    fn recursion_is_found() {
        let _ = StackBounds::of("", "void a(void)\n{\n    b();\n}\nvoid b(void)\n{\n    a();\n}\n");
    }
}
