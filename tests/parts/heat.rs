//! Closed forms of parts that store, conduct and give off heat, and of what depends on it.

use machinist::Simulation;
use machinist_codegen::mechanics::reduce::Keep;
use machinist_codegen::spec::{InstanceSpec, load_scene};

use super::{column, example, off, parts, run};
use crate::own_scene::{folder_of_specs, of_text};

/// Temperature at which the examples start \[K\].
const START: f64 = 293.15;

#[test]
fn a_body_follows_its_heating() {
    let scene = example("thermal/heat_capacitor", Keep::Needed);
    for capacity in [20.0, 1000.0, 1e5] {
        for start in [200.0, START, 600.0] {
            let run = run(&scene, &[("body.capacity", capacity), ("body.start", start)], &[]);
            let decay = 8.0 / capacity;
            let drive = 200.0 / capacity / (decay - 1.0 / 20.0);
            let rise = |t: f64| {
                (start - START) * (-decay * t).exp()
                    + drive * ((-t / 20.0).exp() - (-decay * t).exp())
            };
            let error = off(&run, "temperature", |t| START + rise(t));
            assert!(error < 1e-9, "{capacity}, {start}: {error:e}");
            assert!(off(&run, "rise", |t| START - start + rise(t)) < 1e-6);
        }
    }
}

#[test]
fn a_wall_levels_two_temperatures() {
    let scene = example("thermal/conductor", Keep::Needed);
    for conductance in [0.1, 5.0, 300.0] {
        for [hot, cold] in [[200.0, 300.0], [10.0, 1e4], [1e4, 10.0]] {
            let set =
                [("wall.conductance", conductance), ("hot.capacity", hot), ("cold.capacity", cold)];
            let run = run(&scene, &set, &[]);
            let decay = conductance * (1.0 / hot + 1.0 / cold);
            let drive = 100.0 / hot / (decay - 1.0 / 50.0);
            let difference = |t: f64| {
                80.0 * (-decay * t).exp() + drive * ((-t / 50.0).exp() - (-decay * t).exp())
            };
            // All heat: C_h T_h + C_c T_c.
            let heat = |t: f64| hot * 80.0 + 5000.0 * (1.0 - (-t / 50.0).exp());
            let colder = |t: f64| START + (heat(t) - hot * difference(t)) / (hot + cold);
            let error =
                off(&run, "cold", colder).max(off(&run, "hot", |t| colder(t) + difference(t)));
            assert!(error < 1e-9, "{conductance}, {hot}, {cold}: {error:e}");
            assert!(off(&run, "flow", |t| conductance * difference(t)) < 1e-7);
        }
    }
}

#[test]
fn a_surface_cools_by_a_power_law() {
    let scene = example("thermal/convection", Keep::Needed);
    for exponent in [0.0, 0.25, 1.0 / 3.0] {
        for coefficient in [1.0, 6.0, 50.0] {
            for start in [300.0, 373.15, 900.0] {
                let set = [
                    ("power", 0.0),
                    ("air.exponent", exponent),
                    ("air.coefficient", coefficient),
                    ("housing.start", start),
                ];
                let run = run(&scene, &set, &[]);
                let decay = coefficient * 0.1 / 500.0;
                let first: f64 = start - START;
                let rise = |t: f64| {
                    if exponent == 0.0 {
                        return first * (-decay * t).exp();
                    }
                    let slowed = exponent * decay * 50f64.powf(-exponent) * t;
                    (first.powf(-exponent) + slowed).powf(-1.0 / exponent)
                };
                let error = off(&run, "temperature", |t| START + rise(t));
                assert!(error < 1e-9, "{exponent}, {coefficient}, {start}: {error:e}");
            }
        }
    }
}

/// (1 + a x) x' = U^2/(R C) for the temperature rise x.
#[test]
fn a_winding_heats_up_and_takes_less() {
    let scene = example("electrical/heated_resistor", Keep::Needed);
    for coefficient in [1e-4, 0.00393, 0.05] {
        for capacity in [5.0, 50.0, 5000.0] {
            let set = [("winding.coefficient", coefficient), ("copper.capacity", capacity)];
            let run = run(&scene, &set, &[]);
            let power = 100.0 / capacity;
            let rise = |t: f64| ((1.0 + 2.0 * coefficient * power * t).sqrt() - 1.0) / coefficient;
            let current = |t: f64| 10.0 / (1.0 + coefficient * rise(t));
            let error = off(&run, "temperature", |t| START + rise(t))
                .max(off(&run, "current", current))
                .max(off(&run, "loss", |t| 10.0 * current(t)));
            assert!(error < 1e-8, "{coefficient}, {capacity}: {error:e}");
        }
    }
}

/// C x' = d w^2 exp(-b x) for the temperature rise x.
#[test]
fn oil_thins_as_it_warms() {
    let scene = example("rotational/heated_friction", Keep::Needed);
    for thinning in [1e-3, 0.03, 0.2] {
        for capacity in [100.0, 2000.0, 1e5] {
            let set = [("bearing.thinning", thinning), ("oil.capacity", capacity)];
            let run = run(&scene, &set, &[]);
            let warming = thinning * 0.1 * 1e4 / capacity;
            let rise = |t: f64| (warming * t).ln_1p() / thinning;
            let error = off(&run, "temperature", |t| START + rise(t))
                .max(off(&run, "drag", |t| 10.0 / (1.0 + warming * t)));
            assert!(error < 1e-8, "{thinning}, {capacity}: {error:e}");
            assert!(column(&run, "loss").windows(2).all(|pair| pair[1] <= pair[0]));
        }
    }
}

/// The outputs `loss` of all parts of an example add up to what the account loses.
#[test]
fn every_part_gives_its_losses_as_heat() {
    let (mut heated, mut wrong) = (0, Vec::new());
    for part in parts() {
        let path = folder_of_specs().join(format!("parts/{}.toml", part.name));
        let scene = load_scene(&path).unwrap_or_else(|error| panic!("{}", error.render()));
        let has_loss = |one: &&InstanceSpec| {
            let unit = &scene.units[one.unit];
            let mut named = unit.outputs.iter().chain(&unit.helpers);
            named.any(|output| output.name.value == "loss")
        };
        let losses = scene.instances.iter().filter(has_loss);
        let losses: Vec<String> = losses.map(|one| format!("{}.loss", one.name.value)).collect();
        let text = part.example.expect("an example");
        // A table beside the example is not beside the copy of it, and impacts lose energy at once.
        let has_impacts = part.name == "translational/sliding_mass";
        if losses.is_empty() || has_impacts || text.contains("tables/") {
            continue;
        }
        let rate = losses.join(" + ");
        let state = format!("[states.heat]\nunit = \"J\"\nrate = \"{rate}\"\n");
        let text =
            text.replace("\n[outputs]\n", &format!("\n{state}\n[outputs]\nheated = \"heat\"\n"));
        let machine = of_text(&text, Keep::Needed);
        let run = Simulation::new(&machine).with_energy_balance(true).run();
        let run = run.unwrap_or_else(|error| panic!("{}: {error}", part.name));
        let balance = run.energy_balance.as_ref().expect("asked for");
        let [lost, passed] = [&balance.dissipated, &balance.passed]
            .map(|energy| energy.last().copied().expect("an energy"));
        let heat = run.last("heated").expect("a state");
        let error = (heat - lost).abs();
        if error > 1e-6 * passed {
            wrong.push(format!("{}: {heat} J of {lost} J, {losses:?}", part.name));
        }
        heated += usize::from(lost > 1e-3 * passed);
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(heated > 40, "{heated} parts lose energy");
}
