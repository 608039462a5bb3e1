//! Symbols of our expressions in Symbolica.

use std::collections::HashMap;

use symbolica::atom::{Atom, AtomCore, AtomView};
use symbolica::symbol;

use crate::expr::{
    ConstraintId, CoordinateId, FirstOrderId, Function, HandedId, ParameterId, Symbol,
};

type CasSymbol = symbolica::atom::Symbol;

/// Variables and functions, registered in a fixed order so that forms do not depend on which scene
/// came first.
pub(in crate::cas) struct Vocabulary {
    variables: HashMap<Symbol, CasSymbol>,
    names: HashMap<CasSymbol, Symbol>,
    functions: Vec<(Function, CasSymbol)>,
    select_less: CasSymbol,
    table: CasSymbol,
    /// True if an expression without a value was taken in.
    pub(in crate::cas) undefined: bool,
}

/// Number of variables of each kind that are registered in advance.
const POOL: u32 = 128;

impl Vocabulary {
    pub(in crate::cas) fn new() -> Self {
        let mut vocabulary = Vocabulary {
            variables: HashMap::new(),
            names: HashMap::new(),
            functions: functions(),
            select_less: select_less(),
            table: table(),
            undefined: false,
        };
        vocabulary.name(Symbol::Pi, CasSymbol::PI);
        for index in 0..POOL {
            vocabulary.register_index(index);
        }
        vocabulary
    }

    fn register_index(&mut self, index: u32) {
        let coordinate = CoordinateId(index);
        for symbol in [
            Symbol::Time,
            Symbol::Coordinate(coordinate),
            Symbol::Velocity(coordinate),
            Symbol::Acceleration(coordinate),
            Symbol::FirstOrder(FirstOrderId(index)),
            Symbol::Parameter(ParameterId(index)),
            Symbol::Handed(HandedId(index)),
            Symbol::Multiplier(ConstraintId(index)),
            Symbol::Unloaded(ConstraintId(index)),
        ] {
            self.variable(symbol);
        }
    }

    fn name(&mut self, symbol: Symbol, name: CasSymbol) {
        self.variables.insert(symbol, name);
        self.names.insert(name, symbol);
    }

    /// Returns the variable of a symbol, registered at first use.
    pub(super) fn variable(&mut self, symbol: Symbol) -> CasSymbol {
        if let Some(name) = self.variables.get(&symbol) {
            return *name;
        }
        let text = match symbol {
            Symbol::Pi => return CasSymbol::PI,
            Symbol::Time => "machinist::t".to_owned(),
            Symbol::Coordinate(id) => format!("machinist::q{}", id.0),
            Symbol::Velocity(id) => format!("machinist::v{}", id.0),
            Symbol::Acceleration(id) => format!("machinist::a{}", id.0),
            Symbol::Multiplier(id) => format!("machinist::l{}", id.0),
            Symbol::Unloaded(id) => format!("machinist::u{}", id.0),
            Symbol::FirstOrder(id) => format!("machinist::z{}", id.0),
            Symbol::Parameter(id) => format!("machinist::p{}", id.0),
            Symbol::Handed(id) => format!("machinist::h{}", id.0),
            Symbol::Helper(id) => unreachable!("helper {} has been put in", id.0),
        };
        let name = symbol!(text.as_str());
        self.name(symbol, name);
        name
    }

    /// Returns the symbol of a variable.
    pub(super) fn symbol(&self, variable: CasSymbol) -> Option<Symbol> {
        self.names.get(&variable).copied()
    }

    /// Applies one of our functions to arguments.
    pub(super) fn call(&self, function: Function, arguments: &[Atom]) -> Atom {
        match function {
            Function::SelectLess => self.select_less.call_args(arguments),
            Function::Table { table, order } => {
                let mut all = vec![Atom::num(i64::from(table.0)), Atom::num(i64::from(order))];
                all.extend_from_slice(arguments);
                self.table.call_args(&all)
            }
            _ => match self.functions.iter().find(|(known, _)| *known == function) {
                Some((_, name)) => name.call_args(arguments),
                None => unreachable!("every function of one argument is registered"),
            },
        }
    }

    /// Returns our function for one of Symbolica.
    pub(super) fn function(&self, name: CasSymbol) -> Option<Called> {
        if name == self.select_less {
            Some(Called::SelectLess)
        } else if name == self.table {
            Some(Called::Table)
        } else {
            let known = self.functions.iter().find(|(_, known)| *known == name);
            known.map(|(function, _)| Called::Plain(*function))
        }
    }
}

/// Kind of a function, which determines the meaning of its arguments.
pub(super) enum Called {
    Plain(Function),
    SelectLess,
    Table,
}

fn argument(view: AtomView<'_>, index: usize) -> Atom {
    match view {
        AtomView::Fun(function) => function.get(index).to_owned(),
        _ => unreachable!("a derivative is taken of a function"),
    }
}

fn one_minus_square(view: AtomView<'_>) -> Atom {
    Atom::num(1) - argument(view, 0).pow(2)
}

/// Returns the functions of one argument. Those that Symbolica lacks are registered with their
/// derivatives.
fn functions() -> Vec<(Function, CasSymbol)> {
    let sqrt = symbol!(
        "machinist::sqrt",
        der = |view, _, out| **out = Atom::num((1, 2)) / view.to_owned()
    );
    let abs = symbol!(
        "machinist::abs",
        der = |view, _, out| {
            let x = argument(view, 0);
            let sides = [x, Atom::new(), Atom::num(-1), Atom::num(1)];
            **out = symbol!("machinist::select_less").call_args(&sides);
        }
    );
    let floor = symbol!("machinist::floor", der = |_, _, out| **out = Atom::new());
    let tan = symbol!(
        "machinist::tan",
        der = |view, _, out| **out = Atom::num(1) + view.to_owned().pow(2)
    );
    let sinh = symbol!(
        "machinist::sinh",
        der = |view, _, out| **out = symbol!("machinist::cosh").call_args([argument(view, 0)])
    );
    let cosh = symbol!(
        "machinist::cosh",
        der = |view, _, out| **out = symbol!("machinist::sinh").call_args([argument(view, 0)])
    );
    let tanh = symbol!(
        "machinist::tanh",
        der = |view, _, out| **out = Atom::num(1) - view.to_owned().pow(2)
    );
    let asin = symbol!(
        "machinist::asin",
        der = move |view, _, out| {
            **out = Atom::num(1) / symbol!("machinist::sqrt").call_args([one_minus_square(view)]);
        }
    );
    let acos = symbol!(
        "machinist::acos",
        der = move |view, _, out| {
            **out = Atom::num(-1) / symbol!("machinist::sqrt").call_args([one_minus_square(view)]);
        }
    );
    let atan = symbol!(
        "machinist::atan",
        der = |view, _, out| **out = Atom::num(1) / (Atom::num(1) + argument(view, 0).pow(2))
    );
    vec![
        (Function::Sqrt, sqrt),
        (Function::Abs, abs),
        (Function::Floor, floor),
        (Function::Exp, CasSymbol::EXP),
        (Function::Ln, CasSymbol::LOG),
        (Function::Sin, CasSymbol::SIN),
        (Function::Cos, CasSymbol::COS),
        (Function::Tan, tan),
        (Function::Asin, asin),
        (Function::Acos, acos),
        (Function::Atan, atan),
        (Function::Sinh, sinh),
        (Function::Cosh, cosh),
        (Function::Tanh, tanh),
    ]
}

/// `select_less(a, b, x, y)`, differentiated in its branches only: the solver stops at the
/// discontinuity where a passes b.
fn select_less() -> CasSymbol {
    symbol!(
        "machinist::select_less",
        der = |view, index, out| {
            let branch = |x: i64, y: i64| {
                let sides = [argument(view, 0), argument(view, 1), Atom::num(x), Atom::num(y)];
                symbol!("machinist::select_less").call_args(&sides)
            };
            **out = match index {
                2 => branch(1, 0),
                3 => branch(0, 1),
                _ => Atom::new(),
            };
        }
    )
}

/// `table(id, order, x)`.
fn table() -> CasSymbol {
    symbol!(
        "machinist::table",
        der = |view, _, out| {
            let order = argument(view, 1) + Atom::num(1);
            let all = [argument(view, 0), order, argument(view, 2)];
            **out = symbol!("machinist::table").call_args(&all);
        }
    )
}
