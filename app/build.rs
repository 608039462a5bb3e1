//! Detects whether this package was packed alone and contains the template of `machinist new`.

use std::path::Path;

fn main() {
    println!("cargo:rustc-check-cfg=cfg(packed)");
    println!("cargo:rerun-if-changed=build.rs");
    if !Path::new("../examples/own_machine/Cargo.toml").is_file() {
        println!("cargo:rustc-cfg=packed");
    }
}
