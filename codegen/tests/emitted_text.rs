//! Layout of emitted modules, and confinement of the spec's text to comments. Emitted modules are
//! kept in `tests/emitted/`, where the other tests compile them; `ACCEPT_EMITTED=1 cargo test -p
//! machinist-codegen` renews them.

use std::path::Path;

use crate::support::{HOSTILE, coupled, oddities, pendulum, recurrences, tape};
use machinist_codegen::emit::rust::{emit, emit_index};
use machinist_codegen::emit::{EmitError, EmitOptions};
use machinist_model::Model;
use machinist_model::operations;
use machinist_model::{Node, NodeId, Op, Tape};
use proc_macro2::{TokenStream, TokenTree};

fn emitted(model: &Model) -> String {
    emit(model, &EmitOptions::for_build_script()).expect("a model that can be emitted")
}

fn assert_kept(model: &Model) {
    let name = format!("{}.rs", model.name);
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/emitted").join(name);
    let text = emitted(model);
    if std::env::var_os("ACCEPT_EMITTED").is_some() {
        std::fs::write(&path, &text).expect("tests/emitted can be written");
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        kept == text,
        "{} is not what is emitted; if it should be, renew it with \
         `ACCEPT_EMITTED=1 cargo test -p machinist-codegen` and look at the difference",
        path.display()
    );
}

#[test]
fn the_pendulum_is_emitted_as_kept() {
    assert_kept(&pendulum());
}

#[test]
fn odd_names_and_every_operation_are_emitted_as_kept() {
    assert_kept(&oddities());
}

#[test]
fn series_of_every_operation_and_of_coupled_coordinates_are_emitted_as_kept() {
    assert_kept(&recurrences());
    assert_kept(&coupled());
}

#[test]
fn the_same_model_gives_the_same_bytes() {
    assert_eq!(emitted(&pendulum()), emitted(&pendulum()));
}

/// Returns kind and name of every item of a module.
fn items(text: &str) -> Vec<String> {
    let file = syn::parse_file(text).expect("emitted text is Rust");
    let items = file.items.iter().map(|item| match item {
        syn::Item::Const(item) => format!("const {}", item.ident),
        syn::Item::Fn(item) => format!("fn {}", item.sig.ident),
        syn::Item::Static(item) => format!("static {}", item.ident),
        syn::Item::Struct(item) => format!("struct {}", item.ident),
        syn::Item::Mod(item) => format!("mod {}", item.ident),
        syn::Item::Use(_) => "use".to_owned(),
        syn::Item::Impl(_) => "impl".to_owned(),
        syn::Item::Macro(item) => {
            format!("macro {}", item.mac.path.segments.last().expect("a name").ident)
        }
        _ => "something else".to_owned(),
    });
    items.collect()
}

#[test]
fn hostile_text_adds_no_item() {
    let mut harmless = oddities();
    harmless.title = "title".to_owned();
    harmless.doc = "doc".to_owned();
    harmless.source = "source".to_owned();
    for output in &mut harmless.wanted {
        output.doc = "doc".to_owned();
    }
    assert_eq!(items(&emitted(&oddities())), items(&emitted(&harmless)));
    assert!(!items(&emitted(&oddities())).contains(&"fn main".to_owned()));
}

#[test]
fn hostile_text_reaches_readers_unchanged() {
    let text = emitted(&oddities());
    let tokens: TokenStream = text.parse().expect("emitted text is Rust");
    assert!(strings(tokens).iter().any(|string| string == HOSTILE), "as the doc of a quantity");
}

/// Returns all string literals, also within macros.
fn strings(tokens: TokenStream) -> Vec<String> {
    let strings = tokens.into_iter().flat_map(|token| match token {
        TokenTree::Group(group) => strings(group.stream()),
        TokenTree::Literal(literal) => syn::parse_str::<syn::LitStr>(&literal.to_string())
            .map(|s| s.value())
            .into_iter()
            .collect(),
        _ => vec![],
    });
    strings.collect()
}

#[test]
fn a_number_without_a_literal_is_refused() {
    let mut model = pendulum();
    model.parameters[2].value = f64::INFINITY;
    let error = emit(&model, &EmitOptions::for_scenes()).expect_err("infinite gravity");
    insta::assert_snapshot!(error, @"parameter: inf is not a finite number");

    let mut model = pendulum();
    model.forcing = tape(|b| vec![b.number(f64::NAN)]);
    let error = emit(&model, &EmitOptions::for_scenes()).expect_err("no number");
    insta::assert_snapshot!(error, @"forcing: NaN is not a finite number");
}

#[test]
fn names_that_are_no_identifiers_are_refused() {
    let mut model = pendulum();
    model.parameters[0].quantity.name.ident = "mass; fn main() {}".to_owned();
    let error = emit(&model, &EmitOptions::for_scenes()).expect_err("code as a name");
    assert_eq!(error, EmitError::Identifier { name: "mass; fn main() {}".to_owned() });
}

#[test]
fn tapes_that_break_their_rules_are_refused() {
    let late = Tape { nodes: vec![Node { op: Op::Neg(NodeId(0)), name: None }], results: vec![] };
    let cases = [
        tape(|b| vec![b.state(0)]),
        tape(|b| vec![b.number(0.0)]),
        tape(|b| vec![b.parameter(9), b.number(0.0), b.number(0.0)]),
        Tape { nodes: vec![], results: vec![NodeId(4)] },
        late,
    ];
    let reasons = cases.map(|tape| {
        let model = Model { initial_state: tape, ..pendulum() };
        let error = emit(&model, &EmitOptions::for_scenes()).expect_err("a broken rule");
        error.to_string()
    });
    insta::assert_snapshot!(reasons.join("\n"));
}

#[test]
fn operations_without_a_use_are_not_counted() {
    let model = pendulum();
    let mut forcing = model.forcing.clone();
    assert_eq!(operations(&forcing), 7);
    forcing.nodes.push(Node { op: Op::Neg(NodeId(0)), name: None });
    assert_eq!(operations(&forcing), 7);
}

#[test]
fn the_index_lists_scenes_by_name() {
    let (pendulum, oddities) = (pendulum(), oddities());
    let index = emit_index(&[&pendulum, &oddities], &EmitOptions::for_scenes());
    insta::assert_snapshot!(index.expect("two scenes"));
}

#[test]
fn two_scenes_of_one_name_are_refused() {
    let error = emit_index(&[&pendulum(), &pendulum()], &EmitOptions::for_scenes());
    insta::assert_snapshot!(error.expect_err("one name"), @"two scenes are named `pendulum`");
}
