//! Vectors and matrices of space whose entries are shared parts of expressions.

use machinist_algebra::cas::arithmetic::{call, negative, normal_form, product, sum};
use machinist_algebra::expr::{Expr, Function, Symbol};
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One as _, ToPrimitive as _};

/// Three components along the axes of a frame.
pub type Vector = [Expr; 3];

/// Rows of a matrix.
pub type Matrix3 = [[Expr; 3]; 3];

/// Returns the zero vector.
#[must_use]
pub fn zero() -> Vector {
    [0, 0, 0].map(Expr::integer)
}

/// Returns the unit matrix.
#[must_use]
pub fn identity() -> Matrix3 {
    [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|row| row.map(Expr::integer))
}

/// Returns a + b.
#[must_use]
pub fn plus(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| sum([a[i].clone(), b[i].clone()]).shared())
}

/// Returns the sum of vectors.
#[must_use]
pub fn total(vectors: &[&Vector]) -> Vector {
    std::array::from_fn(|i| sum(vectors.iter().map(|vector| vector[i].clone())).shared())
}

/// Returns -a.
#[must_use]
pub fn minus(a: &Vector) -> Vector {
    a.each_ref().map(negative)
}

/// Returns s a.
#[must_use]
pub fn scaled(s: &Expr, a: &Vector) -> Vector {
    a.each_ref().map(|entry| product([s.clone(), entry.clone()]).shared())
}

/// Returns a . b.
#[must_use]
pub fn dot(a: &Vector, b: &Vector) -> Expr {
    sum(a.iter().zip(b).map(|(a, b)| product([a.clone(), b.clone()]))).shared()
}

/// Returns a x b.
#[must_use]
pub fn cross(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let back = product([a[k].clone(), b[j].clone()]);
        sum([product([a[j].clone(), b[k].clone()]), negative(&back)]).shared()
    })
}

/// Returns \[a\]x, whose product with b is a x b.
#[must_use]
pub fn skew(a: &Vector) -> Matrix3 {
    let [x, y, z] = a.clone();
    let [back_x, back_y, back_z] = minus(a);
    let none = || Expr::integer(0);
    [[none(), back_z, y], [z, none(), back_x], [back_y, x, none()]]
}

/// Returns A a.
#[must_use]
pub fn times(matrix: &Matrix3, a: &Vector) -> Vector {
    matrix.each_ref().map(|row| dot(row, a))
}

/// Returns A^T.
#[must_use]
pub fn transposed(matrix: &Matrix3) -> Matrix3 {
    std::array::from_fn(|i| std::array::from_fn(|j| matrix[j][i].clone()))
}

/// Returns A B.
#[must_use]
pub fn multiplied(a: &Matrix3, b: &Matrix3) -> Matrix3 {
    let columns = transposed(b);
    a.each_ref().map(|row| columns.each_ref().map(|column| dot(row, column)))
}

/// Returns A B A^T for a symmetric B.
#[must_use]
pub fn congruent(a: &Matrix3, b: &Matrix3) -> Matrix3 {
    let half = multiplied(a, b);
    let lower: Matrix3 = std::array::from_fn(|i| {
        std::array::from_fn(|j| if j <= i { dot(&half[i], &a[j]) } else { Expr::integer(0) })
    });
    std::array::from_fn(|i| std::array::from_fn(|j| lower[i.max(j)][i.min(j)].clone()))
}

/// Returns A + B for symmetric matrices.
#[must_use]
pub fn symmetric_sum(terms: &[&Matrix3]) -> Matrix3 {
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let (row, column) = (i.max(j), i.min(j));
            sum(terms.iter().map(|term| term[row][column].clone())).shared()
        })
    })
}

/// Returns the inertia of a point of mass m at r, about the origin: m (r.r 1 - r r^T).
#[must_use]
pub fn of_point(mass: &Expr, r: &Vector) -> Matrix3 {
    shift(&scaled(mass, r), r, 1)
}

/// Returns the change 2 (r.h) 1 - h r^T - r h^T of an inertia about the origin if a body with first
/// moment h about it moves by r, without the part of the point mass.
#[must_use]
pub fn of_moment(h: &Vector, r: &Vector) -> Matrix3 {
    shift(h, r, 2)
}

/// Returns (factor/2) (2 (r.h) 1 - h r^T - r h^T).
fn shift(h: &Vector, r: &Vector, factor: i64) -> Matrix3 {
    let half = Expr::Number(BigRational::new(factor.into(), 2.into()));
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let (i, j) = (i.max(j), i.min(j));
            let entry = |a: usize, b: usize| product([h[a].clone(), r[b].clone()]);
            if i == j {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                let factor = Expr::integer(factor);
                return product([factor, sum([entry(j, j), entry(k, k)])]).shared();
            }
            product([negative(&half), sum([entry(i, j), entry(j, i)])]).shared()
        })
    })
}

/// Returns the sine and the cosine of an angle. Those of quarter turns are exact.
#[must_use]
pub fn sine_and_cosine(angle: &Expr) -> [Expr; 2] {
    if let Some(quarters) = quarter_turns(angle) {
        let sine = [0, 1, 0, -1][quarters];
        let cosine = [1, 0, -1, 0][quarters];
        return [sine, cosine].map(Expr::integer);
    }
    [Function::Sin, Function::Cos].map(|function| call(function, angle).shared())
}

/// Returns the number of quarter turns of an angle, modulo 4, if it is whole.
fn quarter_turns(angle: &Expr) -> Option<usize> {
    let turns = match angle {
        Expr::Symbol(Symbol::Pi) => BigRational::one(),
        Expr::Product(factors) => match &factors[..] {
            [Expr::Number(number), Expr::Symbol(Symbol::Pi)] => number.clone(),
            _ => return None,
        },
        _ => return None,
    };
    let quarters = turns * BigRational::from_integer(2.into());
    let whole = quarters.is_integer().then(|| quarters.to_integer())?;
    let four = BigInt::from(4);
    (((whole % &four) + &four) % &four).to_usize()
}

/// Returns the matrix that turns vectors about a unit axis n by an angle,
/// cos 1 + (1 - cos) n n^T + sin \[n\]x.
#[must_use]
pub fn rotation(axis: &Vector, angle: &Expr) -> Matrix3 {
    let [sine, cosine] = sine_and_cosine(&normal_form(angle));
    let rest = sum([Expr::integer(1), negative(&cosine)]);
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let along = product([rest.clone(), axis[i].clone(), axis[j].clone()]);
            let around = if i == j {
                cosine.clone()
            } else {
                let k = 3 - i - j;
                let around = product([sine.clone(), axis[k].clone()]);
                if j == (i + 1) % 3 { negative(&around) } else { around }
            };
            sum([along, around]).shared()
        })
    })
}

/// Returns the matrix of a quaternion w + x i + y j + z k of any magnitude.
#[must_use]
pub fn of_quaternion([w, x, y, z]: &[Expr; 4]) -> Matrix3 {
    let minus_one = BigRational::from_integer((-1).into());
    let square = |a: &Expr| product([a.clone(), a.clone()]);
    let norm = sum([w, x, y, z].map(square));
    let inverse = normal_form(&Expr::Power(Box::new(norm), Box::new(Expr::Number(minus_one))));
    let twice = product([Expr::integer(2), inverse]).shared();
    let v = [x, y, z];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            if i == j {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                let others = sum([square(v[j]), square(v[k])]);
                let part = product([twice.clone(), others]);
                return sum([Expr::integer(1), negative(&part)]).shared();
            }
            let k = 3 - i - j;
            let around = product([w.clone(), v[k].clone()]);
            let around = if j == (i + 1) % 3 { negative(&around) } else { around };
            let along = product([v[i].clone(), v[j].clone()]);
            product([twice.clone(), sum([along, around])]).shared()
        })
    })
}
