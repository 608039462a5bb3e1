//! Pages checked with the rules of axe-core, which cannot be redistributed here. The test runs if
//! the environment gives its path (`MACHINIST_AXE=path/to/axe.min.js`, of the npm package
//! `axe-core`) and there is a browser.

use std::fs;
use std::path::Path;

use crate::cli::{answer, text};
use crate::live::{browser, found};

/// Collects violations of the rules and leaves them in the page.
const ASK: &str = r#"<script>
addEventListener("load", async () => {
  await new Promise((resolve) => setTimeout(resolve, 1000));
  const broken = (await axe.run(document)).violations.flatMap(({ id, nodes }) =>
    nodes.map(({ html }) => `${id}: ${html.slice(0, 100)}`));
  const told = broken.length ? broken.join("; ") : "nothing";
  document.body.dataset.found = `${told} at ${innerWidth}`.replaceAll('"', "'");
});
</script></body>"#;

/// Browser options: a screen in light and dark, and the narrowest window that browsers open.
const WAYS: [&[&str]; 3] = [
    &["--window-size=1200,900"],
    &["--window-size=1200,900", "--blink-settings=preferredColorScheme=0"],
    &["--window-size=500,900"],
];

/// Pages of machines with events, without, with constraints, with a field, and in space.
const PAGES: [(&str, &str); 5] = [
    ("specs/scenes/drives/winch.toml", "winch"),
    ("specs/scenes/parts/translational/mass.toml", "translational_mass"),
    ("specs/scenes/slider_crank.toml", "slider_crank"),
    ("specs/scenes/shaft_with_rotors.toml", "shaft_with_rotors"),
    ("specs/scenes/msl/spatial_four_bar.toml", "msl_spatial_four_bar"),
];

#[test]
fn pages_break_no_rule_of_axe_in_light_in_dark_and_in_a_narrow_window() {
    let Some(axe) = std::env::var_os("MACHINIST_AXE") else {
        eprintln!("MACHINIST_AXE says nothing: pages are not held against axe-core");
        return;
    };
    let browser = browser().expect("a browser, where axe-core is given");
    let axe = fs::read_to_string(Path::new(&axe)).expect("axe.min.js");
    let asked = format!("<script>{}</script>{ASK}", axe.replace("</script", "<\\/script"));
    let folder = tempfile::tempdir().expect("a folder");
    for (scene, name) in PAGES {
        answer(&["report", scene, "--no-times", "--out", text(folder.path())]);
        let page = folder.path().join(format!("machines/{name}.html"));
        let html = fs::read_to_string(&page).expect("a page");
        let (front, _) = html.rsplit_once("</body>").expect("the end of the page");
        fs::write(&page, format!("{front}{asked}</html>")).expect("written");
        for way in WAYS {
            let found = found(&browser, &page, folder.path(), way);
            let width = way[0].trim_start_matches("--window-size=").split(',').next();
            let expected = format!("nothing at {}", width.unwrap_or_default());
            assert_eq!(found, expected, "{name} {way:?}");
        }
    }
}
