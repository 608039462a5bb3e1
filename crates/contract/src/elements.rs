//! Loops over the elements of a field, independent of the scene.

use crate::Real;
use crate::field::{FieldPoint, FieldScene, MAX_POINTS};

/// Division of a field into elements.
#[derive(Debug, Clone, PartialEq)]
pub struct Division<'a, Places> {
    /// Rule of each element.
    pub rule: Rule<'a>,
    /// x at all nodes \[m\].
    pub places: Places,
}

/// Gauss-Lobatto points of the unit interval and their shape functions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rule<'a> {
    /// Points, both ends included; p + 1.
    pub points: &'a [f64],
    /// Weights; their sum is 1.
    pub weights: &'a [f64],
    /// `slopes[q*(p + 1) + i]` is the derivative of the i-th shape function at the q-th
    /// point.
    pub slopes: &'a [f64],
}

impl Rule<'_> {
    /// Returns the number of points, p + 1.
    #[must_use]
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Returns false: a rule has both ends.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    fn slope(&self, point: usize, node: usize) -> f64 {
        self.slopes[point * self.len() + node]
    }
}

/// A segment of a field between two neighbouring places, divided into equal elements.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Segment {
    /// Indices of its ends among the bounds of the field's segments.
    pub bounds: [u32; 2],
    /// Number of elements.
    pub elements: u32,
    /// Index of the first node.
    pub first_node: u32,
}

/// The elements of one field: consecutive segments that share their ends.
#[derive(Debug, Clone, Copy)]
pub struct Elements<'a, R> {
    /// Index of the field.
    pub field: usize,
    /// Points and shape functions.
    pub rule: Rule<'a>,
    /// The segments.
    pub segments: &'a [Segment],
    /// x of the ends of the segments, from 0 to l.
    pub bounds: &'a [R],
}

/// One element.
#[derive(Debug, Clone, Copy)]
pub struct Element<R> {
    /// Index of the first node.
    pub first_node: usize,
    /// x of the start.
    pub start: R,
    /// Length h.
    pub length: R,
    /// Index of its segment, and index within the segment.
    pub place: [usize; 2],
}

impl<R: Real> Elements<'_, R> {
    /// Iterates over all elements, ordered by x.
    pub fn iter(&self) -> impl Iterator<Item = Element<R>> + '_ {
        let step = self.rule.len() - 1;
        self.segments.iter().enumerate().flat_map(move |(index, segment)| {
            let length = self.length(segment);
            let start = self.bounds[segment.bounds[0] as usize];
            (0..segment.elements).map(move |number| Element {
                first_node: segment.first_node as usize + step * number as usize,
                start: start + length * R::literal(f64::from(number)),
                length,
                place: [index, number as usize],
            })
        })
    }

    /// Returns the elements before and after a bound.
    #[must_use]
    pub fn beside(&self, bound: usize) -> [Option<Element<R>>; 2] {
        let step = self.rule.len() - 1;
        let element = |index: usize, number: u32| {
            let segment = self.segments.get(index)?;
            let length = self.length(segment);
            let start = self.bounds[segment.bounds[0] as usize];
            let first_node = segment.first_node as usize + step * number as usize;
            let start = start + length * R::literal(f64::from(number));
            Some(Element { first_node, start, length, place: [index, number as usize] })
        };
        let last =
            |index: usize| self.segments.get(index).map_or(0, |segment| segment.elements - 1);
        let before = bound.checked_sub(1);
        [before.and_then(|index| element(index, last(index))), element(bound, 0)]
    }

    /// Returns the length of the elements of a segment.
    fn length(&self, segment: &Segment) -> R {
        let [start, end] = segment.bounds.map(|bound| self.bounds[bound as usize]);
        (end - start) / R::literal(f64::from(segment.elements))
    }

    /// Returns the number of nodes.
    #[must_use]
    pub fn nodes(&self) -> usize {
        let elements: u32 = self.segments.iter().map(|segment| segment.elements).sum();
        elements as usize * (self.rule.len() - 1) + 1
    }

    /// Returns x of a point of an element.
    fn x(&self, element: &Element<R>, point: usize) -> R {
        element.start + element.length * R::literal(self.rule.points[point])
    }

    /// Computes x of every node.
    pub fn places(&self, x: &mut [R]) {
        for element in self.iter() {
            for point in 0..self.rule.len() {
                x[element.first_node + point] = self.x(&element, point);
            }
        }
    }

    /// Returns u, u_x, u_t and u_xt at a point of an element, from the values at the nodes.
    #[must_use]
    pub fn point(&self, element: &Element<R>, point: usize, u: &[R], v: &[R]) -> FieldPoint<R> {
        let [mut u_x, mut v_x] = [R::literal(0.0); 2];
        for node in 0..self.rule.len() {
            let slope = R::literal(self.rule.slope(point, node));
            u_x = u_x + slope * u[element.first_node + node];
            v_x = v_x + slope * v[element.first_node + node];
        }
        let here = element.first_node + point;
        [u[here], u_x / element.length, v[here], v_x / element.length]
    }

    /// Returns u_x at the first or last node of an element, from the section force there for a
    /// given acceleration of the node:
    ///
    /// ```text
    /// M_i u_i'' = F_i - [f_1 l_i]      M_i and F_i of this element alone
    /// ```
    ///
    /// The result is as accurate as u, whereas the derivative of the shape functions loses an
    /// order or more. It agrees with the force on the joined part to the last digit. f_1 is taken
    /// as linear in u_x between the two.
    #[must_use]
    pub fn slope_of_section<S: FieldScene<R> + ?Sized>(
        &self,
        scene: &S,
        (time, p): (R, &[R]),
        (u, v): (&[R], &[R]),
        (element, is_last): (&Element<R>, bool),
        acceleration: R,
    ) -> R {
        let here = if is_last { self.rule.len() - 1 } else { 0 };
        let share = element.length * R::literal(self.rule.weights[here]);
        let inertia = share * scene.field_inertia(self.field, self.x(element, here), p);
        let at = self.point(element, here, u, v);
        let x = self.x(element, here);
        let [f_0, own] = scene.field_force(self.field, time, x, &at, p);
        let mut force = share * f_0;
        for point in 0..self.rule.len() {
            let at = self.point(element, point, u, v);
            let x = self.x(element, point);
            let [_, f_1] = scene.field_force(self.field, time, x, &at, p);
            let weight = self.rule.weights[point] * self.rule.slope(point, here);
            force = force + R::literal(weight) * f_1;
        }
        let rest = force - inertia * acceleration;
        let in_section = if is_last { rest } else { -rest };
        let by_slope = scene.field_force_jacobian(self.field, time, x, &at, p)[5];
        let zero = R::literal(0.0);
        let change = (in_section - own) / by_slope;
        at[1] + R::select_less(zero, by_slope.abs(), change, zero)
    }

    /// Computes the length assigned to each node.
    pub fn lengths(&self, lengths: &mut [R]) {
        lengths.fill(R::literal(0.0));
        for element in self.iter() {
            for (point, weight) in self.rule.weights.iter().enumerate() {
                let node = &mut lengths[element.first_node + point];
                *node = *node + element.length * R::literal(*weight);
            }
        }
    }

    /// Computes M, one entry per node.
    pub fn inertia<S: FieldScene<R> + ?Sized>(&self, scene: &S, p: &[R], inertia: &mut [R]) {
        inertia.fill(R::literal(0.0));
        for element in self.iter() {
            for point in 0..self.rule.len() {
                let density = scene.field_inertia(self.field, self.x(&element, point), p);
                let share = element.length * R::literal(self.rule.weights[point]);
                let node = &mut inertia[element.first_node + point];
                *node = *node + share * density;
            }
        }
    }

    /// Computes F, one entry per node.
    pub fn force<S: FieldScene<R> + ?Sized>(
        &self,
        scene: &S,
        (time, p): (R, &[R]),
        (u, v): (&[R], &[R]),
        force: &mut [R],
    ) {
        force.fill(R::literal(0.0));
        for element in self.iter() {
            for point in 0..self.rule.len() {
                let at = self.point(&element, point, u, v);
                let x = self.x(&element, point);
                let forces = scene.field_force(self.field, time, x, &at, p);
                self.spread(&element, point, forces, force);
            }
        }
    }

    /// Adds the nodal forces of the force densities at one point of an element.
    fn spread(&self, element: &Element<R>, point: usize, [f_0, f_1]: [R; 2], force: &mut [R]) {
        let weight = R::literal(self.rule.weights[point]);
        let here = &mut force[element.first_node + point];
        *here = *here + element.length * weight * f_0;
        let weighted = weight * f_1;
        for node in 0..self.rule.len() {
            let there = &mut force[element.first_node + node];
            *there = *there + R::literal(self.rule.slope(point, node)) * weighted;
        }
    }

    /// Computes dF/du and dF/du_t of every element. It calls `add(e, i, j, by_u, by_u_t)` with
    /// the derivatives of the force on the i-th node with respect to the j-th node of the e-th
    /// element.
    pub fn force_jacobian<S: FieldScene<R> + ?Sized>(
        &self,
        scene: &S,
        (time, p): (R, &[R]),
        (u, v): (&[R], &[R]),
        mut add: impl FnMut(usize, usize, usize, R, R),
    ) {
        let len = self.rule.len();
        let zero = R::literal(0.0);
        for (index, element) in self.iter().enumerate() {
            let mut at_points = [[zero; 8]; MAX_POINTS];
            for (point, jacobian) in at_points.iter_mut().enumerate().take(len) {
                let at = self.point(&element, point, u, v);
                let x = self.x(&element, point);
                *jacobian = scene.field_force_jacobian(self.field, time, x, &at, p);
            }
            for i in 0..len {
                for j in 0..len {
                    let [by_u, by_v] = self.entry(&element, &at_points[..len], i, j);
                    add(index, i, j, by_u, by_v);
                }
            }
        }
    }

    /// Returns one entry of the two matrices of an element, from the Jacobians at its points.
    fn entry(&self, element: &Element<R>, at_points: &[[R; 8]], i: usize, j: usize) -> [R; 2] {
        let weight = |point: usize| R::literal(self.rule.weights[point]);
        let slope = |point: usize, node: usize| R::literal(self.rule.slope(point, node));
        let mut entries = [R::literal(0.0); 2];
        for (entry, offset) in entries.iter_mut().zip([0, 2]) {
            let mut sum = weight(i) * at_points[i][offset + 1] * slope(i, j)
                + weight(j) * at_points[j][4 + offset] * slope(j, i);
            if i == j {
                sum = sum + element.length * weight(i) * at_points[i][offset];
            }
            for (point, jacobian) in at_points.iter().enumerate() {
                let bent = slope(point, i) * slope(point, j) / element.length;
                sum = sum + weight(point) * jacobian[4 + offset + 1] * bent;
            }
            *entry = sum;
        }
        entries
    }

    /// Integrates energies and powers over the field: kinetic, potential, rate of the potential,
    /// supplied, dissipated.
    #[must_use]
    pub fn energy_and_power<S: FieldScene<R> + ?Sized>(
        &self,
        scene: &S,
        (time, p): (R, &[R]),
        (u, v): (&[R], &[R]),
    ) -> [R; 5] {
        let mut sums = [R::literal(0.0); 5];
        for element in self.iter() {
            for point in 0..self.rule.len() {
                let at = self.point(&element, point, u, v);
                let x = self.x(&element, point);
                let share = element.length * R::literal(self.rule.weights[point]);
                let [kinetic, potential] = scene.field_energy(self.field, time, x, &at, p);
                let [stored, supplied, dissipated] = scene.field_power(self.field, time, x, &at, p);
                let densities = [kinetic, potential, stored, supplied, dissipated];
                for (sum, density) in sums.iter_mut().zip(densities) {
                    *sum = *sum + share * density;
                }
            }
        }
        sums
    }

    /// Computes the partial derivative of F with respect to time.
    pub fn force_by_time<S: FieldScene<R> + ?Sized>(
        &self,
        scene: &S,
        (time, p): (R, &[R]),
        (u, v): (&[R], &[R]),
        (gradient, force): (&mut [R], &mut [R]),
    ) {
        force.fill(R::literal(0.0));
        for element in self.iter() {
            for point in 0..self.rule.len() {
                let at = self.point(&element, point, u, v);
                let x = self.x(&element, point);
                scene.field_force_gradient(self.field, time, x, &at, p, gradient);
                self.spread(&element, point, [gradient[2], gradient[3]], force);
            }
        }
    }

    /// Computes the derivatives of M and F with respect to the k-th parameter of the field, on
    /// which the nodes' places depend: `slopes` are the derivatives of the bounds. `inertia` and
    /// `force` have an entry per node, `gradient` is as long as that of the force.
    pub fn by_parameter<S: FieldScene<R> + ?Sized>(
        &self,
        scene: &S,
        (time, p): (R, &[R]),
        (u, v): (&[R], &[R]),
        (k, slopes): (usize, &[R]),
        (gradient, inertia, force): (&mut [R], &mut [R], &mut [R]),
    ) {
        inertia.fill(R::literal(0.0));
        force.fill(R::literal(0.0));
        let inertia_gradient = gradient.len() / 2 - 1;
        for element in self.iter() {
            let segment = &self.segments[element.place[0]];
            let [start, end] = segment.bounds.map(|bound| slopes[bound as usize]);
            let stretch = (end - start) / R::literal(f64::from(segment.elements));
            let number = R::literal(element.place[1] as f64);
            for point in 0..self.rule.len() {
                let moved = start + stretch * (number + R::literal(self.rule.points[point]));
                let (x, weight) = (self.x(&element, point), R::literal(self.rule.weights[point]));
                let node = element.first_node + point;

                let density = scene.field_inertia(self.field, x, p);
                let of_density = &mut gradient[..inertia_gradient];
                scene.field_inertia_gradient(self.field, x, p, of_density);
                let change = of_density[1 + k] + of_density[0] * moved;
                inertia[node] =
                    inertia[node] + weight * (element.length * change + stretch * density);

                let at = self.point(&element, point, u, v);
                let [f_0, _] = scene.field_force(self.field, time, x, &at, p);
                let by = scene.field_force_jacobian(self.field, time, x, &at, p);
                scene.field_force_gradient(self.field, time, x, &at, p, gradient);
                let shrink = -(stretch / element.length);
                let change = |f: usize| {
                    gradient[4 + 2 * k + f]
                        + gradient[f] * moved
                        + (by[4 * f + 1] * at[1] + by[4 * f + 3] * at[3]) * shrink
                };
                let changes = [change(0), change(1)];
                self.spread(&element, point, changes, force);
                force[node] = force[node] + weight * stretch * f_0;
            }
        }
    }
}
