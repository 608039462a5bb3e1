"""Eigenmodes and responses, compared with closed forms and finite differences."""

from __future__ import annotations

import numpy as np
import pytest

import machinist


def test_modes_are_the_eigenvalues_of_the_jacobian(gin):
    modes = gin.modes(at=0.3)
    run = gin.simulate(until=0.3, points=2)
    np.testing.assert_allclose(modes.matrix, gin.jacobian(0.3, run.y[:, -1]), rtol=1e-9)
    of_numpy = np.linalg.eigvals(modes.matrix)
    for mode in modes:
        if mode.kind != "free":
            assert abs(of_numpy - mode.eigenvalue).min() < 1e-6 * abs(mode.eigenvalue)
            assert sum(mode.shares.values()) == pytest.approx(1)
    assert "oscillation" in repr(modes) and "<table" in modes._repr_html_()


def test_slopes_of_modes_are_their_differences(gin):
    name, value, step = "coupling.stiffness", 23065.2, 1.0
    modes = gin.modes(slopes=[name])
    ahead, behind = (gin.modes(parameters={name: value + s}) for s in (step, -step))
    for mode, a, b in zip(modes, ahead, behind):
        if mode.kind == "free":
            assert mode.no_slopes and not mode.slopes
            continue
        found = (a.natural_frequency - b.natural_frequency) / (2 * step)
        size = mode.natural_frequency / value
        assert mode.slopes[name].natural_frequency == pytest.approx(found, abs=1e-4 * size)


def test_a_response_is_that_of_the_matrix(gin):
    response = gin.response("motor.phi", "motor.omega", points=50)
    modes = gin.modes()
    place = gin.states.index("motor.omega")
    inertia = gin.parameters["motor.inertia"].value
    force = np.zeros(len(gin.states))
    force[place] = 1 / inertia

    def answer(w):
        return np.linalg.solve(1j * w * np.eye(len(force)) - modes.matrix, force)[place]

    for w, h in zip(response.frequencies, response.values):
        assert abs(h - answer(w)) < 1e-8 * abs(answer(w))
    at, largest = response.peak
    near = [abs(answer(at * factor)) for factor in (0.999, 1, 1.001)]
    assert largest >= response.amplitudes.max() and abs(largest - max(near)) < 1e-8 * largest
    assert "rad/s" in response._repr_svg_()
    assert response.growth is None and all(mode.eigenvalue.real < 1e-9 for mode in modes)


def test_a_response_tells_that_a_motion_grows(gin):
    anti_damped = {"coupling.damping": -50.0}
    response = gin.response("motor.phi", "motor.omega", points=5, at="initial", parameters=anti_damped)
    modes = gin.modes(at="initial", parameters=anti_damped)
    assert response.growth == max(mode.eigenvalue.real for mode in modes) > 0


@pytest.mark.parametrize(
    ("ask", "kind", "told"),
    [
        (lambda m: m.modes(at="somewhere"), machinist.InputError, "not one of equilibrium"),
        (lambda m: m.modes(slopes=["coupling.stif"]), machinist.UnknownNameError, "no parameter"),
        (lambda m: m.modes(untl=2.0), machinist.InputError, "no setting `untl`"),
        (lambda m: m.response("motor.ph", "twist"), machinist.UnknownNameError, "motor.phi"),
        (lambda m: m.response("motor.phi", "twst"), machinist.UnknownNameError, "`twist`"),
        (lambda m: m.response("motor.phi", "twist", frequencies=[-1.0]), ValueError, "-1"),
        (lambda m: m.response("motor.phi", "twist", points=1), ValueError, "range"),
    ],
)
def test_what_makes_no_sense_is_refused(gin, ask, kind, told):
    with pytest.raises(kind, match=told):
        ask(gin)


def test_a_state_space_model_has_the_response_of_the_machine(gin):
    model = gin.linearize("motor.phase_voltage", ["twist", "motor.omega"])
    assert model.inputs == ("motor.phase_voltage",) and model.A.shape == (len(model.states),) * 2
    response = gin.response("motor.phase_voltage", "twist", frequencies=[1.0, 30.0, 200.0])
    for w, wanted in zip(response.frequencies, response.values):
        states = np.linalg.solve(1j * w * np.eye(len(model.A)) - model.A, model.B)
        found = model.C @ states + model.D
        assert abs(found[0, 0] - wanted) < 1e-9 * abs(wanted)
    of_numpy = np.linalg.eigvals(model.A)
    size = abs(of_numpy).max()
    assert all(abs(of_numpy - pole).min() < 1e-7 * size for pole in model.poles)
    assert "state" in repr(model) and "<table" in model._repr_html_()


def test_a_sampled_model_is_that_of_scipy(gin):
    signal = pytest.importorskip("scipy.signal")
    names = (["motor.phase_voltage", "coupling.damping"], ["twist"])
    model = gin.linearize(*names)
    for hold, method in (("zoh", "zoh"), ("tustin", "bilinear")):
        sampled = gin.linearize(*names, sample=1e-3, hold=hold)
        wanted = signal.cont2discrete((model.A, model.B, model.C, model.D), 1e-3, method)
        for found, matrix in zip((sampled.A, sampled.B, sampled.C, sampled.D), wanted):
            np.testing.assert_allclose(found, matrix, rtol=1e-9, atol=1e-12 * abs(matrix).max())
        assert sampled.period == 1e-3 and sampled.to_scipy().dt == 1e-3
    with pytest.raises(machinist.MachinistError, match="did you mean"):
        gin.linearize("motor.phase_voltag", "twist")
