//! Walks along a parameter of the winders.

use super::*;

#[test]
fn a_winder_is_walked_and_its_later_stages_are_told() {
    let text = answer(&["studies", "walk", "--speed", "1.5"]);
    assert!(text.contains("Stage 1, linear, is enough"), "{text}");
    for part in ["Stage 2 would have cost", "Stage 3 would have cost", "least pressure", "stable"] {
        assert!(text.contains(part), "{part} in {text}");
    }
    assert!(
        answer(&["studies", "walk", "--speed", "2.2"])
            .contains("Stage 2, stiffening layer, is enough")
    );
    let text = answer(&["studies", "walk", "--speed", "1.5", "--growth", "3800", "--package", "5"]);
    for part in ["of the drum and 5 N of the package", "40 N pressure that grows by 3800 N/m"] {
        assert!(text.contains(part), "{part} in {text}");
    }
    assert_refused(&["studies", "walk", "--growth", "-1"], &["the growth of the pressure is -1"]);
}

#[test]
fn a_walk_as_json_has_stages_and_map_and_a_map_is_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("map.svg");
    let file = file.to_str().expect("text");
    let text = answer(&["studies", "walk", "--json", "--map", file, "--preload", "100"]);
    let walk: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(walk["decided"], 3);
    assert_eq!(walk["walk"]["stages"].as_array().map(Vec::len), Some(3));
    let condition = walk["map"]["cells"][0][0]["condition"].as_str();
    assert_eq!(condition, Some("stable"));
    let drawn = fs::read_to_string(file).expect("it was drawn");
    assert!(drawn.starts_with("<svg") && drawn.contains("the yarn may be pressed too hard"));
}

#[test]
fn a_winder_that_makes_no_sense_is_refused() {
    assert_refused(
        &["studies", "walk", "--speed", "-1"],
        &["the speed is -1, but must be above zero"],
    );
    assert_refused(&["studies", "walk", "--radius-max", "0.01"], &["is not below 0.01 m"]);
    assert_refused(&["studies", "walk", "--map", "map.pdf"], &["unknown format"]);
}
