"""Sweeps: many variants of a machine, on the threads of this process or on a Dask cluster."""

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
#: Variants of the first pieces, by which the cost of one is measured.
FIRST = 16


@dataclass(frozen=True)
class Plan:
    """What decides the numbers of a sweep besides the machine and the variants."""

    names: tuple[str, ...]
    settings: dict[str, Any]
    wanted: tuple[str, ...]
    extremes: bool

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of the columns of results."""
        if not self.extremes:
            return self.wanted
        return tuple(f"{name}.{end}" for name in self.wanted for end in ("least", "greatest"))


@dataclass(frozen=True, eq=False)
class Piece:
    """Results of neighbouring variants."""

    first: int
    variants: Array
    values: Array
    steps: NDArray[np.uint64]
    errors: list[str | None]
    #: What it took [s].
    seconds: float = field(compare=False)

    def __len__(self) -> int:
        return len(self.variants)


def run_piece(model: Model, plan: Plan, first: int, variants: Array, threads: int) -> Piece:
    """Runs neighbouring variants, here and now."""
    start = time.perf_counter()
    values, steps, errors = _machinist.sweep_piece(
        model._machine, plan.settings, list(plan.names), np.ascontiguousarray(variants),
        list(plan.wanted), plan.extremes, threads,
    )  # fmt: skip
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
    """Runs many variants of a machine; a variant that fails is a row with its reason.

    The numbers are to the last bit those of single runs, however many threads or workers there are.

    :param model: the machine; each worker is sent it once.
    :param space: ranges or values by parameter, with `kind`, `n` and `seed` as in
        :func:`machinist.design`; or a design.
    :param outputs: outputs or states; all outputs unless told otherwise.
    :param extremes: the least and the greatest value over the output times instead of the last.
    :param path: a folder for results as Parquet files, or a file that `machinist sweep` wrote. What
        is there already of this sweep is not run again; another sweep's is refused.
    :param client: a Dask client. Without one, threads of this process run the variants.
    :param threads: number of threads without a client; as many as there are cores unless told.
    :param time_limit: seconds of computing that a variant may take.
    :param chunk_seconds: variants are handed out in pieces that take about so long.
    :param given: other values of parameters that do not vary.
    :param settings: of every run, as those of :meth:`Model.simulate`. `points` are 2 unless
        extremes are asked for.
    """
    variants = space if isinstance(space, Design) else design(space, kind, n, seed=seed)
    for name in (*variants.names, *(given or {})):
        model.parameters.index(name)
    if not chunk_seconds > 0:
        raise InputError(f"chunk_seconds is {chunk_seconds}, not above 0")
    if threads is not None and threads < 1:
        raise InputError(f"threads is {threads}: it takes at least one")
    wanted = tuple([outputs] if isinstance(outputs, str) else outputs)
    wanted = wanted or tuple(model.outputs) or tuple(model.states)
    if "times" not in settings and not extremes:
        settings.setdefault("points", 2)
    set_by = {"parameters": dict(given) if given else None, "time_limit": time_limit, **settings}
    set_by = {name: value for name, value in set_by.items() if value is not None}
    plan = Plan(variants.names, set_by, wanted, extremes)
    # Refuses what makes no sense for any variant.
    run_piece(model, plan, 0, variants.values[:0], 1)

    store = Store(path, model, variants, plan, provenance(model, variants, plan))
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
    took = (time.perf_counter() - start, computing)
    return Sweep(variants, store.table(), ran, took, path, _notes(model, plan, variants.values))


def _notes(model: Model, plan: Plan, variants: Array) -> list[str]:
    """What is to be said of all variants together."""
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
    """Pieces on threads of this process, one after another."""
    size = FIRST
    for first, last in missing:
        while first < last:
            stop = min(last, first + size)
            piece = run_piece(model, plan, first, variants[first:stop], threads)
            yield piece
            first = stop
            size = next_size(size, piece, seconds)


def next_size(size: int, piece: Piece, seconds: float) -> int:
    """Variants of a piece that takes so many seconds, by what the last took; it grows at most
    tenfold at once, as what is measured of few is not exact."""
    by_cost = seconds * len(piece) / max(piece.seconds, 1e-9)
    return max(1, min(round(by_cost), 10 * size))


def provenance(model: Model, variants: Design, plan: Plan) -> dict[str, Any]:
    """What results are of: what decides the numbers first, then what made them."""
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
    """Results of a sweep: a row a variant, in the order of the design."""

    def __init__(
        self,
        variants: Design,
        table: pyarrow.Table,
        ran: int,
        took: tuple[float, float],
        path: str | os.PathLike[str] | None,
        notes: list[str],
    ) -> None:
        #: What was run.
        self.design = variants
        #: `variant`, parameters, results, `steps` and `error`, as an Arrow table.
        self.table = table
        #: Variants that this call ran; others were there.
        self.ran = ran
        #: What it took [s], and what its pieces took, one after another or side by side.
        self.seconds, self.computing = took
        #: The folder or file of results, if there is one.
        self.path = path
        #: What is remarkable: variants with a mass of the wrong sign.
        self.notes = notes

    @property
    def failed(self) -> dict[int, str]:
        """Why variants have no results, by their numbers."""
        errors = self.table["error"].to_pylist()
        return {number: error for number, error in enumerate(errors) if error is not None}

    def __getitem__(self, name: str) -> Array:
        """A column of parameters or results; NaN where a variant failed."""
        if name not in self.table.column_names:
            hint = _machinist.did_you_mean(str(name), self.table.column_names)
            raise UnknownNameError(f"the sweep has no column `{name}`{hint}")
        return self.table[name].to_numpy()

    def __len__(self) -> int:
        return self.table.num_rows

    def to_pandas(self) -> pandas.DataFrame:
        """As a pandas DataFrame."""
        return self.table.to_pandas()

    def to_polars(self) -> polars.DataFrame:
        """As a polars DataFrame."""
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
