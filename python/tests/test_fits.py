"""Sensitivities and fits."""

from __future__ import annotations

import numpy as np
import pytest

import machinist

TRUE = {"coupling.stiffness": 3e4, "motor.inertia": 5.0}


@pytest.fixture(scope="module")
def measured(gin):
    run = gin.simulate(until=0.3, points=151, parameters=TRUE)
    noise = np.random.default_rng(3)
    twist = run["twist"] + 1e-5 * noise.standard_normal(len(run))
    twist[7] = np.nan
    speed = run["motor_speed"] + 1e-3 * noise.standard_normal(len(run))
    return {"time [s]": run.t, "twist [rad]": twist, "motor_speed": speed}


def test_a_fit_finds_what_a_run_was_made_with(gin, measured):
    fit = gin.fit(measured, ["coupling.stiffness", "motor.inertia"])
    assert fit.converged and fit.values == 2 * 151 - 1
    for name, true in TRUE.items():
        found = fit.found[name]
        assert abs(found.value - true) < 4 * found.standard_error < 0.02 * true
        low, high = found.confidence_95
        assert low < found.value < high
    assert fit.residuals["twist"].rms == pytest.approx(1e-5, rel=0.2)
    assert abs(fit.correlations[0, 0] - 1) < 1e-9
    assert "coupling.stiffness" in repr(fit) and "<table" in fit._repr_html_()
    again = fit.simulate(until=0.3, points=151)
    np.testing.assert_allclose(again["motor_speed"], measured["motor_speed"], atol=0.01)
    assert "measured" in fit.plot().svg


def test_frames_runs_and_other_names_are_data_too(gin, measured):
    pandas = pytest.importorskip("pandas")
    polars = pytest.importorskip("polars")
    columns = {"t": measured["time [s]"], "n1": measured["motor_speed"]}
    expected = gin.fit(columns, ["motor.inertia"], map={"n1": "motor_speed"})
    frames = [
        pandas.DataFrame(columns), pandas.DataFrame(columns).set_index("t"),
        polars.DataFrame(columns),
    ]  # fmt: skip
    for frame in frames:
        fit = gin.fit(frame, ["motor.inertia"], map={"n1": "motor_speed"})
        assert fit.parameters == expected.parameters
    run = gin.simulate(until=0.1, points=21, parameters=TRUE, initial={"motor.omega": 3.0})
    fit = gin.fit(
        [run, run], {"motor.omega": (0.0, 10.0)}, outputs=["motor_speed"], given=TRUE,
    )  # fmt: skip
    assert fit.initial["motor.omega"] == pytest.approx(3.0, rel=1e-6)


def test_what_the_data_do_not_tell_is_named(gin, measured):
    fit = gin.fit(measured, ["motor.k_s", "motor.k_r"])
    assert fit.untold
    assert set(fit.untold[0][0]) == {"motor.k_s", "motor.k_r"}
    assert "the data tell" in repr(fit)


@pytest.mark.parametrize(
    ("data", "asked", "more", "kind", "told"),
    [
        ({"t": [0, 1]}, ["motor.inertia"], {}, machinist.InputError, "no column but time"),
        ({"twist": [0, 1]}, ["motor.inertia"], {}, machinist.InputError, "no column `t`"),
        ({"t": [0, 1], "twst": [0, 1]}, ["motor.inertia"], {}, LookupError, "`twist`"),
        ({"t": [0, 1], "twist": [0, 1]}, ["motor.inertai"], {}, LookupError, "motor.inertia"),
        ({"t": [0, 1], "twist": [0]}, ["motor.inertia"], {}, machinist.ShapeError, "1 values"),
        ({"t": [1, 0], "twist": [0, 1]}, ["motor.inertia"], {}, ValueError, "ascend"),
        ({"t": [0, 1], "twist [m]": [0, 1]}, ["motor.inertia"], {}, ValueError, "in m, not"),
        ({"t": [0, 1], "twist": ["a", "b"]}, ["motor.inertia"], {}, ValueError, "numbers"),
        ({"t": [0, 1], "twist": [0, 1]}, {"motor.inertia": (2, 1)}, {}, ValueError, "below"),
        ({"t": [0, 1], "twist": [0, 1]}, [], {}, ValueError, "nothing to be fitted"),
        (3, ["motor.inertia"], {}, ValueError, "DataFrame"),
        ({"t": [0, 1], "twist": [0, 1]}, ["motor.inertia"], {"loss": "l1"}, ValueError, "huber"),
        ({"t": [0, 1], "twist": [0, 1]}, ["motor.inertia"], {"starts": 0}, ValueError, "starts"),
        (
            {"t": [0, 1], "twist": [0, 1]}, ["motor.inertia"], {"sigma": {"twst": 1.0}},
            LookupError, "not measured",
        ),
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_refused(gin, data, asked, more, kind, told):
    with pytest.raises(kind, match=told):
        gin.fit(data, asked, **more)


def test_effects_are_relative_and_the_largest_comes_first(gin):
    found = gin.sensitivities(until=0.1, points=21, outputs=["twist"])
    assert found.effects[0].rms == max(effect.rms for effect in found.effects)
    assert "load.phase" in found.left_out
    effect = found["twist", "coupling.stiffness"]
    by = found.run.sensitivity("twist", "coupling.stiffness")
    scale = 23065.2 / abs(found.run["twist"]).max()
    np.testing.assert_allclose(effect.values, scale * by)
    assert "coupling.stiffness" in repr(found) and "<svg" in found.plot().svg
    with pytest.raises(machinist.UnknownNameError, match="stiffness"):
        gin.sensitivities(["coupling.stifness"])
