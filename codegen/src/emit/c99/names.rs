//! Names in emitted C: no keywords, no macros of the standard headers, each used once.

use std::collections::BTreeSet;

/// Words that no member, variable or argument may have as its name: keywords of C and C++, and
/// macros defined by compilers or by the included headers.
const RESERVED: &[&str] = &[
    "auto",
    "break",
    "case",
    "char",
    "const",
    "continue",
    "default",
    "do",
    "double",
    "else",
    "enum",
    "extern",
    "float",
    "for",
    "goto",
    "if",
    "inline",
    "int",
    "long",
    "register",
    "restrict",
    "return",
    "short",
    "signed",
    "sizeof",
    "static",
    "struct",
    "switch",
    "typedef",
    "union",
    "unsigned",
    "void",
    "volatile",
    "while",
    "_Bool",
    "_Complex",
    "_Imaginary",
    "bool",
    "true",
    "false",
    "asm",
    "typeof",
    "alignas",
    "alignof",
    "nullptr",
    "thread_local",
    "catch",
    "class",
    "concept",
    "const_cast",
    "constexpr",
    "decltype",
    "delete",
    "dynamic_cast",
    "explicit",
    "export",
    "final",
    "friend",
    "mutable",
    "namespace",
    "new",
    "noexcept",
    "not",
    "operator",
    "or",
    "and",
    "xor",
    "compl",
    "bitand",
    "bitor",
    "override",
    "private",
    "protected",
    "public",
    "reinterpret_cast",
    "requires",
    "static_assert",
    "static_cast",
    "template",
    "this",
    "throw",
    "try",
    "typeid",
    "typename",
    "using",
    "virtual",
    "wchar_t",
    "errno",
    "NULL",
    "NAN",
    "INFINITY",
    "HUGE_VAL",
    "HUGE_VALF",
    "HUGE_VALL",
    "FP_NAN",
    "FP_ZERO",
    "FP_NORMAL",
    "FP_INFINITE",
    "FP_SUBNORMAL",
    "EOF",
    "I",
    "assert",
    "offsetof",
    "isnan",
    "isinf",
    "isfinite",
    "isnormal",
    "signbit",
    "fpclassify",
    "isgreater",
    "isless",
    "unix",
    "linux",
    "i386",
    "arm",
    "vax",
    "sun",
    "mips",
    "near",
    "far",
    "M_PI",
    "M_E",
];

/// Functions, types and arguments whose names emitted bodies use.
const USED: &[&str] = &[
    "time", "state", "p", "c", "m", "x", "values", "rate", "sqrt", "fabs", "floor", "exp", "log",
    "sin", "cos", "tan", "asin", "acos", "atan", "sinh", "cosh", "tanh", "pow", "sqrtf", "fabsf",
    "floorf", "expf", "logf", "sinf", "cosf", "tanf", "asinf", "acosf", "atanf", "sinhf", "coshf",
    "tanhf", "powf", "copysign", "memcpy", "inputs", "row", "column", "block", "lane",
];

/// Allocates names, each once.
#[derive(Debug, Clone)]
pub(super) struct Namer {
    taken: BTreeSet<String>,
}

impl Namer {
    /// Returns a namer for members of a struct.
    pub(super) fn for_members() -> Self {
        Self { taken: RESERVED.iter().map(|&word| word.to_owned()).collect() }
    }

    /// Returns a namer for variables of functions that call helpers of these names.
    pub(super) fn for_locals(helpers: impl IntoIterator<Item = String>) -> Self {
        let words = RESERVED.iter().chain(USED).map(|&word| word.to_owned());
        Self { taken: words.chain(helpers).collect() }
    }

    /// Returns `wanted`, or `wanted_2`, `wanted_3`, ... if it is taken.
    pub(super) fn claim(&mut self, wanted: &str) -> String {
        let mut name = wanted.to_owned();
        let mut count = 1_u32;
        while !self.taken.insert(name.clone()) {
            count += 1;
            name = format!("{wanted}_{count}");
        }
        name
    }

    /// Returns names for all members of a struct, in their order.
    pub(super) fn members<'a>(wanted: impl IntoIterator<Item = &'a str>) -> Vec<String> {
        let mut namer = Self::for_members();
        wanted.into_iter().map(|name| namer.claim(name)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Namer;

    #[test]
    fn keywords_and_macros_are_no_members() {
        let members = Namer::members(["double", "phi", "linux", "phi"]);
        assert_eq!(members, ["double_2", "phi", "linux_2", "phi_2"]);
    }

    #[test]
    fn variables_hide_no_function_that_bodies_call() {
        let mut namer = Namer::for_locals(["sin_cos".to_owned()]);
        let names = ["sin", "time", "sin_cos", "phi"].map(|name| namer.claim(name));
        assert_eq!(names, ["sin_2", "time_2", "sin_cos_2", "phi"]);
    }
}
