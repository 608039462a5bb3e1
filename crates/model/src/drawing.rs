//! Drawing of a machine in space.
//!
//! The generator writes the places of everything that is drawn as functions of time, state and
//! parameters, so nothing that draws repeats the kinematics of a machine.

use serde::{Deserialize, Serialize};

use crate::evaluate::{Evaluator, Inputs};
use crate::{Model, Name, Quantity, Tape};

/// Elements of a drawing, with the tape that places them.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Drawing {
    /// Elements, in the order of their numbers among the results.
    pub elements: Vec<Element>,
    /// Numbers of all elements, one after the other, along the axes of the world \[m\].
    pub places: Tape,
}

/// An element of a drawing.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Element {
    /// Kind.
    pub kind: ElementKind,
    /// Path of the frame, body or shape, `robot.elbow`.
    pub name: String,
    /// True for a solid that has no shape of its own but stands for an inertia.
    pub is_of_inertia: bool,
}

/// Kind of an element, which gives the meaning of its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ElementKind {
    /// Direction upwards, of any length, or zero without gravity.
    Up,
    /// Rotational joint: a point and a unit vector of the axis.
    Hinge,
    /// Sliding joint: its points at rest and now, and a unit vector of the axis.
    Slide,
    /// Joint that turns freely: a point.
    Ball,
    /// Line fixed to a body: its ends.
    Link,
    /// Rod: its ends.
    Rod,
    /// Spring: its ends.
    Spring,
    /// Centre of mass of a body without dimensions: a point.
    Mass,
    /// Cylinder: centres of its ends, a unit vector across the axis that turns with it, radius.
    Cylinder,
    /// Sphere: centre, two unit vectors that turn with it, radius.
    Sphere,
    /// Box: centre, and from it to the middle of three sides.
    Box,
}

impl ElementKind {
    /// Returns the number of results of an element.
    #[must_use]
    pub fn numbers(self) -> usize {
        match self {
            Self::Up | Self::Ball | Self::Mass => 3,
            Self::Hinge | Self::Link | Self::Rod | Self::Spring => 6,
            Self::Slide => 9,
            Self::Cylinder | Self::Sphere => 10,
            Self::Box => 12,
        }
    }
}

impl Drawing {
    /// Returns the number of results that the elements have.
    #[must_use]
    pub fn numbers(&self) -> usize {
        self.elements.iter().map(|element| element.kind.numbers()).sum()
    }

    /// Returns the numbers of all elements at a state.
    #[must_use]
    pub fn placed(&self, time: f64, state: &[f64], parameters: &[f64], model: &Model) -> Vec<f64> {
        let mut places = vec![0.0; self.places.results.len()];
        let tables = &model.tables;
        let inputs = Inputs { time, state, parameters, tables, ..Inputs::default() };
        Evaluator::new(&self.places).evaluate(&inputs, &mut places);
        places
    }
}

impl Model {
    /// Returns a model of the same states and parameters whose outputs are the numbers of the
    /// drawing; `None` if there is no drawing.
    #[must_use]
    pub fn of_drawing(&self) -> Option<Model> {
        let drawing = self.drawing.as_ref()?;
        let number = |index: usize| Quantity {
            name: Name {
                path: format!("place {index}"),
                ident: format!("place_{index}"),
                latex: String::new(),
            },
            unit: "1".to_owned(),
            doc: String::new(),
        };
        Some(Model {
            name: self.name.clone(),
            states: self.states.clone(),
            parameters: self.parameters.clone(),
            tables: self.tables.clone(),
            wanted: (0..drawing.numbers()).map(number).collect(),
            outputs: drawing.places.clone(),
            ..Model::default()
        })
    }
}
