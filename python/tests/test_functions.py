"""Rate and Jacobian as functions of arrays."""

from __future__ import annotations

import numpy as np
import pytest

import machinist


def state(model: machinist.Model) -> np.ndarray:
    return model.simulate(until=0.3, points=2).y[:, -1]


def test_the_jacobian_is_the_derivative_of_the_rate(gin):
    y = state(gin)
    jacobian = gin.jacobian(0.3, y)
    for column in range(len(y)):
        step = 1e-6 * max(1.0, abs(y[column]))
        ahead, behind = y.copy(), y.copy()
        ahead[column] += step
        behind[column] -= step
        slope = (gin.rate(0.3, ahead) - gin.rate(0.3, behind)) / (2 * step)
        np.testing.assert_allclose(jacobian[:, column], slope, rtol=1e-5, atol=1e-4)
    pattern = gin.jacobian_sparsity.toarray() != 0
    assert not jacobian[~pattern].any()


def test_parameters_change_the_rate_and_outputs_are_those_of_the_run(gin):
    run = gin.simulate(until=0.3, points=2)
    y = run.y[:, -1]
    stiff = gin.p({"coupling.stiffness": 1e6})
    assert (gin.rate(0.3, y) != gin.rate(0.3, y, stiff)).any()
    outputs = gin.outputs_at(0.3, y)
    assert outputs.tolist() == [run.outputs[name][-1] for name in gin.outputs]


def test_arrays_of_any_layout_and_kind_of_number_will_do(gin):
    y = np.arange(7.0)
    expected = gin.rate(0.0, y)
    padded = np.zeros(14)
    padded[::2] = y
    for given in (y.tolist(), y.astype("f4"), y.astype(int), padded[::2], tuple(y)):
        np.testing.assert_array_equal(gin.rate(0.0, given), expected)
    out = np.empty(7)
    assert gin.rate(0.0, y, out=out) is out
    np.testing.assert_array_equal(out, expected)
    square = np.ones((7, 7))
    assert gin.jacobian(0.0, y, out=square) is square
    np.testing.assert_array_equal(square, gin.jacobian(0.0, y))


def test_what_is_no_number_gives_none_and_no_crash():
    for name in machinist.built_in_names():
        model = machinist.load(name)
        for value in (np.nan, np.inf, -1e300):
            y = np.full(len(model.states), value)
            assert model.rate(0.0, y).shape == y.shape
            model.jacobian(np.nan, y)
            model.outputs_at(0.0, y, np.full(len(model.parameters), value))


def test_solve_ivp_agrees_with_a_method_of_ours(gin):
    integrate = pytest.importorskip("scipy.integrate")
    ours = gin.simulate(until=0.2, points=3, rtol=1e-10)
    found = integrate.solve_ivp(
        gin.rate, (0, 0.2), gin.initial_state(), method="Radau", jac=gin.jacobian,
        t_eval=ours.t, rtol=1e-9, atol=1e-10,
    )  # fmt: skip
    np.testing.assert_allclose(found.y, ours.y, rtol=1e-5, atol=1e-6)


@pytest.mark.parametrize(
    ("arguments", "kind", "told"),
    [
        (([1.0, 2.0],), machinist.ShapeError, "y has 2 values, but must have 7"),
        ((np.zeros((7, 1)),), machinist.ShapeError, r"shape \[7, 1\]"),
        ((np.zeros(7, complex),), machinist.InputError, "complex128"),
        ((["a"] * 7,), machinist.InputError, "real numbers"),
        ((None,), machinist.ShapeError, "one dimension"),
        ((np.zeros(7), [1.0]), machinist.ShapeError, "p has 1 values"),
        ((np.zeros(7), None, np.zeros(3)), machinist.ShapeError, "out has shape"),
        ((np.zeros(7), None, np.zeros(7, "f4")), machinist.InputError, "out must be"),
    ],
)
def test_wrong_shapes_and_kinds_are_refused(gin, arguments, kind, told):
    with pytest.raises(kind, match=told):
        gin.rate(0.0, *arguments)


def test_an_array_is_not_written_while_it_is_read(gin):
    y = np.zeros(7)
    with pytest.raises(machinist.InputError, match="nothing else borrows"):
        gin.rate(0.0, y, out=y)
    fixed = np.zeros(7)
    fixed.flags.writeable = False
    with pytest.raises(machinist.InputError, match="writable"):
        gin.rate(0.0, y, out=fixed)


#: From 0 with y' = 1.7 - y, from 0.5 with y' = 2.7 - y, from 0.7 with y' = 1.3 + y.
SWITCHES = """
[scene]
name = "switches"
[units.u]
unit = "u"
[run]
until = 0.5
points = 2
[define.u.states.y]
unit = "1"
rate = "(1 + floor(2*y) + abs(y - 0.7))/(1 [s])"
"""


def test_a_solver_that_holds_branches_passes_switches_exactly(tmp_path):
    integrate = pytest.importorskip("scipy.integrate")
    file = tmp_path / "switches.toml"
    file.write_text(SWITCHES)
    model = machinist.load(file)
    assert model.rate(0.0, [0.2]) == 1.5 and model.rate(0.0, [1.2]) == 3.5
    held = model.held(model.branches(0.0, [0.2]))
    assert sorted(abs(held.branches)) == [0.0, np.inf]
    assert held.rate(0.0, [1.2]) == 0.5 and held.jacobian(0.0, [1.2]) == -1.0

    t, y, switches = 0.0, np.zeros(1), []
    while t < 0.5:
        held = model.held(model.branches(t, y + 1e-12))

        def ends(t: float, y: np.ndarray, held: machinist.Held = held) -> float:
            return held.margins(t, y).min()

        ends.terminal, ends.direction = True, -1
        run = integrate.solve_ivp(held.rate, (t, 0.5), y, events=ends, rtol=1e-11, atol=1e-13)
        t, y = run.t[-1], run.y[:, -1]
        switches += run.t_events[0].tolist()
    exact = np.cumsum([np.log(1.7 / 1.2), np.log(2.2 / 2.0)])
    np.testing.assert_allclose(switches, exact, rtol=1e-9)
    np.testing.assert_allclose(y, 2.0 * np.exp(0.5 - exact[1]) - 1.3, rtol=1e-9)
    np.testing.assert_allclose(y, model.simulate(rtol=1e-11).y[:, -1], rtol=1e-9)


def test_branches_of_another_machine_are_refused(gin):
    assert gin.branches(0.0, np.zeros(len(gin.states))).size == 0
    with pytest.raises(machinist.ShapeError, match="branches"):
        gin.held([1.0])
