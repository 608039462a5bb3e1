//! Checks that the scenes that come with Machinist are those of the folder of specs.

use std::path::{Path, PathBuf};

use machinist_codegen::scene::compose;
use machinist_codegen::scene::system::LagrangianSystem;
use machinist_codegen::spec::diagnostic::Diagnostics;
use machinist_codegen::spec::library::{LibraryScene, MACHINES, SCENES};
use machinist_codegen::spec::{SceneSpec, load_library_scene, load_scene};

/// Returns a system without the paths of its files.
fn system(spec: Result<SceneSpec, Diagnostics>) -> LagrangianSystem {
    let mut system =
        spec.and_then(|spec| compose(&spec)).unwrap_or_else(|e| panic!("{}", e.render()));
    system.files.iter_mut().for_each(|file| file.path = PathBuf::new());
    system
}

#[test]
fn every_scene_of_the_folder_comes_with_machinist_and_is_the_same_without_its_files() {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../specs/scenes");
    let mut found = 0;
    let folders = ["bench", "drives", "gallery"].map(|folder| scenes.join(folder));
    for folder in std::iter::once(scenes).chain(folders) {
        for entry in std::fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.extension().is_none_or(|ending| ending != "toml") {
                continue;
            }
            let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
            let scene = LibraryScene::find(&name);
            let scene = scene.unwrap_or_else(|| panic!("{name} is not in the library"));
            let [built_in, file] = [load_library_scene(scene), load_scene(&path)].map(system);
            assert!(built_in == file, "{name}");
            assert_eq!(built_in.name, name);
            found += 1;
        }
    }
    assert_eq!(found, SCENES.len() + MACHINES.len());
}
