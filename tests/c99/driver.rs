//! A driver program for emitted C: it reads time, state and parameters as binary numbers, and
//! writes the results of every function. With a step and a number of steps as arguments it runs the
//! machine, and writes time, state and results after each step.

use std::fmt::Write as _;

use machinist_codegen::emit::c99::Real;
use machinist_model::Model;
use machinist_model::functions::{FunctionId, FunctionRow, Gives, Reads};

/// Returns the emitted functions, in the order in which the program calls them.
pub fn functions(model: &Model) -> Vec<&'static FunctionRow> {
    // Emitted C has no series.
    let is_emitted =
        |row: &&FunctionRow| row.id != FunctionId::SaturatingArguments && (row.results)(model) > 0;
    model.functions().filter(is_emitted).collect()
}

/// Returns the source text of the program.
pub fn text(model: &Model, real: Real) -> String {
    let (name, real) = (&model.name, real.name());
    let [states, parameters] = [model.states.len(), model.parameters.len()];
    let count = 1 + states + parameters;
    let read = |what: &str, first: usize, count: usize| {
        // All members have the same type and are contiguous.
        let mut text = String::new();
        if count > 0 {
            let _ = writeln!(text, "        for (k = 0; k < {count}; ++k) {{");
            let _ = writeln!(text, "            numbers[k] = ({real})in[{first} + k];");
            let _ = writeln!(text, "        }}");
            let _ = writeln!(text, "        memcpy(&{what}, numbers, sizeof {what});");
        }
        text
    };
    let mut calls = String::new();
    for row in functions(model) {
        let length = (row.results)(model);
        let arguments = match row.reads {
            Reads::Motion => format!("({real})in[0], &y, &p, &c"),
            Reads::Parameters => "&p".to_owned(),
        };
        let (kind, of) = match row.gives {
            Gives::Numbers("STATES") => (format!("{name}_state_t r"), "&r"),
            Gives::Record(..) => (format!("{name}_outputs_t r"), "&r"),
            Gives::Structure(..) => (format!("{name}_{}_t r", row.name), "&r"),
            _ => (format!("{real} r[{length}]"), "r"),
        };
        let _ = writeln!(calls, "        {{\n            {kind};");
        let _ = writeln!(calls, "            {name}_{}({arguments}, {of});", row.name);
        let _ = writeln!(calls, "            put({of}, {length});\n        }}");
    }
    format!(
        "#include \"{name}.h\"\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n\n\
         static void put(const void *from, size_t count)\n{{\n    \
             size_t k;\n    \
             for (k = 0; k < count; ++k) {{\n        \
                 {real} number;\n        double wide;\n        \
                 memcpy(&number, (const char *)from + k * sizeof number, sizeof number);\n        \
                 wide = (double)number;\n        \
                 if (fwrite(&wide, sizeof wide, 1, stdout) != 1) {{\n            exit(1);\n        }}\n    \
             }}\n}}\n\n\
         static double in[{count}];\nstatic {real} numbers[{count}];\n\n\
         static int run(double step, long steps)\n{{\n    \
             {name}_machine_t machine;\n    double given = 0.0;\n    long k;\n    \
             {name}_begin(&machine);\n    \
             for (k = 0; k <= steps; ++k) {{\n        \
                 double time = (double)machine.time;\n        \
                 if (fwrite(&time, sizeof time, 1, stdout) != 1) {{\n            return 1;\n        }}\n        \
                 put(&machine.state, {states});\n        \
                 if (fwrite(&given, sizeof given, 1, stdout) != 1) {{\n            return 1;\n        }}\n        \
                 given = {name}_step(&machine, ({real})step);\n    \
             }}\n    return 0;\n}}\n\n\
         int main(int argc, char **argv)\n{{\n    \
             {name}_state_t y;\n    {name}_parameters_t p;\n    {name}_constants_t c;\n    size_t k;\n    \
             memset(&p, 0, sizeof p);\n    \
             if (argc > 2) {{\n        return run(strtod(argv[1], NULL), strtol(argv[2], NULL, 10));\n    }}\n    \
             while (fread(in, sizeof in[0], {count}, stdin) == {count}) {{\n\
         {}{}        {name}_prepare(&p, &c);\n{calls}        fflush(stdout);\n    }}\n    \
             return 0;\n}}\n",
        read("y", 1, states),
        read("p", 1 + states, parameters),
    )
}
