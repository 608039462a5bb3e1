//! Spellings of units of measure that are not read, and the units that they stand for.

use super::{FACTORED, Measure, TEMPERATURES, symbols};

/// Words and symbols for units, without the `s` of a plural: (word, unit or number with a unit).
const WORDS: &[(&str, &str)] = &[
    ("sec", "s"),
    ("second", "s"),
    ("msec", "ms"),
    ("millisecond", "ms"),
    ("usec", "us"),
    ("microsecond", "us"),
    ("minute", "min"),
    ("hour", "h"),
    ("hr", "h"),
    ("day", "d"),
    ("meter", "m"),
    ("metre", "m"),
    ("micron", "um"),
    ("millimeter", "mm"),
    ("millimetre", "mm"),
    ("centimeter", "cm"),
    ("centimetre", "cm"),
    ("kilometer", "km"),
    ("kilometre", "km"),
    ("liter", "l"),
    ("litre", "l"),
    ("ltr", "l"),
    ("cc", "cm^3"),
    ("gram", "g"),
    ("kilo", "kg"),
    ("kilogram", "kg"),
    ("ton", "t"),
    ("tonne", "t"),
    ("radian", "rad"),
    ("degree", "deg"),
    ("turn", "rev"),
    ("revolution", "rev"),
    ("rot", "rev"),
    ("rps", "rev/s"),
    ("kph", "km/h"),
    ("kmh", "km/h"),
    ("kmph", "km/h"),
    ("mps", "m/s"),
    ("newton", "N"),
    ("kilonewton", "kN"),
    ("joule", "J"),
    ("watt", "W"),
    ("kilowatt", "kW"),
    ("pascal", "Pa"),
    ("hectopascal", "100 Pa"),
    ("hertz", "Hz"),
    ("cycle", "rev"),
    ("volt", "V"),
    ("amp", "A"),
    ("ampere", "A"),
    ("megohm", "1e6 ohm"),
    ("farad", "F"),
    ("henry", "H"),
    ("tesla", "T"),
    ("gauss", "1e-4 T"),
    ("weber", "Wb"),
    ("coulomb", "C"),
    ("siemen", "S"),
    ("kelvin", "K"),
    ("mole", "mol"),
    ("ms2", "m/s^2"),
    ("nm", "1e-9 m"),
    ("pm", "1e-12 m"),
    ("ns", "1e-9 s"),
    ("arcmin", "1/60 deg"),
    ("arcsec", "1/3600 deg"),
    ("in", "inch"),
    ("inches", "inch"),
    ("ft", "0.3048 m"),
    ("foot", "0.3048 m"),
    ("feet", "0.3048 m"),
    ("yd", "0.9144 m"),
    ("yard", "0.9144 m"),
    ("mi", "1609.344 m"),
    ("mile", "1609.344 m"),
    ("mph", "0.44704 m/s"),
    ("knot", "1852/3600 m/s"),
    ("lb", "0.45359237 kg"),
    ("lbs", "0.45359237 kg"),
    ("lbm", "0.45359237 kg"),
    ("oz", "0.028349523125 kg"),
    ("lbf", "4.4482216152605 N"),
    ("kgf", "9.80665 N"),
    ("kp", "9.80665 N"),
    ("psi", "6894.757293168 Pa"),
    ("atm", "101325 Pa"),
    ("torr", "133.322368 Pa"),
    ("mmhg", "133.322387415 Pa"),
    ("hp", "745.69987158227 W"),
    ("cal", "4.184 J"),
    ("kcal", "4184 J"),
    ("btu", "1055.05585262 J"),
    ("gal", "3.785411784e-3 m^3"),
    ("ps", "1e-12 s"),
    ("PS", "735.49875 W"),
    ("cN", "0.01 N"),
    ("daN", "10 N"),
    ("eV", "1.602176634e-19 J"),
    ("cP", "1e-3 Pa s"),
    ("cSt", "1e-6 m^2/s"),
];

/// Characters that are not ASCII, and the text for them in units.
const CHARACTERS: &[(char, &str)] = &[
    ('·', " "),
    ('⋅', " "),
    ('•', " "),
    ('∙', " "),
    ('×', " "),
    ('\u{a0}', " "),
    ('\u{2009}', " "),
    ('\u{202f}', " "),
    ('²', "^2"),
    ('³', "^3"),
    ('⁴', "^4"),
    ('¹', "1"),
    ('⁻', "^-"),
    ('µ', "u"),
    ('μ', "u"),
    ('Ω', "ohm"),
    ('Ω', "ohm"),
    ('°', "deg"),
    ('′', "arcmin"),
    ('″', "arcsec"),
    ('−', "-"),
];

/// Suggests units for an unknown symbol: a known one with other capitals (`RPM`), a word for one
/// (`sec`), or known ones that must be separated by a space (`Nm`, `kgm2`); else lists all known
/// symbols.
pub(super) fn meant(symbol: &str) -> String {
    match Reading::of(symbol) {
        Reading::Units(ways) => {
            let shown: Vec<String> = ways.iter().take(2).map(|way| format!("`{way}`")).collect();
            format!("did you mean {}?", shown.join(" or "))
        }
        Reading::Number(number) => format!("write it in other units: 1 {symbol} is {number}"),
        Reading::Unknown => format!("known are {}", symbols().collect::<Vec<_>>().join(" ")),
    }
}

/// Returns a hint for a whole text that is no unit, written in ASCII.
pub(super) fn help_with(text: &str) -> Option<String> {
    if let Some(meant) = corrected(text) {
        return Some(format!("did you mean `{meant}`?"));
    }
    let error = Measure::read(&in_ascii(text)).err()?;
    (!text.is_ascii()).then_some(error.help)
}

/// Returns what a text was probably meant for, `kg m^2` for `kgm²`; `None` if it is a unit, or
/// cannot be read as one.
fn corrected(text: &str) -> Option<String> {
    let ascii = in_ascii(text.trim());
    let mut written = String::new();
    let mut rest = ascii.as_str();
    while let Some(first) = rest.chars().next() {
        let is_word = first.is_ascii_alphabetic();
        let belongs = |c: char| c.is_ascii_alphabetic() || (is_word && c.is_ascii_digit());
        let length = rest.find(|c: char| belongs(c) != is_word).unwrap_or(rest.len());
        let (part, after) = rest.split_at(length);
        if !is_word && written.ends_with(|c: char| c.is_ascii_alphanumeric()) {
            // `s-1` is a power.
            written.push_str(if part.starts_with('-') { "^" } else { "" });
            written.push_str(part);
        } else if !is_word || Measure::read(part).is_ok() {
            written.push_str(part);
        } else if part == "per" {
            written.push('/');
        } else {
            let Reading::Units(ways) = Reading::of(part) else { return None };
            written.push_str(ways.first()?);
        }
        rest = after;
    }
    let written = written.replace(" / ", "/");
    let written = written.split_whitespace().collect::<Vec<_>>().join(" ");
    Measure::read(&written).ok().map(|_| written)
}

/// Returns the number with its unit in brackets that a text was meant for, `2 [N m]` for `2 Nm`, and
/// the length of this text; `None` if no unit follows the number. The text starts with the number,
/// of length `number`, and may go on behind the unit.
#[must_use]
pub fn in_brackets(text: &str, number: usize) -> Option<(String, usize)> {
    let (number, behind) = text.split_at_checked(number)?;
    let is_of_unit = |c: char| {
        c.is_ascii_alphanumeric()
            || " ^*/()".contains(c)
            || CHARACTERS.iter().any(|(known, _)| *known == c)
    };
    let mut length = behind.find(|c| !is_of_unit(c)).unwrap_or(behind.len());
    loop {
        let unit = behind.get(..length)?.trim();
        if unit.is_empty() {
            return None;
        }
        let found =
            if Measure::read(unit).is_ok() { Some(unit.to_owned()) } else { corrected(unit) };
        if let Some(found) = found {
            let trailing = behind[..length].len() - behind[..length].trim_end().len();
            let whole = number.len() + length - trailing;
            return Some((format!("{} [{found}]", number.trim_end()), whole));
        }
        length = unit_before(&behind[..length])?;
    }
}

/// Returns the known unit with other capitals that a unit of another dimension was meant for: `s`
/// for `S`.
#[must_use]
pub fn with_other_capitals(unit: &str, wanted: &str) -> Option<&'static str> {
    let wanted = Measure::read(wanted).ok()?.unit.dimension;
    symbols()
        .filter(|known| *known != unit && known.eq_ignore_ascii_case(unit))
        .find(|known| Measure::read(known).is_ok_and(|measure| measure.unit.dimension == wanted))
}

/// Returns the length of a text without the last of the words and signs in it.
fn unit_before(text: &str) -> Option<usize> {
    let text = text.trim_end();
    let last = text.chars().next_back()?;
    if !last.is_ascii_alphanumeric() {
        return Some(text.len() - last.len_utf8());
    }
    Some(text.trim_end_matches(|c: char| c.is_ascii_alphanumeric()).len())
}

/// Returns a text with characters of ASCII only, where units have them.
fn in_ascii(text: &str) -> String {
    let mut written = String::new();
    for c in text.chars() {
        match CHARACTERS.iter().find(|(known, _)| *known == c) {
            Some((_, instead)) => written.push_str(instead),
            None => written.push(c),
        }
    }
    // Of `⁻²`.
    written.replace("^-^", "^-")
}

/// Meaning of a symbol that is not known.
enum Reading {
    /// Units that it may stand for, the likely ones first; at least one.
    Units(Vec<String>),
    /// A number in other units.
    Number(&'static str),
    Unknown,
}

impl Reading {
    fn of(symbol: &str) -> Self {
        if TEMPERATURES.contains(&symbol) {
            return Self::Unknown;
        }
        let alike = symbols().filter(|known| known.eq_ignore_ascii_case(symbol));
        let alike: Vec<String> = alike.map(str::to_owned).collect();
        if !alike.is_empty() {
            return Self::Units(alike);
        }
        // Short words of other capitals are taken apart before: `Nm` is no `nm`.
        let lower = symbol.to_ascii_lowercase();
        let long = Some(lower.as_str()).filter(|word| word.len() > 2);
        let singular = lower.strip_suffix('s').filter(|word| word.len() > 2);
        if let Some(known) = symbols().find(|known| Some(*known) == singular) {
            return Self::Units(vec![known.to_owned()]);
        }
        let listed = [Some(symbol), long, singular].into_iter().flatten().find_map(listed);
        match listed {
            Some(unit) if Measure::read(unit).is_ok() => {
                return Self::Units(vec![unit.to_owned()]);
            }
            Some(number) => return Self::Number(number),
            None => {}
        }
        let joined = |way: &Vec<Part>| {
            let texts: Vec<&str> = way.iter().map(|part| part.text.as_str()).collect();
            texts.join(" ")
        };
        for with_capitals in [true, false] {
            let mut ways = apart(symbol, with_capitals);
            if !ways.is_empty() {
                // Kilo is likelier than kelvin: `knm` is `kN m` rather than `K N m`.
                ways.sort_by_key(|way| {
                    let has = |wanted: fn(&Part) -> bool| way.iter().any(wanted);
                    (has(|part| part.text == "K"), has(|part| part.has_factor), way.len())
                });
                return Self::Units(ways.iter().map(joined).collect());
            }
        }
        Self::Unknown
    }
}

fn listed(word: &str) -> Option<&'static str> {
    WORDS.iter().find(|(known, _)| *known == word).map(|(_, instead)| *instead)
}

/// A part of a word that is a known symbol, possibly with an exponent of one digit.
#[derive(Clone)]
struct Part {
    text: String,
    has_factor: bool,
}

/// Splits a word into known symbols, with or without regard to capitals, in all ways that contain
/// each symbol at most once.
fn apart(word: &str, with_capitals: bool) -> Vec<Vec<Part>> {
    /// Longest word that is split; the number of ways grows fast.
    const LONGEST: usize = 12;
    if word.is_empty() {
        return vec![Vec::new()];
    }
    let mut ways = Vec::new();
    let begins = |known: &&str| {
        word.get(..known.len()).is_some_and(|start| {
            if with_capitals { start == *known } else { start.eq_ignore_ascii_case(known) }
        })
    };
    for known in symbols().filter(begins).take_while(|_| word.len() <= LONGEST) {
        let rest = &word[known.len()..];
        let digits = rest.len() - rest.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        let (exponent, rest) = rest.split_at(digits);
        let text = match exponent {
            "" => known.to_owned(),
            _ if exponent.len() == 1 => format!("{known}^{exponent}"),
            _ => continue,
        };
        let part = Part { text, has_factor: FACTORED.iter().any(|(symbol, ..)| *symbol == known) };
        let others = apart(rest, with_capitals).into_iter();
        let others = others.filter(|way| way.iter().all(|other| other.text != part.text));
        ways.extend(others.map(|way| std::iter::once(part.clone()).chain(way).collect()));
    }
    ways
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Spellings, and what their hint says.
    const SPELLINGS: &[(&str, &str)] = &[
        ("Nm", "did you mean `N m`?"),
        ("NM", "did you mean `N m`?"),
        ("kNm/deg", "did you mean `kN m`?"),
        ("Nmm", "did you mean `N mm`?"),
        ("kgm2", "did you mean `kg m^2`?"),
        ("KGM2", "did you mean `kg m^2` or `K g m^2`?"),
        ("Kg", "did you mean `kg`?"),
        ("m2", "did you mean `m^2`?"),
        ("Nms/rad", "did you mean `N m s` or `N ms`?"),
        ("Ns/m", "did you mean `N s`?"),
        ("Vs", "did you mean `V s`?"),
        ("Pas", "did you mean `Pa s`?"),
        ("mAh", "did you mean `mA h` or `m A h`?"),
        ("RPM", "did you mean `rpm`?"),
        ("Rpm", "did you mean `rpm`?"),
        ("rps", "did you mean `rev/s`?"),
        ("mh", "did you mean `mH`?"),
        ("hz", "did you mean `Hz`?"),
        ("HZ", "did you mean `Hz`?"),
        ("khz", "did you mean `kHz`?"),
        ("Ohm", "did you mean `ohm`?"),
        ("ohms", "did you mean `ohm`?"),
        ("Revs", "did you mean `rev`?"),
        ("bars", "did you mean `bar`?"),
        ("Ω", "did you mean `ohm`?"),
        ("kΩ", "did you mean `kohm`?"),
        ("mn", "did you mean `mN` or `MN`?"),
        ("kn", "did you mean `kN`?"),
        ("mpa", "did you mean `MPa` or `mPa`?"),
        ("kw", "did you mean `kW`?"),
        ("uf", "did you mean `uF`?"),
        ("µF", "did you mean `uF`?"),
        ("µm", "did you mean `um`?"),
        ("sec", "did you mean `s`?"),
        ("Seconds", "did you mean `s`?"),
        ("msec", "did you mean `ms`?"),
        ("minutes", "did you mean `min`?"),
        ("hours", "did you mean `h`?"),
        ("hr", "did you mean `h`?"),
        ("degrees", "did you mean `deg`?"),
        ("°", "did you mean `deg`?"),
        ("°/s", "did you mean `deg/s`?"),
        ("Radians", "did you mean `rad`?"),
        ("turns", "did you mean `rev`?"),
        ("Newton", "did you mean `N`?"),
        ("Volts", "did you mean `V`?"),
        ("amps", "did you mean `A`?"),
        ("watts", "did you mean `W`?"),
        ("Hertz", "did you mean `Hz`?"),
        ("meters", "did you mean `m`?"),
        ("in", "did you mean `inch`?"),
        ("kmh", "did you mean `km/h`?"),
        ("kg m²", "did you mean `kg m^2`?"),
        ("kg·m²", "did you mean `kg m^2`?"),
        ("kg m2/s", "did you mean `m^2`?"),
        ("m/s²", "did you mean `m/s^2`?"),
        ("s⁻¹", "did you mean `s^-1`?"),
        ("m s-2", "did you mean `m s^-2`?"),
        ("Nm per rad", "did you mean `N m`?"),
        ("N m per rad", "did you mean `N m/rad`?"),
        ("nm", "write it in other units: 1 nm is 1e-9 m"),
        ("psi", "write it in other units: 1 psi is 6894.757293168 Pa"),
        ("lbs", "write it in other units: 1 lbs is 0.45359237 kg"),
        ("ft", "write it in other units: 1 ft is 0.3048 m"),
        ("hp", "write it in other units: 1 hp is 745.69987158227 W"),
        ("PS", "write it in other units: 1 PS is 735.49875 W"),
    ];

    #[test]
    fn an_unknown_spelling_is_told_what_it_may_have_been_meant_for() {
        for (text, wanted) in SPELLINGS {
            assert_eq!(Measure::parse(text).expect_err(text).help, *wanted, "{text}");
            assert_eq!(Measure::coherent(text).expect_err(text).help, *wanted, "{text}");
        }
        let help = |text: &str| Measure::parse(text).expect_err(text).help;
        assert!(help("parsec").starts_with("known are kg m s"));
        assert!(help("degC").contains("in K") && help("°C").contains("in K"));
    }

    #[test]
    fn numbers_are_shown_with_their_unit_in_brackets() {
        for (text, wanted, length) in [
            ("2 Nm", "2 [N m]", 4),
            ("2Nm", "2 [N m]", 3),
            ("2 N m/rad + 3", "2 [N m/rad]", 9),
            ("2 Nm*sin(3*t)", "2 [N m]", 4),
            ("2 kg·m² - x", "2 [kg m^2]", 9),
            ("2 Ω", "2 [ohm]", 4),
            ("2 sec)", "2 [s]", 5),
            ("2 W/(m K) + 1", "2 [W/(m K)]", 9),
        ] {
            assert_eq!(in_brackets(text, 1), Some((wanted.to_owned(), length)), "{text}");
        }
        for text in ["2 x", "2", "2 + 3", "2 motor.omega", "2 *3"] {
            assert_eq!(in_brackets(text, 1), None, "{text}");
        }
    }

    #[test]
    fn listed_words_stand_for_units_or_numbers_in_units_and_for_no_known_symbol() {
        for (word, instead) in WORDS {
            assert!(symbols().all(|known| known != *word), "{word}");
            let (number, unit) = match instead.split_once(' ') {
                Some((number, unit)) if number.starts_with(|c: char| c.is_ascii_digit()) => {
                    (number, unit)
                }
                _ => ("1", *instead),
            };
            Measure::parse(unit).unwrap_or_else(|error| panic!("{word}: {error:?}"));
            let is_number = |part: &str| part.parse::<f64>().is_ok_and(|number| number > 0.0);
            assert!(number.split('/').all(is_number), "{word}");
        }
    }

    #[test]
    fn kilo_is_likelier_than_kelvin() {
        for (word, help) in [
            ("knm", "did you mean `kN m` or `K N m`?"),
            ("nms", "did you mean `N m s` or `N m S`?"),
            ("KW", "did you mean `kW`?"),
        ] {
            assert_eq!(meant(word), help);
        }
    }

    #[test]
    fn wrong_capitals_of_another_dimension_are_told() {
        assert_eq!(with_other_capitals("S", "s"), Some("s"));
        assert_eq!(with_other_capitals("MN", "s"), None);
        assert_eq!(with_other_capitals("k", "K"), Some("K"));
    }

    #[test]
    fn every_pair_of_known_symbols_written_as_one_is_taken_apart_or_is_another() {
        for one in symbols() {
            for other in symbols().filter(|other| *other != one) {
                let word = format!("{one}{other}");
                let is_temperature = TEMPERATURES.contains(&word.as_str());
                if let (Err(error), false) = (Measure::parse(&word), is_temperature) {
                    let is_read = ["did you mean `", "write it in other units: 1 "]
                        .iter()
                        .any(|start| error.help.starts_with(start));
                    assert!(is_read, "{word}: {}", error.help);
                }
            }
        }
    }
}
