//! Table of integration methods: their names, orders and Cargo features. `method.rs` has the code that
//! each of them runs.

use std::fmt;
use std::str::FromStr;

use serde::{Serialize, Serializer};

use crate::error::{UnknownMethod, did_you_mean};

methods! {
    /// Backward differentiation formulas of orders 1 to 5, quasi-constant step; for stiff machines.
    Bdf { name: "bdf", order: 5, implicit: true, of: diffsol },
    /// Trapezoidal rule and second-order BDF in one step; for stiff machines and loose tolerances.
    TrBdf2 { name: "tr_bdf2", order: 2, implicit: true, of: diffsol },
    /// Singly diagonally implicit Runge-Kutta of order 3, explicit first stage; for stiff machines.
    Esdirk34 { name: "esdirk34", order: 3, implicit: true, of: diffsol },
    /// Explicit Runge-Kutta of order 5 by Tsitouras, diffsol's; for machines that are not stiff.
    Tsit45 { name: "tsit45", order: 5, implicit: false, of: diffsol },
    /// Explicit Runge-Kutta of order 5 by Tsitouras; for machines that are not stiff.
    Tsit5 { name: "tsit5", order: 5, implicit: false, of: always },
    /// Explicit Runge-Kutta of order 8 by Dormand and Prince; not stiff, tight tolerances.
    Dop853 { name: "dop853", order: 8, implicit: false, of: always },
    /// Rosenbrock method of order 5 by Steinebach; for stiff machines.
    Rodas5p { name: "rodas5p", order: 5, implicit: true, of: implicit },
    /// Radau IIA of orders 5, 9 and 13, whichever pays; stiff machines, tight tolerances.
    Radau { name: "radau", order: 13, implicit: true, of: implicit },
    /// Explicit where it can be, implicit where the machine is stiff, by the tolerance.
    Auto { name: "auto", order: 13, implicit: true, of: implicit },
    /// Taylor series of an order that follows the tolerance; smooth machines that are not stiff.
    Taylor { name: "taylor", order: 32, implicit: false, of: always },
    /// The solution in closed form, without steps; linear machines with constant coefficients.
    Exact { name: "exact", order: 0, implicit: false, of: implicit },
}

struct Row {
    name: &'static str,
    order: u32,
    implicit: bool,
    doc: &'static str,
    /// The Cargo feature that it requires.
    feature: Option<&'static str>,
}

impl Method {
    /// Returns the name that specs and the command line use.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// Returns the order of convergence: the highest if it varies, and 0 for a method without
    /// steps.
    #[must_use]
    pub fn order(self) -> u32 {
        self.row().order
    }

    /// Returns whether each step solves equations, so that the method copes with stiffness.
    #[must_use]
    pub fn is_implicit(self) -> bool {
        self.row().implicit
    }
    /// Returns the Cargo feature that the method requires; `None` if it is always available.
    #[must_use]
    pub fn feature(self) -> Option<&'static str> {
        self.row().feature
    }
    /// Returns a description in one line.
    #[must_use]
    pub fn doc(self) -> &'static str {
        self.row().doc.trim()
    }

    /// Returns the method of this name.
    ///
    /// # Errors
    /// [`UnknownMethod`], which lists the known names and proposes the nearest.
    pub fn from_name(name: &str) -> Result<Self, UnknownMethod> {
        Self::ALL.iter().copied().find(|method| method.name() == name).ok_or_else(|| {
            let names = || Self::ALL.iter().map(|method| method.name());
            UnknownMethod {
                name: name.to_owned(),
                hint: did_you_mean(name, names()),
                known: names().collect::<Vec<_>>().join(", "),
            }
        })
    }
}

impl fmt::Display for Method {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.pad(self.name())
    }
}

impl FromStr for Method {
    type Err = UnknownMethod;

    fn from_str(name: &str) -> Result<Self, UnknownMethod> {
        Self::from_name(name)
    }
}

impl Serialize for Method {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// One row per method: the variant with its line of doc, and its properties.
macro_rules! methods {
    ($(#[doc = $doc:literal] $variant:ident {
        name: $name:literal, order: $order:literal, implicit: $implicit:literal,
        of: $feature:tt
    },)*) => {
        /// An integration method.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        #[non_exhaustive]
        pub enum Method {
            $(#[doc = $doc] $variant,)*
        }

        impl Method {
            /// Every method, compiled in or not, in the order of the table.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            fn row(self) -> &'static Row {
                match self {
                    $(Self::$variant => {
                        const ROW: Row = Row {
                            name: $name,
                            order: $order,
                            implicit: $implicit,
                            doc: $doc,
                            feature: feature_of!($feature),
                        };
                        &ROW
                    })*
                }
            }
        }
    };
}
use methods;

/// The Cargo feature of a row.
macro_rules! feature_of {
    (always) => {
        None
    };
    ($feature:ident) => {
        Some(stringify!($feature))
    };
}
use feature_of;
