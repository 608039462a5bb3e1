//! Parts of expressions that are defined once and used many times.
//!
//! An expression is a tree, and a tree of recursive quantities, such as the velocities along a chain
//! of bodies, grows exponentially with the length of the chain. A shared part is a leaf of the
//! expressions that use it, and becomes one node of the graph. Its derivatives are shared parts
//! too: they follow the chain rule, and each is formed once.

use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use rustc_hash::{FxHashMap, FxHashSet};

use super::{Expr, Function, Symbol};

/// A part that several expressions share.
///
/// Two of them are equal if their definitions are, whatever their names.
#[derive(Clone)]
pub struct Shared(Arc<Inner>);

struct Inner {
    definition: Expr,
    /// Name of its node in emitted code, if it has one.
    name: Option<String>,
    symbols: Arc<BTreeSet<Symbol>>,
    /// Number of shared parts that nest in the definition, one within the other.
    depth: u32,
    /// Digest of the definition, of 128 bits: a comparison of definitions would visit parts as
    /// often as they are used.
    digest: u128,
    /// Derivatives that have been formed.
    slopes: Mutex<FxHashMap<Symbol, Expr>>,
}

impl Shared {
    /// Returns the part with a definition.
    #[must_use]
    pub fn new(definition: Expr, name: Option<String>) -> Self {
        let (mut depth, mut symbols, mut own) = (0, Arc::default(), BTreeSet::new());
        definition.visit(&mut |part| match part {
            Expr::Symbol(symbol) => drop(own.insert(*symbol)),
            Expr::Shared(Shared(inner)) => {
                depth = depth.max(inner.depth + 1);
                symbols = joined(&symbols, &inner.symbols);
            }
            _ => {}
        });
        let mut digest = Digest::default();
        definition.hash(&mut digest);
        let symbols = joined(&symbols, &Arc::new(own));
        let (digest, slopes) = (digest.bits(), Mutex::default());
        Shared(Arc::new(Inner { definition, name, symbols, depth, digest, slopes }))
    }

    /// Returns the definition.
    #[must_use]
    pub fn definition(&self) -> &Expr {
        &self.0.definition
    }

    /// Returns the name of its node in emitted code, if it has one.
    #[must_use]
    pub fn name(&self) -> Option<&str> {
        self.0.name.as_deref()
    }

    /// Returns all symbols that its value depends on.
    #[must_use]
    pub fn symbols(&self) -> &BTreeSet<Symbol> {
        &self.0.symbols
    }

    /// Returns the digest of the definition, which identifies the part.
    #[must_use]
    pub fn digest(&self) -> u128 {
        self.0.digest
    }

    /// Returns the shared parts of an expression and of their definitions, each after those that it
    /// uses, except those for which `is_known` returns true and what only they use.
    ///
    /// Work on them in this order does not recurse: parts may nest thousands of levels deep.
    #[must_use]
    pub fn within(expr: &Expr, is_known: impl Fn(&Shared) -> bool) -> Vec<Shared> {
        let mut found: FxHashMap<u128, Shared> = FxHashMap::default();
        let mut left = direct(expr);
        while let Some(part) = left.pop() {
            if !found.contains_key(&part.digest()) && !is_known(&part) {
                left.extend(direct(part.definition()));
                found.insert(part.digest(), part);
            }
        }
        let mut parts: Vec<Shared> = found.into_values().collect();
        parts.sort_unstable();
        parts
    }

    /// Returns the derivative by a symbol, formed by `derive` at the first call.
    pub(crate) fn slope(&self, by: Symbol, derive: impl Fn(&Expr) -> Expr) -> Expr {
        if let Some(slope) = self.known_slope(by) {
            return slope;
        }
        let whole = Expr::Shared(self.clone());
        for part in Shared::within(&whole, |part| part.known_slope(by).is_some()) {
            let slope = Expr::shared(derive(&part.0.definition));
            part.slopes().insert(by, slope);
        }
        self.known_slope(by).unwrap_or_else(|| Expr::integer(0))
    }

    fn known_slope(&self, by: Symbol) -> Option<Expr> {
        if !self.0.symbols.contains(&by) {
            return Some(Expr::integer(0));
        }
        self.slopes().get(&by).cloned()
    }

    fn slopes(&self) -> MutexGuard<'_, FxHashMap<Symbol, Expr>> {
        self.0.slopes.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Returns the shared parts that an expression uses itself.
fn direct(expr: &Expr) -> Vec<Shared> {
    let mut parts = Vec::new();
    expr.visit(&mut |part| {
        if let Expr::Shared(shared) = part {
            parts.push(shared.clone());
        }
    });
    parts
}

impl Drop for Inner {
    /// Drops the parts within one after the other: nested drops would exhaust the stack.
    fn drop(&mut self) {
        let mut left = self.release();
        while let Some(Shared(part)) = left.pop() {
            if let Some(mut inner) = Arc::into_inner(part) {
                left.extend(inner.release());
            }
        }
    }
}

impl Inner {
    /// Gives away the parts that it uses.
    fn release(&mut self) -> Vec<Shared> {
        let mut parts = direct(&self.definition);
        self.definition = Expr::integer(0);
        let slopes = self.slopes.get_mut().unwrap_or_else(PoisonError::into_inner);
        for slope in std::mem::take(slopes).into_values() {
            parts.extend(direct(&slope));
        }
        parts
    }
}

impl Expr {
    /// Visits every part of some expressions, then every part of the definitions of their shared
    /// parts, each definition once.
    pub fn visit_all<'a>(exprs: impl IntoIterator<Item = &'a Expr>, see: &mut impl FnMut(&Expr)) {
        let mut seen = FxHashSet::default();
        let mut left = Vec::new();
        for expr in exprs {
            expr.visit(see);
            left.extend(direct(expr));
            while let Some(part) = left.pop() {
                if seen.insert(part.digest()) {
                    part.definition().visit(see);
                    left.extend(direct(part.definition()));
                }
            }
        }
    }

    /// Returns the expression with symbols replaced by other expressions.
    #[must_use]
    pub fn replace(&self, with: &impl Fn(Symbol) -> Option<Expr>) -> Expr {
        Replacement::new(with, None::<fn(Function) -> Function>).of(self)
    }

    /// Returns the expression as a shared part. Numbers and symbols, also with a factor, remain as
    /// they are.
    #[must_use]
    pub fn shared(self) -> Expr {
        self.shared_as(None)
    }

    /// Returns the same under a name for emitted code.
    #[must_use]
    pub fn shared_as(self, name: Option<String>) -> Expr {
        let is_leaf =
            |expr: &Expr| matches!(expr, Expr::Number(_) | Expr::Symbol(_) | Expr::Shared(_));
        match &self {
            Expr::Product(factors)
                if factors.len() == 2
                    && matches!(factors[0], Expr::Number(_))
                    && is_leaf(&factors[1]) =>
            {
                self
            }
            leaf if is_leaf(leaf) => self,
            _ => Expr::Shared(Shared::new(self, name)),
        }
    }
}

/// Returns the union of two sets, of which one usually contains the other.
fn joined(a: &Arc<BTreeSet<Symbol>>, b: &Arc<BTreeSet<Symbol>>) -> Arc<BTreeSet<Symbol>> {
    if Arc::ptr_eq(a, b) || b.is_subset(a) {
        Arc::clone(a)
    } else if a.is_subset(b) {
        Arc::clone(b)
    } else {
        Arc::new(a.union(b).copied().collect())
    }
}

/// Replaces symbols and functions in expressions, and in each of their shared parts once.
pub struct Replacement<S, F> {
    symbols: S,
    functions: Option<F>,
    /// Results for the shared parts met so far.
    known: FxHashMap<u128, Expr>,
}

impl<S: Fn(Symbol) -> Option<Expr>, F: Fn(Function) -> Function> Replacement<S, F> {
    /// Returns a replacement of symbols, and of functions if some are to be replaced.
    pub fn new(symbols: S, functions: Option<F>) -> Self {
        Self { symbols, functions, known: FxHashMap::default() }
    }

    /// Returns an expression with symbols and functions replaced. Terms keep their order.
    pub fn of(&mut self, expr: &Expr) -> Expr {
        for part in Shared::within(expr, |part| self.known.contains_key(&part.digest())) {
            let is_changed = self.functions.is_some()
                || part.symbols().iter().any(|symbol| (self.symbols)(*symbol).is_some());
            let result = if is_changed {
                let name = part.name().map(str::to_owned);
                self.replaced(part.definition()).shared_as(name)
            } else {
                Expr::Shared(part.clone())
            };
            self.known.insert(part.digest(), result);
        }
        self.replaced(expr)
    }

    fn replaced(&self, expr: &Expr) -> Expr {
        let all = |parts: &[Expr]| parts.iter().map(|part| self.replaced(part)).collect();
        match expr {
            Expr::Number(_) => expr.clone(),
            Expr::Symbol(symbol) => (self.symbols)(*symbol).unwrap_or_else(|| expr.clone()),
            Expr::Sum(terms) => Expr::Sum(all(terms)),
            Expr::Product(factors) => Expr::Product(all(factors)),
            Expr::Power(base, exponent) => {
                Expr::Power(Box::new(self.replaced(base)), Box::new(self.replaced(exponent)))
            }
            Expr::Call(function, arguments) => {
                let function = self.functions.as_ref().map_or(*function, |new| new(*function));
                Expr::Call(function, all(arguments))
            }
            Expr::Shared(shared) => self.known.get(&shared.digest()).unwrap_or(expr).clone(),
        }
    }
}

impl PartialEq for Shared {
    fn eq(&self, other: &Self) -> bool {
        self.0.digest == other.0.digest
    }
}

impl Eq for Shared {}

impl PartialOrd for Shared {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Shared {
    fn cmp(&self, other: &Self) -> Ordering {
        self.0.depth.cmp(&other.0.depth).then(self.0.digest.cmp(&other.0.digest))
    }
}

impl Hash for Shared {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u64(self.0.digest as u64);
        state.write_u64((self.0.digest >> 64) as u64);
    }
}

impl fmt::Debug for Shared {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Shared({:032x})", self.0.digest)
    }
}

/// A hash of 128 bits that is the same in every process, so that the order of terms is.
#[derive(Default)]
struct Digest([u64; 2]);

impl Digest {
    fn bits(&self) -> u128 {
        u128::from(self.0[0]) | u128::from(self.0[1]) << 64
    }

    /// Mixes one word into both halves by the finalizer of splitmix64, with different constants.
    fn mix(&mut self, word: u64) {
        let constants = [0x9E37_79B9_7F4A_7C15, 0xC2B2_AE3D_27D4_EB4F];
        for (half, constant) in self.0.iter_mut().zip(constants) {
            let mut z = (half.rotate_left(23) ^ word).wrapping_add(constant);
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            *half = z ^ (z >> 31);
        }
    }
}

impl Hasher for Digest {
    fn finish(&self) -> u64 {
        self.0[0]
    }

    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.mix(u64::from_le_bytes(word));
        }
        self.mix(bytes.len() as u64);
    }

    fn write_u32(&mut self, word: u32) {
        self.mix(u64::from(word));
    }

    fn write_u64(&mut self, word: u64) {
        self.mix(word);
    }

    fn write_usize(&mut self, word: usize) {
        self.mix(word as u64);
    }
}
