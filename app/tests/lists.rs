//! Lists of scenes kept by hand agree with the properties of the scenes.

use machinist_contract::taylor::TaylorSeries;
use machinist_scenes::scenes;
use machinist_studies::double_double::precise;

#[test]
fn scenes_that_series_carry_run_in_lanes_and_in_31_digits() {
    for name in scenes::NAMES {
        let scene = scenes::find_f64(name).expect("it is built in");
        let has_corners = scene.taylor().map(TaylorSeries::has_corners);
        let is_carried = scene.events() == 0
            && scene.relations() == 0
            && scene.constraints() == 0
            && has_corners == Some(false);
        assert_eq!(machinist_lanes::find(name).is_some(), is_carried, "{name} in lanes");
        assert_eq!(precise(name).is_some(), is_carried, "{name} in 31 digits");
    }
}
