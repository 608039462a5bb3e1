"""Sweeps: many variants of a machine, on threads of this process or on a Dask cluster."""

from __future__ import annotations

import platform
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from importlib import metadata
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _machinist
from ._designs import Axis, Design, Kind, design
from ._store import Store
from ._tables import html, text
from .errors import InputError, UnknownNameError

if TYPE_CHECKING:
    import os

    import pandas
    import polars
    import pyarrow
    from dask.distributed import Client

    from ._model import Model

Array = NDArray[np.float64]
#: Number of variants in the first chunks, which measure the cost of a variant.
FIRST = 16


@dataclass(frozen=True)
class Plan:
    """Settings that determine the results of a sweep, besides machine and variants."""

    names: tuple[str, ...]
    settings: dict[str, Any]
    wanted: tuple[str, ...]
    extremes: bool

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of the result columns."""
        if not self.extremes:
            return self.wanted
        return tuple(f"{name}.{end}" for name in self.wanted for end in ("least", "greatest"))

    def run(self, model: Model, variants: Array, threads: int) -> tuple[Any, Any, Any]:
        """Values, steps and reasons of failure of variants."""
        return _machinist.sweep_piece(
            model._machine, self.settings, list(self.names), variants,
            list(self.wanted), self.extremes, threads,
        )  # fmt: skip

    def units_of(self, model: Model) -> dict[str, str]:
        """Units of the columns."""
        units = {name: model.parameters[name].unit for name in self.names}
        for name in self.wanted:
            quantity = model.outputs.get(name) or model.states[name]
            for column in (name, f"{name}.least", f"{name}.greatest"):
                units[column] = quantity.unit
        return units


@dataclass(frozen=True, eq=False)
class Piece:
    """Results of consecutive variants."""

    first: int
    variants: Array
    values: Array
    steps: NDArray[np.uint64]
    errors: list[str | None]
    #: Computing time [s].
    seconds: float = field(compare=False)

    def __len__(self) -> int:
        return len(self.variants)


def run_piece(model: Model, plan: Plan, first: int, variants: Array, threads: int) -> Piece:
    """Run consecutive variants in this process."""
    start = time.perf_counter()
    values, steps, errors = plan.run(model, np.ascontiguousarray(variants), threads)
    return Piece(first, variants, values, steps, errors, time.perf_counter() - start)


def sweep(
    model: Model,
    space: Mapping[str, Axis] | Design | Any,
    *,
    kind: Kind = "grid",
    n: int | None = None,
    seed: int = 0,
    outputs: Sequence[str] = (),
    extremes: bool = False,
    path: str | os.PathLike[str] | None = None,
    client: Client | None = None,
    threads: int | None = None,
    time_limit: float | None = None,
    chunk_seconds: float = 1.0,
    given: Mapping[str, float] | None = None,
    **settings: Any,
) -> Sweep:
    """Run many variants of a machine. The row of a failed variant contains the reason.

    The results equal those of single runs to the last bit, for any number of threads or workers.

    :param model: the machine; it is sent to each worker once.
    :param space: ranges or values by parameter, with `kind`, `n` and `seed` as in
        :func:`machinist.design`; or a design.
    :param outputs: outputs or states; default: all outputs.
    :param extremes: return minimum and maximum over the output times instead of the last value.
    :param path: folder for results as Parquet files, or a file written by `machinist sweep`. An
        existing sweep is resumed; results of another sweep are rejected.
    :param client: a Dask client. Without one, threads of this process run the variants.
    :param threads: number of threads without a client; default: number of cores.
    :param time_limit: limit of the computing time of a variant [s].
    :param chunk_seconds: approximate computing time of a chunk of variants [s].
    :param given: values of parameters that do not vary.
    :param settings: settings of every run, as for :meth:`Model.simulate`. `points` defaults to 2
        without `extremes`.
    """
    variants = space if isinstance(space, Design) else design(space, kind, n, seed=seed)
    for name in (*variants.names, *(given or {})):
        model.parameters.index(name)
    wanted = tuple([outputs] if isinstance(outputs, str) else outputs)
    wanted = wanted or tuple(model.outputs) or tuple(model.states)
    if "times" not in settings and not extremes:
        settings.setdefault("points", 2)
    set_by = {"parameters": dict(given) if given else None, "time_limit": time_limit, **settings}
    set_by = {name: value for name, value in set_by.items() if value is not None}
    plan = Plan(variants.names, set_by, wanted, extremes)
    # Reject settings that are invalid for every variant.
    run_piece(model, plan, 0, variants.values[:0], 1)

    store = Store(path, model, variants, plan, provenance(model, variants, plan))
    ran, took = runs(model, plan, variants, store, client, threads, chunk_seconds)
    return Sweep(variants, store.table(), ran, took, path, _notes(model, plan, variants.values))


def runs(
    model: Model,
    plan: Plan,
    variants: Design,
    store: Store,
    client: Client | None,
    threads: int | None,
    chunk_seconds: float,
) -> tuple[int, tuple[float, float]]:
    """Run what the store misses. Returns the number of variants, wall-clock and computing time."""
    if not chunk_seconds > 0:
        raise InputError(f"chunk_seconds is {chunk_seconds}, not above 0")
    if threads is not None and threads < 1:
        raise InputError(f"threads is {threads}: it takes at least one")
    missing = store.missing()
    start = time.perf_counter()
    if client is None:
        pieces = _here(model, plan, variants.values, missing, threads or 0, chunk_seconds)
    else:
        from ._dask import on_cluster

        pieces = on_cluster(client, model, plan, variants.values, missing, chunk_seconds)
    ran, computing = 0, 0.0
    for piece in pieces:
        store.add(piece)
        ran += len(piece)
        computing += piece.seconds
    return ran, (time.perf_counter() - start, computing)


def _notes(model: Model, plan: Plan, variants: Array) -> list[str]:
    """Notes on the variants as a whole."""
    told = _machinist.negative_inertias(
        model._machine, plan.settings, list(plan.names), np.ascontiguousarray(variants)
    )
    if told is None:
        return []
    count, first, note = told
    return [f"{count} of {len(variants)} variants, the first is {first}: {note}"]


def _here(
    model: Model,
    plan: Plan,
    variants: Array,
    missing: list[tuple[int, int]],
    threads: int,
    seconds: float,
) -> Iterator[Piece]:
    """Chunks run on threads of this process, one after another."""
    size = FIRST
    for first, last in missing:
        while first < last:
            stop = min(last, first + size)
            piece = run_piece(model, plan, first, variants[first:stop], threads)
            yield piece
            first = stop
            size = next_size(size, piece, seconds)


def next_size(size: int, piece: Piece, seconds: float) -> int:
    """Number of variants in a chunk of the given duration, estimated from the last chunk. It grows
    at most tenfold at a time, since the timing of few variants is inaccurate."""
    by_cost = seconds * len(piece) / max(piece.seconds, 1e-9)
    return max(1, min(round(by_cost), 10 * size))


def provenance(model: Model, variants: Design, plan: Plan) -> dict[str, Any]:
    """Provenance of results: first what determines them, then the software that computed them."""
    return {
        "sweep": {
            "model": model.name,
            "fingerprint": model.fingerprint,
            "machinist": _machinist.__version__,
            "design": variants.told,
            "settings": {
                name: value.tolist() if isinstance(value, np.ndarray) else value
                for name, value in plan.settings.items()
                if name != "time_limit"
            },
            "outputs": list(plan.wanted),
            "extremes": plan.extremes,
        },
        "made_by": {
            "python": platform.python_version(),
            **{name: _version(name) for name in ("numpy", "scipy", "pyarrow")},
            "system": f"{platform.system()} {platform.machine()}",
            "time_limit": plan.settings.get("time_limit"),
        },
    }


def _version(package: str) -> str | None:
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return None


class Sweep:
    """Results of a sweep: one row per variant, in the order of the design."""

    def __init__(
        self,
        variants: Design,
        table: pyarrow.Table,
        ran: int,
        took: tuple[float, float],
        path: str | os.PathLike[str] | None,
        notes: list[str],
    ) -> None:
        #: Design of the sweep.
        self.design = variants
        #: Arrow table with `variant`, parameters, results, `steps` and `error`.
        self.table = table
        #: Number of variants run by this call; the others existed already.
        self.ran = ran
        #: Wall-clock time [s], and total computing time of the chunks [s].
        self.seconds, self.computing = took
        #: Folder or file of the results, or None.
        self.path = path
        #: Warnings: variants with a negative mass.
        self.notes = notes

    @property
    def failed(self) -> dict[int, str]:
        """Reasons of failed variants, by variant number."""
        errors = self.table["error"].to_pylist()
        return {number: error for number, error in enumerate(errors) if error is not None}

    def __getitem__(self, name: str) -> Array:
        """Column of a parameter or a result; NaN where a variant failed."""
        if name not in self.table.column_names:
            hint = _machinist.did_you_mean(str(name), self.table.column_names)
            raise UnknownNameError(f"the sweep has no column `{name}`{hint}")
        return self.table[name].to_numpy()

    def __len__(self) -> int:
        return self.table.num_rows

    def to_pandas(self) -> pandas.DataFrame:
        """Table as a pandas DataFrame."""
        return self.table.to_pandas()

    def to_polars(self) -> polars.DataFrame:
        """Table as a polars DataFrame."""
        import polars

        return polars.from_arrow(self.table)  # type: ignore[return-value]

    def _title(self) -> str:
        failed = len(self) - self.table["error"].null_count
        told = f", {failed} failed" if failed else ""
        return f"{self.design!r}{told}; {self.ran} run now in {self.seconds:.3g} s"

    def _rows(self) -> tuple[list[str], list[list[str]]]:
        import pyarrow.compute as pc

        heading = ["", "least", "greatest", "mean"]
        rows = []
        for name in self.table.column_names[1:-2]:
            ends = pc.min_max(self.table[name]).as_py()
            mean = pc.mean(self.table[name]).as_py()
            numbers = (ends["min"], ends["max"], mean)
            rows.append([name, *("" if x is None else f"{x:.6g}" for x in numbers)])
        return heading, rows

    def __repr__(self) -> str:
        notes = [f"note: {note}" for note in self.notes]
        return "\n".join([self._title(), *text(*self._rows()), *notes])

    def _repr_html_(self) -> str:
        return html(self._title(), *self._rows())
