"""State-space models."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _machinist
from ._tables import html, text
from .errors import InputError, ShapeError

Array = NDArray[np.float64]


class StateSpace:
    """Model x' = A x + B u, y = C x + D u, or x[k+1] = A x[k] + B u[k], in deviations from an
    operating point. Constraints are eliminated: x contains independent coordinates.
    """

    def __init__(self, machine: str, at: str, told: dict[str, Any]) -> None:
        self._machine = machine
        self._at = at
        #: Names of x, u and y, their units, and their values at the operating point.
        self.states, self.state_units, self.x0 = _signals(told["states"])
        self.inputs, self.input_units, self.u0 = _signals(told["inputs"])
        self.outputs, self.output_units, self.y0 = _signals(told["outputs"])
        n, m, p = len(self.states), len(self.inputs), len(self.outputs)
        #: A (n by n), B (n by m), C (p by n) and D (p by m).
        self.A: Array = told["a"].reshape(n, n)
        self.B: Array = told["b"].reshape(n, m)
        self.C: Array = told["c"].reshape(p, n)
        self.D: Array = told["d"].reshape(p, m)
        #: Time of the operating point [s].
        self.time: float = told["time"]
        #: x' at the operating point; zero in equilibrium.
        self.drift: Array = told["drift"]
        #: States that constraints determine and that x leaves out.
        self.eliminated: tuple[str, ...] = tuple(told["eliminated"])
        #: Period of the samples [s]; None for a continuous model.
        self.period: float | None = told["period"]
        #: Poles and invariant zeros.
        self.poles = _roots(told["poles"])
        self.zeros = _roots(told["zeros"])
        #: Poles that no input moves and that no output shows, with the states of their motions.
        self.uncontrollable = [(complex(*pole), motion) for pole, motion in told["uncontrollable"]]
        self.unobservable = [(complex(*pole), motion) for pole, motion in told["unobservable"]]

    def lqr(self, Q: Mapping[str, float] | ArrayLike, R: ArrayLike | None = None) -> Regulator:
        """Linear-quadratic regulator u = u0 - K (x - x0), continuous or sampled as the model.

        :param Q: deviations of outputs and of inputs that cost 1, in their units:
            ``lqr({"height": 0.02, "command": 20})``. Or the weight of the states, as `R` the weight
            of all inputs: the cost is the integral (sampled: the sum) of x^T Q x + u^T R u.
        """
        if isinstance(Q, Mapping):
            told = self._design("lqr", self.B, self.C, self.D, self._weights(Q, R))
            inputs = tuple(name for name in self.inputs if name in Q)
            return Regulator(told, inputs, self.states)
        n, m = len(self.states), len(self.inputs)
        states, inverse = _root("Q", Q, n), _inverse_root("R", R, m)
        weights = [(f"u{k + 1}", 1.0) for k in range(m)] + [(f"y{k + 1}", 1.0) for k in range(n)]
        told = self._design("lqr", self.B @ inverse, states.T, np.zeros((n, m)), weights)
        told["gain"] = (inverse @ told["gain"].reshape(m, n)).ravel()
        return Regulator(told, self.inputs, self.states)

    def kalman(self, Q: Mapping[str, float] | ArrayLike, R: ArrayLike | None = None) -> Estimator:
        """Steady Kalman filter for disturbed inputs and measured outputs.

        :param Q: standard deviations of noise on inputs and on measured outputs, of each sample; of
            a continuous model square roots of spectral densities:
            ``kalman({"height": 5e-3, "gust": 300})``. Or the covariance of the inputs, as `R` that
            of all outputs.
        """
        if isinstance(Q, Mapping):
            told = self._design("kalman", self.B, self.C, self.D, self._weights(Q, R))
            outputs = tuple(name for name in self.outputs if name in Q)
            return Estimator(told, outputs, self.states)
        m, p = len(self.inputs), len(self.outputs)
        # Measurements y of unit noise are inverse y, with inverse inverse^T = R^-1.
        inputs, inverse = _root("Q", Q, m), _inverse_root("R", R, p).T
        weights = [(f"u{k + 1}", 1.0) for k in range(m)] + [(f"y{k + 1}", 1.0) for k in range(p)]
        matrices = (self.B @ inputs, inverse @ self.C, inverse @ self.D @ inputs)
        told = self._design("kalman", *matrices, weights)
        for key in ("gain", "correction"):
            if told[key] is not None:
                told[key] = (told[key].reshape(len(self.states), p) @ inverse).ravel()
        return Estimator(told, self.outputs, self.states)

    def _weights(
        self, deviations: Mapping[str, float], other: ArrayLike | None
    ) -> list[tuple[str, float]]:
        if other is not None:
            raise InputError("R is for matrices; deviations of all signals are in the first one")
        names = {name: f"u{k + 1}" for k, name in enumerate(self.inputs)}
        names |= {name: f"y{k + 1}" for k, name in enumerate(self.outputs)}
        for name in deviations:
            if name not in names:
                hint = _machinist.did_you_mean(name, list(names))
                raise InputError(f"the model has no input or output `{name}`{hint}")
        return [(names[name], float(deviation)) for name, deviation in deviations.items()]

    def _design(
        self, kind: str, B: Array, C: Array, D: Array, weights: list[tuple[str, float]]
    ) -> dict[str, Any]:
        matrices = [np.ascontiguousarray(matrix).ravel() for matrix in (self.A, B, C, D)]
        sizes = (len(self.states), B.shape[1], C.shape[0])
        return _machinist.design(kind, (matrices, sizes), self.period, weights)

    def to_control(self) -> Any:
        """The model as `control.StateSpace` of python-control, with the names of its signals."""
        import control

        signals = {"states": self.states, "inputs": self.inputs, "outputs": self.outputs}
        # python-control reserves dots in names for signals of subsystems.
        names = {key: [name.replace(".", "_") for name in of] for key, of in signals.items()}
        dt = 0 if self.period is None else self.period
        return control.ss(self.A, self.B, self.C, self.D, dt, name=self._machine, **names)

    def to_scipy(self) -> Any:
        """The model as `scipy.signal.StateSpace`."""
        import scipy.signal

        dt = {} if self.period is None else {"dt": self.period}
        return scipy.signal.StateSpace(self.A, self.B, self.C, self.D, **dt)

    def _title(self) -> str:
        sampled = "" if self.period is None else f", sampled at {self.period:g} s"
        return f"Linear model of {self._machine}, {self._at}, t = {self.time:g} s{sampled}"

    def _rows(self) -> list[list[str]]:
        kinds = (
            ("state", self.states, self.state_units, self.x0),
            ("input", self.inputs, self.input_units, self.u0),
            ("output", self.outputs, self.output_units, self.y0),
        )
        return [
            [kind, name, f"{value:.6g}", unit]
            for kind, names, units, values in kinds
            for name, unit, value in zip(names, units, values)
        ]

    def __repr__(self) -> str:
        return "\n".join([self._title(), *text(_HEADING, self._rows())])

    def _repr_html_(self) -> str:
        return html(self._title(), _HEADING, self._rows())


class LinearPiece:
    """Linear models about the motion of a part of a run: dx' = A(t) dx + B(t) du."""

    def __init__(self, told: dict[str, Any]) -> None:
        #: Names of x, u and y.
        self.states = tuple(name for name, _ in told["states"])
        self.inputs = tuple(name for name, _ in told["inputs"])
        self.outputs = tuple(name for name, _ in told["outputs"])
        k, n = len(told["times"]), len(self.states)
        m, p = len(self.inputs), len(self.outputs)
        #: Times [s], and the matrices at each: A[k] is that at times[k].
        self.times: Array = told["times"]
        self.A: Array = told["a"].reshape(k, n, n)
        self.B: Array = told["b"].reshape(k, n, m)
        self.C: Array = told["c"].reshape(k, p, n)
        self.D: Array = told["d"].reshape(k, p, m)
        #: x, y and x' along the motion.
        self.x: Array = told["x"].reshape(k, n)
        self.y: Array = told["y"].reshape(k, p)
        self.drift: Array = told["drift"].reshape(k, n)
        #: Modes in this piece, and states that constraints determine and x leaves out.
        self.modes: dict[str, float] = dict(told["modes"])
        self.eliminated: tuple[str, ...] = tuple(told["eliminated"])

    def __repr__(self) -> str:
        span = f"{self.times[0]:g} s to {self.times[-1]:g} s"
        return f"{len(self.times)} linear models of order {len(self.states)}, {span}"


class Regulator:
    """Linear-quadratic regulator u = u0 - K (x - x0). It unpacks as `control.lqr`: K, S, E."""

    def __init__(
        self, told: dict[str, Any], inputs: tuple[str, ...], states: tuple[str, ...]
    ) -> None:
        m, n = len(inputs), len(states)
        #: Names of the controlled inputs, the rows of K, and of the states, its columns.
        self.inputs, self.states = inputs, states
        #: Gain, and the solution of the Riccati equation: x^T S x is the cost from x on.
        self.K: Array = told["gain"].reshape(m, n)
        self.S: Array = told["cost"].reshape(n, n)
        #: Poles of the closed loop, the eigenvalues of A - B K.
        self.poles = _roots(told["poles"])

    def __iter__(self) -> Iterator[Any]:
        return iter((self.K, self.S, self.poles))


class Estimator:
    """Steady Kalman filter. It unpacks as `control.lqe`: L, P, E."""

    def __init__(
        self, told: dict[str, Any], outputs: tuple[str, ...], states: tuple[str, ...]
    ) -> None:
        n, p = len(states), len(outputs)
        #: Names of the measured outputs, the columns of L, and of the states, its rows.
        self.outputs, self.states = outputs, states
        #: Gain: of x' (continuous), or of the prediction x[k+1].
        self.L: Array = told["gain"].reshape(n, p)
        #: Gain of the correction x[k|k] of a sampled model; None for a continuous one.
        corrects = told["correction"] is not None
        self.M: Array | None = told["correction"].reshape(n, p) if corrects else None
        #: Covariance of the error of x before the measurement.
        self.P: Array = told["covariance"].reshape(n, n)
        #: Poles of the estimator, the eigenvalues of A - L C.
        self.poles = _roots(told["poles"])

    def __iter__(self) -> Iterator[Any]:
        return iter((self.L, self.P, self.poles))


_HEADING = ("", "name", "at the point", "unit")


def _signals(
    told: Sequence[tuple[str, str, float]],
) -> tuple[tuple[str, ...], tuple[str, ...], Array]:
    names = tuple(name for name, _, _ in told)
    units = tuple(unit for _, unit, _ in told)
    return names, units, np.array([value for _, _, value in told], dtype=float)


def _roots(told: Sequence[tuple[float, float]]) -> NDArray[np.complex128]:
    return np.array([complex(*root) for root in told], dtype=complex)


def _symmetric(name: str, given: ArrayLike | None, size: int) -> Array:
    if given is None:
        raise InputError(f"{name} is missing")
    matrix = np.atleast_2d(np.asarray(given, dtype=float))
    if matrix.shape != (size, size):
        raise ShapeError(f"{name} is {matrix.shape}, but must be {(size, size)}")
    if not np.isfinite(matrix).all() or not np.allclose(matrix, matrix.T, rtol=1e-12, atol=0.0):
        raise InputError(f"{name} must be finite and symmetric")
    return 0.5 * (matrix + matrix.T)


def _root(name: str, given: ArrayLike | None, size: int) -> Array:
    """F with F F^T = the matrix, which is positive semidefinite."""
    matrix = _symmetric(name, given, size)
    scale = np.sqrt(np.abs(np.diag(matrix)))
    scale[scale == 0.0] = 1.0
    values, vectors = np.linalg.eigh(matrix / np.outer(scale, scale))
    if (values < -1e-12 * size).any():
        raise InputError(f"{name} must not have negative eigenvalues")
    return scale[:, None] * vectors * np.sqrt(np.maximum(values, 0.0))


def _inverse_root(name: str, given: ArrayLike | None, size: int) -> Array:
    """F with F F^T = the inverse of the matrix, which is positive definite."""
    try:
        lower = np.linalg.cholesky(_symmetric(name, given, size))
    except np.linalg.LinAlgError:
        raise InputError(f"{name} must be positive definite") from None
    return np.linalg.inv(lower).T
