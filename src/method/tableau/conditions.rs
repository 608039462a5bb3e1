//! Order conditions, one for each rooted tree, to check all coefficients.

use super::{DOP853, Pair, RODAS5P, Rosenbrock, Row, TSIT5};

/// A rooted tree, with the indices of its root's subtrees, which precede it in the list.
#[derive(Clone, PartialEq, Debug)]
struct Tree {
    children: Vec<usize>,
    order: usize,
    /// Density gamma, the product of the orders of all subtrees.
    density: f64,
}

/// Returns all rooted trees of up to `most` vertices.
fn trees(most: usize) -> Vec<Tree> {
    let mut trees = vec![Tree { children: Vec::new(), order: 1, density: 1.0 }];
    for order in 2..=most {
        let mut found = Vec::new();
        add_forests(&trees, order - 1, trees.len(), &mut Vec::new(), &mut found);
        for children in found {
            let density = children.iter().map(|child: &usize| trees[*child].density);
            let density = order as f64 * density.product::<f64>();
            trees.push(Tree { children, order, density });
        }
    }
    trees
}

/// Adds all choices of trees with `left` vertices together, in nonincreasing order.
fn add_forests(
    trees: &[Tree],
    left: usize,
    last: usize,
    chosen: &mut Vec<usize>,
    found: &mut Vec<Vec<usize>>,
) {
    if left == 0 {
        found.push(chosen.clone());
        return;
    }
    for (index, tree) in trees.iter().enumerate().take(last) {
        if tree.order <= left {
            chosen.push(index);
            add_forests(trees, left - tree.order, index + 1, chosen, found);
            chosen.pop();
        }
    }
}

type Matrix = Vec<Vec<f64>>;

/// Returns the elementary weights of every tree at every stage. A vertex with one child uses the
/// matrix `one`, with more children the matrix `more`.
fn weights(trees: &[Tree], one: &Matrix, more: &Matrix) -> Matrix {
    let stages = one.len();
    let mut weights: Matrix = Vec::new();
    for tree in trees {
        let matrix = if tree.children.len() == 1 { one } else { more };
        let at = |stage: usize| -> f64 {
            let of = |child: &usize| -> f64 { dot(&matrix[stage], &weights[*child]) };
            tree.children.iter().map(of).product()
        };
        let of_tree = (0..stages).map(at).collect();
        weights.push(of_tree);
    }
    weights
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn full(row: Row, stages: usize) -> Vec<f64> {
    let mut full = vec![0.0; stages];
    for &(stage, weight) in row {
        full[stage] = weight;
    }
    full
}

/// Returns the largest violation of the conditions up to an order by weights b for a step of
/// `theta`, and the largest violation of those of the next order.
fn violations(b: &[f64], trees: &[Tree], weights: &Matrix, order: usize, theta: f64) -> [f64; 2] {
    let mut violations = [0.0f64; 2];
    for (tree, weights) in trees.iter().zip(weights).filter(|(tree, _)| tree.order <= order + 1) {
        let exact = theta.powi(tree.order as i32) / tree.density;
        let beyond = usize::from(tree.order > order);
        violations[beyond] = violations[beyond].max((dot(b, weights) - exact).abs());
    }
    violations
}

#[test]
fn there_are_as_many_trees_as_cayley_counted() {
    let trees = trees(8);
    let counts: Vec<_> =
        (1..=8).map(|order| trees.iter().filter(|tree| tree.order == order).count()).collect();
    assert_eq!(counts, [1, 1, 2, 4, 9, 20, 48, 115]);
}

#[test]
fn explicit_pairs_have_their_orders_and_no_more() {
    // Orders of the solution, of the embedded solutions and of the dense output.
    let cases: [(&str, &Pair, usize, &[usize], usize); 2] =
        [("tsit5", &TSIT5, 5, &[4], 4), ("dop853", &DOP853, 8, &[5, 3], 7)];
    for (name, pair, order, embedded, dense) in cases {
        let stages = pair.nodes.len();
        let a: Matrix =
            pair.rows.iter().chain(pair.dense.extra).map(|row| full(row, stages)).collect();
        for (row, node) in a.iter().zip(pair.nodes) {
            let sum: f64 = row.iter().sum();
            assert!((sum - node).abs() < 2e-15 * row.iter().map(|a| a.abs()).sum::<f64>().max(1.0));
        }
        let trees = trees(order + 1);
        let weights = weights(&trees, &a, &a);
        let require = |what: &str, b: &[f64], order: usize, theta: f64| {
            let [within, beyond] = violations(b, &trees, &weights, order, theta);
            println!("{name}, {what}: {within:e}, then {beyond:e}");
            assert!(within < 2e-14, "{name}, {what}, has an error of {within:e}");
            assert!(beyond > 1e-9, "{name}, {what}, is of a higher order");
        };
        let b = &a[pair.rows.len() - 1];
        require("solution", b, order, 1.0);
        for (row, order) in pair.estimates.iter().zip(embedded) {
            let estimate = full(row, stages);
            let lower: Vec<f64> = b.iter().zip(&estimate).map(|(b, e)| b - e).collect();
            require("embedded", &lower, *order, 1.0);
        }
        let mut b = vec![0.0; stages];
        for theta in [0.1, 0.37, 0.5, 0.9] {
            (pair.dense.weights)(theta, &mut b);
            require("dense output", &b, dense, theta);
        }
        (pair.dense.weights)(1.0, &mut b);
        let end =
            b.iter().zip(&a[pair.rows.len() - 1]).fold(0.0f64, |m, (a, b)| m.max((a - b).abs()));
        assert!(end < 1e-13, "{name}: dense output ends {end:e} off");
    }
}

/// alpha, beta and gamma of the untransformed method.
struct Original {
    alpha: Matrix,
    beta: Matrix,
    gamma: Matrix,
}

// Loops over matrices use indices.
#[allow(clippy::needless_range_loop)]
fn original(method: &Rosenbrock) -> Original {
    let stages = method.stages.len();
    // gamma^-1 = I / gamma - C, lower triangular.
    let inverse: Matrix = (0..stages)
        .map(|row| {
            let of_row = full(method.stages[row], stages);
            let diagonal = |column| if column == row { 1.0 / method.gamma } else { 0.0 };
            of_row.iter().enumerate().map(|(column, c)| diagonal(column) - c).collect()
        })
        .collect();
    let mut gamma = vec![vec![0.0; stages]; stages];
    for column in 0..stages {
        for row in column..stages {
            let sum: f64 = (column..row).map(|k| inverse[row][k] * gamma[k][column]).sum();
            let unit = f64::from(u8::from(row == column));
            gamma[row][column] = (unit - sum) / inverse[row][row];
        }
    }
    let alpha: Matrix = states(method)[..stages].iter().map(|row| times(row, &gamma)).collect();
    let sum = |a: &Vec<f64>, b: &Vec<f64>| a.iter().zip(b).map(|(a, b)| a + b).collect();
    let beta = alpha.iter().zip(&gamma).map(|(a, b)| sum(a, b)).collect();
    Original { alpha, beta, gamma }
}

/// Returns the rows of a, with continued rows completed.
fn states(method: &Rosenbrock) -> Matrix {
    let stages = method.stages.len();
    let mut rows: Matrix = Vec::new();
    for (index, row) in method.states.iter().enumerate() {
        let mut next = full(row, stages);
        if index > 1 && row[0].0 == index - 1 {
            for (next, before) in next.iter_mut().zip(&rows[index - 1]) {
                *next += before;
            }
        }
        rows.push(next);
    }
    rows
}

fn times(row: &[f64], matrix: &Matrix) -> Vec<f64> {
    (0..row.len()).map(|column| row.iter().zip(matrix).map(|(a, m)| a * m[column]).sum()).collect()
}

#[test]
fn rodas5p_has_its_orders_with_the_exact_jacobian() {
    let method = &RODAS5P;
    let original = original(method);
    for (stage, (alpha, gamma)) in original.alpha.iter().zip(&original.gamma).enumerate() {
        let (alpha, gamma): (f64, f64) = (alpha.iter().sum(), gamma.iter().sum());
        assert!((alpha - method.nodes[stage]).abs() < 1e-13, "c of {stage}: {alpha}");
        assert!((gamma - method.time_weights[stage]).abs() < 1e-13, "d of {stage}: {gamma}");
    }
    let trees = trees(6);
    let weights = weights(&trees, &original.beta, &original.alpha);
    let require = |what: &str, of_u: &[f64], order: usize, theta: f64| {
        let b = times(of_u, &original.gamma);
        let [within, beyond] = violations(&b, &trees, &weights, order, theta);
        println!("{what}: {within:e}, then {beyond:e}");
        assert!(within < 1e-13, "{what} has an error of {within:e}");
        assert!(beyond > 1e-6, "{what} is of a higher order");
    };
    let states = states(method);
    let (end, embedded) = (&states[8], &states[7]);
    require("solution", end, 5, 1.0);
    require("embedded", embedded, 4, 1.0);
    for theta in [0.1f64, 0.37, 0.5, 0.9] {
        let rest = 1.0 - theta;
        let [first, second, third] = method.dense;
        let of_u: Vec<f64> = (0..8)
            .map(|u| end[u] + rest * (first[u] + theta * (second[u] + theta * third[u])))
            .map(|inner| theta * inner)
            .collect();
        require("dense output", &of_u, 4, theta);
    }
}

#[test]
fn rodas5p_is_stiffly_accurate() {
    let original = original(&RODAS5P);
    let states = states(&RODAS5P);
    let b = times(&states[8], &original.gamma);
    // b is the last row of beta, and the last argument is at the end of the step.
    let last = &original.beta[7];
    let distance = b.iter().zip(last).fold(0.0f64, |max, (b, beta)| max.max((b - beta).abs()));
    assert!(distance < 1e-13, "{distance:e}");
    assert!((original.alpha[7].iter().sum::<f64>() - 1.0).abs() < 1e-13);
}
