"""Native part of the package: the interface between Rust and Python."""

from collections.abc import Mapping, Sequence
from os import PathLike
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]
#: Period, guess, turns, time to settle; multiple, segments, points.
Search = tuple[
    str | float | None,
    float | None,
    Sequence[tuple[str, float]],
    float | None,
    tuple[int, int, int],
]

__version__: str
MODEL_MARK: bytes
MODEL_VERSION: int

class Machine:
    """A machine ready to run."""

    @staticmethod
    def built_in(name: str, elements: int | None, order: int | None) -> Machine | None: ...
    @staticmethod
    def of_model(bytes: bytes, elements: int | None, order: int | None) -> Machine: ...
    @property
    def fingerprint(self) -> str: ...
    @property
    def states(self) -> int: ...
    def defaults(self) -> Array: ...
    def describe(self) -> dict[str, Any]: ...
    def rate(
        self,
        t: float,
        y: ArrayLike,
        p: ArrayLike | None = None,
        out: Array | None = None,
        held: ArrayLike | None = None,
    ) -> Array: ...
    def branches(self, t: float, y: ArrayLike, p: ArrayLike | None = None) -> Array: ...
    def margins(
        self, t: float, y: ArrayLike, held: ArrayLike, p: ArrayLike | None = None
    ) -> Array: ...
    def outputs(
        self, t: float, y: ArrayLike, p: ArrayLike | None = None, out: Array | None = None
    ) -> Array: ...
    def jacobian(
        self,
        t: float,
        y: ArrayLike,
        p: ArrayLike | None = None,
        out: Array | None = None,
        held: ArrayLike | None = None,
    ) -> Array: ...
    def jacobian_pattern(self) -> tuple[list[int], list[int]]: ...
    def initial_state(self, p: ArrayLike | None = None) -> Array: ...
    def discontinuities(self, p: ArrayLike | None = None) -> Array: ...
    def simulate(self, settings: dict[str, Any]) -> tuple[Run | None, Exception | None]: ...
    def time_runs(self, settings: dict[str, Any], runs: int) -> list[float]: ...

class Run:
    """A run: times and numeric columns."""

    def times(self) -> Array: ...
    def columns(self) -> list[tuple[str, str, str, str]]: ...
    def values(self, column: int) -> Array: ...
    def told(self) -> dict[str, Any]: ...

class Stepper:
    """A run that is carried in pieces."""

    def __init__(self, machine: Machine, settings: dict[str, Any]) -> None: ...
    @staticmethod
    def restore(machine: Machine, bytes: bytes) -> Stepper: ...
    def save(self) -> bytes: ...
    def copy(self) -> Stepper: ...
    def advance(self, until: float, halts: bool) -> list[tuple[float, str]]: ...
    def set(self, values: Mapping[str, float] | ArrayLike) -> None: ...
    @property
    def time(self) -> float: ...
    @property
    def state(self) -> Array: ...
    @property
    def parameters(self) -> Array: ...
    @property
    def rate(self) -> Array: ...
    @property
    def outputs(self) -> Array: ...
    @property
    def is_sliding(self) -> bool: ...
    @property
    def manner(self) -> tuple[str, float]: ...

def built_in_names() -> list[str]:
    """Names of the built-in scenes, sorted."""

def machine_names() -> list[str]:
    """Names of the machines of standard parts that come with the package, sorted."""

def derive(
    file: PathLike[str] | None, name: str | None, keep_all: bool
) -> tuple[bytes | None, list[tuple[str, str, int, int, int, str, str, str]]] | None: ...
def program(again: tuple[str, Sequence[str]], arguments: Sequence[str]) -> int: ...
def methods() -> list[tuple[str, int, bool, str]]: ...
def did_you_mean(name: str, known: list[str]) -> str: ...
def modes(machine: Machine, settings: dict[str, Any], at: str, by: list[str]) -> dict[str, Any]: ...
def response(
    machine: Machine,
    settings: dict[str, Any],
    at: str,
    from_to: tuple[str, str],
    frequencies: ArrayLike | None,
    points: int,
) -> tuple[str, str, str, list[Array], float | None, tuple[float, float] | None]: ...
def state_space(
    machine: Machine,
    settings: dict[str, Any],
    at: str,
    signals: tuple[Sequence[str], Sequence[str]],
    sampling: tuple[float, str] | None,
) -> dict[str, Any]: ...
def design(
    kind: str,
    matrices: tuple[list[Array], tuple[int, int, int]],
    period: float | None,
    weights: Sequence[tuple[str, float]],
) -> dict[str, Any]: ...
def pieces_along(
    machine: Machine,
    settings: dict[str, Any],
    signals: tuple[Sequence[str], Sequence[str]],
    times: ArrayLike,
) -> list[dict[str, Any]]: ...
def cycle(machine: Machine, settings: dict[str, Any], search: Search) -> dict[str, Any]: ...
def branches(
    machine: Machine,
    settings: dict[str, Any],
    search: Search,
    over: tuple[str, float, float],
    steps: tuple[float, int, int],
) -> list[dict[str, Any]]: ...
def sections(
    machine: Machine,
    settings: dict[str, Any],
    search: Search,
    over: tuple[str, list[float]],
    columns: Sequence[str],
    counts: tuple[int, int],
) -> tuple[list[Array | None], list[str | None], list[int | None]]: ...
def fit(
    machine: Machine,
    settings: dict[str, Any],
    asked: list[tuple[str, tuple[float, float] | None]],
    runs: list[tuple[Array, list[tuple[str, Array]]]],
    sigma: list[tuple[str, float]],
    is_robust: bool,
    starts: int,
    steps: int,
) -> dict[str, Any]: ...
def negative_inertias(
    machine: Machine, settings: dict[str, Any], names: Sequence[str], values: Array
) -> tuple[int, int, str] | None: ...
def sweep_piece(
    machine: Machine,
    settings: dict[str, Any],
    names: Sequence[str],
    values: Array,
    wanted: Sequence[str],
    extremes: bool,
    threads: int,
) -> tuple[Array, NDArray[np.uint64], list[str | None]]: ...
def scatter_design(
    machine: Machine,
    settings: dict[str, Any],
    given: tuple[tuple[bool, str] | None, Sequence[tuple[str, str]]],
    design: tuple[str, int, int, bool],
) -> dict[str, Any]: ...
def scatter_paths(
    machine: Machine,
    settings: dict[str, Any],
    given: tuple[tuple[bool, str] | None, Sequence[tuple[str, str]]],
    design: tuple[int, int],
) -> Array: ...
def scatter_effects(
    values: Array, design: tuple[int, int, int], confidence: float
) -> list[tuple[float, float, float, float, int]]: ...
def scatter_linear(
    machine: Machine,
    settings: dict[str, Any],
    given: tuple[tuple[bool, str] | None, Sequence[tuple[str, str]]],
    of: Sequence[str],
) -> list[tuple[float, float, list[tuple[float, float, float]], list[str]]]: ...
def scatter_results(
    machine: Machine, of: Sequence[str], limits: Sequence[str]
) -> tuple[list[str], list[str], bool, list[bool]]: ...
def scatter_piece(
    machine: Machine,
    settings: dict[str, Any],
    names: Sequence[str],
    values: Array,
    results: tuple[Sequence[str], Sequence[str]],
    threads: int,
) -> tuple[Array, NDArray[np.uint64], list[str | None]]: ...
def scatter_statistics(
    values: Array,
    is_at_most: Sequence[bool],
    design: tuple[int | None, int | None],
    asked: tuple[float, Sequence[float]],
) -> dict[str, Any]: ...
