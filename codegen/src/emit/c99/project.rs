//! A CMake file for the emitted C, and an example program.

use std::fmt::Write as _;

use super::layout::comment;
use super::{MARK, Scene};
use crate::emit::EmitError;

/// Returns the CMake file.
pub(super) fn cmake(scene: &Scene<'_>) -> String {
    let name = &scene.model.name;
    format!(
        "# {MARK} {}; do not edit.\n\
         cmake_minimum_required(VERSION 3.10)\n\
         project({name} C)\n\
         \n\
         add_library({name} STATIC {name}.c {name}.h)\n\
         target_include_directories({name} PUBLIC ${{CMAKE_CURRENT_SOURCE_DIR}})\n\
         set_target_properties({name} PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON C_EXTENSIONS OFF)\n\
         if(CMAKE_C_COMPILER_ID MATCHES \"GNU|Clang\")\n  \
           # The last keeps products and sums apart, as other compilers and emitted Rust have them.\n  \
           target_compile_options({name} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -ffp-contract=off)\n\
         endif()\n\
         if(CMAKE_C_COMPILER_ID STREQUAL \"GNU\")\n  \
           # Orders long functions for few registers; faster, with the same results.\n  \
           target_compile_options({name} PRIVATE -fschedule-insns -fsched-pressure)\n  \
           # States the stack of every function in {name}.c.su, beside the object.\n  \
           target_compile_options({name} PRIVATE -fstack-usage)\n\
         endif()\n\
         if(UNIX)\n  \
           target_link_libraries({name} PUBLIC m)\n\
         endif()\n\
         \n\
         add_executable({name}_example {name}_example.c)\n\
         set_target_properties({name}_example PROPERTIES C_STANDARD 99 C_STANDARD_REQUIRED ON)\n\
         target_link_libraries({name}_example PRIVATE {name})\n",
        env!("CARGO_PKG_VERSION")
    )
}

/// Default number of steps between two rows of the example's output.
const STEPS_A_ROW: usize = 10;

/// Returns a program that runs the machine and prints a table.
pub(super) fn example(scene: &Scene<'_>) -> Result<String, EmitError> {
    let (model, name) = (scene.model, &scene.model.name);
    let rows = model.run.points.max(2) - 1;
    let span = model.run.until - model.run.from;
    let place = "run".to_owned();
    let span_text = scene.options.real.literal(span);
    let span_text = span_text.ok_or(EmitError::NotFinite { place, value: span })?;
    let has_outputs = !model.wanted.is_empty();
    let (columns, of): (Vec<_>, _) = if has_outputs {
        let columns = scene.output_members.iter().zip(&model.wanted);
        (columns.map(|(member, output)| (member, output.name.path.as_str())).collect(), "outputs")
    } else {
        let columns = scene.state_members.iter().zip(&model.states);
        let columns = columns.map(|(member, state)| (member, state.quantity.name.path.as_str()));
        (columns.collect(), "machine.state")
    };
    let mut titles = String::new();
    let mut values = String::new();
    for (member, path) in columns {
        let _ = writeln!(titles, "    (void)printf(\",{}\");", path.replace(['%', '"', '\\'], "_"));
        let _ = writeln!(values, "        (void)printf(\",%.9g\", (double){of}.{member});");
    }
    let (outputs, compute) = if has_outputs {
        let outputs = format!("    {name}_outputs_t outputs;\n");
        let of = "&machine.state, &machine.p, &machine.c, &outputs";
        (outputs, format!("        {name}_outputs(machine.time, {of});\n"))
    } else {
        (String::new(), String::new())
    };
    let real = scene.real();
    let about = [
        format!("{MARK} {}; do not edit.", env!("CARGO_PKG_VERSION")),
        String::new(),
        format!(
            "Runs {name} over the time of its spec and prints a table. The argument is the number \
             of steps between two rows, {STEPS_A_ROW} unless given."
        ),
    ];
    Ok(format!(
        "{}#include \"{name}.h\"\n\n#include <stdio.h>\n#include <stdlib.h>\n\n\
         int main(int count, char **arguments)\n{{\n    \
         const long rows = {rows};\n    \
         const long steps = (count > 1) ? strtol(arguments[1], NULL, 10) : {STEPS_A_ROW};\n    \
         {name}_machine_t machine;\n{outputs}    \
         long row, step;\n\n    \
         if (steps < 1) {{\n        \
             (void)fputs(\"the number of steps must be 1 or more\\n\", stderr);\n        \
             return EXIT_FAILURE;\n    }}\n    \
         {name}_begin(&machine);\n    \
         (void)printf(\"time\");\n{titles}    (void)printf(\"\\n\");\n    \
         for (row = 0; row <= rows; ++row) {{\n{compute}        \
             (void)printf(\"%.9g\", (double)machine.time);\n{values}        (void)printf(\"\\n\");\n        \
             for (step = 0; (step < steps) && (row < rows); ++step) {{\n            \
                 if ({name}_step(&machine, {span_text} / ({real})(rows * steps)) < 0) {{\n                \
                     (void)fputs(\"more events in a step than may be\\n\", stderr);\n            }}\n        \
             }}\n    \
         }}\n    \
         return EXIT_SUCCESS;\n}}\n",
        comment(about)
    ))
}
