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
