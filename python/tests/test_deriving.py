"""Specs derived in the process: equal models, errors, warnings, signals, threads."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import warnings
from pathlib import Path

import numpy as np
import pytest

import machinist

PENDULUM = """
[scene]
name = "bob"
[units]
bob = {{ unit = "bob" }}
[define.bob]
parameters = {{ mass = {{ value = 1.0, unit = "kg" }}, length = {{ value = {length}, unit = "m" }} }}
coordinates = {{ angle = {{ unit = "rad" }} }}
[define.bob.energy]
kinetic = "mass*(length*angle_dot)^2/2"
potential = "mass*9.81 [m/s^2]*length*(1 - cos(angle))"
[initial]
"bob.angle" = 0.1
[outputs]
angle = "bob.angle"
[run]
until = 2.0
points = 101
"""


def chain(rotors: int) -> str:
    """Spec of a chain of rotors and springs."""
    lines = ["joints = ["]
    for n in range(rotors - 1):
        lines.append(f'{{ connect = ["r{n}.b", "s{n}.a"] }}, {{ connect = ["s{n}.b", "r{n + 1}.a"] }},')
    lines += ["]", "[scene]", 'name = "chain"', "[units]"]
    lines += [f'r{n} = {{ unit = "rotational/inertia" }}' for n in range(rotors)]
    lines += [f's{n} = {{ unit = "rotational/spring_damper" }}' for n in range(rotors - 1)]
    lines += ["[outputs]", f'speed = "r{rotors - 1}.omega"', "[run]", "until = 1.0", "points = 3"]
    return "\n".join(lines)


@pytest.fixture
def no_cache(tmp_path, monkeypatch):
    monkeypatch.setenv("MACHINIST_CACHE", str(tmp_path / "cache"))


def test_a_spec_needs_no_program(tmp_path, monkeypatch, no_cache):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.delenv("MACHINIST", raising=False)
    for length in (0.7, 1.3):
        file = tmp_path / f"bob_{length}.toml"
        file.write_text(PENDULUM.format(length=length))
        bob = machinist.load(file)
        run = bob.simulate(rtol=1e-10)
        # Frequency of small oscillations, corrected for the amplitude: 1 - a^2/16.
        frequency = np.sqrt(9.81 / length) * (1 - 0.1**2 / 16)
        np.testing.assert_allclose(run["angle"], 0.1 * np.cos(frequency * run.t), atol=1e-4)
    assert any((tmp_path / "cache").iterdir()), "derived models are cached"


def test_a_file_that_changed_is_derived_again(tmp_path):
    file = tmp_path / "bob.toml"
    found = []
    for length in (0.7, 1.3, 0.7):
        file.write_text(PENDULUM.format(length=length))
        found.append(machinist.load(str(file)))
    assert found[0] is found[2] and found[0] is not found[1]
    assert found[1].parameters["bob.length"].value == 1.3


def test_every_mistake_has_its_place_and_the_text_around_it(tmp_path):
    file = tmp_path / "specs" / "bad.toml"
    file.parent.mkdir()
    text = PENDULUM.format(length=1).replace('angle = "bob.angle"', 'a = "bob.angel"\nb = "bob.mas"')
    file.write_text(text)
    with pytest.raises(machinist.SpecError) as told:
        machinist.load(file)
    error = told.value
    hints = ["did you mean `angle`?", "did you mean `mass`?"]
    assert [mistake.hint for mistake in error.mistakes] == hints
    assert [mistake.code for mistake in error.mistakes] == ["spec::unknown-name"] * 2
    for mistake, name in zip(error.mistakes, ("bob.angel", "bob.mas"), strict=True):
        assert mistake.file == str(file)
        line = text.splitlines()[mistake.line - 1]
        assert line[mistake.column - 1 :][: mistake.length] == name
        assert name.removeprefix("bob.") in mistake.message and name in mistake.report
    assert (error.file, error.line, error.hint, error.code) == (
        str(file), error.mistakes[0].line, error.mistakes[0].hint, error.mistakes[0].code,
    )  # fmt: skip
    assert str(error).startswith(f"{file}:{error.line}: ")
    again = pickle.loads(pickle.dumps(error))
    assert again.mistakes == error.mistakes and again.report == error.report


def test_a_mistake_in_a_unit_names_the_file_of_the_unit(tmp_path):
    unit = tmp_path / "units" / "bob.toml"
    scene = tmp_path / "scenes" / "swing.toml"
    for folder in (unit.parent, scene.parent):
        folder.mkdir()
    before, own = PENDULUM.format(length=1).split("[define.bob]\n")
    inside, _, after = own.partition("[initial]")
    wrong = inside.replace("length*", "lenght*").replace("[define.bob.energy]", "[energy]")
    wrong += '[unit]\nname = "bob"\ntitle = "A bob"\n'
    unit.write_text(wrong)
    scene.write_text(f"{before}[initial]{after}")
    with pytest.raises(machinist.SpecError) as told:
        machinist.load(scene)
    place = 1 + next(n for n, line in enumerate(wrong.splitlines()) if "lenght" in line)
    assert (Path(told.value.file), told.value.line) == (unit, place), told.value.report


@pytest.mark.parametrize("content", [b"", b"[scene", b"\xff\xfe", b"a = 1\n" * 200_000])
def test_what_is_no_spec_is_refused(tmp_path, content):
    file = tmp_path / "odd.toml"
    file.write_bytes(content)
    with pytest.raises(machinist.SpecError) as told:
        machinist.load(file)
    assert told.value.file == str(file)


def test_a_missing_file_and_a_folder_are_refused(tmp_path):
    with pytest.raises(machinist.ModelFileError, match="No such file"):
        machinist.load(tmp_path / "missing.toml")
    with pytest.raises(machinist.ModelFileError):
        machinist.load(f"{tmp_path}/")


def test_warnings_of_a_spec_are_warnings_of_python(tmp_path):
    table = tmp_path / "push.csv"
    rows = [f"{t},{int(t > 3)}" for t in (0, 1, 2, 3, 3.01, 4, 5, 6)]
    table.write_text("\n".join(["time [s],push [1]", *rows]) + "\n")
    file = tmp_path / "pushed.toml"
    drop = "[outputs.push]\nexpression = 'table(\"push.csv\", \"push\", t)'\nunit = \"1\"\n[outputs]\n"
    file.write_text(PENDULUM.format(length=1).replace("[outputs]\n", drop))
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        machinist.load(file)
    (one,) = told
    assert isinstance(one.message, machinist.SpecWarning)
    assert one.filename == __file__
    mistake = one.message.mistake
    assert (Path(mistake.file), mistake.line) == (table, 4)
    assert "monotone" in mistake.hint and "push.csv" in mistake.report


def test_machines_of_standard_parts_have_names():
    winch = machinist.load("winch")
    assert winch.simulate(until=0.1, points=3).t[-1] == 0.1
    with pytest.raises(machinist.UnknownNameError, match="did you mean `winch`"):
        machinist.load("wintch")


def test_everything_is_kept_on_request(gin):
    whole = machinist.load("saw_gin", keep_all=True)
    assert whole.running == "compiled"
    assert len(gin.states) < len(whole.states)
    assert machinist.load("saw_gin", keep_all=True) is whole


def test_threads_derive_at_once(tmp_path, no_cache):
    found = {}

    def load(length: float) -> None:
        file = tmp_path / f"bob_{length}.toml"
        file.write_text(PENDULUM.format(length=length))
        found[length] = machinist.load(file)

    lengths = [0.5 + 0.1 * n for n in range(8)]
    threads = [threading.Thread(target=load, args=(length,)) for length in lengths]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [found[n].parameters["bob.length"].value for n in lengths] == lengths


def test_the_interpreter_is_free_while_a_spec_is_derived(tmp_path, no_cache):
    file = tmp_path / "chain.toml"
    file.write_text(chain(150))
    thread = threading.Thread(target=machinist.load, args=(file,))
    longest, last = 0.0, time.perf_counter()
    thread.start()
    while thread.is_alive():
        time.sleep(0.001)
        now = time.perf_counter()
        longest, last = max(longest, now - last), now
    assert longest < 0.25, f"Python stood still for {longest} s"


INTERRUPTED = """
import signal, sys, time, machinist
signal.signal(signal.SIGINT, signal.default_int_handler)
print("ready", flush=True)
try:
    machinist.load(sys.argv[1])
except KeyboardInterrupt:
    print("interrupted", flush=True)
print(machinist.load(sys.argv[2]).simulate(until=0.1).t[-1])
busy = time.process_time()
time.sleep(0.5)
print(time.process_time() - busy)
"""


def test_ctrl_c_ends_a_derivation(tmp_path, no_cache):
    large, small = tmp_path / "large.toml", tmp_path / "small.toml"
    # Takes several seconds.
    large.write_text(chain(1500))
    small.write_text(PENDULUM.format(length=1))
    child = subprocess.Popen(
        [sys.executable, "-c", INTERRUPTED, str(large), str(small)],
        stdout=subprocess.PIPE, text=True, env=dict(os.environ),
    )  # fmt: skip
    assert child.stdout and child.stdout.readline() == "ready\n"
    time.sleep(1.2)
    sent = time.perf_counter()
    child.send_signal(signal.SIGINT)
    assert child.stdout.readline() == "interrupted\n"
    took = time.perf_counter() - sent
    assert took < 1.0, f"it took {took} s"
    # The process goes on, and no thread is left at work.
    rest = child.stdout.read().split()
    assert child.wait() == 0
    assert float(rest[0]) == 0.1
    assert float(rest[1]) < 0.4, f"{rest[1]} s of processor time after the end"
