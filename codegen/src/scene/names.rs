//! The three spellings of a name.

use crate::spec::code::Code;
use crate::spec::diagnostic::{Mistake, Span};
use crate::spec::quoted;
use machinist_model::Name;

/// Greek letters by name, with their LaTeX. Capitals that look Latin have none.
const GREEK: &[(&str, &str)] = &[
    ("alpha", r"\alpha"),
    ("beta", r"\beta"),
    ("gamma", r"\gamma"),
    ("delta", r"\delta"),
    ("epsilon", r"\varepsilon"),
    ("zeta", r"\zeta"),
    ("eta", r"\eta"),
    ("theta", r"\vartheta"),
    ("iota", r"\iota"),
    ("kappa", r"\kappa"),
    ("lambda", r"\lambda"),
    ("mu", r"\mu"),
    ("nu", r"\nu"),
    ("xi", r"\xi"),
    ("rho", r"\varrho"),
    ("sigma", r"\sigma"),
    ("tau", r"\tau"),
    ("phi", r"\varphi"),
    ("chi", r"\chi"),
    ("psi", r"\psi"),
    ("omega", r"\omega"),
    ("Gamma", r"\Gamma"),
    ("Delta", r"\Delta"),
    ("Theta", r"\Theta"),
    ("Lambda", r"\Lambda"),
    ("Xi", r"\Xi"),
    ("Sigma", r"\Sigma"),
    ("Phi", r"\Phi"),
    ("Psi", r"\Psi"),
    ("Omega", r"\Omega"),
];

/// Returns the name of `own` in `instance`, or in the scene.
pub fn name(instance: Option<&str>, own: &str) -> Name {
    let (path, ident) = match instance {
        Some(instance) => {
            (format!("{instance}.{own}"), format!("{}_{own}", instance.replace('.', "_")))
        }
        None => (own.to_owned(), own.to_owned()),
    };
    Name { path, ident, latex: latex(instance, own) }
}

/// Writes `phi_2_dot` of `motor` as `\dot{\varphi}_{2,\mathrm{motor}}`.
fn latex(instance: Option<&str>, own: &str) -> String {
    let (stem, accent) = match (own.strip_suffix("_ddot"), own.strip_suffix("_dot")) {
        (Some(stem), _) if !stem.is_empty() => (stem, Some(r"\ddot")),
        (_, Some(stem)) if !stem.is_empty() => (stem, Some(r"\dot")),
        _ => (own, None),
    };
    let mut parts = stem.split('_').filter(|part| !part.is_empty());
    let (head, digits) = without_digits(parts.next().unwrap_or(stem));
    let head = letter(head);
    let head = accent.map_or(head.clone(), |accent| format!("{accent}{{{head}}}"));
    let digits = (!digits.is_empty()).then(|| digits.to_owned());
    let mut below: Vec<String> = digits.into_iter().chain(parts.map(subscript)).collect();
    below.extend(instance.map(upright));
    if below.is_empty() { head } else { format!("{head}_{{{}}}", below.join(",")) }
}

/// Splits `phi2` into `phi` and `2`. A name of digits alone is not split.
fn without_digits(word: &str) -> (&str, &str) {
    let stem = word.trim_end_matches(|c: char| c.is_ascii_digit());
    if stem.is_empty() { (word, "") } else { (stem, &word[stem.len()..]) }
}

fn letter(word: &str) -> String {
    match GREEK.iter().find(|(name, _)| *name == word) {
        Some((_, latex)) => (*latex).to_owned(),
        None if word.len() == 1 => word.to_owned(),
        None => upright(word),
    }
}

fn subscript(word: &str) -> String {
    if word.chars().all(|c| c.is_ascii_digit()) {
        return word.to_owned();
    }
    let (stem, digits) = without_digits(word);
    let stem = letter(stem);
    if digits.is_empty() { stem } else { format!("{stem}_{{{digits}}}") }
}

fn upright(word: &str) -> String {
    format!(r"\mathrm{{{}}}", word.replace('_', r"\_"))
}

/// Names of one kind, which must stay distinct when flattened.
#[derive(Debug, Default)]
pub struct Flat {
    taken: std::collections::HashMap<String, String>,
}

impl Flat {
    /// Adds a name.
    ///
    /// # Errors
    /// If another one has the same identifier.
    pub fn take(&mut self, name: &Name, span: Span) -> Result<(), Box<Mistake>> {
        let Some(other) = self.taken.insert(name.ident.clone(), name.path.clone()) else {
            return Ok(());
        };
        let (ident, path, other) = (quoted(&name.ident), quoted(&name.path), quoted(&other));
        let message = format!("{path} and {other} are both called {ident} in emitted code");
        Err(Box::new(
            Mistake::new(Code::DuplicateName, span, message, "clashes").help("rename one of them"),
        ))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn latex_knows_greek_letters_subscripts_and_dots() {
        let cases = [
            (None, "phi", r"\varphi"),
            (Some("motor"), "phi", r"\varphi_{\mathrm{motor}}"),
            (Some("motor"), "psi_x1", r"\psi_{x_{1},\mathrm{motor}}"),
            (None, "phi2_dot", r"\dot{\varphi}_{2}"),
            (None, "x_ddot", r"\ddot{x}"),
            (None, "J", "J"),
            (Some("saw_gin"), "speed", r"\mathrm{speed}_{\mathrm{saw\_gin}}"),
            (None, "omega_0", r"\omega_{0}"),
            (None, "mean_torque", r"\mathrm{mean}_{\mathrm{torque}}"),
        ];
        for (instance, own, expected) in cases {
            assert_eq!(name(instance, own).latex, expected, "{own}");
        }
    }
}
