//! The Taylor series of a scene as one function: zeroth coefficients line by line, then one loop
//! over the orders with one line per node.

mod coefficients;
mod needs;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::Scene;
use super::names::argument;
use crate::emit::EmitError;
use crate::emit::text::doc;
use coefficients::Writer;
use machinist_model::series::{Convolution, MassMatrix, TaylorTape, recurrences};
use needs::{Needs, needs};

/// Maximum number of nodes. A larger function takes long to compile and runs slowly, so such
/// scenes have no series.
const MOST_NODES: usize = 4000;

/// Number of sums formed in one loop: as many as one operation of a processor takes. Larger
/// groups would be ready only with the last of their sums.
const LANES: usize = 4;

/// Recurrences of a scene, and the parts of them that are emitted.
pub(super) struct Series {
    tape: TaylorTape,
    needs: Needs,
    has_corners: bool,
}

impl Series {
    /// Returns the series of a scene, unless it has no states or too many nodes.
    pub(super) fn new(scene: &Scene<'_>) -> Option<Self> {
        let tape = recurrences(scene.model);
        // A series does not fulfil constraints.
        let is_free = scene.model.constraints.is_empty();
        let is_wanted = is_free && !tape.rate.is_empty() && tape.nodes.len() <= MOST_NODES;
        let has_corners = tape.has_corners(scene.model.discontinuities.results.len());
        is_wanted.then(|| Self { needs: needs(&tape), tape, has_corners })
    }

    /// Returns the names to import from the contract's `taylor`.
    pub(super) fn imports(&self) -> TokenStream {
        let lanes = (!self.needs.convolutions.is_empty()).then(|| quote!(Lanes,));
        let factored = self.tape.mass_matrix.is_some().then(|| quote!(Factored,));
        quote!(taylor::{#factored #lanes order_and_inverse},)
    }

    /// Returns the part of `simulator!` that implements `TaylorSeries`.
    pub(super) fn part(&self) -> String {
        let sums = self.needs.convolutions.len();
        let corners = if self.has_corners { " has_corners" } else { "" };
        format!("series {sums}{corners};")
    }

    /// Returns the sums in groups.
    fn groups(&self) -> Vec<&[Convolution]> {
        self.needs.convolutions.chunks(LANES).collect()
    }

    /// Returns the function.
    pub(super) fn items(&self, scene: &Scene<'_>) -> Result<TokenStream, EmitError> {
        let names = Names::new(scene);
        let mut writer = Writer::new(scene, &self.tape, &self.needs, names.clone());
        let zeroth = writer.zeroth()?;
        let solve = self.tape.mass_matrix.as_ref().map(|mass| solve(mass, &mut writer, &names));
        let (first_factored, solve_first) = solve.unzip();
        let befores = writer.befores();
        let rates = writer.rates();
        let lanes = self.lanes(&names);
        let sums = self.sums(&names);
        let higher = writer.higher();
        let solve_higher = self.tape.mass_matrix.as_ref().map(|mass| {
            let accelerations = writer.higher_accelerations(mass);
            let right_side = mass.right_side.iter().map(|&id| writer.newest_or_zero(id));
            let factored = &names.factored;
            quote!(let [#(#accelerations),*] = #factored.solve([#(#right_side),*]);)
        });
        let set = self.set_lanes(&writer, &names);
        let keep = writer.keep_befores();
        let higher_rates = writer.higher_rates();
        let newest_states = writer.newest_states();
        let reads = &writer.reads;
        let (p, time) = (argument(reads.given.parameters, "p"), argument(reads.given.time, "time"));
        let workspace =
            if self.needs.convolutions.is_empty() { quote!(_workspace) } else { quote!(workspace) };
        let states = writer.states();
        let Names { order, highest, k, inverse, rates: all_rates, newest, coefficients, .. } =
            &names;
        let k = if writer.reads.order { quote!(#k) } else { quote!(_) };
        let docs = self.docs();
        Ok(quote! {
            #docs
            pub fn series<R: Real>(
                #time: R,
                state: &[R; STATES],
                #p: &Parameters<R>,
                #coefficients: &mut [[R; STATES]],
                #workspace: &mut [R],
            ) {
                #lanes
                #states
                #(#zeroth)*
                #first_factored
                #solve_first
                #(#befores)*
                let mut #all_rates = [#(#rates),*];
                #coefficients[0] = *state;
                let #highest = #coefficients.len() - 1;
                for (#order, #newest) in #coefficients.iter_mut().enumerate().skip(1) {
                    let (#k, #inverse) = order_and_inverse::<R>(#order);
                    *#newest = #all_rates.map(|rate| rate * #inverse);
                    if #order == #highest {
                        break;
                    }
                    #newest_states
                    #sums
                    #(#higher)*
                    #solve_higher
                    #set
                    #(#keep)*
                    #all_rates = [#(#higher_rates),*];
                }
            }
        })
    }

    fn docs(&self) -> TokenStream {
        let sums = match self.needs.convolutions.len() {
            0 => "No sums of products.".to_owned(),
            1 => "One sum of products an order.".to_owned(),
            many => format!("{many} sums of products an order."),
        };
        let nodes = format!("{} recurrences.", self.tape.nodes.len());
        doc([
            "Normalized Taylor coefficients of the solution through `state`, order after order.",
            "",
            "`_k` marks the coefficient of order k, `_before` that of order k - 1; bare names are",
            "zeroth coefficients. The workspace is as `series_workspace` says.",
            "",
            &format!("{nodes} {sums}"),
            "",
            "# Panics",
            "If there is no room for the zeroth coefficients, or the workspace is too short.",
        ])
    }

    /// Returns the lanes of each group, from the workspace.
    fn lanes(&self, names: &Names) -> TokenStream {
        let groups = self.groups();
        let (last, coefficients) = (groups.len().saturating_sub(1), &names.coefficients);
        let statements = groups.iter().enumerate().map(|(index, group)| {
            let (lane, lanes) = (names.lanes(index), Literal::usize_unsuffixed(group.len()));
            let rest = if index == last { quote!(_) } else { quote!(workspace) };
            quote! {
                let (mut #lane, #rest) = Lanes::<R, #lanes>::new(workspace, #coefficients.len());
            }
        });
        statements.collect()
    }

    fn sums(&self, names: &Names) -> TokenStream {
        let order = &names.order;
        let statements = (0..self.groups().len()).map(|index| {
            let (lane, sums) = (names.lanes(index), names.sums(index));
            quote!(let #sums = #lane.sums(#order);)
        });
        statements.collect()
    }

    fn set_lanes(&self, writer: &Writer<'_>, names: &Names) -> TokenStream {
        let groups = self.groups().into_iter().enumerate();
        let order = &names.order;
        let statements = groups.map(|(index, group)| {
            let lane = names.lanes(index);
            let left = group.iter().map(|convolution| writer.left_factor(convolution));
            let right = group.iter().map(|convolution| writer.newest_or_zero(convolution.right));
            quote!(#lane.set(#order, [#(#left),*], [#(#right),*]);)
        });
        statements.collect()
    }
}

/// Returns the factored mass matrix and the zeroth accelerations.
fn solve(mass: &MassMatrix, writer: &mut Writer<'_>, names: &Names) -> (TokenStream, TokenStream) {
    let n = mass.right_side.len();
    let mut matrix = vec![vec![quote!(R::literal(0.0)); n]; n];
    for &(row, column, entry) in &mass.lower {
        matrix[row as usize][column as usize] = writer.value(entry);
    }
    let rows = matrix.iter().map(|row| quote!([#(#row),*]));
    let factored = &names.factored;
    let accelerations = writer.accelerations(mass);
    let right_side = mass.right_side.iter().map(|&id| writer.value(id));
    (
        quote!(let #factored = Factored::new([#(#rows),*]);),
        quote!(let [#(#accelerations),*] = #factored.solve([#(#right_side),*]);),
    )
}

/// Names of the function's own variables.
#[derive(Clone)]
pub(super) struct Names {
    namer: super::names::Namer,
    order: Ident,
    highest: Ident,
    k: Ident,
    inverse: Ident,
    rates: Ident,
    newest: Ident,
    factored: Ident,
    coefficients: Ident,
    lanes: Ident,
    sums: Ident,
}

impl Names {
    fn new(scene: &Scene<'_>) -> Self {
        let mut namer = scene.locals.clone();
        namer.reserve("workspace");
        let [order, highest, k, inverse, rates, newest, factored, coefficients, lanes, sums] = [
            "order",
            "highest",
            "k",
            "inverse",
            "rates",
            "state_k",
            "factored",
            "coefficients",
            "lanes",
            "sums",
        ]
        .map(|name| namer.claim(name));
        Self {
            namer,
            order,
            highest,
            k,
            inverse,
            rates,
            newest,
            factored,
            coefficients,
            lanes,
            sums,
        }
    }

    fn lanes(&self, group: usize) -> Ident {
        if group == 0 { self.lanes.clone() } else { format_ident!("{}_{group}", self.lanes) }
    }

    fn sums(&self, group: usize) -> Ident {
        if group == 0 { self.sums.clone() } else { format_ident!("{}_{group}", self.sums) }
    }
}
