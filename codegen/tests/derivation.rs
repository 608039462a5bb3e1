//! Tests of results of the computer algebra.

use machinist_algebra::cas::{Algebra, session};
use machinist_algebra::expr::operations;
use machinist_algebra::expr::{CoordinateId, Expr, Function, ParameterId, Symbol};
use machinist_model::TableId;
use num_rational::BigRational;

fn number(n: i64) -> Expr {
    Expr::Number(BigRational::from_integer(n.into()))
}
fn q(index: u32) -> Expr {
    Expr::Symbol(Symbol::Coordinate(CoordinateId(index)))
}
fn p(index: u32) -> Expr {
    Expr::Symbol(Symbol::Parameter(ParameterId(index)))
}
fn power(base: Expr, exponent: i64) -> Expr {
    Expr::Power(Box::new(base), Box::new(number(exponent)))
}
fn call(function: Function, argument: Expr) -> Expr {
    Expr::Call(function, vec![argument])
}
fn derivative(expr: Expr) -> Expr {
    session("a test", Algebra::most_simplifying(1), move |cas| {
        let form = cas.form(&expr);
        let derivative = cas.derivative(&form, Symbol::Coordinate(CoordinateId(0)));
        cas.expr(&derivative)
    })
    .expect("a session")
}
fn simplified(expr: Expr) -> Expr {
    session("a test", Algebra::most_simplifying(1), move |cas| {
        let form = cas.form(&expr);
        cas.simplify(&form)
    })
    .expect("a session")
}

#[test]
fn a_spring_pulls_back() {
    let half = Expr::Number(BigRational::new(1.into(), 2.into()));
    let spring = Expr::Product(vec![half, p(0), power(q(0), 2)]);
    assert_eq!(derivative(spring), Expr::Product(vec![q(0), p(0)]));
}

#[test]
fn selection_is_differentiated_branch_by_branch() {
    let square = power(q(0), 2);
    let minimum = Expr::Call(
        Function::SelectLess,
        vec![square.clone(), p(0), Expr::Product(vec![p(1), square]), call(Function::Sin, q(0))],
    );
    let expected = Expr::Call(
        Function::SelectLess,
        vec![
            power(q(0), 2),
            p(0),
            Expr::Product(vec![number(2), q(0), p(1)]),
            call(Function::Cos, q(0)),
        ],
    );
    assert_eq!(derivative(minimum), expected);
}

#[test]
fn derivative_of_a_table_is_the_table_of_the_next_order() {
    let table = |order| Function::Table { table: TableId(3), order };
    assert_eq!(derivative(call(table(0), q(0))), call(table(1), q(0)));
}

#[test]
fn every_function_has_the_derivative_of_the_textbook() {
    let x = q(0);
    let one_over = |e: Expr| power(e, -1);
    let cases = [
        (
            Function::Tanh,
            Expr::Sum(vec![
                number(1),
                Expr::Product(vec![number(-1), power(call(Function::Tanh, x.clone()), 2)]),
            ]),
        ),
        (Function::Cosh, call(Function::Sinh, x.clone())),
        (Function::Sinh, call(Function::Cosh, x.clone())),
        (Function::Exp, call(Function::Exp, x.clone())),
        (Function::Ln, one_over(x.clone())),
        (Function::Atan, one_over(Expr::Sum(vec![number(1), power(x.clone(), 2)]))),
        (
            Function::Sqrt,
            Expr::Product(vec![
                Expr::Number(BigRational::new(1.into(), 2.into())),
                one_over(call(Function::Sqrt, x.clone())),
            ]),
        ),
    ];
    for (function, expected) in cases {
        assert_eq!(derivative(call(function, x.clone())), expected, "{function:?}");
    }
}

#[test]
fn pythagoras_and_addition_theorems_save_operations() {
    let sin = |e: Expr| call(Function::Sin, e);
    let cos = |e: Expr| call(Function::Cos, e);
    let pythagoras = Expr::Sum(vec![
        Expr::Product(vec![p(0), power(sin(q(0)), 2)]),
        Expr::Product(vec![p(0), power(cos(q(0)), 2)]),
        q(1),
    ]);
    assert_eq!(operations(&simplified(pythagoras)), 1);
    let addition = Expr::Sum(vec![
        Expr::Product(vec![p(0), p(1), sin(q(0)), sin(q(1))]),
        Expr::Product(vec![p(0), p(1), cos(q(0)), cos(q(1))]),
    ]);
    assert_eq!(operations(&simplified(addition)), 4);
}

#[test]
fn exact_numbers_beyond_64_bits_come_back_unchanged() {
    let huge: BigRational = "-123456789012345678901234567890/9876543210987654321098765432101"
        .parse()
        .expect("a number");
    let expr = Expr::Product(vec![Expr::Number(huge.clone()), q(0)]);
    assert_eq!(derivative(expr), Expr::Number(huge));
}

#[test]
fn sessions_of_several_threads_take_turns() {
    let threads: Vec<_> = (0..4)
        .map(|_| {
            std::thread::spawn(|| {
                for _ in 0..20 {
                    assert_eq!(derivative(power(q(0), 2)), Expr::Product(vec![number(2), q(0)]));
                }
            })
        })
        .collect();
    for thread in threads {
        thread.join().expect("no thread ends in a panic");
    }
}
