//! Answers to the questions of the studies' authors, with a picture and two sentences each.

use machinist_studies::closed_form::two_mass::{SAW_GIN, TwoMass};
use machinist_studies::conclusions::{
    Couplings, DampedCouplings, Limit, PressureWindow, StableSpeeds, fells, limit, load_resonance,
    peaks,
};
use machinist_studies::reed_study::Beat;
use machinist_studies::verify::CheckFailure;
use machinist_studies::winder_walk::Winder;
use maud::{Markup, html};

use super::figure::{self, Named, Scales};
use crate::number::number;

/// Computed answers.
pub struct Study {
    couplings: Couplings,
    /// Largest acceleration and torque with the study's own coupling.
    own: (f64, f64),
    /// Stiffness at which the load excites the coupling \[N m/rad\].
    excited: f64,
    speeds: StableSpeeds,
    /// Limit of the bench winder.
    bench: (Winder, Limit),
    window: PressureWindow,
    fells: Vec<Beat>,
}

/// Stiffness and dissipation of the saw-gin study's coupling.
const OWN: (f64, f64) = (23_065.2, 128.5346);
/// Frequency of the supply \[rad/s\].
const SUPPLY: f64 = 100.0 * std::f64::consts::PI;
/// Ratio of a peak to that of a soft coupling above which the coupling counts as hard.
const SPARED: f64 = 1.1;

impl Study {
    /// Computes the answers.
    ///
    /// # Errors
    /// The reason of the failure.
    pub fn new() -> Result<Self, String> {
        Self::computed().map_err(|error| error.to_string())
    }

    fn computed() -> Result<Self, CheckFailure> {
        let bench = Winder::at_speed(5.5)?;
        let ends = limit(&bench)?;
        Ok(Self {
            couplings: Couplings::new()?,
            own: peaks(OWN.0, OWN.1)?,
            excited: load_resonance(OWN.1)?,
            speeds: StableSpeeds::new()?,
            window: PressureWindow::of(&bench.winding_at(ends.speed))?,
            bench: (bench, ends),
            fells: fells()?,
        })
    }
}

/// Renders the answers, or the reason why there are none.
pub fn section(study: &Result<Study, String>) -> Markup {
    html! {
        @match study {
            Ok(study) => {
                h3 { "Which coupling for the saw gin" }
                (coupling(study))
                h3 { "Where a winder winds stably" }
                (winding(study))
                h3 { "How stiff the cloth fell may be for the reed" }
                (fell(&study.fells))
            }
            Err(error) => p.warning { "There are no answers: " (error) },
        }
    }
}

fn coupling(study: &Study) -> Markup {
    let Couplings { stiffnesses, rows } = &study.couplings;
    let of = |values: fn(&DampedCouplings) -> &Vec<f64>| -> Vec<Named> {
        let named = |row| {
            let row: &DampedCouplings = row;
            let name = format!("{} N m s/rad", number(row.damping, 4));
            (name, stiffnesses.clone(), values(row).clone())
        };
        rows.iter().map(named).collect()
    };
    let axis = "stiffness of the coupling [N m/rad]";
    let caption = html! {
        "Largest acceleration of the cylinder over run-up and load, by stiffness and dissipation of
         the coupling."
    };
    let torque = html! { "Largest torque of the coupling, by its stiffness and dissipation." };
    html! {
        @if let [_, own, more] = rows.as_slice() {
            (judged(stiffnesses, [&own.accelerations, &more.accelerations], study.own))
            p {
                "The load, at 241.8 rad/s, excites the coupling's own oscillation at "
                (number(1e-3 * study.excited, 3)) " kN m/rad."
            }
        }
        (figure::curves("conclusions-acceleration", [axis, "acceleration [rad/s\u{b2}]"], &of(|row| &row.accelerations), Scales::LogarithmicAcross, &caption))
        (figure::curves("conclusions-torque", [axis, "torque [N m]"], &of(|row| &row.torques), Scales::LogarithmicAcross, &torque))
    }
}

/// Renders two sentences on the couplings with the study's dissipation.
fn judged(stiffnesses: &[f64], [accelerations, of_more]: [&[f64]; 2], own: (f64, f64)) -> Markup {
    let soft = accelerations.first().copied().unwrap_or(f64::NAN);
    let pairs = || stiffnesses.iter().zip(accelerations);
    let spared = pairs().take_while(|(_, peak)| **peak <= SPARED * soft).last();
    let spared = spared.map_or(f64::NAN, |(stiffness, _)| *stiffness);
    let worst = pairs().max_by(|a, b| a.1.total_cmp(b.1));
    let (at, peak) = worst.map_or((f64::NAN, f64::NAN), |(at, peak)| (*at, *peak));
    let natural = TwoMass { stiffness: at, ..SAW_GIN }.natural_frequency();
    let most = |values: &[f64]| values.iter().fold(0.0, |most: f64, value| most.max(*value));
    let kilo = |stiffness: f64| number(1e-3 * stiffness, 3);
    html! {
        p {
            "With the study's dissipation the cylinder's largest acceleration stays within 10 % of "
            (number(soft, 3)) " rad/s\u{b2} up to " (kilo(spared)) " kN m/rad; the study's own coupling, "
            (kilo(OWN.0)) " kN m/rad, lets through " (number(own.0, 3)) " rad/s\u{b2} and "
            (number(own.1, 3)) " N m. It grows to " (number(peak, 3)) " rad/s\u{b2} near " (kilo(at))
            " kN m/rad, whose natural frequency of " (number(natural, 3)) " rad/s is near that of the
             motor's switching transient, the supply's " (number(SUPPLY, 3)) " rad/s, and falls to "
            (number(accelerations.last().copied().unwrap_or(f64::NAN), 3)) " rad/s\u{b2} at "
            (kilo(stiffnesses.last().copied().unwrap_or(f64::NAN))) " kN m/rad; twice the
             dissipation makes the peak " (number(most(of_more), 3)) " rad/s\u{b2}."
        }
    }
}

fn winding(study: &Study) -> Markup {
    let (bench, ends) = &study.bench;
    let StableSpeeds { pressures, kept, growing } = &study.speeds;
    let curve = |name: &str, limits: &[Limit]| -> Named {
        (name.to_owned(), pressures.clone(), limits.iter().map(|limit| limit.speed).collect())
    };
    let curves =
        [curve("pressure kept", kept), curve("pressure grows with the package, (15)", growing)];
    let best = pressures.iter().zip(kept).max_by(|a, b| a.1.speed.total_cmp(&b.1.speed));
    html! {
        p {
            "Pressed with " (number(bench.preload, 3)) " N the bench winder winds stably at every radius
             up to " (number(ends.speed, 3)) " m/s. Above this speed, at R = "
            (number(1e3 * ends.radius, 3)) " mm, " (ends.condition.name())
            "; the disturbance that varies the pressure most is " (ends.disturbance.name()) ". "
            @if let Some((pressure, limit)) = best {
                "Of all pressures, " (number(*pressure, 3)) " N allows the greatest speed, "
                (number(limit.speed, 3)) " m/s; above it, " (limit.condition.name())
                " first, because of " (limit.disturbance.name()) "."
            }
        }
        (figure::curves(
            "conclusions-speeds",
            ["pressure with the empty bobbin [N]", "greatest stable speed [m/s]"],
            &curves,
            Scales::Linear,
            &html! {
                "Greatest speed up to which winding is stable at every radius and at the worst phases, by
                 the pressure."
            },
        ))
        @let window = &study.window;
        @let least = window.least.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        @let most = window.most.iter().copied().fold(f64::INFINITY, f64::min);
        p {
            "At " (number(window.speed, 3)) " m/s, at every radius of the growing package, a pressure
             from " (number(least, 3)) " N to " (number(most, 3)) " N winds stably. Below it, contact
             or adhesion is lost; above it, the yarn is pressed too hard."
        }
        (self::window(window))
    }
}

/// Renders figure 8 of the study.
fn window(window: &PressureWindow) -> Markup {
    let radii: Vec<f64> = window.radii.iter().map(|radius| 1e3 * radius).collect();
    let curve = |name: &str, values: &[f64]| (name.to_owned(), radii.clone(), values.to_vec());
    let curves = [
        curve("N", &window.pressure),
        curve("[Nmin] + dN", &window.least),
        curve("[Nmax] - dN", &window.most),
    ];
    figure::curves(
        "conclusions-window",
        ["radius of the package [mm]", "pressure [N]"],
        &curves,
        Scales::Linear,
        &html! {
            "Figure 8 of the study for the bench winder at " (number(window.speed, 3))
            " m/s: the pressure and the window that it has to keep."
        },
    )
}

/// Returns the verdict on the study's conclusion that motion changes little and stress markedly.
fn verdict(change: &[f64; 5]) -> &'static str {
    let motion = change[0].abs().max(change[1].abs());
    if motion < 0.2 * change[2].abs() {
        "the study's conclusion holds"
    } else {
        "the study's conclusion does not hold"
    }
}

/// Stress before the reed \[Pa\] that serves as an example of a limit.
const EXAMPLE: f64 = 60e6;

/// Returns C2/C1 at which the stress before the reed, which grows with it, reaches a limit \[Pa\],
/// interpolated between the runs.
fn stiffest(beats: &[Beat], limit: f64) -> f64 {
    let stress = |beat: &Beat| beat.largest()[2];
    let pair = beats.windows(2).find(|pair| stress(&pair[1]) > limit);
    pair.map_or(f64::INFINITY, |pair| {
        let part = (limit - stress(&pair[0])) / (stress(&pair[1]) - stress(&pair[0]));
        pair[0].share + part * (pair[1].share - pair[0].share)
    })
}

fn fell(beats: &[Beat]) -> Markup {
    let shares: Vec<f64> = beats.iter().map(|beat| beat.share).collect();
    let Some(none) = beats.first() else { return html! {} };
    let relative = |name: &str, of: &dyn Fn(&Beat) -> f64| -> Named {
        let values = beats.iter().map(|beat| of(beat) / of(none)).collect();
        (name.to_owned(), shares.clone(), values)
    };
    let curves = [
        relative("angle of the shaft", &|beat| beat.largest()[0]),
        relative("angle of the reed", &|beat| beat.largest()[1]),
        relative("stress before the reed", &|beat| beat.largest()[2]),
        relative("stress after the reed", &|beat| beat.largest()[3]),
        relative("travel into the fell", &Beat::forward),
    ];
    let at = |share: f64| beats.iter().find(|beat| (beat.share - share).abs() < 1e-9);
    html! {
        @if let (Some(soft), Some(stiff), Some(last)) = (at(0.5), at(1.0), beats.last()) {
            @let change = soft.change_to(stiff);
            p {
                "Against a fell that only pushes, from C2 = C1/2 to C1, the shaft's largest angle changes
                 by " (number(change[0], 2)) " %, the reed's by " (number(change[1], 2))
                " %, the stress before the reed by " (number(change[2], 3))
                " %: " (verdict(&change)) ". The travel into the fell falls by "
                (number(100.0 * (1.0 - stiff.forward() / soft.forward()), 2))
                " %, and the stress rises from "
                (number(1e-6 * none.largest()[2], 3)) " MPa without a fell to "
                (number(1e-6 * last.largest()[2], 3)) " MPa at C2 = " (number(last.share, 2))
                " C1. The study states no limit of the stress; a limit of " (number(1e-6 * EXAMPLE, 3))
                " MPa, for example, allows C2 up to " (number(stiffest(beats, EXAMPLE), 2)) " C1."
            }
        }
        (figure::curves(
            "conclusions-fell",
            ["stiffness of the fell, C2/C1", "ratio to the value without a fell"],
            &curves,
            Scales::Linear,
            &html! { "Largest angles and stresses over a period of the drive, with a fell that only pushes." },
        ))
    }
}
