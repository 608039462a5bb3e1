"""Runs: times and columns as NumPy arrays."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _machinist, _svg
from ._tables import Quantity, html, text
from .errors import UnknownNameError

if TYPE_CHECKING:
    import pandas
    import polars

Array = NDArray[np.float64]


class Happened(NamedTuple):
    """An event of a run."""

    time: float
    name: str


class Stop(NamedTuple):
    """Time and cause of an early end of a run."""

    time: float
    cause: str


@dataclass(frozen=True)
class Column(Quantity):
    """A column of a run; `kind` is state, output, energy or sensitivity."""

    kind: str


class Columns(Mapping[str, Array]):
    """Columns of one kind by name, without copies."""

    def __init__(self, run: Run, kind: str) -> None:
        self._run = run
        self._places = {
            column.name: place
            for place, column in enumerate(run.columns)
            if column.kind == kind
        }
        self._kind = kind

    def __getitem__(self, name: str) -> Array:
        try:
            return self._run._native.values(self._places[name])
        except (KeyError, TypeError):
            hint = _machinist.did_you_mean(str(name), list(self._places))
            raise UnknownNameError(f"the run has no {self._kind} `{name}`{hint}") from None

    def __iter__(self) -> Iterator[str]:
        return iter(self._places)

    def __len__(self) -> int:
        return len(self._places)

    def __repr__(self) -> str:
        return f"<{len(self)} columns: {', '.join(self)}>"


class Run:
    """Result of a simulation.

    `run["twist"]` is a column by name: a state, else an output, an energy or a sensitivity.
    `run.states` and `run.outputs` select one kind. Arrays are views of the run's memory.
    """

    def __init__(self, native: _machinist.Run) -> None:
        self._native = native
        self._told: dict[str, Any] | None = None
        self._columns: tuple[Column, ...] | None = None
        self._kinds: dict[str, Columns] = {}

    @property
    def t(self) -> Array:
        """Output times [s]."""
        return self._native.times()

    @property
    def columns(self) -> tuple[Column, ...]:
        """Name, unit, kind and description of every column."""
        if self._columns is None:
            rows = self._native.columns()
            self._columns = tuple(Column(name, unit, doc, kind) for name, unit, kind, doc in rows)
        return self._columns

    def _of(self, kind: str) -> Columns:
        if kind not in self._kinds:
            self._kinds[kind] = Columns(self, kind)
        return self._kinds[kind]

    @property
    def states(self) -> Columns:
        """States by name."""
        return self._of("state")

    @property
    def outputs(self) -> Columns:
        """Outputs by name."""
        return self._of("output")

    @property
    def energies(self) -> Columns:
        """Energies of the machine [J]."""
        return self._of("energy")

    @property
    def sensitivities(self) -> Columns:
        """Requested derivatives, named as in `d(twist)/d(coupling.stiffness)`."""
        return self._of("sensitivity")

    def sensitivity(self, of: str, by: str) -> Array:
        """d(of)/d(by) over time: state or output by parameter or initial value."""
        return self.sensitivities[f"d({of})/d({by})"]

    @property
    def y(self) -> Array:
        """Copy of the states as one array of shape (states, times), as in SciPy's results."""
        return np.array([self.states[name] for name in self.states]).reshape(-1, len(self.t))

    def __getitem__(self, name: str) -> Array:
        for place, column in enumerate(self.columns):
            if column.name == name:
                return self._native.values(place)
        hint = _machinist.did_you_mean(str(name), [column.name for column in self.columns])
        raise UnknownNameError(f"the run has no column `{name}`{hint}")

    def __contains__(self, name: object) -> bool:
        return any(column.name == name for column in self.columns)

    def __len__(self) -> int:
        return len(self.t)

    def _all_told(self) -> dict[str, Any]:
        if self._told is None:
            self._told = self._native.told()
        return self._told

    @property
    def machine(self) -> str:
        """Name of the scene."""
        return self._all_told()["machine"]

    @property
    def method(self) -> str:
        """Integration method used."""
        return self._all_told()["method"]

    @property
    def rtol(self) -> float:
        """Relative tolerance used."""
        return self._all_told()["rtol"]

    @property
    def work(self) -> dict[str, int]:
        """Work counters: steps, rejected steps, evaluations and so on."""
        return dict(self._all_told()["work"])

    @property
    def notes(self) -> list[str]:
        """Notes of the method on the run; usually empty."""
        return list(self._all_told()["notes"])

    @property
    def events(self) -> list[Happened]:
        """Events in order of time."""
        return [Happened(*event) for event in self._all_told()["events"]]

    @property
    def stopped(self) -> Stop | None:
        """Time and cause of an early end; None for a complete run."""
        stopped = self._all_told()["stopped"]
        return None if stopped is None else Stop(*stopped)

    @property
    def drift(self) -> tuple[float, float] | None:
        """Constraint drift before and after projection, or None."""
        return self._all_told()["drift"]

    @property
    def energy_residual(self) -> float | None:
        """Relative residual of the energy balance, if `energy_balance` was requested."""
        return self._all_told()["energy_residual"]

    @property
    def error(self) -> dict[str, float] | None:
        """Estimated error of each column, if `error` or `accuracy` was requested and succeeded."""
        return self._all_told()["error"]

    @property
    def error_unknown(self) -> str | None:
        """Reason why a requested error estimate is unavailable."""
        return self._all_told()["error_unknown"]

    def to_pandas(self) -> pandas.DataFrame:
        """Columns as a pandas DataFrame indexed by time, units in `attrs["units"]`."""
        import pandas

        frame = pandas.DataFrame(
            self._by_name(), index=pandas.Index(self.t, name="t"), copy=False
        )
        frame.attrs["units"] = {"t": "s", **{c.name: c.unit for c in self.columns}}
        return frame

    def to_polars(self) -> polars.DataFrame:
        """Columns as a polars DataFrame, time first."""
        import polars

        return polars.DataFrame({"t": self.t, **self._by_name()})

    def _by_name(self) -> dict[str, Array]:
        """All columns by name; a state takes precedence over an output of the same name."""
        named: dict[str, Array] = {}
        for place, column in enumerate(self.columns):
            named.setdefault(column.name, self._native.values(place))
        return named

    def plot(self, columns: Sequence[str] | None = None) -> Picture:
        """Plot columns over time, one panel per unit; default: the outputs.

        Notebooks display the result; `.save("run.svg")` writes it to a file.
        """
        names = list(columns) if columns is not None else list(self.outputs) or list(self.states)
        units = {column.name: column.unit for column in self.columns}
        panels: dict[str, list[tuple[str, Array]]] = {}
        for name in names:
            values = self[name]
            unit = units[name]
            panels.setdefault(unit, []).append((name, values))
        told = self._all_told()
        marks = sorted({event.time for event in self.events})[:50]
        return Picture(
            _svg.plot(told["title"], self.t, list(panels.items()), marks=marks)
        )

    def __repr__(self) -> str:
        told = self._all_told()
        ends = f"{self.t[0]:g} s to {self.t[-1]:g} s" if len(self) else "nothing"
        lines = [
            f"{told['machine']}: {told['title']}",
            f"{told['method']}, rtol {told['rtol']:g}, {ends}, {len(self)} points, "
            f"{told['work']['steps']} steps, {len(told['events'])} events",
        ]
        if self.stopped:
            lines.append(f"stopped at t = {self.stopped.time:g} s: {self.stopped.cause}")
        lines += [f"note: {note}" for note in told["notes"]]
        return "\n".join([*lines, *text(_HEADING, self._rows())])

    def _rows(self) -> list[list[str]]:
        def row(place: int, column: Column) -> list[str]:
            values = self._native.values(place)
            least, greatest, last = (
                (values.min(), values.max(), values[-1]) if len(values) else (np.nan,) * 3
            )
            numbers = [f"{value:.6g}" for value in (least, greatest, last)]
            return [column.name, column.unit, column.kind, *numbers]

        return [row(place, column) for place, column in enumerate(self.columns)]

    def _repr_html_(self) -> str:
        picture = self.plot()._repr_svg_() if len(self) > 1 else ""
        return f"{picture}{html(repr(self).splitlines()[1], _HEADING, self._rows())}"


_HEADING = ("name", "unit", "kind", "least", "greatest", "last")


class Picture:
    """An SVG picture, displayed by notebooks."""

    def __init__(self, svg: str) -> None:
        #: SVG source.
        self.svg = svg

    def _repr_svg_(self) -> str:
        return self.svg

    def save(self, path: str) -> None:
        """Write the picture to a file."""
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.svg)

    def __repr__(self) -> str:
        return f"<picture, {len(self.svg)} bytes of SVG>"
