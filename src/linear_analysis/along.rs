//! Linear models along a run: A(t), B(t), C(t) and D(t).

use serde::Serialize;

use super::{LinearError, Linearization, Point, StateSpace};
use crate::simulate::Simulation;
use crate::trajectory::ColumnKind;

/// Models of a part of a run in which x has the same entries.
///
/// The order changes where constraints begin or end to hold, as a brake closes. Modes may change
/// within the order; they begin a new piece too.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Piece {
    /// Modes and their values in the piece.
    pub modes: Vec<(String, f64)>,
    /// Models about the motion at each time, in order. Their `drift` is x' there.
    pub models: Vec<StateSpace>,
}

/// Returns the models about the motion of a run at some times \[s\], in pieces.
///
/// Small deviations from the motion follow dx' = A(t) dx + B(t) du within a piece. Across an event,
/// its time deviates as well, which these matrices do not contain.
///
/// # Errors
/// [`LinearError`] if the run is refused or stops, or as [`Linearization::state_space`].
pub fn models_along(
    run: &Simulation<'_>,
    times: &[f64],
    inputs: &[impl AsRef<str>],
    outputs: &[impl AsRef<str>],
) -> Result<Vec<Piece>, LinearError> {
    let simulator = run.simulator();
    let (_, parameters) = run.checked_start()?;
    let trajectory = run.clone().times(times).run()?;
    let columns: Vec<&[f64]> =
        trajectory.of_kind(ColumnKind::State).map(|column| &column.values[..]).collect();
    let mut pieces: Vec<Piece> = Vec::new();
    for (row, &time) in trajectory.times.iter().enumerate() {
        let state: Vec<f64> = columns.iter().map(|values| values[row]).collect();
        let modes: Vec<(String, f64)> = state
            .iter()
            .enumerate()
            .filter(|(entry, _)| simulator.is_mode(*entry))
            .map(|(entry, value)| (simulator.state(entry).name.to_owned(), *value))
            .collect();
        let point = Point { time, state, parameters: parameters.clone() };
        let model = Linearization::at(simulator, point)?.state_space(inputs, outputs)?;
        let names = |model: &StateSpace| {
            model.states.iter().map(|signal| signal.name.clone()).collect::<Vec<_>>()
        };
        match pieces.last_mut() {
            Some(piece) if piece.modes == modes && names(&piece.models[0]) == names(&model) => {
                piece.models.push(model);
            }
            _ => pieces.push(Piece { modes, models: vec![model] }),
        }
    }
    Ok(pieces)
}
