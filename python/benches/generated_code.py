"""Nanoseconds of one rate and of one Jacobian: emitted C, emitted Rust, and CasADi's generated C.

    MACHINIST=target/release/machinist python python/benches/generated_code.py

gcc and cargo are needed; CasADi is left out if it is not installed. Everything is compiled for this
processor, and called through the same loop by a function pointer, over sixteen states by turns.
Rounds of all candidates alternate, with the stack at each of four places within a line of the cache:
the fastest round at each place counts, at the place where that is slowest. Values of all
candidates are compared before they are timed.
"""

from __future__ import annotations

import ctypes
import math
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
MACHINIST = os.environ.get("MACHINIST", "machinist")
STATES, ROUNDS = 16, 120
# Bytes of a line of the cache, and the places in it at which the stack may be.
LINE, PLACES = 64, 4
COLUMNS = ["C", "C fused", "C clang", "Rust", "CasADi"]
SCENES = {"m1": "M1", "m2": "M2", "m6_5": "M65"}
FLAGS = ["-O3", "-march=native", "-shared", "-fPIC", "-fno-semantic-interposition", "-w"]
OPTIMIZED = ["gcc", *FLAGS]
# Of the emitted CMake file.
SCHEDULED = ["-fschedule-insns", "-fsched-pressure"]

LOOP = """
#include <alloca.h>
#include <time.h>
typedef void function_t(double t, const double *y, double *values);
double seconds(function_t *call, const double *states, int n, double *values, long count, int place)
{
    struct timespec start, end;
    long k;
    /* Moves the stack to this place in a line of the cache. */
    char *moved = alloca(LINE + ((unsigned long)__builtin_frame_address(0) + place) % LINE);
    __asm__ volatile("" : : "r"(moved) : "memory");
    clock_gettime(CLOCK_MONOTONIC, &start);
    for (k = 0; k < count; ++k) {
        const long turn = k % %d;
        call(0.01 * (double)turn, states + turn * n, values);
        __asm__ volatile("" : : "r"(values) : "memory");
    }
    clock_gettime(CLOCK_MONOTONIC, &end);
    return (double)(end.tv_sec - start.tv_sec) + 1e-9 * (double)(end.tv_nsec - start.tv_nsec);
}
""".replace("%d", str(STATES)).replace("LINE", str(LINE))

SHIM = """
#include "NAME.c"
static NAME_parameters_t p;
static NAME_constants_t c;
void begin(void) { NAME_default_parameters(&p); NAME_prepare(&p, &c); }
void rate(double t, const double *y, double *values)
{
    NAME_rate(t, (const NAME_state_t *)y, &p, &c, (NAME_state_t *)values);
}
void jacobian(double t, const double *y, double *values)
{
    NAME_rate_jacobian(t, (const NAME_state_t *)y, &p, &c, values);
}
int nonzeros(void) { return (int)(sizeof NAME_rate_jacobian_rows / sizeof NAME_rate_jacobian_rows[0]); }
int row(int k) { return (int)NAME_rate_jacobian_rows[k]; }
int column(int k) { return (int)NAME_rate_jacobian_columns[k]; }
"""

RUST = """
pub mod NAME {
    use machinist_contract::{Describe as _, Simulator as _};
    #[path = "PATH"]
    #[allow(warnings)]
    pub mod module;
    static mut P: [f64; 64] = [0.0; 64];
    static mut C: [f64; 64] = [0.0; 64];
    const MACHINE: module::TYPE = module::TYPE;
    #[no_mangle]
    pub unsafe extern "C" fn NAME_begin() {
        let count = MACHINE.shape().parameters;
        for index in 0..count {
            P[index] = MACHINE.parameter_default(index);
        }
        let constants = machinist_contract::Simulator::<f64>::constants(&MACHINE);
        let (p, c) = (&*(&raw const P), &mut *(&raw mut C));
        MACHINE.prepare(&p[..count], &mut c[..constants]);
    }
    unsafe fn known() -> (&'static [f64], &'static [f64]) {
        let constants = machinist_contract::Simulator::<f64>::constants(&MACHINE);
        (&(&*(&raw const P))[..MACHINE.shape().parameters], &(&*(&raw const C))[..constants])
    }
    #[no_mangle]
    pub unsafe extern "C" fn NAME_rate(t: f64, y: *const f64, values: *mut f64) {
        let ((p, c), states) = (known(), MACHINE.shape().states());
        let y = core::slice::from_raw_parts(y, states);
        MACHINE.prepared_rate(t, y, p, c, core::slice::from_raw_parts_mut(values, states));
    }
    #[no_mangle]
    pub unsafe extern "C" fn NAME_jacobian(t: f64, y: *const f64, values: *mut f64) {
        let ((p, c), states) = (known(), MACHINE.shape().states());
        let y = core::slice::from_raw_parts(y, states);
        let nonzeros = MACHINE.rate_jacobian_pattern().entries.len();
        let values = core::slice::from_raw_parts_mut(values, nonzeros);
        MACHINE.prepared_rate_jacobian(t, y, p, c, values);
    }
}
"""


def emitted_c(name: str, folder: pathlib.Path, contraction: str, compiler: str = "gcc"):
    """Compiles emitted C; returns the library and the names of the states."""
    scene = REPOSITORY / "specs/scenes/bench" / f"{name}.toml"
    written = folder / f"c_{name}"
    if not written.exists():
        # Of the equations that the Rust in the repository is emitted from.
        command = [MACHINIST, "gen", "--target", "c99", "--algebra", "symbolica", str(scene), "-o", str(written)]
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        (written / "shim.c").write_text(SHIM.replace("NAME", name))
    library = written / f"{compiler}_{contraction}.so"
    flags = [*FLAGS, "-std=c99", f"-ffp-contract={contraction}", *(SCHEDULED if compiler == "gcc" else [])]
    subprocess.run([compiler, *flags, "shim.c", "-o", library, "-lm"], check=True, cwd=written)
    header = (written / f"{name}.h").read_text()
    states = re.search(r"typedef struct \{\n((?:(?!typedef).)*?)\} " + name + "_state_t;", header, re.S)
    members = re.findall(r"/\* ([\w.]+)[: \[]", states.group(1))
    return ctypes.CDLL(str(library)), members


def emitted_rust(folder: pathlib.Path):
    crate = folder / "rust"
    (crate / "src").mkdir(parents=True)
    contract = REPOSITORY / "crates/contract"
    (crate / "Cargo.toml").write_text(
        '[package]\nname = "emitted"\nversion = "0.1.0"\nedition = "2021"\n[lib]\ncrate-type = ["cdylib"]\n'
        f'[dependencies]\nmachinist-contract = {{ path = "{contract}" }}\n'
        '[profile.release]\ncodegen-units = 1\nlto = "fat"\n[workspace]\n'
    )
    modules = [
        RUST.replace("NAME", name).replace("TYPE", kind).replace(
            "PATH", str(REPOSITORY / "generated/bench/src/scenes" / f"{name}.rs"))
        for name, kind in SCENES.items()
    ]
    (crate / "src/lib.rs").write_text("".join(modules))
    environment = {**os.environ, "RUSTFLAGS": "-C target-cpu=native -A warnings", "CARGO_TARGET_DIR": str(crate / "target")}
    for name in ("RUSTC_WRAPPER", "RUSTC_WORKSPACE_WRAPPER", "CLIPPY_ARGS"):
        environment.pop(name, None)
    subprocess.run(["cargo", "build", "--release", "--quiet"], check=True, cwd=crate, env=environment)
    return ctypes.CDLL(str(crate / "target/release/libemitted.so"))


def equations(name: str, ca, y: dict, t):
    """The equations of a model in CasADi, from its definition in words; in the order of `y`."""
    if name.startswith("m6"):
        count = len(y) // 2
        angle = ca.vertcat(*[y[f"chain.theta_{k + 1}"] for k in range(count)])
        speed = ca.vertcat(*[y[f"chain.omega_{k + 1}"] for k in range(count)])
        kinetic = potential = across = down = height = 0
        for k in range(count):
            across = across + ca.cos(angle[k]) * speed[k]
            down = down + ca.sin(angle[k]) * speed[k]
            height = height - ca.cos(angle[k])
            kinetic = kinetic + (across**2 + down**2) / 2
            potential = potential + 9.81 * height
        lagrangian = kinetic - potential
        momentum = ca.gradient(lagrangian, speed)
        mass = ca.jacobian(momentum, speed)
        force = ca.gradient(lagrangian, angle) - ca.jtimes(momentum, angle, speed)
        factors = ca.ldl(mass)
        acceleration = ca.ldl_solve(force, *factors)
        return {f"chain.theta_{k + 1}": speed[k] for k in range(count)} | {
            f"chain.omega_{k + 1}": acceleration[k] for k in range(count)
        }
    line, poles, voltage = 100 * ca.pi, 4.0, 220 * 2**0.5
    k_r, k_s, reactance, stator, rotor, inertia = 0.952, 0.956, 4.14, 0.115, 0.0858, 4.20
    leakage = 1 - k_r * k_s
    names = ["motor.psi_sx", "motor.psi_sy", "motor.psi_rx", "motor.psi_ry"]
    sx, sy, rx, ry = (y[key] for key in names)
    speed = y["motor.omega"]
    slip = line - poles * speed
    a, b = line * stator, line * rotor
    rates = dict(zip(names, [
        voltage - a * sx + a * k_r * rx + line * sy,
        -a * sy + a * k_r * ry - line * sx,
        -b * rx + b * k_s * sx + slip * ry,
        -b * ry + b * k_s * sy - slip * rx,
    ]))
    torque = 1.5 * poles * k_r * line / (leakage * reactance) * (rx * sy - sx * ry)
    if name == "m1":
        return rates | {"motor.omega": torque / inertia}
    twist, driven = y["coupling.twist"], y["cylinder.omega"]
    coupling = 23065.2 * twist + 128.5346 * (speed - driven)
    switched = 1 / (1 + ca.exp(-(t - 1.2) / 0.02))
    load = switched * (843.72 + 78.78 * ca.sin(ca.pi**2 * 735 / 30 * t)) * ca.tanh(driven / 0.5)
    return rates | {
        "coupling.twist": speed - driven,
        "motor.omega": (torque - coupling) / inertia,
        "cylinder.omega": (coupling - load) / 1.244,
        "cylinder.phi": driven,
    }


def casadi_c(name: str, names: list[str], folder: pathlib.Path):
    try:
        import casadi as ca
    except ImportError:
        return None
    t, y = ca.SX.sym("t"), ca.SX.sym("y", len(names))
    rates = equations(name, ca, {key: y[k] for k, key in enumerate(names)}, t)
    rate = ca.vertcat(*[rates[key] for key in names])
    jacobian = ca.jacobian(rate, y)
    generator = ca.CodeGenerator("casadi_code", {"with_header": False})
    shims = "#include <string.h>\n"
    for key, value in [("rate", rate), ("jacobian", jacobian)]:
        function = ca.Function(f"of_{key}", [t, y], [value], {"cse": True})
        generator.add(function)
        shims += (
            f"__attribute__((flatten)) void {key}(double t, const double *y, double *values)\n{{\n"
            f"    const double *from[{function.sz_arg() + 2}] = {{&t, y}};\n"
            f"    double *to[{function.sz_res() + 1}] = {{values}};\n"
            f"    static long long whole[{function.sz_iw() + 1}];\n    static double work[{function.sz_w() + 1}];\n"
            f"    of_{key}(from, to, whole, work, 0);\n}}\n"
        )
    source = folder / f"casadi_{name}.c"
    source.write_text(generator.dump() + shims)
    library = source.with_suffix(".so")
    subprocess.run([*OPTIMIZED, str(source), "-o", str(library), "-lm"], check=True)
    rows, columns = jacobian.sparsity().get_triplet()
    return ctypes.CDLL(str(library)), list(zip(rows, columns))


def aligned(values: list[float]):
    """Returns numbers for C that start with a line of the cache."""
    room = ctypes.create_string_buffer(8 * len(values) + LINE)
    numbers = (ctypes.c_double * len(values)).from_buffer(room, -ctypes.addressof(room) % LINE)
    numbers[:] = values
    return numbers


def main() -> None:
    folder = pathlib.Path(tempfile.mkdtemp())
    (folder / "loop.c").write_text(LOOP)
    subprocess.run([*OPTIMIZED, str(folder / "loop.c"), "-o", str(folder / "loop.so")], check=True)
    seconds = ctypes.CDLL(str(folder / "loop.so")).seconds
    seconds.restype = ctypes.c_double
    rust = emitted_rust(folder)
    print(f"{'':<14}" + "".join(f"{key:>10}" for key in COLUMNS) + "  [ns]  slower of ours, over the fastest")
    for name in SCENES:
        plain, names = emitted_c(name, folder, "off")
        fused, _ = emitted_c(name, folder, "fast")
        by_clang = emitted_c(name, folder, "fast", "clang")[0] if shutil.which("clang") else None
        for library in (plain, fused, by_clang):
            if library:
                library.begin()
        getattr(rust, f"{name}_begin")()
        casadi = casadi_c(name, names, folder)
        n, nonzeros = len(names), plain.nonzeros()
        places = [(plain.row(k), plain.column(k)) for k in range(nonzeros)]
        sizes = {"motor.omega": 78.5, "cylinder.omega": 78.5, "coupling.twist": 0.03}
        states = aligned([
            0.3 * sizes.get(key, 1.0) * math.sin(0.8 * (1 + index + 0.3 * turn))
            for turn in range(STATES) for index, key in enumerate(names)
        ])
        for what, count in [("rate", n), ("jacobian", nonzeros)]:
            calls = {
                "C": getattr(plain, what),
                "C fused": getattr(fused, what),
                "Rust": getattr(rust, f"{name}_{what}"),
            }
            if by_clang:
                calls["C clang"] = getattr(by_clang, what)
            if casadi:
                calls["CasADi"] = getattr(casadi[0], what)
            values = {}
            for key, call in calls.items():
                out = (ctypes.c_double * max(count, 4 * n * n))()
                call.argtypes = [ctypes.c_double, ctypes.c_void_p, ctypes.c_void_p]
                call.restype = None
                call(0.07, ctypes.addressof(states) + 8 * n * 7, ctypes.addressof(out))
                if key == "CasADi" and what == "jacobian":
                    found = dict(zip(casadi[1], out))
                    values[key] = [found.get(place, 0.0) for place in places]
                else:
                    values[key] = list(out)[:count]
            largest = max(abs(x) for x in values["C"])
            for key, found in values.items():
                off = max(abs(a - b) for a, b in zip(found, values["C"]))
                assert off < 1e-9 * largest, f"{name}: {what} of {key} is off by {off:e} of {largest:e}"
            times = {key: [] for key in calls}
            out = aligned([0.0] * (4 * n * n))
            for turn in range(ROUNDS):
                order = list(calls) if turn // PLACES % 2 else list(calls)[::-1]
                place = LINE // PLACES * (turn % PLACES)
                for key in order:
                    took = seconds(calls[key], states, n, out, ctypes.c_long(10000), place)
                    times[key].append(took / 10000 * 1e9)
            found = {
                key: max(min(values[place::PLACES]) for place in range(PLACES))
                for key, values in times.items()
            }
            cells = "".join(f"{found[key]:>10.1f}" if key in found else f"{'-':>10}" for key in COLUMNS)
            of_c = min(found[key] for key in ("C fused", "C clang") if key in found)
            ours = max(of_c, found["Rust"])
            print(f"{name + ' ' + what:<14}{cells}        {ours / min(found.values()):.2f}")
            sys.stdout.flush()


if __name__ == "__main__":
    main()
