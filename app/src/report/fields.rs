//! Scenes with fields: discretized runs, pictures along the field, and the effects of the number of
//! elements and of the stiffness of the reed's contact.

use std::time::Duration;

use machinist::field::{Discretisation, FieldError, FieldSimulator};
use machinist::linear_analysis::{
    LinearError, Linearization, ModeKind, Place, Point, operating_point,
};
use machinist::simulate::parameter_defaults;
use machinist::trajectory::Trajectory;
use machinist::{SimulateError, Simulation};
use machinist_contract::Describe as _;
use machinist_contract::field::FieldScene;
use machinist_scenes::scenes::shaft_step_torque::ShaftStepTorque;
use machinist_studies::closed_form::shaft::SAW_GIN_SHAFT;
use machinist_studies::reed_cells::Fell;
use machinist_studies::reed_study::{Beat, COMPARED, beats};
use machinist_studies::verify::CheckFailure;
use maud::{Markup, html};

use super::figure::{self, Named, Scales};
use super::modes::{self, Modes, NoModes};
use crate::failure::Failure;
use crate::number::number;

/// Discretization for modes, coarse enough for a table.
const FEW: Discretisation = Discretisation { elements: Some(8), order: Some(4) };
/// Number of times and modes shown in pictures.
const TIMES: usize = 240;
const SHAPES: usize = 5;

/// Field of a scene over time.
pub struct Along {
    name: String,
    unit: String,
    times: Vec<f64>,
    places: Vec<f64>,
    /// Row for each place: the field minus its value at x = 0.
    twist: Vec<Vec<f64>>,
    shapes: Vec<Named>,
}

/// Run of a scene with its modes and fields.
pub struct FieldRun {
    pub trajectory: Result<Trajectory, SimulateError>,
    pub modes: Result<Modes, NoModes>,
    pub along: Vec<Along>,
}

/// Runs a scene with the discretization of its spec. The modes use a coarser one.
pub fn run(scene: &dyn FieldScene<f64>, time_limit: Duration) -> Result<FieldRun, Failure> {
    let refused = |error: FieldError| Failure::input(error, "");
    let simulator = FieldSimulator::new(scene, Discretisation::default()).map_err(refused)?;
    let limited = Simulation::new(simulator.single()).time_limit(time_limit);
    let trajectory = limited.with_energy_balance(true).run();
    let coarse = FieldSimulator::new(scene, FEW).map_err(refused)?;
    let along = match &trajectory {
        Ok(trajectory) => {
            let along = |field| Along::new(scene, &simulator, &coarse, field, trajectory);
            (0..scene.fields()).map(along).collect()
        }
        Err(_) => Vec::new(),
    };
    Ok(FieldRun {
        trajectory,
        modes: modes::modes(&Simulation::new(coarse.single()).time_limit(time_limit)),
        along,
    })
}

impl Along {
    fn new(
        scene: &dyn FieldScene<f64>,
        simulator: &FieldSimulator<'_, f64>,
        coarse: &FieldSimulator<'_, f64>,
        field: usize,
        trajectory: &Trajectory,
    ) -> Self {
        let value = scene.field(field).value;
        let parameters = parameter_defaults(simulator);
        let n = simulator.shape().coordinates;
        let every = trajectory.times.len().div_ceil(TIMES).max(1);
        let moments: Vec<usize> = (0..trajectory.times.len()).step_by(every).collect();
        let places = simulator.places(field, &parameters);
        let mut twist = vec![Vec::with_capacity(moments.len()); places.len()];
        for moment in &moments {
            let state = trajectory.columns[..n].iter().map(|column| column.values[*moment]);
            let values = simulator.values(field, &state.collect::<Vec<f64>>());
            for (row, value) in twist.iter_mut().zip(&values) {
                row.push(value - values[0]);
            }
        }
        Self {
            name: value.name.to_owned(),
            unit: value.unit.to_owned(),
            times: moments.iter().map(|moment| trajectory.times[*moment]).collect(),
            places,
            twist,
            shapes: shapes(coarse, field).unwrap_or_default(),
        }
    }

    fn section(&self, scene: &str) -> Markup {
        let twist = html! {
            code { (self.name) } " along the field over time, less its value at x = 0, in "
            (self.unit) "."
        };
        let shapes = html! {
            "Shapes of the slowest oscillations, the largest part in phase; 8 elements of order 4."
        };
        let axes = (&self.times[..], &self.places[..]);
        html! {
            (figure::picture(&format!("{scene}-{}-twist", self.name), axes, &self.twist, &self.unit, &twist))
            @if !self.shapes.is_empty() {
                (figure::curves(&format!("{scene}-{}-shapes", self.name), ["x [m]", "shape"], &self.shapes, Scales::Linear, &shapes))
            }
        }
    }
}

/// Returns the mode shapes along a field about the end of the run, each scaled to a largest size of
/// 1.
fn shapes(simulator: &FieldSimulator<'_, f64>, field: usize) -> Result<Vec<Named>, LinearError> {
    let until = simulator.run_defaults().until;
    let point = operating_point(&Simulation::new(simulator), Place::Time(until))?;
    let parameters = parameter_defaults(simulator);
    let places = simulator.places(field, &parameters);
    let modes = Linearization::at(simulator, point)?.modes()?;
    let n = simulator.shape().coordinates;
    let mut curves = Vec::new();
    for mode in modes.iter().filter(|mode| mode.kind == ModeKind::Oscillation) {
        let parts = [0, 1].map(|part| {
            let shape: Vec<f64> = mode.shape[..n].iter().map(|value| value[part]).collect();
            simulator.values(field, &shape)
        });
        let size = |part: &Vec<f64>| part.iter().fold(0.0, |most: f64, v| most.max(v.abs()));
        let part = if size(&parts[0]) >= size(&parts[1]) { &parts[0] } else { &parts[1] };
        let largest = size(part);
        if largest > 0.0 && curves.len() < SHAPES {
            let shape = part.iter().map(|value| value / largest).collect();
            let name = format!("{} rad/s", number(mode.natural_frequency(), 4));
            curves.push((name, places.clone(), shape));
        }
    }
    Ok(curves)
}

/// Renders pictures of a scene's fields.
pub fn section(scene: &str, fields: &[Along]) -> Markup {
    html! {
        @if !fields.is_empty() {
            h3 { "Along the field" }
            @for along in fields { (along.section(scene)) }
        }
    }
}

/// Measurements of fields apart from scenes.
pub struct Study {
    errors: Result<Vec<Named>, String>,
    /// Beats with a fell that only pushes, and with one that also pulls.
    beats: Result<[[Beat; 3]; 2], String>,
}

impl Study {
    /// Measures fields.
    pub fn new() -> Self {
        Self {
            errors: errors().map_err(|error| error.to_string()),
            beats: both().map_err(|error| error.to_string()),
        }
    }

    /// Renders the section of the page.
    pub fn section(&self) -> Markup {
        html! {
            h3 { "Error against number of elements" }
            @match &self.errors {
                Ok(curves) => (figure::curves("fields-errors", ["elements", "relative error"], curves, Scales::Logarithmic, &html! {
                    "Fifth frequency of " code { "shaft_step_torque" } " against its closed form:
                     errors fall with the number of elements to the power of twice their order, down
                     to rounding."
                })),
                Err(error) => p.warning { "There are no frequencies: " (error) },
            }
            h3 { "What a stiffer contact changes" }
            @match &self.beats {
                Ok([machine, linear]) => {
                    p {
                        "The study concludes that a stiffer contact with the cloth fell changes the
                         motion little and the stress markedly."
                    }
                    (contact("fell that only pushes", "one-sided", machine))
                    (contact("fell that also pulls, the linear reading", "linear", linear))
                }
                Err(error) => p.warning { "The reed did not run: " (error) },
            }
        }
    }
}

fn both() -> Result<[[Beat; 3]; 2], CheckFailure> {
    Ok([beats(Fell::OnlyPushes)?, beats(Fell::PushesAndPulls)?])
}

fn errors() -> Result<Vec<Named>, LinearError> {
    let exact = SAW_GIN_SHAFT.fixed_free_frequency(5);
    let mut curves = Vec::new();
    for (order, most) in [(1, 64), (2, 32), (4, 16), (8, 8)] {
        let (mut x, mut y) = (Vec::new(), Vec::new());
        let mut elements = 8 / order;
        while elements <= most {
            let wanted = Discretisation { elements: Some(elements), order: Some(order) };
            if let Ok(simulator) = FieldSimulator::new(&ShaftStepTorque, wanted) {
                let state = vec![0.0; simulator.shape().states()];
                let point = Point { time: 0.0, state, parameters: parameter_defaults(&simulator) };
                let linearization = Linearization::at(simulator.single(), point)?;
                let found = linearization.second_order()?.undamped_frequencies()?;
                x.push(elements as f64);
                y.push(found.get(4).map_or(f64::NAN, |found| (found / exact - 1.0).abs()));
            }
            elements *= 2;
        }
        curves.push((format!("order {order}"), x, y));
    }
    Ok(curves)
}

fn contact(fell: &str, id: &str, beats: &[Beat; 3]) -> Markup {
    let names = beats.each_ref().map(|beat| format!("C2 = {} C1", number(beat.share, 2)));
    let [none, half, whole] = beats;
    let (first, last) = (none.change_to(half), half.change_to(whole));
    let of = |index: usize, unit: f64| -> Vec<Named> {
        let scaled = |beat: &Beat| beat.columns[index].iter().map(|value| value / unit).collect();
        let beats = beats.iter().zip(&names);
        beats.map(|(beat, name)| (name.clone(), beat.times.clone(), scaled(beat))).collect()
    };
    let curves = |index: usize, what: &str, axis: &str, unit: f64| {
        let caption = html! { (what) ", " (fell) "." };
        figure::curves(
            &format!("fields-{id}-{index}"),
            ["time [s]", axis],
            &of(index, unit),
            Scales::Linear,
            &caption,
        )
    };
    html! {
        h4 { "With a " (fell) }
        p {
            "From C1/2 to C1 the largest angle of the shaft at the reed changes by "
            (number(last[0], 2)) " %, that of the reed by " (number(last[1], 2))
            " %, the stress before the reed by " (number(last[2], 2)) " % and the torque of the fell by "
            (number(last[4], 2)) " %."
        }
        div.scroll {
            table {
                thead { tr {
                    th { "Largest over a period of the drive" }
                    @for name in &names { th.number { (name) } }
                    th { "Unit" } th.number { "0 to C1/2 [%]" } th.number { "C1/2 to C1 [%]" }
                } }
                tbody {
                    @for (index, (name, unit)) in COMPARED.iter().enumerate() {
                        tr {
                            td { code { (name) } }
                            @for beat in beats { td.number { (number(beat.largest()[index], 5)) } }
                            td.unit { (unit) }
                            td.number { @if first[index].is_finite() { (number(first[index], 3)) } }
                            td.number { (number(last[index], 3)) }
                        }
                    }
                }
            }
        }
        (curves(1, "Angle of the reed", "angle of the reed [rad]", 1.0))
        (curves(0, "Angle of the shaft at the reed", "angle of the shaft [rad]", 1.0))
        (curves(2, "Stress at the shaft's surface before the reed", "stress [MPa]", 1e6))
        (curves(3, "Stress at the shaft's surface after the reed", "stress [MPa]", 1e6))
    }
}
