//! Kinks of small graphs, by their values.

use machinist_model::Name;
use machinist_model::evaluate::{Evaluator, Inputs};

use super::*;

type Build = fn(&mut Graph, NodeId, NodeId, NodeId) -> NodeId;

const SPAN: f64 = 100.0;
/// The parameter.
const P: f64 = 3.0;

fn table(knots: &[f64], coefficients: &[[f64; 4]]) -> Table {
    let name = Name { path: "table".to_owned(), ident: "table".to_owned(), latex: String::new() };
    Table { name, knots: knots.to_vec(), coefficients: coefficients.to_vec() }
}

/// Returns guards and times of a rate of time, a parameter and two states, the second a mode.
fn found(build: impl FnOnce(&mut Graph, [NodeId; 4]) -> NodeId, tables: &[Table]) -> [Vec<f64>; 2] {
    let mut graph = Graph::new();
    let leaves = [Op::Time, Op::Parameter(0), Op::State(0), Op::State(1)];
    let leaves = leaves.map(|op| graph.insert(op));
    let rate = build(&mut graph, leaves);
    let zero = graph.literal(0.0);
    let given = Given {
        is_mode: &[false, true],
        tables,
        run: (0.0, SPAN),
        parameters: &[P],
        is_place: &[true, false],
        start: &[2.0, 1.0],
    };
    let places = Places { rate: &[rate, zero], holds: &[], guards: &[] };
    let kinks = kinks(&mut graph, &places, &given);
    assert_eq!(kinks.guards.len(), kinks.rates.len());
    [kinks.guards, kinks.times].map(|nodes| {
        let tape = graph.tape(&nodes);
        let inputs =
            Inputs { time: 0.25, state: &[2.0, 1.0], parameters: &[P], ..Inputs::default() };
        let mut values = vec![0.0; nodes.len()];
        Evaluator::new(&tape).evaluate(&inputs, &mut values);
        values
    })
}

fn times(build: impl FnOnce(&mut Graph, NodeId, NodeId) -> NodeId) -> Vec<f64> {
    let [guards, times] = found(|graph, [time, p, ..]| build(graph, time, p), &[]);
    assert!(guards.is_empty(), "{guards:?}");
    times
}

/// factor (t - p)^2
fn square(graph: &mut Graph, time: NodeId, p: NodeId, factor: f64) -> NodeId {
    let distance = graph.sub(time, p);
    let square = graph.mul(distance, distance);
    let factor = graph.literal(factor);
    graph.mul(factor, square)
}

#[test]
fn what_is_linear_in_time_passes_zero_at_a_time_that_parameters_decide() {
    let two = |graph: &mut Graph| graph.literal(2.0);
    let abs = |graph: &mut Graph, a| graph.call(Function::Abs, a);
    // |p - 2 t|, |p + -(2 t)|, |(t - p)/2|, |t/p - 2|, |p t - 2 p|
    let expected = [P / 2.0, P / 2.0, P, 2.0 * P, 2.0];
    let builds: [Build; 5] = [
        |g, t, p, two| {
            let twice = g.mul(two, t);
            g.sub(p, twice)
        },
        |g, t, p, two| {
            // Without folding a sign away.
            let product = g.mul(p, t);
            let opposite = g.neg(product);
            let twice = g.mul(two, p);
            let [a, b] = [g.mul(twice, opposite), g.mul(p, p)];
            let b = g.mul(b, p);
            g.add(a, b)
        },
        |g, t, p, two| {
            let distance = g.sub(t, p);
            g.div(distance, two)
        },
        |g, t, p, two| {
            let share = g.div(t, p);
            g.sub(share, two)
        },
        |g, t, p, two| {
            let [a, b] = [g.mul(p, t), g.mul(two, p)];
            g.sub(a, b)
        },
    ];
    for (build, expected) in builds.into_iter().zip(expected) {
        let found = times(|graph, time, p| {
            let two = two(graph);
            let argument = build(graph, time, p, two);
            abs(graph, argument)
        });
        assert_eq!(found, [expected]);
    }
    let found = times(|graph, time, p| {
        let zero = graph.literal(0.0);
        graph.select_less(time, p, zero, time)
    });
    assert_eq!(found, [P]);
    // The same one twice counts once, and without time there is none.
    let found = times(|graph, time, p| {
        let distance = graph.sub(time, p);
        let [a, zero] = [abs(graph, distance), graph.literal(0.0)];
        let b = graph.select_less(time, p, zero, time);
        let c = abs(graph, p);
        let sum = graph.add(a, b);
        graph.add(sum, c)
    });
    assert_eq!(found, [P]);
}

#[test]
fn what_the_state_decides_is_a_guard_and_modes_are_not() {
    let [guards, times] = found(
        |graph, [time, _, x, mode]| {
            let ahead = graph.select_less(x, time, time, x);
            let behind = graph.select_less(time, x, x, mode);
            let size = graph.call(Function::Abs, mode);
            let sum = graph.add(ahead, behind);
            graph.add(sum, size)
        },
        &[],
    );
    // x - t and t - x are one.
    assert_eq!((guards, times), (vec![1.75], vec![]));
    let [guards, _] = found(
        |graph, [_, p, x, _]| {
            let [least, whole] = [graph.select_less(x, p, x, p), graph.call(Function::Floor, x)];
            graph.add(least, whole)
        },
        &[],
    );
    // For `floor`, its argument.
    assert_eq!(guards, [2.0 - P, 2.0]);
}

#[test]
fn functions_that_are_narrow_in_each_turn_are_guarded_where_their_argument_turns() {
    // In time at 0.25, by an exponent or a denominator that moves by this much, and by p = 3 times.
    let turning = |size: f64, function: fn(&mut Graph, NodeId) -> NodeId| {
        let [guards, times] = found(
            |graph, [time, p, ..]| {
                let (wave, size) = (graph.call(Function::Cos, time), graph.literal(size));
                let wave = graph.mul(size, wave);
                let wave = graph.mul(p, wave);
                function(graph, wave)
            },
            &[],
        );
        assert!(times.is_empty(), "{times:?}");
        guards
    };
    let bell = |graph: &mut Graph, wave| graph.call(Function::Exp, wave);
    let pole = |graph: &mut Graph, wave| {
        let [square, one] = [graph.mul(wave, wave), graph.literal(1.0)];
        let below = graph.add(one, square);
        graph.div(one, below)
    };
    let where_it_turns = |guards: &[f64], slope: f64| {
        guards.iter().filter(|guard| (*guard / slope - 1.0).abs() < 1e-12).count()
    };
    for (size, is_narrow) in [(100.0, true), (1.4, true), (1.3, false), (0.01, false)] {
        let slope = -size * P * 0.25_f64.sin();
        let guards = turning(size, bell);
        assert_eq!(where_it_turns(&guards, slope), usize::from(is_narrow), "{size}");
        // A zone about the largest values, in front of guards without slots.
        assert_eq!(guards.len(), usize::from(is_narrow) + usize::from(2.0 * size * P > 25.0));
    }
    for (size, is_narrow) in [(100.0, true), (2.4, true), (2.3, false)] {
        let slope = -2.0 * (size * P).powi(2) * 0.25_f64.sin() * 0.25_f64.cos();
        let guards = turning(size, pole);
        assert_eq!(guards.len(), usize::from(is_narrow), "{size}");
        assert_eq!(where_it_turns(&guards, slope), guards.len(), "{guards:?}");
    }
}

#[test]
fn functions_that_are_narrow_in_each_turn_of_a_state_are_guarded_along_its_motion() {
    let tanh = |size: f64| {
        let rate = |graph: &mut Graph, [_, p, x, _]: [NodeId; 4]| {
            let (wave, size) = (graph.call(Function::Cos, x), graph.literal(size));
            let wave = graph.mul(size, wave);
            let wave = graph.mul(p, wave);
            graph.call(Function::Tanh, wave)
        };
        let [guards, times] = found(rate, &[]);
        assert!(times.is_empty(), "{times:?}");
        guards
    };
    for (size, is_narrow) in [(100.0, true), (1.4, true), (1.3, false)] {
        let [cos, sin] = [2.0_f64.cos(), 2.0_f64.sin()];
        let slope = -size * P * sin * (size * P * cos).tanh();
        let guards = tanh(size);
        assert_eq!(guards.len(), usize::from(is_narrow), "{size}");
        assert!(guards.iter().all(|guard| (guard / slope - 1.0).abs() < 1e-12), "{guards:?}");
    }
}

#[test]
fn a_divisor_counts_by_the_factors_of_which_it_is_the_product() {
    // 1/(d e d): the square has a ratio of 121, its factor d = 1.2 + cos(x) one of 11, and
    // e = 1 + least + cos(x) one of 60.
    for (least, narrow) in [(0.034, 1), (0.1, 0)] {
        let rate = |graph: &mut Graph, [_, _, x, _]: [NodeId; 4]| {
            let wave = graph.call(Function::Cos, x);
            let [wide, sharp] = [1.2, 1.0 + least].map(|shift| {
                let shift = graph.literal(shift);
                graph.add(shift, wave)
            });
            let product = graph.mul(wide, sharp);
            let product = graph.mul(product, wide);
            let one = graph.literal(1.0);
            graph.div(one, product)
        };
        let [guards, _] = found(rate, &[]);
        assert_eq!(guards.len(), narrow, "{least}");
    }
}

#[test]
fn what_is_there_only_near_a_place_is_guarded_where_it_begins() {
    // The difference of x, which is 2, and p, which is 3.
    type Of = fn(&mut Graph, NodeId, NodeId) -> NodeId;
    let guards = |of: Of| {
        let [guards, times] = found(
            |graph, [_, p, x, _]| {
                let distance = graph.sub(x, p);
                let steep = graph.literal(30.0);
                of(graph, distance, steep)
            },
            &[],
        );
        assert!(times.is_empty(), "{times:?}");
        guards
    };
    let bell = guards(|graph, distance, steep| {
        let argument = graph.mul(steep, distance);
        let square = graph.mul(argument, argument);
        let exponent = graph.neg(square);
        graph.call(Function::Exp, exponent)
    });
    assert_eq!(bell, [(1.0 + 625.0_f64).sqrt().sqrt() - (1.0 + 900.0 * 900.0_f64).sqrt().sqrt()]);
    let pole = guards(|graph, distance, steep| {
        let argument = graph.mul(steep, distance);
        let (one, square) = (graph.literal(1.0), graph.mul(argument, argument));
        let below = graph.add(one, square);
        let cube = graph.powi(below, 3);
        graph.div(one, cube)
    });
    assert_eq!(pole, [100.0_f64.powf(0.5 / 3.0) - 901.0_f64.sqrt()]);
    let sech = guards(|graph, distance, steep| {
        let argument = graph.mul(steep, distance);
        let (one, below) = (graph.literal(1.0), graph.call(Function::Cosh, argument));
        graph.div(one, below)
    });
    assert_eq!(sech, [12.0 - 901.0_f64.sqrt()]);
    // The square of a step is a bell, and two steps are the ends of a window.
    assert!(guards(|graph, distance, _| graph.call(Function::Tanh, distance)).is_empty());
    let square = guards(|graph, distance, _| {
        let step = graph.call(Function::Tanh, distance);
        graph.mul(step, step)
    });
    assert_eq!(square, [12.0 - 2.0_f64.sqrt()]);
    let window = guards(|graph, distance, steep| {
        let other = graph.add(distance, steep);
        let steps = [distance, other].map(|distance| graph.call(Function::Tanh, distance));
        graph.sub(steps[0], steps[1])
    });
    assert_eq!(window.len(), 2);
    // The machine starts in it, it has an effect everywhere, or it grows without bound.
    let none: [Of; 3] = [
        |graph, distance, _| {
            let square = graph.mul(distance, distance);
            let (one, below) = (graph.literal(1.0), graph.literal(1.0));
            let below = graph.add(below, square);
            graph.div(one, below)
        },
        |graph, distance, steep| {
            let argument = graph.mul(steep, distance);
            let square = graph.mul(argument, argument);
            let (one, below) = (graph.literal(1.0), graph.literal(1.0));
            let below = graph.add(below, square);
            let below = graph.call(Function::Sqrt, below);
            graph.div(one, below)
        },
        |graph, distance, steep| {
            let argument = graph.mul(steep, distance);
            graph.call(Function::Exp, argument)
        },
    ];
    for (index, of) in none.into_iter().enumerate() {
        assert!(guards(of).is_empty(), "{index}");
    }
}

#[test]
fn narrow_features_of_time_are_found_and_wide_ones_left_to_steps() {
    for (factor, is_found) in [(1e6, true), (1.1, true), (0.9, false), (1e-2, false)] {
        let expected = if is_found { vec![P] } else { vec![] };
        let bell = times(|graph, time, p| {
            let square = square(graph, time, p, -factor);
            graph.call(Function::Exp, square)
        });
        assert_eq!(bell, expected, "{factor}");
        let pole = times(|graph, time, p| {
            let [square, one] = [square(graph, time, p, factor), graph.literal(1.0)];
            let below = graph.add(one, square);
            graph.div(one, below)
        });
        assert_eq!(pole, expected, "{factor}");
        let step = times(|graph, time, p| {
            let [distance, factor] = [graph.sub(time, p), graph.literal(factor.sqrt())];
            let argument = graph.mul(factor, distance);
            graph.call(Function::Tanh, argument)
        });
        assert_eq!(step, expected, "{factor}");
    }
    // A square turns where its base passes zero; a product of two lines has no such place.
    let lines = |graph: &mut Graph, time: NodeId, p: NodeId| {
        [p, graph.literal(7.0)].map(|zero| {
            let [distance, factor] = [graph.sub(time, zero), graph.literal(1e3)];
            graph.mul(factor, distance)
        })
    };
    let of_one = times(|graph, time, p| {
        let [line, _] = lines(graph, time, p);
        graph.mul(line, line)
    });
    let of_two = times(|graph, time, p| {
        let [a, b] = lines(graph, time, p);
        graph.mul(a, b)
    });
    assert_eq!((of_one, of_two), (vec![P], vec![]));
    // A parameter may determine how narrow it is; the start stands for a wide one.
    for (power, expected) in [(-1, 0.0), (7, 2.0)] {
        let found = times(|graph, time, p| {
            let two = graph.literal(2.0);
            let [distance, steepness] = [graph.sub(time, two), graph.powi(p, power)];
            let argument = graph.mul(steepness, distance);
            graph.call(Function::Tanh, argument)
        });
        assert_eq!(found, [expected], "{power}");
    }
    let none = times(|graph, time, p| {
        let [cube, wave] = [graph.powi(time, 3), graph.mul(p, time)];
        let thousand = graph.literal(1e9);
        let cube = graph.mul(thousand, cube);
        let [a, b] = [graph.call(Function::Exp, cube), graph.call(Function::Sin, wave)];
        graph.mul(a, b)
    });
    assert!(none.is_empty(), "{none:?}");
}

#[test]
fn tables_bend_at_corners_and_where_they_are_curved() {
    let flat = [[1.0, 0.0, 0.0, 0.0]; 3];
    let knots = [0.0, 2.0, 3.0, 7.0];
    assert!(corners(&table(&knots, &flat)).is_empty());
    assert!(bends(&table(&knots, &flat)).is_empty());
    // A spline through points of a line is curved by its rounding.
    let rounded = [[1.0, 1.0, 1e-14, 0.0], [3.0, 1.0, -1e-14, 1e-15], [4.0, 1.0, 0.0, 0.0]];
    assert!(bends(&table(&knots, &rounded)).is_empty());
    // u^2 + u^3 has the slope 16 at 2.
    let smooth = [[0.0, 0.0, 1.0, 1.0], [12.0, 16.0, 0.0, 0.0], [28.0, 16.0, 0.0, 0.0]];
    assert!(corners(&table(&knots, &smooth)).is_empty());
    assert_eq!(bends(&table(&knots, &smooth)), [(2.0, 1.0)]);
    let bent = [[0.0, 0.0, 1.0, 1.0], [12.0, 15.0, 0.0, 0.0], [27.0, 15.0, -1.0, 0.0]];
    assert_eq!(corners(&table(&knots, &bent)), [2.0]);
    assert_eq!(bends(&table(&knots, &bent)), [(2.0, 1.0), (3.0, 1.0)]);
    let many: Vec<f64> = (0..200).map(f64::from).collect();
    let pieces: Vec<[f64; 4]> =
        (0..199).map(|k| [0.0, f64::from(k % 2), 1.0 + f64::from(k), 0.0]).collect();
    assert!(corners(&table(&many, &pieces)).is_empty());
    let most = bends(&table(&many, &pieces));
    // The most curved ones.
    assert_eq!((most.len(), most[0].0, most[63].0), (64, 135.0, 198.0));
}

#[test]
fn a_table_over_time_is_found_at_its_knots_and_one_over_a_state_at_its_ends() {
    let knots = [0.0, 0.25, 0.5, 4.0];
    let curved = [[0.0, 0.0, 1.0, 0.0], [0.0, 0.5, 1.0, 0.0], [0.0, 1.0, 0.0, 0.0]];
    let tables = [table(&knots, &curved)];
    let look = |over: fn(&mut Graph, [NodeId; 4]) -> NodeId| {
        let build = |graph: &mut Graph, leaves| {
            let argument = over(graph, leaves);
            graph.table(machinist_model::TableId(0), 0, argument)
        };
        found(build, &tables)
    };
    let mut of_time = look(|graph, [time, p, ..]| graph.sub(time, p));
    of_time[1].sort_by(f64::total_cmp);
    // Ends, a corner where the slope jumps, and curved segments between knots.
    assert_eq!(of_time, [vec![], vec![P, P + 0.25, P + 0.5, P + 4.0]]);
    assert_eq!(look(|_, [_, _, x, _]| x), [vec![2.0, -2.0], vec![]]);
}

/// Comparisons change together if the difference of one is a multiple of the other's, in whatever
/// form they are written.
#[test]
fn multiples_of_a_guard_are_one_guard() {
    let [guards, _] = found(
        |graph, [time, p, x, _]| {
            let [one, minus_one, zero, three] = [1.0, -1.0, 0.0, -3.0].map(|it| graph.literal(it));
            let distance = graph.sub(x, p);
            let size = graph.call(Function::Abs, distance);
            let [far, near] = [p, x].map(|of| graph.mul(three, of));
            let scaled = graph.select_less(far, near, one, minus_one);
            let (sum, other) = (graph.add(x, time), graph.add(p, time));
            let shifted = graph.sub(sum, other);
            let shifted = graph.select_less(shifted, zero, one, minus_one);
            let other = graph.select_less(x, time, one, minus_one);
            let sum = graph.add(size, scaled);
            let sum = graph.add(sum, shifted);
            graph.add(sum, other)
        },
        &[],
    );
    assert_eq!(guards.len(), 2, "{guards:?}");
}
