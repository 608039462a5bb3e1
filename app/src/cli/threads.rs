//! Simulators of a scene for several threads.

use machinist_contract::Simulator;

use super::scene::{Scene, built_in};

pub type Lender<'s> = Box<dyn Fn(&mut dyn FnMut(&dyn Simulator<f64>)) + Sync + 's>;

/// Returns a function that lends a simulator. Emitted code and models are shared; fields are
/// discretized for each thread.
pub fn lender(scene: &Scene) -> Lender<'_> {
    match scene {
        Scene::Emitted(simulator) => {
            let name = simulator.name().to_owned();
            Box::new(move |work| built_in(&name).into_iter().for_each(&mut *work))
        }
        Scene::Model(model) => {
            let model = &**model;
            Box::new(move |work| work(model.single()))
        }
        Scene::Fields(cut) => {
            let again = cut.again();
            Box::new(move |work| {
                if let Ok(simulator) = again() {
                    work(simulator.single());
                }
            })
        }
    }
}
