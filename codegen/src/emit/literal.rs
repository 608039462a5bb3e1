//! Formatting of all floating-point numbers.

use std::str::FromStr;

use proc_macro2::TokenStream;

/// A number without a literal: infinite or NaN.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("{0} is not a finite number")]
pub struct NotFinite(pub f64);

/// Returns a literal of emitted Rust: the shortest text that reads back as exactly this number.
/// Many digits are grouped by three.
///
/// # Errors
/// [`NotFinite`] for infinities and NaN.
pub fn literal_text(value: f64) -> Result<String, NotFinite> {
    if !value.is_finite() {
        return Err(NotFinite(value));
    }
    let size = value.abs();
    let positional = size == 0.0 || (1e-4..1e9).contains(&size);
    let text = if positional { format!("{value:?}") } else { format!("{value:e}") };
    Ok(group_digits(&text))
}

/// Returns [`literal_text`] as tokens. A minus sign is a separate token.
///
/// # Errors
/// [`NotFinite`] for infinities and NaN.
pub fn literal(value: f64) -> Result<TokenStream, NotFinite> {
    let text = literal_text(value)?;
    TokenStream::from_str(&text).map_err(|_| NotFinite(value))
}

/// Returns [`literal`], or a standard constant, or a small multiple of pi or its square, if its
/// value is exactly equal.
///
/// # Errors
/// [`NotFinite`] for infinities and NaN.
pub fn constant_or_literal(value: f64) -> Result<TokenStream, NotFinite> {
    match constant(value).or_else(|| multiple_of_pi(value)) {
        Some(text) => TokenStream::from_str(&text).map_err(|_| NotFinite(value)),
        None => literal(value),
    }
}

fn constant(value: f64) -> Option<String> {
    let constant = CONSTANTS.iter().find(|(_, known)| known.to_bits() == value.to_bits());
    constant.map(|(name, _)| format!("core::f64::consts::{name}"))
}

/// Multiples that are hard to recognize as decimal numbers.
fn multiple_of_pi(value: f64) -> Option<String> {
    use std::f64::consts::PI;
    let pi = "core::f64::consts::PI";
    let is_value = |candidate: f64| candidate.to_bits() == value.to_bits();
    if is_value(PI * PI) {
        return Some(format!("{pi} * {pi}"));
    }
    (2..=12).map(f64::from).find_map(|factor| {
        if is_value(factor * PI) {
            Some(format!("{factor:?} * {pi}"))
        } else if is_value(factor * PI * PI) {
            Some(format!("{factor:?} * {pi} * {pi}"))
        } else {
            None
        }
    })
}

const CONSTANTS: &[(&str, f64)] = {
    use std::f64::consts;
    &[
        ("PI", consts::PI),
        ("TAU", consts::TAU),
        ("FRAC_PI_2", consts::FRAC_PI_2),
        ("FRAC_PI_3", consts::FRAC_PI_3),
        ("FRAC_PI_4", consts::FRAC_PI_4),
        ("FRAC_PI_6", consts::FRAC_PI_6),
        ("FRAC_1_PI", consts::FRAC_1_PI),
        ("SQRT_2", consts::SQRT_2),
        ("FRAC_1_SQRT_2", consts::FRAC_1_SQRT_2),
        ("E", consts::E),
        ("LN_2", consts::LN_2),
        ("LN_10", consts::LN_10),
    ]
};

/// Changes `-23065.284612e7` to `-23_065.284_612e7`.
fn group_digits(text: &str) -> String {
    let (mantissa, exponent) = match text.split_once('e') {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (text, None),
    };
    let (sign, digits) = match mantissa.strip_prefix('-') {
        Some(digits) => ("-", digits),
        None => ("", mantissa),
    };
    let (whole, fraction) = match digits.split_once('.') {
        Some((whole, fraction)) => (whole, Some(fraction)),
        None => (digits, None),
    };
    let many = whole.len() > 5 || fraction.is_some_and(|digits| digits.len() > 5);
    let group =
        |digits: &str, first: usize| if many { spaced(digits, first) } else { digits.into() };
    let mut grouped = format!("{sign}{}", group(whole, whole.len() % 3));
    if let Some(fraction) = fraction {
        grouped.push('.');
        grouped.push_str(&group(fraction, 0));
    }
    if let Some(exponent) = exponent {
        grouped.push('e');
        grouped.push_str(exponent);
    }
    grouped
}

/// Inserts an underscore after the first `first` digits, then after every third.
fn spaced(digits: &str, first: usize) -> String {
    let mut text = String::with_capacity(digits.len() * 4 / 3);
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && index % 3 == first % 3 {
            text.push('_');
        }
        text.push(digit);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{literal, literal_text};
    use proptest::prelude::*;

    fn read_back(value: f64) -> f64 {
        let tokens = literal(value).expect("finite");
        let expression: syn::Expr = syn::parse2(tokens).expect("an expression");
        match expression {
            syn::Expr::Lit(literal) => read_digits(&literal.lit),
            syn::Expr::Unary(syn::ExprUnary { op: syn::UnOp::Neg(_), expr, .. }) => match *expr {
                syn::Expr::Lit(literal) => -read_digits(&literal.lit),
                _ => panic!("a minus before something else than a literal"),
            },
            _ => panic!("something else than a literal"),
        }
    }

    fn read_digits(literal: &syn::Lit) -> f64 {
        let syn::Lit::Float(float) = literal else { panic!("a literal that is no float") };
        assert_eq!(float.suffix(), "");
        float.base10_parse().expect("digits")
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4096))]
        #[test]
        fn every_finite_bit_pattern_is_read_back(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            prop_assume!(value.is_finite());
            prop_assert_eq!(read_back(value).to_bits(), bits);
        }

        #[test]
        fn numbers_of_everyday_size_are_read_back(value in -1e12_f64..1e12) {
            prop_assert_eq!(read_back(value).to_bits(), value.to_bits());
        }
    }

    #[test]
    fn the_ends_of_the_range_are_read_back() {
        for value in [0.0, -0.0, f64::MIN_POSITIVE, 5e-324, f64::MAX, f64::MIN, 1e-4, 1e9] {
            assert_eq!(read_back(value).to_bits(), value.to_bits(), "{value:e}");
        }
    }

    #[test]
    fn infinities_and_nan_are_refused() {
        for value in [f64::INFINITY, f64::NEG_INFINITY, f64::NAN] {
            assert!(literal(value).is_err());
            assert!(super::constant_or_literal(value).is_err());
        }
    }

    #[test]
    fn numbers_made_of_pi_are_written_with_pi() {
        use std::f64::consts::PI;
        let shown = [PI, 3.0 * PI, PI * PI, 4.0 * PI * PI, 0.1 * PI];
        let texts = shown.map(|x| super::constant_or_literal(x).expect("finite").to_string());
        let texts = texts.map(|text| text.replace(' ', "").replace("core::f64::consts::", ""));
        assert_eq!(texts, ["PI", "3.0*PI", "PI*PI", "4.0*PI*PI", "0.314_159_265_358_979_3"]);
    }

    #[test]
    fn literals_look_as_a_person_would_write_them() {
        let shown = [4.2, -0.5, 0.0, 23065.2, 128.5346, 8e10, 9.817e-6, 0.089_887_999, 1_234_567.5];
        let texts: Vec<_> = shown.into_iter().map(|x| literal_text(x).expect("finite")).collect();
        assert_eq!(
            texts,
            [
                "4.2",
                "-0.5",
                "0.0",
                "23065.2",
                "128.5346",
                "8e10",
                "9.817e-6",
                "0.089_887_999",
                "1_234_567.5"
            ]
        );
    }
}
