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


def systems(model, rng):
    """The machine's own model, and random, stiff, badly scaled and unstable ones of several sizes."""
    yield model.A, model.B, model.C
    for n, m, p, spread in [
        (1, 1, 1, 0), (2, 1, 1, 0), (3, 2, 1, 0), (4, 1, 2, 2), (5, 2, 2, 3),
        (6, 3, 2, 0), (8, 2, 3, 2), (10, 3, 3, 0), (12, 4, 2, 1),
    ]:  # fmt: skip
        a = rng.standard_normal((n, n))
        scale = 10.0 ** np.linspace(-0.5 * spread, 0.5 * spread, n)
        yield (
            a * scale[:, None] / scale,
            rng.standard_normal((n, m)) * scale[:, None],
            rng.standard_normal((p, n)) / scale,
        )


def state_space_of(a, b, c, period):
    told = {
        "states": [(f"x{k}", "1", 0.0) for k in range(len(a))],
        "inputs": [(f"u{k}", "1", 0.0) for k in range(b.shape[1])],
        "outputs": [(f"y{k}", "1", 0.0) for k in range(len(c))],
        "a": a.ravel(), "b": b.ravel(), "c": c.ravel(), "d": np.zeros((len(c), b.shape[1])).ravel(),
        "time": 0.0, "drift": np.zeros(len(a)), "eliminated": [], "period": period,
        "poles": [], "zeros": [], "uncontrollable": [], "unobservable": [],
    }  # fmt: skip
    return machinist.StateSpace("system", "equilibrium", told)


def riccati(linalg, a, b, q, r, period):
    """Solution by SciPy, its gain, and the residual of a solution relative to its largest entry."""
    solve = linalg.solve_continuous_are if period is None else linalg.solve_discrete_are

    def gain(x):
        right = b.T @ x if period is None else b.T @ x @ a
        return np.linalg.solve(r if period is None else r + b.T @ x @ b, right)

    def residual(x):
        own = a.T @ x + x @ a if period is None else a.T @ x @ a - x
        rest = x @ b if period is None else a.T @ x @ b
        return abs(own - rest @ gain(x) + q).max() / abs(x).max()

    x = solve(a, b, q, r)
    return x, gain(x), residual


def test_gains_are_those_of_scipy(gin):
    linalg = pytest.importorskip("scipy.linalg")
    model = gin.linearize(["motor.phase_voltage"], ["twist", "motor.omega"])
    count = 0
    for a, b, c in systems(model, np.random.default_rng(5)):
        count += 1
        n, m, p = len(a), b.shape[1], len(c)
        for period in (None, 1e-3):
            if period is not None:
                # Samples of the continuous system.
                both = np.block([[a, b], [np.zeros((m, n + m))]])
                both = linalg.expm(both * 0.1 / max(1.0, abs(np.linalg.eigvals(a)).max()))
                a, b = both[:n, :n], both[:n, n:]
            system = state_space_of(a, b, c, period)
            q, r = c.T @ c, np.diag(1.0 + np.arange(m))
            w, v = np.diag(1.0 + np.arange(m)), np.diag(2.0 + np.arange(p))
            designs = [
                (system.lqr(q, r), riccati(linalg, a, b, q, r, period)),
                (system.kalman(w, v), riccati(linalg, a.T, c.T, b @ w @ b.T, v, period)),
            ]
            for (gain, solution, poles), (x, wanted, residual) in designs:
                gain = gain if gain.shape == wanted.shape else gain.T
                # SciPy's own residual limits the comparison, ours must be of rounding.
                allowed = max(1e-10, 100 * residual(x))
                assert abs(gain - wanted).max() < allowed * abs(wanted).max()
                assert abs(solution - x).max() < allowed * abs(x).max()
                assert residual(solution) < 1e-12
                assert (poles.real < 0 if period is None else abs(poles) < 1).all()
            # Deviations are the diagonal weights of outputs.
            names = {name: 1.0 for name in system.outputs}
            names |= {name: 1.0 / np.sqrt(1.0 + k) for k, name in enumerate(system.inputs)}
            gain = designs[0][0].K
            assert abs(system.lqr(names).K - gain).max() < 1e-10 * abs(gain).max()
    assert count == 10


def test_designs_that_make_no_sense_are_refused(gin):
    model = gin.linearize(["motor.phase_voltage"], ["twist", "motor.omega"])
    n = len(model.states)
    for ask, told in [
        (lambda: model.lqr({"twst": 1.0}), "did you mean"),
        (lambda: model.lqr({"twist": 1.0}), "no input"),
        (lambda: model.lqr(np.eye(n)), "R is missing"),
        (lambda: model.lqr(-np.eye(n), 1.0), "negative"),
        (lambda: model.lqr(np.eye(n), -1.0), "positive definite"),
        (lambda: model.kalman({"twist": 1.0, "motor.phase_voltage": 1.0}, 1.0), "matrices"),
    ]:
        with pytest.raises(machinist.MachinistError, match=told):
            ask()


def test_models_along_a_run_are_those_at_its_times(gin):
    names = (["motor.phase_voltage"], ["twist", "motor.omega"])
    times = [0.2, 0.9, 1.4]
    (piece,) = gin.linearize_along(*names, times)
    assert piece.A.shape == (3, len(piece.states), len(piece.states)) and not piece.modes
    for index, time in enumerate(times):
        alone = gin.linearize(*names, at=time)
        assert alone.states == piece.states
        size = abs(alone.A).max()
        assert abs(piece.A[index] - alone.A).max() < 1e-6 * size
        np.testing.assert_allclose(piece.B[index], alone.B, rtol=1e-6)
        np.testing.assert_allclose(piece.C[index], alone.C, rtol=1e-6, atol=1e-9)
    assert "3 linear models" in repr(piece)
