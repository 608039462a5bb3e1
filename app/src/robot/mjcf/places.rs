//! Positions and orientations of elements.

use nalgebra::{Isometry3, Matrix3, Quaternion, Unit, UnitQuaternion, Vector3};
use roxmltree::Node;

use super::{Model, elements};
use crate::robot::shapes::turn_of_z;
use crate::robot::xml::Read;

/// Attributes of positions and directions.
pub(super) const GEOMETRY: [&str; 8] =
    ["pos", "axis", "anchor", "quat", "axisangle", "euler", "xyaxes", "zaxis"];

/// Maximum number of copies of the elements of a body.
const MOST_COPIES: usize = 100_000;

/// An element within a body or within frames in it.
#[derive(Clone)]
pub(super) struct Part<'a, 'input> {
    pub(super) node: Node<'a, 'input>,
    /// Pose of the frames in the body.
    pub(super) frame: Isometry3<f64>,
    pub(super) class: Option<&'a str>,
    /// End of the names of a copy.
    pub(super) ending: String,
}

impl<'a, 'input> Part<'a, 'input> {
    /// Returns the body itself, as a place for its elements.
    pub(super) fn of(node: Node<'a, 'input>, class: Option<&'a str>, ending: String) -> Self {
        Part { node, frame: Isometry3::identity(), class, ending }
    }
}

impl<'a, 'input> Model<'a, 'input> {
    /// Returns the elements of a kind within a body, and within frames and replicas in it.
    pub(super) fn parts(&self, body: &Part<'a, 'input>, tag: &str) -> Read<Vec<Part<'a, 'input>>> {
        let mut found = Vec::new();
        self.collect(
            &Part::of(body.node, body.class, body.ending.clone()),
            tag,
            &mut found,
            &mut 0,
        )?;
        Ok(found)
    }

    fn collect(
        &self,
        within: &Part<'a, 'input>,
        tag: &str,
        found: &mut Vec<Part<'a, 'input>>,
        copies: &mut usize,
    ) -> Read<()> {
        for node in elements(within.node) {
            let class = node.attribute("childclass").or(within.class);
            let part = Part { node, class, ..within.clone() };
            match node.tag_name().name() {
                "frame" => {
                    let frame = within.frame * self.place(node, None)?;
                    self.collect(&Part { frame, ..part }, tag, found, copies)?;
                }
                "replicate" => {
                    for (place, number) in self.replicas(node)? {
                        *copies += 1;
                        if *copies > MOST_COPIES {
                            let message = format!("there are more than {MOST_COPIES} copies");
                            return Err(self.reader.error(node, message, ""));
                        }
                        let frame = within.frame * place;
                        let ending = number + within.ending.as_str();
                        self.collect(&Part { frame, ending, ..part.clone() }, tag, found, copies)?;
                    }
                }
                own if own == tag => found.push(part),
                _ => {}
            }
        }
        Ok(())
    }

    /// Returns the places of copies, and the ends of their names.
    fn replicas(&self, node: Node<'a, 'input>) -> Read<Vec<(Isometry3<f64>, String)>> {
        let text = self.reader.attribute(node, "count")?;
        let count = text.trim().parse().ok().filter(|count: &usize| *count <= MOST_COPIES);
        let Some(count) = count else {
            let message = format!("`count` is `{}`", text.escape_debug());
            let help = format!("it is a number of copies, at most {MOST_COPIES}");
            return Err(self.reader.error(node, message, help));
        };
        let offset = Vector3::from(self.reader.vector(Some(node), "offset", [0.0; 3])?);
        let angles = self.reader.vector(Some(node), "euler", [0.0; 3])?;
        let (separator, digits) =
            (node.attribute("sep").unwrap_or_default(), count.to_string().len());
        let mut at = Vector3::zeros();
        let mut all = Vec::new();
        for number in 0..count {
            let angles = angles.map(|angle| angle * number as f64);
            let turn = self.euler(&angles);
            let turn =
                turn.ok_or_else(|| self.reader.error(node, "`eulerseq` is no orientation", ""))?;
            all.push((
                Isometry3::from_parts(at.into(), turn),
                format!("{separator}{number:0digits$}"),
            ));
            at += turn * offset;
        }
        Ok(all)
    }

    /// Reads position and orientation of an element.
    pub(super) fn place(
        &self,
        node: Node<'a, 'input>,
        class: Option<&str>,
    ) -> Read<Isometry3<f64>> {
        let position = Vector3::from(self.vector(node, class, "pos", [0.0; 3])?);
        Ok(Isometry3::from_parts(position.into(), self.orientation(node, class)?))
    }

    /// Reads position and orientation of an element, which `fromto` may give with half its length.
    pub(super) fn stretched(
        &self,
        node: Node<'a, 'input>,
        class: Option<&str>,
    ) -> Read<(Isometry3<f64>, Option<f64>)> {
        let ends = self.values(node, class, "fromto")?;
        let [x0, y0, z0, x1, y1, z1] = ends[..] else {
            return Ok((self.place(node, class)?, None));
        };
        let (from, to) = (Vector3::new(x0, y0, z0), Vector3::new(x1, y1, z1));
        let way = from - to;
        let at = Isometry3::from_parts(((from + to) / 2.0).into(), turn_of_z(&way));
        Ok((at, Some(way.norm() / 2.0)))
    }

    fn orientation(
        &self,
        node: Node<'a, 'input>,
        class: Option<&str>,
    ) -> Read<UnitQuaternion<f64>> {
        let wrong = |key: &str| self.reader.error(node, format!("`{key}` is no orientation"), "");
        let unit = |values: &[f64], key: &str| {
            Unit::try_new(Vector3::new(values[0], values[1], values[2]), 0.0)
                .ok_or_else(|| wrong(key))
        };
        for key in ["quat", "axisangle", "euler", "xyaxes", "zaxis"] {
            let values = self.values(node, class, key)?;
            return Ok(match (key, values.len()) {
                (_, 0) => continue,
                ("quat", 4) if values.iter().any(|part| *part != 0.0) => {
                    let [w, x, y, z] = [values[0], values[1], values[2], values[3]];
                    UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z))
                }
                ("axisangle", 4) => UnitQuaternion::from_axis_angle(
                    &unit(&values, key)?,
                    values[3] * self.compiler.angle,
                ),
                ("euler", 3) => self.euler(&values).ok_or_else(|| wrong("eulerseq"))?,
                ("xyaxes", 6) => {
                    let x = unit(&values, key)?;
                    let y = Vector3::new(values[3], values[4], values[5]);
                    let y = Unit::try_new(y - *x * x.dot(&y), 1e-12).ok_or_else(|| wrong(key))?;
                    let axes = Matrix3::from_columns(&[*x, *y, x.cross(&y)]);
                    UnitQuaternion::from_matrix(&axes)
                }
                ("zaxis", 3) => turn_of_z(&*unit(&values, key)?),
                _ => return Err(wrong(key)),
            });
        }
        Ok(UnitQuaternion::identity())
    }

    /// Returns rotations about axes that turn, or that do not if their letters are capitals.
    fn euler(&self, angles: &[f64]) -> Option<UnitQuaternion<f64>> {
        let mut whole = UnitQuaternion::identity();
        if self.compiler.sequence.len() != 3 {
            return None;
        }
        for (letter, angle) in self.compiler.sequence.chars().zip(angles) {
            let axis = match letter.to_ascii_lowercase() {
                'x' => Vector3::x_axis(),
                'y' => Vector3::y_axis(),
                'z' => Vector3::z_axis(),
                _ => return None,
            };
            let turn = UnitQuaternion::from_axis_angle(&axis, angle * self.compiler.angle);
            whole = if letter.is_ascii_lowercase() { whole * turn } else { turn * whole };
        }
        Some(whole)
    }

    /// Returns the sum of the roundings of the numbers of an attribute.
    pub(super) fn rounding(&self, node: Node<'a, 'input>, class: Option<&str>, key: &str) -> f64 {
        let text = self.text(node, class, key).unwrap_or_default();
        self.digits.rounding(text.split_whitespace())
    }

    /// Returns the rounding of the orientation of a body \[rad\].
    pub(super) fn rounding_of_place(&self, node: Node<'a, 'input>) -> Read<f64> {
        let mut whole = 0.0;
        for key in ["quat", "axisangle", "euler", "xyaxes", "zaxis"] {
            let rounding = self.rounding(node, None, key);
            let values = self.values(node, None, key)?;
            let norm = |values: &[f64]| values.iter().map(|part| part * part).sum::<f64>().sqrt();
            whole += match (key, &values[..]) {
                (_, []) => 0.0,
                // A rotation turns by twice the angle of its quaternion.
                ("quat", values) => 2.0 * rounding / norm(values),
                ("euler", _) => rounding * self.compiler.angle,
                ("axisangle", [axis @ .., angle]) => {
                    rounding * self.compiler.angle * (1.0 + angle.abs() / norm(axis))
                }
                ("xyaxes", values) => {
                    let [x, y] =
                        [0, 3].map(|first| norm(values.get(first..first + 3).unwrap_or(&[])));
                    rounding / x.min(y)
                }
                (_, values) => rounding / norm(values),
            };
        }
        Ok(whole)
    }
}
