//! The saw gin's equations, figures and parameters.

use super::{Held, LedgerRow, Parameter, Statement, Study};
use crate::verify::CheckFailure;
use crate::verify::machine::{motor_run_up, saw_gin, saw_gin_shaft};

const SHAFT: Held =
    Held::Verify("shaft_step_torque: static twist under the end torque, every node");
const WAVES: Held =
    Held::Verify("shaft_step_torque: first ten frequencies, 10 elements of order 8");
const RIGHT_HAND_SIDE: Held = Held::Verify("saw_gin: right-hand side at 1000 random states");

pub(super) fn rows() -> Result<Vec<LedgerRow>, CheckFailure> {
    let mut rows: Vec<LedgerRow> = STATEMENTS.iter().map(|told| told.row(Study::SawGin)).collect();
    for (machine, parameters) in
        [(motor_run_up(), MOTOR), (saw_gin(), AGGREGATE), (saw_gin_shaft(), CYLINDER)]
    {
        for parameter in parameters {
            rows.push(parameter.row(Study::SawGin, &machine)?);
        }
    }
    Ok(rows)
}

const STATEMENTS: &[Statement] = &[
    Statement {
        at: "(1)",
        figure: "rotor and saw cylinder on an elastic coupling, i = 1",
        verdict: "same in both readings",
        place: "`two_mass`, `saw_gin`; units `coupling`, `rotor`",
        held: Held::Verify("two_mass: transient under a harmonic load"),
    },
    Statement {
        at: "(1), 4.1, (9)",
        figure: "the load, given in three forms",
        verdict: "sin(w2 t + phi20) under (1), sin(pi w2 t + phi20) in 4.1, cos(pi w2 t + phi20) \
                  in (9); the scenes use the form of 4.1, whose numbers are given; gains below",
        place: "unit `technological_load`",
        held: RIGHT_HAND_SIDE,
    },
    Statement {
        at: "(2)",
        figure: "motor with flux linkages in synchronous axes",
        verdict: "printed: 78.54 1/s instead of 2 pi 50, 220 V instead of the amplitude 220 sqrt \
                  2, and the angle phi_D instead of the electrical speed P phi_D'; consistent: \
                  all three corrected",
        place: "`motor_run_up`, `saw_gin`; printed `saw_gin_as_printed`",
        held: Held::Verify("motor_run_up: flux transient at 76.97 rad/s"),
    },
    Statement {
        at: "(3)",
        figure: "fitted law of the cylinder's acceleration, 200 e^(2.05 t) cos 75 t",
        verdict: "printed: a fit to one run, which grows without bound; consistent: the \
                  acceleration is an output",
        place: "`closed_form::printed_laws`; output `cylinder_acceleration` of `saw_gin`",
        held: Held::Verify("saw_gin_as_printed: printed law of acceleration at 1.844 s"),
    },
    Statement {
        at: "(4)",
        figure: "moment balance of a shaft element dx",
        verdict: "consistent for rho = dJ/dx; the text before (4) has rho = dJ/dx dx, one dx too \
                  many",
        place: "units `shaft`, `saw_shaft`, as an energy density",
        held: WAVES,
    },
    Statement {
        at: "(5), (6)",
        figure: "torque and twist of a section, M = G I phi_x",
        verdict: "same in both readings",
        place: "`saw_gin_shaft`, output `shaft_torque`",
        held: SHAFT,
    },
    Statement {
        at: "(7), (8)",
        figure: "wave equation of the shaft under a distributed load",
        verdict: "same in both readings; the Kelvin-Voigt damping of the scenes is ours",
        place: "`saw_gin_shaft`, `shaft_step_torque`",
        held: WAVES,
    },
    Statement {
        at: "(10), (11)",
        figure: "law (3) prescribed as the acceleration of every section",
        verdict: "printed only: the acceleration should follow from an equation of motion; (11) \
                  has dots for derivatives by x; consistent: the equation of motion determines \
                  the shaft's motion",
        place: "`closed_form::printed_laws`",
        held: Held::Test("printed_formulas_satisfy_the_printed_equation"),
    },
    Statement {
        at: "(12), (13)",
        figure: "integrals over x with two constants",
        verdict: "same in both readings, given (11)",
        place: "`closed_form::printed_laws`",
        held: Held::Test("angle_is_the_integral_of_the_slope"),
    },
    Statement {
        at: "(14), (15)",
        figure: "slope and angle with both constants zero",
        verdict: "printed only: with phi_x = 0 at the driven end no torque enters the shaft; \
                  consistent: G I phi_x equals the coupling's torque there",
        place: "`closed_form::printed_laws`; outputs `slope`, `twist` of `saw_gin_shaft`",
        held: Held::Test("formula_as_printed_stays_below_the_figures"),
    },
    Statement {
        at: "figure 1",
        figure: "dynamic model: motor, coupling, distributed cylinder",
        verdict: "consistent: the distributed shaft carries the inertia J2",
        place: "`saw_gin_shaft`, drawn on its report page",
        held: Held::Verify(
            "saw_gin_shaft: speeds and torques over the run-up with a shaft 1e6 times as stiff",
        ),
    },
    Statement {
        at: "figure 2",
        figure: "reactive moments on an element, M+ = -M",
        verdict: "same in both readings; both moments follow from one energy, so no sign is chosen",
        place: "unit `shaft`; ports of a field",
        held: SHAFT,
    },
    Statement {
        at: "figure 3",
        figure: "acceleration of the cylinder over time",
        verdict: "duration and peak in both readings below",
        place: "`saw_gin`, `saw_gin_as_printed`, on their report pages",
        held: Held::Verify("saw_gin: run-up and loading, state after 2 s"),
    },
    Statement {
        at: "figure 4",
        figure: "acceleration along the shaft over time",
        verdict: "printed: by (3) the same at every x; consistent: varies along x, number below",
        place: "`saw_gin_shaft`, plotted along x on its report page",
        held: Held::Verify("saw_gin_shaft: twist of the shaft under both steady loads"),
    },
    Statement {
        at: "(9)",
        figure: "load distributed over the shaft's length",
        verdict: "printed: it grows with x, and its integral is the load times l/(2 R dphi2); \
                  consistent: even or growing with x, and its integral is the load; numbers below",
        place: "unit `saw_shaft`; `closed_form::printed_laws`",
        held: Held::Verify("saw_gin_shaft: integrals of the even and the growing load density"),
    },
    Statement {
        at: "figures 5, 6",
        figure: "slope over time for several x; angle along x at 1.8 s",
        verdict: "the report plots (14), (15) as printed beside the consistent twist; largest \
                  values below",
        place: "the report's studies page; `closed_form::printed_laws`; `saw_gin_shaft`",
        held: Held::Verify("saw_gin_as_printed: relative twist, density J, load halved"),
    },
    Statement {
        at: "section 4.1",
        figure: "Runge-Kutta method with an error of dt^4",
        verdict: "printed: the classical method with fixed steps; here: error-controlled methods \
                  of fifth to eighth order",
        place: "methods `tsit5`, `dop853`, `rodas5p`, `radau`, `taylor`",
        held: Held::Test("every_method_converges_at_its_order_at_the_ends_of_steps_and_between"),
    },
    Statement {
        at: "section 1",
        figure: "starting torque of 1.5 to 6 times the rated one, 2 for this motor",
        verdict: "2 is the ratio of breakdown torque to rated torque; the starting torque is \
                  below the rated one (number below), so the motor's load is not greatest at \
                  standstill",
        place: "`motor_run_up`",
        held: Held::Verify("motor_run_up: starting torque"),
    },
    Statement {
        at: "section 5",
        figure: "conclusion: twist of the shaft is considerable",
        verdict: "not confirmed: 0.07 deg/m in the consistent reading; the report's studies page \
                  shows the coupling's effect on the cylinder's acceleration",
        place: "`studies::conclusions`",
        held: Held::Test("a_soft_coupling_spares_the_cylinder_and_one_near_the_transient_does_not"),
    },
];

const fn number(
    at: &'static str,
    figure: &'static str,
    unit: &'static str,
    printed: f64,
    name: &'static str,
    place: &'static str,
) -> Parameter {
    Parameter { at, figure, unit, printed, name, place, held: RIGHT_HAND_SIDE }
}

const MOTOR: &[Parameter] = &[
    number(
        "4.1",
        "supply frequency f",
        "Hz",
        50.0,
        "motor.supply_frequency",
        "unit `induction_motor`",
    ),
    number("4.1", "phase voltage Um", "V", 220.0, "motor.phase_voltage", "unit `induction_motor`"),
    number("4.1", "pole pairs P", "1", 4.0, "motor.pole_pairs", "unit `induction_motor`"),
    number("4.1", "Ks", "1", 0.956, "motor.k_s", "unit `induction_motor`"),
    number("4.1", "Kr", "1", 0.952, "motor.k_r", "unit `induction_motor`"),
    number("4.1", "stator reactance xs", "ohm", 4.14, "motor.x_s", "unit `induction_motor`"),
    number("4.1", "alpha_s'", "1", 0.115, "motor.alpha_s", "unit `induction_motor`"),
    number("4.1", "alpha_r'", "1", 0.0858, "motor.alpha_r", "unit `induction_motor`"),
    number(
        "4.1",
        "inertia of the rotor Jd",
        "kg m^2",
        4.2,
        "motor.inertia",
        "unit `induction_motor`",
    ),
];

const AGGREGATE: &[Parameter] = &[
    number(
        "4.1",
        "inertia of the saw cylinder J2",
        "kg m^2",
        1.244,
        "cylinder.inertia",
        "unit `rotor`",
    ),
    number("4.1", "mean load", "N m", 843.72, "load.mean", "unit `technological_load`"),
    number(
        "4.1",
        "amplitude of the load",
        "N m",
        78.78,
        "load.amplitude",
        "unit `technological_load`",
    ),
    number(
        "4.1",
        "rated speed in w2, 1/min",
        "1",
        735.0,
        "load.speed",
        "unit `technological_load`",
    ),
    number("(9)", "phase of the load phi20", "rad", 0.0, "load.phase", "unit `technological_load`"),
    number(
        "4.1",
        "stiffness of the coupling c",
        "N m/rad",
        23_065.2,
        "coupling.stiffness",
        "unit `coupling`",
    ),
    number(
        "4.1",
        "damping of the coupling",
        "N m s/rad",
        128.5346,
        "coupling.damping",
        "unit `coupling`",
    ),
];

const fn of_shaft(
    at: &'static str,
    figure: &'static str,
    unit: &'static str,
    printed: f64,
    name: &'static str,
) -> Parameter {
    let held = Held::Verify("saw_gin_shaft: twist of the shaft under both steady loads");
    Parameter { at, figure, unit, printed, name, place: "unit `saw_shaft`", held }
}

const CYLINDER: &[Parameter] = &[
    of_shaft("(9)", "length of the shaft l", "m", 2.322, "saws.length"),
    of_shaft("(5)", "shear modulus G", "Pa", 8e10, "saws.shear_modulus"),
    of_shaft("(8)", "polar moment I", "m^4", 9.817e-6, "saws.polar_moment"),
];
