"""State-space models."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._tables import html, text

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


_HEADING = ("", "name", "at the point", "unit")


def _signals(
    told: Sequence[tuple[str, str, float]],
) -> tuple[tuple[str, ...], tuple[str, ...], Array]:
    names = tuple(name for name, _, _ in told)
    units = tuple(unit for _, unit, _ in told)
    return names, units, np.array([value for _, _, value in told], dtype=float)


def _roots(told: Sequence[tuple[float, float]]) -> NDArray[np.complex128]:
    return np.array([complex(*root) for root in told], dtype=complex)
