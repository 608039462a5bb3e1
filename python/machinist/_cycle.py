"""Periodic motions, Floquet multipliers and branches."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _machinist
from ._run import Run
from ._tables import html, text
from .errors import ShapeError

if TYPE_CHECKING:
    from ._model import Model, Parameters

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Multiplier:
    """Factor by which a small disturbance of a periodic motion grows in a period."""

    #: The multiplier.
    value: complex
    #: True for the multiplier 1 of a motion of unknown period, which belongs to its phase.
    is_trivial: bool
    #: Bifurcation at which it would leave the unit circle: fold, flip or Neimark-Sacker.
    crossing: str
    #: Changes of the states by name, in their units; the largest over its scale is 1.
    vector: dict[str, complex]

    @property
    def modulus(self) -> float:
        """Modulus of the multiplier."""
        return abs(self.value)


_HEADING = ("multiplier", "modulus", "leaves at")


class Cycle:
    """A periodic motion with its stability."""

    def __init__(self, machine: str, states: Sequence[str], told: dict[str, Any]) -> None:
        self._machine = machine
        #: Start of the period [s].
        self.start: float = told["start"]
        #: Period [s].
        self.period: float = told["period"]
        #: True if the period is that of an excitation, False if it was solved for.
        self.is_forced: bool = told["is_forced"]
        #: State at the start, in the order of the machine's states.
        self.state: Array = told["state"]
        #: Largest relative difference of the state after a period.
        self.residual: float = told["residual"]
        #: Number of Newton's steps.
        self.iterations: int = told["iterations"]
        #: Remarks on the runs.
        self.notes: list[str] = told["notes"]
        #: stable, unstable or neutral.
        self.stability: str = told["stability"]
        #: The motion over one period.
        self.motion = Run(told["motion"])
        #: Floquet multipliers in descending order of their moduli.
        self.multipliers: tuple[Multiplier, ...] = tuple(
            Multiplier(
                complex(*value),
                is_trivial,
                crossing,
                dict(zip(states, (real + 1j * imaginary).tolist())),
            )
            for value, is_trivial, crossing, (real, imaginary) in told["multipliers"]
        )

    def __getitem__(self, name: str) -> Array:
        """Column of the motion by name."""
        return self.motion[name]

    def amplitude(self, name: str) -> float:
        """Half the range of a column over the period."""
        values = self.motion[name]
        return float(values.max() - values.min()) / 2

    def _rows(self) -> list[list[str]]:
        return [
            [f"{m.value:.9g}", f"{m.modulus:.9g}", "phase" if m.is_trivial else m.crossing]
            for m in self.multipliers
        ]

    def __repr__(self) -> str:
        kind = "of the excitation" if self.is_forced else "solved for"
        lines = [f"{self._machine}: {self.stability}, period {self.period:.10g} s ({kind})"]
        lines += [f"note: {note}" for note in self.notes]
        return "\n".join([*lines, *text(_HEADING, self._rows())])

    def _repr_html_(self) -> str:
        return html(repr(self).splitlines()[0], _HEADING, self._rows())


@dataclass(frozen=True, eq=False)
class BranchPoint:
    """A motion of a branch."""

    #: Value of the parameter.
    value: float
    #: Bifurcation located here, else None: fold, branch point, flip, Neimark-Sacker, jump, grazing,
    #: nonsmooth fold or other events.
    bifurcation: str | None
    #: Guard that is grazed here.
    grazed: str | None
    #: The motion.
    cycle: Cycle


class Branch(Sequence[BranchPoint]):
    """Periodic motions over a parameter, in the order of the branch."""

    def __init__(
        self,
        machine: str,
        states: Sequence[str],
        told: dict[str, Any],
        doubled: Sequence[Branch] = (),
    ) -> None:
        self._machine = machine
        #: Branches of twice the period that begin at flips, and those that begin at their flips.
        self.doubled: tuple[Branch, ...] = tuple(doubled)
        #: Parameter that was followed.
        self.parameter: str = told["parameter"]
        #: Its unit.
        self.unit: str = told["unit"]
        #: Reason why the branch ends.
        self.end: str = told["end"]
        #: True if the branch reached an end of the range, or its own start.
        self.is_complete: bool = told["is_complete"]
        self._points = tuple(
            BranchPoint(value, bifurcation, grazed, Cycle(machine, states, cycle))
            for value, bifurcation, grazed, cycle in told["points"]
        )

    @overload
    def __getitem__(self, index: int) -> BranchPoint: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[BranchPoint]: ...
    def __getitem__(self, index: int | slice) -> BranchPoint | Sequence[BranchPoint]:
        return self._points[index]

    def __len__(self) -> int:
        return len(self._points)

    @property
    def values(self) -> Array:
        """Values of the parameter."""
        return np.array([point.value for point in self])

    @property
    def bifurcations(self) -> list[BranchPoint]:
        """Points at which bifurcations were located."""
        return [point for point in self if point.bifurcation]

    def amplitudes(self, name: str) -> Array:
        """Half the range of a column over each period."""
        return np.array([point.cycle.amplitude(name) for point in self])

    def __repr__(self) -> str:
        head = f"{self._machine}: {len(self)} motions over {self.parameter} [{self.unit}]"
        rows = [[str(p.bifurcation), f"{p.value:.9g}"] for p in self.bifurcations]
        return "\n".join([head, f"ends at {self.end}", *text(("bifurcation", "at"), rows)])


class Sections:
    """Values of columns once in a period of the excitation, over a parameter."""

    def __init__(
        self,
        machine: str,
        over: tuple[str, Array],
        columns: Sequence[str],
        told: tuple[list[Array | None], list[str | None], list[int | None]],
    ) -> None:
        tables, reasons, repeats = told
        self._machine = machine
        #: Parameter that was varied, and its values.
        self.parameter, self.values = over
        #: Names of the columns.
        self.columns: tuple[str, ...] = tuple(columns)
        #: Reason why a run stopped, for each value; None if it did not.
        self.reasons: list[str | None] = reasons
        #: Number of periods after which the motion repeats, for each value; None if it does not
        #: within half of the returns.
        self.repeats: list[int | None] = repeats
        found = next((table for table in tables if table is not None), None)
        shape = (len(self.columns), 0) if found is None else found.shape
        missing = np.full(shape, np.nan)
        self._table = np.array([missing if table is None else table for table in tables])

    def __getitem__(self, name: str) -> Array:
        """Values of a column: a row for each value of the parameter, NaN if its run stopped."""
        if name not in self.columns:
            raise KeyError(name)
        values: Array = self._table[:, self.columns.index(name), :]
        return values

    def __repr__(self) -> str:
        return (
            f"{self._machine}: {', '.join(self.columns)} once in a period over {self.parameter}, "
            f"{len(self.values)} values of {self._table.shape[2]} periods"
        )


def cycle(
    model: Model,
    period: str | float | None = None,
    *,
    guess: float | None = None,
    multiple: int = 1,
    turns: Mapping[str, float] | None = None,
    settle: float | None = None,
    segments: int = 1,
    points: int = 401,
    parameters: Parameters | None = None,
    initial: Mapping[str, float] | ArrayLike | None = None,
    **settings: Any,
) -> Cycle:
    """Periodic motion near the end of a run, with its Floquet multipliers.

    :param period: period of the excitation [s], or the parameter that determines it (rad/s, Hz
        or s); None for a machine that oscillates by itself, whose period is solved for.
    :param guess: first guess of an unknown period [s].
    :param multiple: number of periods of the excitation in a period of the motion.
    :param turns: angles that advance by whole turns in a period, with their numbers of turns.
    :param settle: time for which the machine runs first [s]; default: the length of the run.
    :param segments: number of segments of the period (multiple shooting).
    :param settings: settings of the runs, as for :meth:`Model.simulate`; `rtol` is at most 1e-10 by
        default.
    :raises AnalysisError: no periodic motion was found.
    """
    given = _settings(parameters, initial, settings)
    counts = (multiple, segments, points)
    search = (period, guess, list((turns or {}).items()), settle, counts)
    told = _machinist.cycle(model._machine, given, search)
    return Cycle(model.name, tuple(model.states), told)


def branch(
    model: Model,
    over: str,
    start_value: float,
    end_value: float,
    *,
    period: str | float | None = None,
    guess: float | None = None,
    multiple: int = 1,
    turns: Mapping[str, float] | None = None,
    settle: float | None = None,
    segments: int = 1,
    points: int = 401,
    longest_step: float = 0.05,
    max_points: int = 1000,
    doublings: int = 0,
    parameters: Parameters | None = None,
    initial: Mapping[str, float] | ArrayLike | None = None,
    **settings: Any,
) -> Branch:
    """Follow a periodic motion over a parameter, through folds, flips and other bifurcations.

    :param over: parameter, from `start_value` until the branch leaves the range to `end_value`.
    :param longest_step: longest step as a share of the range.
    :param max_points: maximum number of motions.
    :param doublings: follow branches of twice the period that begin at flips, and those that begin
        at their flips, up to this number of doublings; see :attr:`Branch.doubled`.
    :param period: as all others, see :func:`cycle`.
    """
    given = _settings(parameters, initial, settings)
    counts = (multiple, segments, points)
    search = (period, guess, list((turns or {}).items()), settle, counts)
    ends = (over, float(start_value), float(end_value))
    steps = (longest_step, max_points, doublings)
    first, *others = _machinist.branches(model._machine, given, search, ends, steps)
    states = tuple(model.states)
    return Branch(
        model.name, states, first, [Branch(model.name, states, other) for other in others]
    )


def sections(
    model: Model,
    over: str,
    values: ArrayLike,
    *,
    period: str | float,
    returns: int = 64,
    columns: Sequence[str] | None = None,
    settle: float | None = None,
    threads: int = 0,
    parameters: Parameters | None = None,
    initial: Mapping[str, float] | ArrayLike | None = None,
    **settings: Any,
) -> Sections:
    """Run a machine at values of a parameter and keep columns once in a period (Poincare section).

    :param over: parameter that takes the `values`.
    :param period: period of the excitation [s], or the parameter that determines it.
    :param returns: number of periods after the time to settle that are kept.
    :param columns: outputs and states; default: all outputs, or all states if there are none.
    :param settle: time for which the machine runs first [s]; default: the length of the run.
    :param threads: number of threads; default: the number of cores.
    :param settings: settings of the runs, as for :meth:`Model.simulate`.
    """
    given = _settings(parameters, initial, settings)
    places = np.atleast_1d(np.asarray(values, dtype=float))
    if places.ndim != 1:
        raise ShapeError("the values of a parameter are a list")
    names = tuple(model.outputs or model.states) if columns is None else tuple(columns)
    told = _machinist.sections(
        model._machine,
        given,
        (period, None, [], settle, (1, 1, 2)),
        (over, places.tolist()),
        names,
        (returns, threads),
    )
    return Sections(model.name, (over, places), names, told)


def _settings(
    parameters: Parameters | None,
    initial: Mapping[str, float] | ArrayLike | None,
    settings: dict[str, Any],
) -> dict[str, Any]:
    given = {"parameters": parameters, "initial": initial, **settings}
    given = {name: value for name, value in given.items() if value is not None}
    if initial is not None:
        # The search begins at these values, not in the equilibrium near them.
        given.setdefault("equilibrium", False)
    return given
