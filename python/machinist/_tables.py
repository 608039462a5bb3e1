"""Tables of names with units and descriptions, as text and HTML."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from html import escape
from typing import Generic, TypeVar

from . import _machinist
from .errors import UnknownNameError


@dataclass(frozen=True)
class Quantity:
    """A quantity of a machine: name, SI unit and description."""

    name: str
    unit: str
    doc: str


@dataclass(frozen=True)
class Parameter(Quantity):
    """A parameter with its value in the scene.

    `tunable` is true if the parameter may change between two segments of a run and has an effect
    there: rates, outputs or events depend on it, constraints do not.
    """

    value: float
    tunable: bool


@dataclass(frozen=True)
class State(Quantity):
    """An entry of the state y = [q, q', z].

    `kind` is position, velocity, first order or mode (an integer that events change).
    """

    kind: str
    scale: float


@dataclass(frozen=True)
class Event(Quantity):
    """Event at a zero crossing of a guard."""


Row = TypeVar("Row", bound=Quantity)


class Table(Mapping[str, Row], Generic[Row]):
    """Quantities by name, in the order of the machine."""

    def __init__(
        self, machine: str, what: str, rows: Sequence[Row], heading: Sequence[str]
    ) -> None:
        self._machine = machine
        self._what = what
        self._rows = tuple(rows)
        self._heading = tuple(heading)
        self._places = {row.name: place for place, row in enumerate(self._rows)}

    def __getitem__(self, name: str) -> Row:
        return self._rows[self.index(name)]

    def __iter__(self) -> Iterator[str]:
        return iter(self._places)

    def __len__(self) -> int:
        return len(self._rows)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the quantities."""
        return tuple(self._places)

    def index(self, name: str) -> int:
        """Index of a name, from 0."""
        try:
            return self._places[name]
        except (KeyError, TypeError):
            hint = _machinist.did_you_mean(str(name), list(self._places))
            raise UnknownNameError(f"{self._machine} has no {self._what} `{name}`{hint}") from None

    def _cells(self) -> list[list[str]]:
        return [[told(getattr(row, name)) for name in self._heading] for row in self._rows]

    def __repr__(self) -> str:
        title = f"{len(self)} {self._what}{'' if len(self) == 1 else 's'} of {self._machine}"
        return "\n".join([title, *text(self._heading, self._cells())])

    def _repr_html_(self) -> str:
        return html(f"{len(self)} {self._what}s of {self._machine}", self._heading, self._cells())


def told(value: object) -> str:
    """Text of a table cell."""
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:.9g}" if isinstance(value, float) else str(value)


def text(heading: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Lines of a text table with aligned columns."""
    if not rows:
        return []
    table = [heading, *rows]
    widths = [max(len(row[column]) for row in table) for column in range(len(heading))]
    return ["  ".join(c.ljust(w) for c, w in zip(row, widths)).rstrip() for row in table]


def html(title: str, heading: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """HTML table for notebooks."""
    head = "".join(f"<th>{escape(name)}</th>" for name in heading)
    body = "".join(
        "<tr>" + "".join(f"<td>{escape(cell)}</td>" for cell in row) + "</tr>" for row in rows
    )
    return (
        f"<table><caption>{escape(title)}</caption>"
        f"<thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>"
    )
