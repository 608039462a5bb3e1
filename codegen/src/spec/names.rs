//! Names allowed in specs.

use crate::spec::code::Code;
use crate::spec::diagnostic::{FileId, Mistake, Span, Spanned};

/// Maximum number of characters of a name.
pub const MAX_NAME: usize = 64;

/// Keywords of all editions of Rust, strict and reserved, which emitted code could not use as
/// identifiers.
const RUST_KEYWORDS: &[&str] = &[
    "Self", "abstract", "as", "async", "await", "become", "box", "break", "const", "continue",
    "crate", "do", "dyn", "else", "enum", "extern", "false", "final", "fn", "for", "gen", "if",
    "impl", "in", "let", "loop", "macro", "match", "mod", "move", "mut", "override", "priv", "pub",
    "ref", "return", "self", "static", "struct", "super", "trait", "true", "try", "type", "typeof",
    "union", "unsafe", "unsized", "use", "virtual", "where", "while", "yield",
];

/// Functions of the expression language.
pub const FUNCTIONS: &[&str] = &[
    "sin",
    "cos",
    "tan",
    "asin",
    "acos",
    "atan",
    "sinh",
    "cosh",
    "tanh",
    "exp",
    "ln",
    "sqrt",
    "abs",
    "min",
    "max",
    "sign",
    "smooth_step",
    "step",
    "piecewise",
    "motion_law",
    "table",
    "der",
    "cbrt",
    "atan2",
    "mod",
    "dot",
    "norm",
    "x_of",
    "y_of",
    "z_of",
];

/// Reports whether specs may not use a name, because emitted code or expressions use it.
#[must_use]
pub fn is_reserved(name: &str) -> bool {
    RUST_KEYWORDS.contains(&name) || FUNCTIONS.contains(&name) || ["t", "pi"].contains(&name)
}

/// Rejects invalid names.
///
/// # Errors
/// Unless it is an ASCII identifier that starts with a letter, has at most 64 characters, and is
/// neither a Rust keyword nor a function, `t` or `pi`.
pub fn check(name: &Spanned<String>) -> Result<(), Mistake> {
    let text = name.value.as_str();
    let refuse = |message: String, label: &str, help: &str| {
        Err(Mistake::new(Code::InvalidName, name.span, message, label).help(help))
    };
    let rule = "a name is made of ASCII letters, digits and _, and starts with a letter";
    let word = |c: char| c.is_ascii_alphanumeric() || c == '_';
    if !text.starts_with(|c: char| c.is_ascii_alphabetic()) || !text.chars().all(word) {
        return refuse(format!("{} is not a valid name", quoted(text)), "not a name", rule);
    }
    if text.len() > MAX_NAME {
        let message = format!("a name has at most {MAX_NAME} characters");
        return refuse(message, "too long", "shorten it");
    }
    if RUST_KEYWORDS.contains(&text) {
        let message = format!("{} is a keyword of Rust", quoted(text));
        return refuse(message, "reserved name", "emitted code uses the names of the spec");
    }
    if FUNCTIONS.contains(&text) || text == "t" || text == "pi" {
        let message = format!("{} already has a meaning in expressions", quoted(text));
        return refuse(message, "reserved name", "choose another name");
    }
    Ok(())
}

/// Names of other features of the crate of emitted scenes, and of the folder for benchmarks beside them, which scenes
/// must not have.
const FEATURES: &[&str] = &["bench", "default", "libm", "scenes", "std"];

/// Types that modules of emitted scenes define or import, written as the scene names that would
/// clash with them.
const TYPES: &[&str] = &[
    "bends",
    "box",
    "clone",
    "constants",
    "constraint",
    "copy",
    "cubic_table",
    "debug",
    "describe",
    "direction",
    "energy",
    "err",
    "event",
    "factored",
    "field_attachment",
    "field_description",
    "field_place",
    "field_point",
    "field_scene",
    "lanes",
    "linear_equations",
    "none",
    "ok",
    "option",
    "outputs",
    "parameters",
    "phantom_data",
    "power_balance",
    "quantity",
    "r",
    "real",
    "result",
    "run_defaults",
    "shape",
    "simulator",
    "some",
    "sparsity_pattern",
    "state_kind",
    "string",
    "taylor_series",
    "vec",
];

/// Rejects names that emitted scenes cannot have.
///
/// # Errors
/// If modules or features of emitted code use the name themselves.
pub fn check_scene(name: &Spanned<String>) -> Result<(), Mistake> {
    // `linear_equations`, `LinearEquations` and `linearequations` all give the same type.
    let plain = |text: &str| text.replace('_', "").to_ascii_lowercase();
    let own = plain(&name.value);
    if FEATURES.iter().chain(TYPES).all(|taken| plain(taken) != own) {
        return Ok(());
    }
    let message = format!("a scene cannot be called {}: emitted code uses it", quoted(&name.value));
    Err(Mistake::new(Code::InvalidName, name.span, message, "reserved name")
        .help("add a word: names of two words do not clash"))
}

/// Returns the mistake in a scene's name, if any.
#[must_use]
pub fn scene_name_mistake(name: &str) -> Option<Mistake> {
    let name = Spanned { value: name.to_owned(), span: Span::new(FileId(0), 0..0) };
    check(&name).and_then(|()| check_scene(&name)).err()
}

/// Returns a text of the spec for a message: in quotes, escaped, shortened.
#[must_use]
pub fn quoted(text: &str) -> String {
    let shown: String = text.chars().take(MAX_NAME).collect();
    let more = if shown.len() < text.len() { "..." } else { "" };
    format!("`{}{more}`", shown.escape_debug())
}

/// Returns a hint that names the candidate most similar to `name`, or else lists a few.
#[must_use]
pub fn did_you_mean<'a>(name: &str, candidates: impl Iterator<Item = &'a str>) -> String {
    let candidates: Vec<&str> = candidates.collect();
    let likeness = |candidate: &str| strsim::jaro_winkler(name, candidate);
    let short = name.len() <= MAX_NAME;
    let best = candidates.iter().filter(|candidate| short && likeness(candidate) > 0.8);
    match best.max_by(|a, b| likeness(a).total_cmp(&likeness(b))) {
        Some(best) => format!("did you mean `{best}`?"),
        None if candidates.is_empty() => String::new(),
        None if candidates.len() <= 12 => format!("known are {}", candidates.join(", ")),
        None => format!("known are {}, ...", candidates[..12].join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_name(text: &str) -> bool {
        let span = Span::new(FileId(0), 0..0);
        check(&Spanned { value: text.to_owned(), span }).is_ok()
    }

    #[test]
    fn names_are_identifiers_of_rust() {
        for text in ["J", "psi_x1", "angle_dot", "raw", "e", "x_", "T"] {
            assert!(is_name(text), "{text}");
            assert!(syn::parse_str::<syn::Ident>(text).is_ok(), "{text}");
        }
        assert!(is_name(&"a".repeat(64)));
        assert!(!is_name(&"a".repeat(65)));
    }

    #[test]
    fn what_rust_reserves_is_no_name() {
        for keyword in RUST_KEYWORDS {
            assert!(!is_name(keyword), "{keyword}");
        }
        // Keywords known to syn are all on the list.
        for word in ["self", "Self", "try", "async", "yield", "macro", "typeof", "become", "crate"]
        {
            assert!(syn::parse_str::<syn::Ident>(word).is_err() && !is_name(word), "{word}");
        }
        for text in ["", "_x", "1x", "a b", "a-b", "\u{3c6}", "r#try", "x;", "pi", "t", "sin", "'a"]
        {
            assert!(!is_name(text), "{text}");
        }
    }

    #[test]
    fn hints_name_the_likest_candidate() {
        let known = ["coordinate", "kind"];
        assert_eq!(did_you_mean("cordinate", known.into_iter()), "did you mean `coordinate`?");
        assert_eq!(did_you_mean("zzz", known.into_iter()), "known are coordinate, kind");
        assert_eq!(did_you_mean("zzz", std::iter::empty()), "");
    }
}
