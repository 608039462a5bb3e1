"""Runs that are advanced piece by piece."""

from __future__ import annotations

import copy
import math
import os
import pickle
import random
import signal
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

import machinist

SPECS = Path(__file__).parents[2] / "specs" / "scenes"

BELT = """
[scene]
name = "belt"
[units.u]
unit = "u"
[initial]
"u.v" = 0.3
[outputs]
place = "u.x"
[run]
until = 5
points = 2
rtol = 1e-9
method = "auto"
[define.u.coordinates.x]
unit = "m"
velocity = "v"
[define.u.parameters]
belt = { value = 0.0, unit = "m/s" }
pull = { value = 0.4, unit = "N" }
[define.u.energy]
kinetic = "(2 [kg])*v^2/2"
[[define.u.forces]]
coordinate = "x"
expression = "pull - (1 [N])*sign(v - belt)"
"""

SAMPLED = """
[scene]
name = "sampled"
[units.u]
unit = "u"
[outputs]
x = "u.x"
[run]
until = 2
points = 2
rtol = 1e-9
[define.u.states.x]
unit = "1"
rate = "(held - x)/(0.3 [s])"
[define.u.states.held]
unit = "1"
rate = "0"
[define.u.states.sum]
unit = "1"
rate = "0"
[define.u.states.next]
unit = "s"
rate = "0"
initial = "period"
[define.u.parameters]
period = { value = 0.05, unit = "s" }
[define.u.events.samples]
guard = "t - next"
direction = "rising"
set = { next = "next + period", sum = "sum + 0.3*(1 - x)", held = "max(min(2*(1 - x) + sum, 1.5), -1.5)" }
"""

PLANT = """
[scene]
name = "plant"
[units.u]
unit = "u"
[outputs]
x = "u.x"
[run]
until = 2
points = 2
rtol = 1e-9
method = "dop853"
[define.u.states.x]
unit = "1"
rate = "(input - x)/(0.3 [s])"
[define.u.parameters]
input = { value = 0.0, unit = "1" }
level = { value = 1e3, unit = "1" }
[define.u.modes.full]
[define.u.events.fills]
guard = "x - level"
direction = "rising"
when = { full = 0 }
set = { full = 1 }
"""


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory):
    """Loads a spec of this file."""
    folder: Path = tmp_path_factory.mktemp("specs")

    def load(text: str) -> machinist.Model:
        file = folder / f"{text.split(chr(34))[1]}.toml"
        file.write_text(text)
        return machinist.load(file)

    return load


def pieces(run, until: float, count: int) -> list:
    """Events of a run in pieces of equal length."""
    start, events = run.time, []
    for piece in range(1, count + 1):
        share = piece / count
        events += run.advance(until if piece == count else start + share * (until - start))
    return events


def off(run, state) -> float:
    """Largest difference from a state, over the size of each entry."""
    sizes = [max(s.scale, abs(v)) for s, v in zip(run.model.states.values(), state)]
    return float(np.max(np.abs(run.y - state) / np.array(sizes)))


@pytest.mark.parametrize(
    ("name", "until"),
    [
        ("bouncing_mass", 0.4), ("coulomb_oscillator", 1.0), ("pendulum_constrained", 0.5),
        ("saw_gin", 0.3), ("shaft_with_rotors", 0.02), ("stick_slip", 2.0),
        ("winder_holder_drop", 0.2),
        # Teeth and bearings stick from the start on, with events there.
        ("parts/rotational/gear_drive", 0.3),
    ],
)  # fmt: skip
def test_pieces_make_up_the_run(name, until):
    model = machinist.load(SPECS / f"{name}.toml" if "/" in name else name)
    whole = model.simulate(until=until, points=2)
    run = model.start(until=until)
    assert run.advance(until) == list(whole.events)
    assert (run.time, run.method) == (until, whole.method)
    if not any("repeated" in note for note in whole.notes):
        np.testing.assert_array_equal(run.y, whole.y[:, -1])
    run = model.start(until=until)
    events = pieces(run, until, 17)
    assert [event.name for event in events] == [event.name for event in whole.events]
    for found, exact in zip(events, whole.events):
        assert found.time == pytest.approx(exact.time, rel=1e-6)
    assert off(run, whole.y[:, -1]) < 3e-6
    assert list(run.states) == list(model.states) and list(run.outputs) == list(model.outputs)
    again = model.outputs_at(run.time, run.y, model.p())
    np.testing.assert_allclose(list(run.outputs.values()), again, rtol=1e-9, atol=1e-12)


def test_a_sampled_controller_samples_within_pieces(own):
    decay, x, held, total = math.exp(-0.05 / 0.3), 0.0, 0.0, 0.0
    for _ in range(40):
        x = held + (x - held) * decay
        held, total = max(min(2 * (1 - x) + total, 1.5), -1.5), total + 0.3 * (1 - x)
    exact = held + (x - held) * math.exp(-0.03 / 0.3)
    for count in (1, 7, 400):
        run = own(SAMPLED).start()
        assert len(pieces(run, 2.03, count)) == 40
        assert run["x"] == pytest.approx(exact, abs=1e-10)


def test_a_controller_in_python_closes_the_loop(own):
    # x_(k+1) = u + (x - u) e^(-T/tau) with u = 2 (1 - x) + sum.
    run, x, total = own(PLANT).start(), 0.0, 0.0
    for sample in range(1, 61):
        value = 2 * (1 - run["x"]) + total
        total += 0.3 * (1 - run["x"])
        x = value + (x - value) * math.exp(-0.05 / 0.3)
        run.set({"u.input": value})
        assert run.parameters["u.input"] == value
        assert run.advance(0.05 * sample) == []
        assert run["x"] == pytest.approx(x, abs=1e-9)
    assert run["x"] == pytest.approx(1, abs=0.02)


def test_the_example_of_the_book_runs():
    page = Path(__file__).parents[2] / "docs/book/src/fmu.md"
    text = page.read_text().split("test_hosting.py")[1]
    seen: dict = {}
    exec(text.split("```python\n")[1].split("```")[0], seen)
    run = seen["run"]
    assert run.time == 1.0 and run["driver_speed"] == pytest.approx(100, abs=2)
    np.testing.assert_array_equal(seen["again"].y, run.y)


def test_a_piece_ends_after_an_event_if_it_is_to():
    model = machinist.load("bouncing_mass")
    whole = model.simulate(until=0.4, points=2)
    run, events = model.start(until=0.4), []
    while run.time < 0.4:
        found = run.advance(0.4, to_event=True)
        assert all(event.time == run.time for event in found) and (found or run.time == 0.4)
        events += found
    assert [event.name for event in events] == [event.name for event in whole.events]
    assert off(run, whole.y[:, -1]) < 1e-6


def test_modes_settle_to_parameters_that_are_set(own):
    run = own(PLANT).start(parameters={"u.input": 1.0})
    run.advance(0.3 * math.log(2))
    run.set({"u.level": 0.4})
    assert run.modes == {"u.full": 0}
    # The guard is beyond zero at once.
    assert run.step(1e-3) == [(0.3 * math.log(2), "u.fills")]
    assert run.modes == {"u.full": 1}


def test_an_input_may_jump_at_an_event(own):
    model, filled = own(PLANT), 0.3 * math.log(2)
    for at in (filled, math.nextafter(filled, 0), math.nextafter(filled, 1), filled + 1e-12):
        run = model.start(parameters={"u.input": 1.0, "u.level": 0.5})
        events = run.advance(at)
        run.set({"u.input": 0.2})
        events += run.advance(1.0)
        assert len(events) <= 1 and run.modes["u.full"] == len(events)
        assert run["x"] == pytest.approx(0.2 + 0.3 * math.exp(-(1 - at) / 0.3), abs=1e-8)


def test_a_run_slides_and_leaves_a_surface_that_is_moved(own):
    run = own(BELT).start()
    # 0.3 m/s are lost at 0.3 m/s^2.
    run.advance(0.5)
    assert not run.is_sliding and run["u.v"] == pytest.approx(0.15, abs=1e-12)
    run.advance(1.5)
    assert run.is_sliding and "sliding" in repr(run)
    np.testing.assert_array_equal(run.rate, [0.0, 0.0])
    run.set({"u.belt": 0.5})
    run.advance(2.0)
    assert run["u.v"] == pytest.approx(0.35, abs=1e-9) and not run.is_sliding
    run.advance(3.0)
    assert run["u.v"] == 0.5 and run.is_sliding
    run.set({"u.pull": 1.5})
    assert run.advance(4.0) == [] and not run.is_sliding
    assert run["u.v"] == pytest.approx(0.75, abs=1e-9)


def moments(own):
    """Runs that stick, that slide along a surface, and in flight between events."""
    stuck = machinist.load("stick_slip").start()
    stuck.advance(0.2)
    sliding = own(BELT).start()
    sliding.advance(1.5)
    flying = machinist.load("bouncing_mass").start(method="tsit5", until=3.0)
    flying.advance(0.11)
    assert sliding.is_sliding and any(stuck.modes.values())
    return {"stuck": stuck, "sliding": sliding, "flying": flying}


def change(run, which):
    """Goes on through another event."""
    if which == "sliding":
        run.set({"u.belt": -0.2})
    return run.advance(run.time + 0.7)


def test_copies_and_saved_runs_continue_bit_for_bit(own, tmp_path):
    for which, run in moments(own).items():
        others = [copy.copy(run), copy.deepcopy(run), pickle.loads(pickle.dumps(run))]
        others.append(run.model.restore(run.save()))
        kept = pickle.dumps(run)
        events = change(run, which)
        for other in others:
            assert change(other, which) == events
            np.testing.assert_array_equal(other.y, run.y)
            assert other.save() == run.save() and other.method == run.method
        # In another process.
        file = tmp_path / f"{which}.pickle"
        file.write_bytes(kept)
        code = (
            "import pickle, sys\n"
            "run = pickle.load(open(sys.argv[1], 'rb'))\n"
            "if sys.argv[2] == 'sliding': run.set({'u.belt': -0.2})\n"
            "run.advance(run.time + 0.7)\n"
            "sys.stdout.write(run.save().hex())"
        )
        ended = subprocess.run(
            [sys.executable, "-c", code, str(file), which], capture_output=True, text=True
        )
        assert ended.stdout == run.save().hex(), ended.stderr


def test_a_state_can_be_corrected_by_starting_from_it(own):
    run = machinist.load("stick_slip").start()
    run.advance(0.2)
    again = run.model.start(start=run.time, initial=run.y, parameters=list(run.parameters.values()))
    run.advance(1.5)
    again.advance(1.5)
    assert off(again, run.y) < 1e-6


def test_bytes_of_something_else_are_refused(gin):
    data = gin.start().save()
    other = machinist.load("two_mass")
    for model, bad, told in [
        (other, data, "another machine"),
        (gin, b"", "not a saved run"),
        (gin, b"machinist run v0" + data[16:], "another version"),
        (gin, data[:16] + b"\x63" + data[17:], "another version"),
        (gin, data[:-1], "cut off"),
        (gin, data[:-1] + bytes([data[-1] ^ 1]), "altered"),
    ]:
        with pytest.raises(machinist.InputError, match=told):
            model.restore(bad)
    with pytest.raises(TypeError):
        gin.restore("text")
    coarse, fine = (machinist.load("reed_beat_up", elements=n) for n in (4, 8))
    with pytest.raises(machinist.InputError, match="another machine"):
        fine.restore(coarse.start().save())


@pytest.mark.parametrize(
    ("settings", "kind"),
    [
        ({"parameters": {"coupling.stifness": 1}}, machinist.UnknownNameError),
        ({"parameters": {"coupling.stiffness": float("nan")}}, machinist.InputError),
        ({"parameters": [1.0, 2.0]}, machinist.ShapeError),
        ({"initial": {"motor.omgea": 1}}, machinist.UnknownNameError),
        ({"initial": np.zeros(3)}, machinist.ShapeError),
        ({"until": -1.0}, machinist.InputError),
        ({"rtol": 0.0}, machinist.InputError),
        ({"atol": [1.0]}, machinist.ShapeError),
        ({"method": "tsit6"}, machinist.UnknownNameError),
        ({"time_limit": -1.0}, machinist.InputError),
    ],
)
def test_a_start_is_refused_as_a_run_is(gin, settings, kind):
    with pytest.raises(kind) as of_start:
        gin.start(**settings)
    with pytest.raises(kind) as of_run:
        gin.simulate(**settings)
    assert str(of_start.value) == str(of_run.value)
    assert of_start.value.code == of_run.value.code


def test_what_cannot_be_set_is_refused_and_changes_nothing(gin):
    run = gin.start()
    before = run.save()
    for given in (
        {"coupling.stifness": 1.0}, {"coupling.stiffness": math.nan},
        {"coupling.stiffness": "soft"}, [1.0, 2.0], {"load.mean": 1.0, "nothing": 1.0},
    ):  # fmt: skip
        with pytest.raises(machinist.InputError) as of_set:
            run.set(given)
        with pytest.raises(machinist.InputError) as of_run:
            gin.simulate(parameters=given)
        assert str(of_set.value) == str(of_run.value)
    with pytest.raises(machinist.InputError, match="not both"):
        run.set(gin.p(), mean=1.0)
    for until in (-1.0, math.nan, math.inf):
        with pytest.raises(machinist.InputError, match="cannot advance"):
            run.advance(until)
    for size in (0.0, -1e-3, math.nan):
        with pytest.raises(machinist.InputError, match="does not go forward"):
            run.step(size)
    assert run.advance(0.0) == [] and run.save() == before
    run.set(gin.p({"load.mean": 12.0}))
    assert run.parameters["load.mean"] == 12.0
    pendulum = machinist.load("pendulum_constrained")
    fixed = next(p.name for p in pendulum.parameters.values() if not p.tunable)
    held = pendulum.start()
    with pytest.raises(machinist.InputError, match="cannot change during a run"):
        held.set({fixed: 1.01 * held.parameters[fixed]})
    held.set({fixed: held.parameters[fixed]})
    with pytest.raises(machinist.UnknownNameError, match="did you mean `twist`"):
        run["twits"]


def test_a_start_in_equilibrium_stays_there():
    model = machinist.load("two_mass")
    names = {name: 0.0 for name in model.parameters if name.endswith("torque")}
    run = model.start(equilibrium=True, parameters=names)
    before = run.y
    run.advance(0.1)
    np.testing.assert_allclose(run.y, before, atol=1e-9)


def test_a_piece_keeps_to_its_limits(gin):
    run = gin.start(max_steps=300)
    before = run.save()
    with pytest.raises(machinist.StoppedError, match="limit of 300 steps") as told:
        run.advance(2.0)
    assert told.value.code == "run::too-many-steps" and 0 < told.value.time < 2
    assert run.save() == before
    pieces(run, 2.0, 100)
    slow = gin.start(time_limit=0.2)
    start = time.perf_counter()
    with pytest.raises(machinist.StoppedError, match="limit of 0.2 s"):
        slow.advance(1e9)
    assert time.perf_counter() - start < 5 and slow.time == 0


@pytest.mark.skipif(os.name == "nt", reason="signals")
def test_ctrl_c_ends_a_piece(gin):
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    run = gin.start(time_limit=20)
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            run.advance(1e9)
    finally:
        signal.signal(signal.SIGINT, before)
    assert run.time == 0
    run.advance(0.1)


def test_threads_advance_runs_of_one_machine(gin):
    exact = gin.start()
    pieces(exact, 0.2, 50)
    runs = [gin.start() for _ in range(4)]
    threads = [threading.Thread(target=pieces, args=(run, 0.2, 50)) for run in runs]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for run in runs:
        np.testing.assert_array_equal(run.y, exact.y)


def test_another_thread_sees_the_run_before_its_piece(gin):
    run, seen = gin.start(time_limit=0.5), []

    def goes_on():
        with pytest.raises(machinist.StoppedError):
            run.advance(1e9)

    thread = threading.Thread(target=goes_on)
    thread.start()
    refused = 0
    while thread.is_alive():
        seen.append((run.time, run["twist"], len(run.save())))
        try:
            run.set({"load.mean": 1.0})
        except machinist.InputError as error:
            refused += "already" in str(error)
        time.sleep(0.01)
    assert len(seen) > 10 and {one[0] for one in seen} == {0.0} and refused > 10


@pytest.mark.parametrize("name", ["bouncing_mass", "stick_slip"])
def test_the_error_stays_in_uneven_pieces(name):
    """Lengths down to 1e-9 s, and ends at events."""
    model = machinist.load(name)
    exact = model.simulate(until=1.0, points=2, rtol=1e-11)
    draw, run, events = random.Random(7), model.start(until=1.0), []
    while run.time < 1.0:
        ahead = [event.time for event in exact.events if event.time > run.time]
        if ahead and draw.random() < 0.1:
            until = ahead[0] + draw.choice([0, 1e-15, -1e-12, 1e-12, 1e-9])
        else:
            until = run.time + 10 ** draw.uniform(-9, -1)
        if until > run.time:
            events += run.advance(min(until, 1.0))
    assert [event.name for event in events] == [event.name for event in exact.events]
    assert off(run, exact.y[:, -1]) < 3e-7


@pytest.mark.parametrize("name", ["parts/rotational/rack", "stick_slip"])
def test_ten_thousand_pieces_keep_the_error(name):
    """Of a machine that is solved by its modes, and of one that steps between events."""
    model = machinist.load(SPECS / f"{name}.toml")
    exact = model.simulate(until=1.0, points=2, rtol=1e-12)
    run = model.start(until=1.0)
    pieces(run, 1.0, 10_000)
    assert off(run, exact.y[:, -1]) < 1e-8
