"""Runs: arrays, metadata and rejected arguments."""

from __future__ import annotations

import os
import signal
import threading
import time

import numpy as np
import pytest

import machinist


def test_columns_are_the_memory_of_the_run(gin):
    run = gin.simulate(until=0.1, points=11)
    assert run["twist"] is run.outputs["twist"]
    assert not run.states["motor.omega"].flags.owndata
    assert run.t[0] == 0 and run.t[-1] == 0.1 and len(run) == 11
    assert run.y.shape == (len(gin.states), 11)
    assert list(run.outputs) == list(gin.outputs)
    kept = run["twist"]
    before = kept.copy()
    del run
    np.testing.assert_array_equal(kept, before)


def test_a_run_does_what_it_is_asked(gin):
    run = gin.simulate(
        start=0.1, until=0.3, times=[0.1, 0.2, 0.3], parameters={"coupling.stiffness": 1e4},
        initial={"motor.omega": 10.0}, rtol=1e-6, method="dop853",
    )  # fmt: skip
    assert run.t.tolist() == [0.1, 0.2, 0.3]
    assert run.states["motor.omega"][0] == 10.0
    assert (run.method, run.rtol) == ("dop853", 1e-6)
    again = gin.simulate(
        start=0.1, until=0.3, times=np.array([0.1, 0.2, 0.3]), rtol=1e-6, method="dop853",
        parameters=gin.p({"coupling.stiffness": 1e4}), initial=run.y[:, 0],
    )  # fmt: skip
    np.testing.assert_array_equal(run.y, again.y)


def test_the_error_of_a_run_is_estimated_and_met(gin):
    times = np.linspace(0.0, 0.5, 98)
    exact = gin.simulate(until=0.5, times=times, rtol=1e-12)
    assert exact.error is None and exact.error_unknown is None
    for rtol in (1e-5, 1e-7):
        run = gin.simulate(until=0.5, times=times, rtol=rtol, error=True)
        for name in gin.outputs:
            off = np.max(np.abs(run[name] - exact[name]))
            rounding = 1e-14 * np.max(np.abs(exact[name]))
            assert 0.1 * off < run.error[name] < 10 * off + rounding
    run = gin.simulate(until=0.5, times=times, accuracy=1e-9)
    assert not any("accuracy" in note for note in run.notes)
    for name in gin.outputs:
        assert np.max(np.abs(run[name] - exact[name])) < 3e-9 * np.max(np.abs(exact[name]))
    run = gin.simulate(until=0.1, points=11, accuracy=1e-17)
    assert run.notes[-1].startswith("the accuracy is not met: the error of `")
    with pytest.raises(machinist.InputError, match="accuracy -1"):
        gin.simulate(until=0.1, accuracy=-1.0)


def test_frames_hold_all_columns_and_their_units(gin):
    run = gin.simulate(until=0.1, points=5)
    frame = pytest.importorskip("pandas") and run.to_pandas()
    assert frame.index.name == "t" and frame.attrs["units"]["twist"] == "rad"
    np.testing.assert_array_equal(frame["twist"], run["twist"])
    polars = pytest.importorskip("polars") and run.to_polars()
    assert polars.columns[0] == "t" and polars.height == 5


def test_events_are_listed_and_drawn():
    run = machinist.load("bouncing_mass").simulate()
    assert len(run.events) == run.work["events"] > 0
    assert all(a.time <= b.time for a, b in zip(run.events, run.events[1:]))
    assert "stroke-dasharray" in run.plot().svg


def test_what_stops_a_run_is_raised_with_what_there_is_of_it(gin):
    with pytest.raises(machinist.StoppedError, match="limit of 300 steps") as told:
        gin.simulate(max_steps=300)
    error = told.value
    assert "raise the limit" in error.hint and error.code == "run::too-many-steps"
    assert 0 < error.run.t[-1] <= error.time < 2
    assert error.run.stopped.time == error.time
    kept = gin.simulate(max_steps=300, on_stop="keep")
    np.testing.assert_array_equal(kept.t, error.run.t)
    assert "stopped at" in repr(kept)


def test_a_run_ends_at_its_limit_of_time(gin):
    start = time.perf_counter()
    with pytest.raises(machinist.StoppedError, match="limit of 0.2 s"):
        gin.simulate(until=1e9, points=2, time_limit=0.2)
    assert time.perf_counter() - start < 5


def test_the_interpreter_is_free_during_a_run(gin):
    seen = []
    run = threading.Thread(
        target=lambda: gin.simulate(until=1e9, points=2, time_limit=0.5, on_stop="keep")
    )
    run.start()
    while run.is_alive():
        seen.append(time.perf_counter())
        time.sleep(0.01)
    assert len(seen) > 10


@pytest.mark.skipif(os.name == "nt", reason="signals")
def test_ctrl_c_ends_a_run(gin):
    # What is started in the background by a shell ignores it, and so would this process.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    start = time.perf_counter()
    try:
        with pytest.raises(KeyboardInterrupt):
            gin.simulate(until=1e9, points=2, time_limit=20)
    finally:
        signal.signal(signal.SIGINT, before)
    assert time.perf_counter() - start < 10


def test_sensitivities_and_the_energy_balance_are_columns(gin):
    run = gin.simulate(until=0.1, points=6, sensitivities=["coupling.stiffness"])
    by = run.sensitivity("twist", "coupling.stiffness")
    step = 1.0
    shifted = [
        gin.simulate(until=0.1, points=6, rtol=1e-11, parameters={"coupling.stiffness": k})["twist"]
        for k in (23065.2 - step, 23065.2 + step)
    ]
    difference = (shifted[1] - shifted[0]) / (2 * step)
    np.testing.assert_allclose(by, difference, atol=1e-5 * abs(difference).max())
    balanced = gin.simulate(until=0.1, points=6, energy_balance=True)
    assert balanced.energy_residual < 1e-6
    assert "energy.residual" in balanced.energies


@pytest.mark.parametrize(
    ("settings", "kind", "told"),
    [
        ({"parameters": {"coupling.stifness": 1}}, machinist.UnknownNameError, "did you mean"),
        ({"parameters": {"coupling.stiffness": float("nan")}}, machinist.InputError, "is NaN"),
        ({"parameters": {"coupling.stiffness": "soft"}}, machinist.InputError, "a number"),
        ({"parameters": [1.0, 2.0]}, machinist.ShapeError, "21 parameters"),
        ({"parameters": np.ones((21, 2))}, machinist.ShapeError, "one dimension"),
        ({"parameters": np.ones(21, complex)}, machinist.InputError, "complex128"),
        ({"parameters": 3}, machinist.ShapeError, "one dimension"),
        ({"initial": {"motor.omgea": 1}}, machinist.UnknownNameError, "motor.omega"),
        ({"initial": np.zeros(3)}, machinist.ShapeError, "7 states"),
        ({"until": "soon"}, machinist.InputError, "until must be a number"),
        ({"until": -1.0}, machinist.InputError, "must end after"),
        ({"until": float("inf")}, machinist.InputError, "must end after"),
        ({"points": -3}, machinist.InputError, "whole number"),
        ({"points": 10**12}, machinist.InputError, "output points"),
        ({"times": [0.2, 0.1]}, machinist.InputError, "output time"),
        ({"rtol": 0.0}, machinist.InputError, "tolerance"),
        ({"atol": [1.0]}, machinist.ShapeError, "states"),
        ({"method": "tsit6"}, machinist.UnknownNameError, "did you mean `tsit5`"),
        ({"method": "exact"}, machinist.StoppedError, "not linear"),
        ({"sensitivities": ["nothing"]}, machinist.UnknownNameError, "nothing"),
        ({"on_stop": "ignore"}, machinist.InputError, "on_stop"),
        ({"time_limit": -1.0}, machinist.InputError, "time_limit"),
    ],
)
def test_what_makes_no_sense_is_refused(gin, settings, kind, told):
    with pytest.raises(kind, match=told):
        gin.simulate(**settings)
