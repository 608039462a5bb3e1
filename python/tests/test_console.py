"""The console script `machinist`: the commands of the program."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import time
import urllib.request
from pathlib import Path

import numpy as np

import machinist


def test_a_first_hour(commanded, tmp_path):
    for arguments, told in [
        (("new", "lift", "--from", "winch"), "wrote lift.toml"),
        (("check", "lift.toml"), "lift.toml"),
        (("run", "lift.toml", "--plot", "lift.svg", "--out", "lift.csv"), ""),
        (("show", "lift.toml"), "load"),
        (("modes", "lift.toml"), "Hz"),
        (("compile", "lift.toml", "--out", "lift.model"), "wrote lift.model"),
        (("parts", "hoist"), "hoisted_load"),
        (("list",), "saw_gin"),
    ]:
        done = commanded(*arguments)
        assert done.returncode == 0, f"{arguments}: {done.stderr}"
        assert told in done.stdout + done.stderr, f"{arguments}: {done.stdout}{done.stderr}"
    assert (tmp_path / "lift.svg").read_text().startswith("<svg")
    # The package loads what the script has written, and runs it to the same numbers.
    lift, of_file = machinist.load(tmp_path / "lift.toml"), machinist.load(tmp_path / "lift.model")
    assert lift.fingerprint == of_file.fingerprint
    head = (tmp_path / "lift.csv").read_text().splitlines()
    table = np.array([[float(cell) for cell in line.split(",")] for line in head[1:]])
    run = lift.simulate()
    names = [re.sub(r" \[.*", "", name) for name in head[0].split(",")]
    for name in lift.outputs:
        np.testing.assert_allclose(table[:, names.index(name)], run[name], rtol=1e-12)


def test_errors_have_the_exit_codes_of_the_program(commanded, tmp_path):
    (tmp_path / "bad.toml").write_text("[scene]\nname = 1\n")
    for arguments, code, told in [
        (("check", "bad.toml"), 2, "bad.toml:2:"),
        (("run", "nothing"), 2, "there is no scene `nothing`"),
        (("runn",), 2, "unrecognized subcommand"),
        (("--help",), 0, "Usage: machinist"),
        (("--version",), 0, f"machinist {machinist.__version__}"),
        (("run", "saw_gin", "--max-steps", "10"), 1, "10 steps"),
        (("run", "saw_gin", "--out", "a.parquet"), 2, "without Parquet"),
    ]:
        done = commanded(*arguments)
        assert done.returncode == code, f"{arguments}: {done.returncode} {done.stderr}"
        assert told in done.stdout + done.stderr, f"{arguments}: {done.stdout}{done.stderr}"


def test_symbolica_is_refused_with_a_reason(commanded):
    told = ["this build has no Symbolica", "cargo install --path app"]
    for done in [
        commanded("derive", "saw_gin", "--algebra", "symbolica"),
        commanded("run", "saw_gin", MACHINIST_ALGEBRA="symbolica"),
    ]:
        assert done.returncode == 2
        text = " ".join(done.stderr.split())
        assert all(part in text for part in told), done.stderr
    assert commanded("derive", "saw_gin").returncode == 0, "equations need no Symbolica"


def test_ctrl_c_ends_a_command(script, tmp_path):
    child = subprocess.Popen(
        [script, "sweep", "saw_gin", "--parameter", "coupling.stiffness=1e4..1e5:log"]
        + ["--count", "100000"],
        cwd=tmp_path, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
    )  # fmt: skip
    time.sleep(1.0)
    assert child.poll() is None, child.stderr and child.stderr.read()
    child.send_signal(signal.SIGINT)
    assert child.wait(timeout=10) in (-signal.SIGINT, 128 + signal.SIGINT)


def test_the_script_starts_without_numpy(script):
    code = (
        "import sys, runpy; sys.argv = ['machinist', 'list']\n"
        "try: runpy.run_module('machinist', run_name='__main__')\n"
        "except SystemExit as end: assert not end.code, end.code\n"
        "assert 'numpy' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True, stdout=subprocess.DEVNULL)


def test_watch_starts_its_workers_as_the_script_was_started(script, commanded, tmp_path):
    assert commanded("new", "lift", "--from", "winch").returncode == 0
    # A folder of the package's name, where the command runs, is not taken for the package.
    (tmp_path / "machinist").mkdir()
    (tmp_path / "machinist" / "__init__.py").write_text("raise SystemExit('the wrong package')")
    child = subprocess.Popen(
        [script, "watch", "lift.toml"],
        cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        env={**os.environ, "PYTHONUNBUFFERED": "1"},
    )  # fmt: skip
    try:
        assert child.stdout and child.stderr
        address = re.search(r"http://\S+", child.stdout.readline())
        assert address
        with urllib.request.urlopen(address[0]) as page:
            assert b"<html" in page.read()
        # Printed once the machine was derived and has run.
        assert child.stderr.readline().startswith("lift.toml: ")
    finally:
        child.send_signal(signal.SIGINT)
        child.wait(timeout=10)


def test_the_console_script_is_that_of_this_environment(script):
    assert Path(script).parent == Path(sys.executable).parent
