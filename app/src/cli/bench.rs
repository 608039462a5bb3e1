//! `machinist bench`: run time of each method over its accuracy on a scene.

use clap::Args;
use machinist::Method;
use machinist_studies::work_precision::{Curve, Plan, Point, WorkPrecision, measure};

use super::amount::plain;
use super::arguments::{SceneArgs, SpanArgs, TimeArgs};
use super::output::{columns, print, print_with};
use super::scene::{Loading, Scene};
use crate::failure::Failure;
use crate::number::number;
use crate::progress::during;

#[derive(Debug, Args)]
pub struct Bench {
    /// Methods. Default: all
    #[arg(long, value_name = "NAMES", value_delimiter = ',')]
    methods: Vec<String>,
    /// Relative tolerances. Default: 1e-2 to 1e-12, by powers of ten
    #[arg(long, value_name = "TOLERANCES", value_delimiter = ',', value_parser = plain)]
    rtols: Vec<f64>,
    /// Number of runs, whose median time is reported
    #[arg(long, value_name = "NUMBER", default_value_t = 25)]
    runs: usize,
    /// Print JSON
    #[arg(long, help_heading = "Output")]
    json: bool,
    #[command(flatten)]
    scene: SceneArgs,
    #[command(flatten)]
    span: SpanArgs,
    #[command(flatten)]
    time: TimeArgs,
}

impl Bench {
    pub fn execute(&self) -> Result<(), Failure> {
        let mut plan = Plan { runs: self.runs.max(1), ..Plan::default() };
        if !self.methods.is_empty() {
            let methods = self.methods.iter().map(|name| Method::from_name(name));
            plan.methods =
                methods.collect::<Result<_, _>>().map_err(|error| Failure::input(error, ""))?;
        }
        if !self.rtols.is_empty() {
            plan.tolerances.clone_from(&self.rtols);
        }
        plan.tolerances.sort_by(|a, b| b.total_cmp(a));
        plan.time_limit = self.time.limit();
        let loading = Loading { is_timed: true, ..self.scene.machine.loading() };
        let scene = Scene::load(&self.scene.scene, &loading)?;
        let run = self.span.apply(self.scene.simulation(scene.simulator())?);
        let measured = during("timing the methods", || measure(&run, scene.twin(), &plan))?;
        if self.json {
            return print_with(|out| {
                serde_json::to_writer_pretty(&mut *out, &measured)?;
                writeln!(out)
            });
        }
        print(&self.table(&scene, &measured))
    }

    fn table(&self, scene: &Scene, measured: &WorkPrecision) -> String {
        let mut text = format!(
            "{} ({}), measured against {}\n\
             error: maximum over states and time, relative to the state's largest value, or to\n\
             its scale if that value is only rounding\n\
             times: medians of up to {} runs; elsewhere only their ratios are comparable\n\n",
            measured.scene,
            scene.how(),
            measured.reference.name,
            self.runs.max(1),
        );
        let header = [
            "method",
            "rtol",
            "ms",
            "steps",
            "rejected",
            "rates",
            "Jacobians",
            "error",
            "error/rtol",
        ];
        let mut rows = vec![header.map(str::to_owned)];
        let agreement = measured.reference.agreement;
        for curve in &measured.curves {
            rows.extend(curve.points.iter().map(|point| row(curve, point, agreement)));
        }
        text.push_str(&columns(&rows, 1));
        for curve in &measured.curves {
            for stop in &curve.stopped {
                text.extend([&format!("rtol {:.0e}: ", stop.rtol), &stop.reason, "\n"]);
            }
        }
        text
    }
}

/// Formats a row. Errors smaller than the reference can resolve are marked.
fn row(curve: &Curve, point: &Point, agreement: f64) -> [String; 9] {
    let mark = if point.error < agreement { "~" } else { "" };
    let work = point.work;
    [
        curve.method.name().to_owned(),
        format!("{:.0e}", point.rtol),
        number(point.milliseconds, 3),
        work.steps.to_string(),
        work.rejected.to_string(),
        work.rate_evaluations.to_string(),
        work.jacobian_evaluations.to_string(),
        format!("{mark}{}", number(point.error, 2)),
        number(point.proportionality(), 2),
    ]
}
