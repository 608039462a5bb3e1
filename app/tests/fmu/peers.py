"""Archives by FMPy: validated, simulated by both interfaces, compared with a run of our own.

peers.py ARCHIVE.fmu RUN.csv ... ends with 1 if an archive has a problem, or if an output is off by
more than 1e-6 of its range. Archives of sources are compiled first, without a warning. Their
Co-Simulation takes fixed steps: its error is below 2e-4 and falls with the step.
"""

import csv
import os
import shutil
import subprocess
import sys
import tempfile
import warnings
import zipfile

import fmpy
import numpy
from fmpy.validation import validate_fmu
from lxml import etree

WORST = 1e-6
WORST_BY_FIXED_STEPS = 2e-4
STRICT = "-std=c99 -O2 -Wall -Wextra -Wpedantic -Wconversion -Werror -ffp-contract=off -shared -fPIC"
# Errors of CVode add up where nothing is damped; there it is asked once more.
TOLERANCES = [1e-12, 1e-13]


def table(path):
    with open(path, newline="") as file:
        rows = list(csv.reader(file))
    names = [name.split(" [")[0] for name in rows[0]]
    return dict(zip(names, numpy.array(rows[1:], dtype=float).T))


def is_mode(found, exact):
    return numpy.issubdtype(found.dtype, numpy.integer) or set(exact) <= {-1.0, 0.0, 1.0, 2.0}


def largest_error(found, run):
    """Over ranges; but for up to two points at which a mode changes, where all may be as before it
    or as behind it."""
    time = next(iter(run.values()))
    rows = numpy.minimum(numpy.searchsorted(time, found["time"] - 1e-9), len(time) - 1)
    known = numpy.abs(time[rows] - found["time"]) < 1e-9
    names = found.dtype.names[1:]
    changes = numpy.zeros(len(rows), dtype=bool)
    for name in names:
        if is_mode(found[name], run[name]):
            changes |= known & (numpy.abs(run[name][rows] - found[name]) >= 0.4)
    if changes.sum() <= 2:
        known &= ~changes
    worst = (0.0, "")
    for name in names:
        exact = run[name]
        size = numpy.ptp(exact)
        size = max(size, 1e-6 * numpy.abs(exact).max(), 1e-300)
        error = numpy.abs(exact[rows] - found[name])[known] / size
        if error.size and error.max() > worst[0]:
            worst = (error.max(), name)
    return worst


def problems_of_terminals(archive):
    """By the schema of the standard; variables are those of the description."""
    with zipfile.ZipFile(archive) as files:
        name = "terminalsAndIcons/terminalsAndIcons.xml"
        if name not in files.namelist():
            return []
        terminals = etree.fromstring(files.read(name))
    folder = os.path.join(os.path.dirname(fmpy.__file__), "schema", "fmi3")
    schema = etree.XMLSchema(file=os.path.join(folder, "fmi3TerminalsAndIcons.xsd"))
    schema.validate(terminals)
    problems = [str(error) for error in schema.error_log]
    known = {v.name: v for v in fmpy.read_model_description(archive).modelVariables}
    for member in terminals.iter("TerminalMemberVariable"):
        variable = known.get(member.get("variableName"))
        if variable is None or variable.causality not in ("input", "output"):
            problems.append(f"{member.get('variableName')} is no input or output")
    names = [terminal.get("name") for terminal in terminals.iter("Terminal")]
    if len(names) != len(set(names)):
        problems.append(f"terminals are named twice: {names}")
    print(f"{archive}: terminals {', '.join(names)}")
    return problems


def compiled(archive, folder):
    """Unpacks an archive and compiles its sources, with the headers of the standard that FMPy has.
    Returns the folder; None if there is no compiler."""
    compiler = shutil.which("cc") or shutil.which("gcc") or shutil.which("clang")
    if compiler is None:
        return None
    fmpy.extract(archive, folder)
    description = fmpy.read_model_description(archive)
    name = description.modelExchange.modelIdentifier
    files = description.buildConfigurations[0].sourceFileSets[0].sourceFiles
    is_2 = description.fmiVersion == "2.0"
    binaries = os.path.join(folder, "binaries", fmpy.platform if is_2 else fmpy.platform_tuple)
    os.makedirs(binaries)
    headers = os.path.join(os.path.dirname(fmpy.__file__), "c-code")
    out = os.path.join(binaries, name + fmpy.sharedLibraryExtension)
    sources = [os.path.join(folder, "sources", file) for file in files]
    command = [compiler, *STRICT.split(), "-isystem", headers, "-o", out, *sources, "-lm"]
    subprocess.run(command, check=True)
    return folder


def problems_of_steps(folder, description, run):
    """Errors of Co-Simulation by fixed steps, as they are and of a quarter."""
    experiment = description.defaultExperiment
    by_name = {v.name: v for v in description.modelVariables}
    step = float(by_name["fixed_step"].start)
    errors = []
    for size in [step, step / 4]:
        values = {"fixed_step": size}
        found = simulated(folder, "CoSimulation", experiment, 1e-6, values)
        error, name = largest_error(found, run)
        print(f"{folder}: CoSimulation by steps of {size:.1e} s: {error:.1e} ({name})")
        errors.append(error)
    # Of fourth order, and of second where branches change within steps: at least 16 times less, but
    # for what is at the error of the run.
    if errors[0] < WORST_BY_FIXED_STEPS and errors[1] < max(errors[0] / 8, WORST):
        return []
    return [f"errors of Co-Simulation {errors}"]


def simulated(archive, interface, experiment, tolerance, start_values={}):
    """FMPy's CVode takes 500 steps at most from output to output: where that is too few there are
    more outputs."""
    for more in [1, 16, 256]:
        try:
            return fmpy.simulate_fmu(
                archive,
                fmi_type=interface,
                stop_time=float(experiment.stopTime),
                output_interval=float(experiment.stepSize) / more,
                relative_tolerance=tolerance,
                record_events=False,
                start_values=start_values,
            )
        except RuntimeError as error:
            if "mxstep" not in str(error):
                raise
    raise RuntimeError(f"{archive}: too stiff for CVode")


def main(arguments):
    warnings.simplefilter("error")
    failed = False
    for archive, run in zip(arguments[::2], arguments[1::2]):
        problems = validate_fmu(archive) + problems_of_terminals(archive)
        description = fmpy.read_model_description(archive)
        experiment = description.defaultExperiment
        run = table(run)
        interfaces = ["CoSimulation", "ModelExchange"]
        with tempfile.TemporaryDirectory() as folder:
            unit = archive
            if description.buildConfigurations:
                unit = compiled(archive, folder)
                if unit is None:
                    print(f"{archive}: skipped: there is no C compiler")
                    interfaces = []
                else:
                    problems += problems_of_steps(unit, description, run)
                    interfaces = ["ModelExchange"]
            for interface in interfaces:
                for tolerance in TOLERANCES:
                    found = simulated(unit, interface, experiment, tolerance)
                    error, name = largest_error(found, run)
                    print(f"{archive}: {interface} at {tolerance:.0e}: {error:.1e} ({name})")
                    if error < WORST:
                        break
                failed |= not error < WORST
        for problem in problems:
            print(f"{archive}: {problem}")
            failed = True
    return failed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
