//! Stack of a binary for Cortex-M, from its instructions.

use std::collections::BTreeMap;

/// A function: bytes by which it lowers the stack, and the functions it calls.
#[derive(Default)]
struct Function {
    bytes: u64,
    calls: Vec<String>,
}

/// Returns the bytes of stack of the deepest chain of calls from a function, in a disassembly.
///
/// # Panics
/// For a call by a register or recursion, whose depth instructions do not tell.
pub fn deepest(listing: &str, from: &str) -> u64 {
    let mut functions: BTreeMap<String, Function> = BTreeMap::new();
    let mut name = String::new();
    for line in listing.lines() {
        let label = line.strip_suffix(">:").and_then(|line| line.split_once(" <"));
        if let Some((_, label)) = label {
            label.clone_into(&mut name);
            continue;
        }
        let mut columns = line.split('\t').skip(2);
        let (Some(operation), arguments) = (columns.next(), columns.next().unwrap_or("")) else {
            continue;
        };
        let function = functions.entry(name.clone()).or_default();
        function.bytes += lowered(operation, arguments);
        let target = arguments.rsplit_once('<').and_then(|(_, rest)| rest.strip_suffix('>'));
        // A jump to the start of another function is a call at its end.
        if operation.starts_with('b')
            && let Some(target) = target.filter(|target| !target.contains('+') && **target != name)
        {
            function.calls.push(target.to_owned());
        }
        assert!(!operation.starts_with("blx"), "{name} calls a function by a register");
    }
    chain(&functions, from, &mut Vec::new())
}

/// Returns the bytes by which an instruction lowers the stack.
fn lowered(operation: &str, arguments: &str) -> u64 {
    let first = |text: &str| text.split([',', ' ', ';', ']']).next().map(str::to_owned);
    let number = |text: &str| -> u64 {
        first(text).and_then(|text| text.parse().ok()).unwrap_or_else(|| panic!("{text}"))
    };
    let base = operation.split('.').next().unwrap_or(operation);
    match base {
        "push" | "stmdb" | "vpush" | "vstmdb"
            if base.ends_with("push") || arguments.starts_with("sp!") =>
        {
            let registers = arguments.split_once('{').map_or("", |(_, list)| list);
            registers.trim_end_matches('}').split(", ").map(registers_in).sum::<u64>()
                * if arguments.contains("{d") { 8 } else { 4 }
        }
        "sub" | "subw" if arguments.starts_with("sp, ") => {
            number(arguments.rsplit_once('#').map_or("", |(_, number)| number))
        }
        "str" | "strd" if arguments.ends_with("]!") && arguments.contains("[sp, #-") => {
            number(arguments.rsplit_once("#-").map_or("", |(_, number)| number))
        }
        _ => 0,
    }
}

/// Returns the number of registers that an entry of a list names, such as `d8-d15`.
fn registers_in(entry: &str) -> u64 {
    let number = |name: &str| name[1..].parse::<u64>().unwrap_or_else(|_| panic!("{entry}"));
    entry.split_once('-').map_or(1, |(from, to)| number(to) - number(from) + 1)
}

fn chain<'f>(
    functions: &'f BTreeMap<String, Function>,
    name: &'f str,
    open: &mut Vec<&'f str>,
) -> u64 {
    assert!(!open.contains(&name), "{name} is recursive: {open:?}");
    let Some(function) = functions.get(name) else { return 0 };
    open.push(name);
    let calls = function.calls.iter().map(|called| chain(functions, called, open));
    let deepest = calls.max().unwrap_or(0);
    open.pop();
    function.bytes + deepest
}
