//! Tests of sums of waves with literal numbers, by their values at some times.

use super::*;

type Of = fn(f64) -> f64;

const TIMES: [f64; 4] = [0.0, 0.3, 1.1, 2.7];

/// A term a t^power e^(growth t) sin(frequency t + phase).
#[derive(Clone, Copy)]
struct Term {
    size: f64,
    power: i32,
    growth: f64,
    frequency: f64,
    phase: f64,
}

impl Term {
    fn value(self, t: f64) -> f64 {
        let Term { size, power, growth, frequency, phase } = self;
        size * t.powi(power) * (growth * t).exp() * (frequency * t + phase).sin()
    }

    fn sum(self, algebra: &mut Algebra) -> Sum {
        let Term { size, power, growth, frequency, phase } = self;
        let [size, growth, frequency, phase] =
            [size, growth, frequency, phase].map(|value| algebra.literal(value));
        let time = algebra.time();
        let grown = algebra.product(&growth, &time).expect("linear in time");
        let turned = algebra.product(&time, &frequency).expect("linear in time");
        let turned = algebra.sum(&turned, &phase);
        let mut product = algebra.call(Function::Exp, &grown).expect("a wave");
        for factor in [algebra.call(Function::Sin, &turned).expect("a wave"), size] {
            product = algebra.product(&product, &factor).expect("a wave");
        }
        for _ in 0..power {
            product = algebra.product(&product, &time).expect("a wave");
        }
        product
    }
}

const TERMS: [Term; 4] = [
    Term { size: 2.0, power: 0, growth: 0.0, frequency: 3.0, phase: 0.4 },
    Term { size: -1.5, power: 1, growth: -0.5, frequency: 2.0, phase: 1.1 },
    Term { size: 0.7, power: 2, growth: 0.25, frequency: 0.0, phase: 0.9 },
    Term { size: 1.2, power: 0, growth: 0.0, frequency: 3.0, phase: -0.8 },
];

/// Returns the value of a sum with literal coefficients at a given time.
fn value(algebra: &Algebra, sum: &Sum, t: f64) -> f64 {
    let number = |node| algebra.graph.literal_value(node).expect("of literals");
    let waves = sum.waves(algebra).into_iter().map(|pair| {
        let [growth, frequency] = [pair.growth, pair.frequency].map(number);
        let (sine, cosine) = (frequency * t).sin_cos();
        let swing = number(pair.cosine) * cosine + number(pair.sine) * sine;
        t.powi(pair.power as i32) * (growth * t).exp() * swing
    });
    waves.sum()
}

fn assert_is(algebra: &Algebra, sum: &Sum, expected: impl Fn(f64) -> f64, what: &str) {
    for t in TIMES {
        let (found, expected) = (value(algebra, sum, t), expected(t));
        assert!((found - expected).abs() < 1e-12, "{what} at {t}: {found} {expected}");
    }
}

#[test]
fn sums_products_and_powers_of_waves_are_waves() {
    let mut algebra = Algebra::new();
    for a in TERMS {
        let of_a = a.sum(&mut algebra);
        assert_is(&algebra, &of_a, |t| a.value(t), "itself");
        let negative = algebra.negative(&of_a);
        assert_is(&algebra, &negative, |t| -a.value(t), "negative");
        let four = algebra.literal(4.0);
        let quarter = algebra.quotient(&of_a, &four).expect("by a constant");
        assert_is(&algebra, &quarter, |t| a.value(t) / 4.0, "quotient");
        let cube = algebra.power(&of_a, 3).expect("a wave");
        assert_is(&algebra, &cube, |t| a.value(t).powi(3), "cube");
        for b in TERMS {
            let of_b = b.sum(&mut algebra);
            let sum = algebra.sum(&of_a, &of_b);
            assert_is(&algebra, &sum, |t| a.value(t) + b.value(t), "sum");
            let product = algebra.product(&of_a, &of_b).expect("waves");
            assert_is(&algebra, &product, |t| a.value(t) * b.value(t), "product");
        }
        let nothing = algebra.sum(&of_a, &negative);
        assert!(nothing.0.is_empty() && nothing.is_of_states());
    }
}

#[test]
fn functions_of_what_is_linear_in_time_are_waves_and_others_nothing() {
    let mut algebra = Algebra::new();
    let [slope, offset] = [0.5, 0.3].map(|value| algebra.literal(value));
    let time = algebra.time();
    let part = algebra.product(&slope, &time).expect("linear in time");
    let argument = algebra.sum(&part, &offset);
    let functions: [(Function, Of); 5] = [
        (Function::Sin, f64::sin),
        (Function::Cos, f64::cos),
        (Function::Exp, f64::exp),
        (Function::Sinh, f64::sinh),
        (Function::Cosh, f64::cosh),
    ];
    for (function, of) in functions {
        let found = algebra.call(function, &argument).expect("a wave");
        assert_is(&algebra, &found, |t| of(0.5 * t + 0.3), function.name());
    }
    assert!(algebra.call(Function::Tanh, &argument).is_none());
    let square = algebra.power(&argument, 2).expect("a wave");
    assert!(algebra.call(Function::Sin, &square).is_none());
    let root = algebra.call(Function::Sqrt, &offset).expect("a constant");
    assert_is(&algebra, &root, |_| 0.3_f64.sqrt(), "root");
    let power = algebra.of_constants(&[&slope, &offset], |graph, of| graph.powf(of[0], of[1]));
    assert_is(&algebra, &power.expect("a constant"), |_| 0.5_f64.powf(0.3), "power");
    assert!(algebra.of_constants(&[&argument], |_, of| of[0]).is_none());
}

#[test]
fn what_is_not_linear_in_the_state_is_nothing() {
    let mut algebra = Algebra::new();
    let (x, y, time, two) =
        (algebra.state(0), algebra.state(1), algebra.time(), algebra.literal(2.0));
    let twice = algebra.product(&two, &x).expect("linear");
    assert!(twice.is_of_states() && twice.depends_on_state());
    assert!(!time.is_of_states() && !time.depends_on_state());
    let both = algebra.sum(&twice, &time);
    assert!(!both.is_of_states() && both.depends_on_state());
    assert!(algebra.product(&x, &y).is_none() && algebra.product(&x, &time).is_none());
    assert!(algebra.quotient(&two, &x).is_none() && algebra.quotient(&x, &time).is_none());
    assert!(algebra.power(&x, 2).is_none() && algebra.power(&time, 9).is_none());
    assert!(algebra.power(&time, 0).is_none() && algebra.power(&two, -1).is_some());
    assert_eq!(algebra.power(&x, 1).expect("itself").0, x.0);
    assert!(algebra.call(Function::Sin, &x).is_none());
    // As many terms as allowed, and more; powers that a model can have, and higher ones.
    let mut many = Sum::default();
    for k in 1..=20 {
        let frequency = algebra.literal(f64::from(k));
        let turned = algebra.product(&frequency, &time).expect("linear in time");
        let wave = algebra.call(Function::Sin, &turned).expect("a wave");
        many = algebra.sum(&many, &wave);
    }
    let square = algebra.power(&many, 2);
    assert!(square.is_some());
    let more = algebra.sum(&many, &time);
    assert!(algebra.product(&more, &many).is_none());
    let mut highest = time.clone();
    for _ in 1..Excitation::HIGHEST_POWER {
        highest = algebra.product(&highest, &time).expect("a wave");
    }
    assert!(algebra.product(&highest, &time).is_none());
}

#[test]
fn a_choice_by_time_switches_where_both_sides_are_equal() {
    let mut algebra = Algebra::new();
    let [two, three, zero] = [2.0, 3.0, 0.0].map(|value| algebra.literal(value));
    let time = algebra.time();
    let x = algebra.state(0);
    let twice = algebra.product(&two, &time).expect("linear in time");
    // 2 t + 3 < t + 5 until t = 2.
    let lhs = algebra.sum(&twice, &three);
    let rhs = algebra.sum(&three, &two);
    let rhs = algebra.sum(&rhs, &time);
    for _ in 0..2 {
        let chosen = algebra.choice(&lhs, &rhs, [&x, &time]).expect("by time");
        let bases: Vec<Basis> = chosen.0.iter().map(|(basis, _)| *basis).collect();
        assert_eq!(bases, [x.0[0].0, time.0[0].0]);
        for ((_, coefficient), is_then) in chosen.0.iter().zip([true, false]) {
            let Op::SelectLess { then, otherwise, .. } = algebra.graph.op(*coefficient) else {
                panic!("it is chosen by time");
            };
            let [then, otherwise] =
                [then, otherwise].map(|node| algebra.graph.literal_value(node).expect("0 or 1"));
            let expected: [f64; 2] = if is_then { [1.0, 0.0] } else { [0.0, 1.0] };
            assert_eq!([then, otherwise].map(f64::to_bits), expected.map(f64::to_bits));
        }
        let switches: Vec<f64> = algebra
            .switches()
            .iter()
            .map(|node| algebra.graph().literal_value(*node).expect("of literals"))
            .collect();
        assert_eq!(switches, [2.0]);
    }
    // A comparison that is constant in time is decided, and gives no switch.
    let chosen = algebra.choice(&two, &three, [&time, &zero]).expect("by numbers");
    assert_eq!((chosen.0, algebra.switches().len()), (time.0, 1));
    assert!(algebra.choice(&x, &two, [&two, &three]).is_none());
}
