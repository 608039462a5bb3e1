//! Whether this package stands alone, and so has the template of `machinist new` within it.

use std::path::Path;

fn main() {
    println!("cargo:rustc-check-cfg=cfg(packed)");
    println!("cargo:rerun-if-changed=build.rs");
    if !Path::new("../examples/own_machine/Cargo.toml").is_file() {
        println!("cargo:rustc-cfg=packed");
    }
}
