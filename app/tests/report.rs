//! Pages of the report: complete, reproducible, and made only of text.

use std::fs;
use std::path::Path;
use std::process::Stdio;

use crate::cli::{answer, assert_refused, copy_specs, machinist, names_in, text};

/// Machine without events, so that some checks do not apply.
const WITHOUT_EVENTS: &str = include_str!("../../specs/scenes/parts/translational/mass.toml");
const MASS: &str = "translational_mass";

#[test]
fn the_report_is_pages_that_need_nothing_else_and_come_out_the_same() {
    let folder = tempfile::tempdir().expect("a folder");
    let specs = folder.path().join("specs");
    copy_specs(&specs);
    let [scenes, emitted] = [specs.join("scenes"), folder.path().join("emitted")];
    // One of each kind, because all pages take minutes without optimization.
    let shown = ["bouncing_mass", "shaft_with_rotors", "slider_crank", "two_mass"];
    for file in names_in(&scenes) {
        if !shown.iter().any(|name| file == format!("{name}.toml")) {
            fs::remove_file(scenes.join(file)).expect("removed");
        }
    }
    answer(&["gen", "--specs", text(&scenes), "--out", text(&emitted)]);
    // A machine that is not built in, for which some checks do not apply.
    fs::create_dir(scenes.join("drives")).expect("a folder");
    let mass = scenes.join("drives/mass.toml");
    fs::write(&mass, WITHOUT_EVENTS).expect("written");
    let pages = ["bouncing_mass", "shaft_with_rotors", "slider_crank", MASS, "two_mass"];
    let start = |out: &Path| {
        let places = ["--specs", text(&scenes), "--emitted", text(&emitted)];
        let arguments = [&["report", "--no-times", "--out", text(out)], &places[..]].concat();
        machinist(&arguments).stdout(Stdio::null()).spawn().expect("the program starts")
    };
    let folders = ["first", "second"].map(|name| folder.path().join(name));
    // In parallel, because each takes a while.
    let ends = folders.each_ref().map(|out| start(out)).map(|mut child| child.wait());
    assert!(ends.iter().all(|end| end.as_ref().expect("an end").success()));
    for folder in &folders {
        assert_eq!(names_in(folder), ["index.html", "machines", "studies.html"]);
        assert_eq!(names_in(&folder.join("machines")), pages.map(|name| format!("{name}.html")));
    }
    let machines = pages.map(|name| format!("machines/{name}.html"));
    let files = machines.iter().map(String::as_str).chain(["index.html", "studies.html"]);
    for file in files {
        let [first, second] = folders.each_ref().map(|folder| page(&folder.join(file)));
        assert!(first == second, "{file}");
        assert_links_lead_somewhere(&folders[0].join(file), &first);
    }
    let [index, studies] = ["index.html", "studies.html"].map(|file| page(&folders[0].join(file)));
    for name in pages {
        assert!(index.contains(&format!("href=\"machines/{name}.html\"")), "{name}");
    }
    let [checked, left_out] = counted(text(&mass));
    assert!(index.contains(&format!("{checked} of {checked} checks, {left_out} left out")));
    assert!(index.contains(&format!("<dd class=\"note\">{left_out} left out</dd>")));
    assert!(index.contains("fresh") && studies.contains("Reproduction ledger"));
    let conclusions = ["What the authors wanted to know", "the study's conclusion holds"];
    assert!(conclusions.iter().all(|words| studies.contains(words)));
    let two_mass = page(&folders[0].join("machines/two_mass.html"));
    for part in ["Content-Security-Policy", "<math", "href=\"../index.html\"", "class=\"symbol\""] {
        assert!(two_mass.contains(part), "the page lacks {part}");
    }
    // A machine with a field runs in its page, too.
    let shaft = page(&folders[0].join("machines/shaft_with_rotors.html"));
    assert!(!shaft.contains("cannot run it") && shaft.contains("id=\"live\""));
}

#[test]
fn a_report_by_an_algebra_that_is_named_leaves_emitted_files_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let specs = folder.path().join("specs");
    copy_specs(&specs);
    let [scenes, emitted] = [specs.join("scenes"), folder.path().join("emitted")];
    for file in names_in(&scenes).iter().filter(|file| *file != "two_mass.toml") {
        fs::remove_file(scenes.join(file)).expect("removed");
    }
    answer(&["gen", "--specs", text(&scenes), "--out", text(&emitted)]);
    let file = emitted.join("two_mass.rs");
    let before = fs::read_to_string(&file).expect("emitted").replace("Two", "Twin");
    fs::write(&file, &before).expect("written");
    let out = folder.path().join("out");
    let places = ["--specs", text(&scenes), "--emitted", text(&emitted), "--out", text(&out)];
    answer(&[&["report", "--no-times", "--algebra", "plain"], &places[..]].concat());
    assert_eq!(fs::read_to_string(&file).expect("still there"), before);
    assert!(page(&out.join("index.html")).contains("not compared"));
}

#[test]
fn a_machine_of_ones_own_gets_a_page_of_its_own() {
    let folder = tempfile::tempdir().expect("a folder");
    let winch = folder.path().join("winch.toml");
    // Text of users is escaped, even if it looks like a tag.
    let spec = include_str!("../../specs/scenes/drives/winch.toml");
    let spec = spec.replace("Winch that lifts", "<b>Winch</b> that lifts");
    fs::write(&winch, spec).expect("written");
    let out = folder.path().join("out");
    answer(&["report", text(&winch), "--no-times", "--out", text(&out)]);
    assert_eq!(names_in(&out), ["machines"]);
    let page = page(&out.join("machines/winch.html"));
    assert!(page.contains("&lt;b&gt;Winch&lt;/b&gt; that lifts") && !page.contains("<b>Winch"));
    for part in ["<title>rope: Rope that can go slack</title>", "brake.closes"] {
        assert!(page.contains(part), "the page lacks {part}");
    }
    let [checked, left_out] = counted(text(&winch));
    assert!(left_out == 0 && page.contains(&format!("<dd>{checked} / {checked}</dd>")));
    assert!(page.len() < 1_500_000);
    // The page is live: a slider for each parameter, and parts that turn and slide.
    let known = page.split("id=\"live-known\">").nth(1).and_then(|rest| rest.split('<').next());
    let known: serde_json::Value = serde_json::from_str(known.expect("data")).expect("JSON");
    let sliders = page.matches("class=\"slider\"").count();
    assert_eq!(Some(sliders), known["parameters"].as_array().map(|all| all.len() + 1));
    let moving = known["moving"]["parts"].as_array().expect("parts");
    assert!(moving.iter().any(|part| part["slides"] == true), "the load slides");
    assert!(moving.iter().any(|part| part["slides"] == false), "the motor turns");
}

#[test]
fn rows_that_are_left_out_are_counted_apart_and_say_why() {
    let folder = tempfile::tempdir().expect("a folder");
    let mass = folder.path().join("mass.toml");
    fs::write(&mass, WITHOUT_EVENTS).expect("written");
    let out = folder.path().join("out");
    answer(&["report", text(&mass), "--no-times", "--out", text(&out)]);
    let page = page(&out.join(format!("machines/{MASS}.html")));
    let [checked, left_out] = counted(text(&mass));
    assert!(page.contains(&format!("<dd>{checked} / {checked}</dd>")), "{checked} checks");
    assert!(left_out > 0 && page.contains(&format!("<dd class=\"note\">{left_out} left out</dd>")));
    assert!(page.contains(&format!("{left_out} rows cannot be asked of this machine")));
    assert_eq!(page.matches("<span class=\"muted\">left out</span>").count(), left_out);
    assert!(page.contains("the machine has no events"));
    assert!(!page.contains(">NaN<"));
}

#[test]
fn a_model_file_has_no_page() {
    let folder = tempfile::tempdir().expect("a folder");
    let model = folder.path().join("two_mass.model");
    answer(&["compile", "two_mass", "-o", text(&model)]);
    let out = folder.path().join("out");
    assert_refused(&["report", text(&model), "--out", text(&out)], &["no equations to show"]);
    assert!(!out.exists());
}

/// Returns the number of checks of `verify`, all of which pass, and the number left out.
fn counted(scene: &str) -> [usize; 2] {
    let table = answer(&["verify", scene]);
    let last = table.lines().last().expect("a line that counts");
    let words: Vec<&str> = last.split([' ', ',']).filter(|word| !word.is_empty()).collect();
    let [checked, "checks", "0", "failed", rest @ ..] = &words[..] else { panic!("{last}") };
    let left_out = rest.first().map_or(0, |count| count.parse().expect("a count"));
    [checked.parse().expect("a count"), left_out]
}

/// Asserts that links lead to a part of the page, or to a page beside it.
fn assert_links_lead_somewhere(file: &Path, page: &str) {
    for link in page.split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
        let leads = match link.strip_prefix('#') {
            Some(id) => page.contains(&format!("id=\"{id}\"")),
            None if link.starts_with("data:image/") => true,
            None => file.with_file_name(link).is_file(),
        };
        assert!(leads, "{}: {link}", file.display());
    }
}

/// Returns the text of a page, which must refer to nothing outside.
fn page(file: &Path) -> String {
    let page = fs::read_to_string(file).expect("a page");
    for reference in ["<link", " src=\"", "@import", "url(http"] {
        assert!(!outside_of_scripts(&page).contains(reference), "the page has {reference}");
    }
    page
}

/// Returns the page without the text of its scripts.
fn outside_of_scripts(page: &str) -> String {
    let mut pieces = page.split("<script");
    let mut text = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let (tag, rest) = piece.split_once('>').expect("the end of a tag");
        assert!(!tag.contains("src"), "a script from elsewhere: {tag}");
        text.push_str(rest.split_once("</script>").expect("the end of a script").1);
    }
    text
}
