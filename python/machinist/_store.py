"""Sweep results as an Arrow table and, in a folder, as Parquet files.

A folder contains `sweep.json`, which identifies the sweep, and files `part-FIRST-STOP.parquet` with
consecutive variants. Files are written atomically. A resumed sweep runs only the missing variants.
It also accepts a single file with all variants, as written by the program.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .errors import SweepError

if TYPE_CHECKING:
    import pyarrow

    from ._designs import Design
    from ._model import Model
    from ._sweep import Piece, Plan

_PART = re.compile(r"^part-(\d+)-(\d+)\.parquet$")
_MANIFEST = "sweep.json"


class Store:
    """Storage of the chunks of a sweep."""

    def __init__(
        self,
        path: str | os.PathLike[str] | None,
        model: Model,
        variants: Design,
        plan: Plan,
        provenance: dict[str, Any],
    ) -> None:
        self._count = len(variants)
        self._plan = plan
        self._pieces: dict[tuple[int, int], pyarrow.Table] = {}
        self._folder = None if path is None else Path(path)
        self._of = _identity(json.loads(json.dumps(provenance["sweep"], default=str)))
        of = json.dumps(self._of, sort_keys=True)
        self._key = hashlib.sha256(of.encode()).hexdigest()
        self._told = json.dumps({**provenance, "key": self._key}, indent=1, default=str)
        self._units = plan.units_of(model)
        self._schema = self._made_schema()
        if self._folder is not None and self._folder.is_file():
            self._take(self._folder)
        elif self._folder is not None:
            self._open(self._folder)

    def _made_schema(self) -> pyarrow.Schema:
        import pyarrow

        def number(name: str) -> pyarrow.Field:
            return pyarrow.field(name, pyarrow.float64(), metadata={"unit": self._units[name]})

        names = [*self._plan.names, *self._plan.columns]
        return pyarrow.schema(
            [
                pyarrow.field("variant", pyarrow.int64()),
                *map(number, names),
                pyarrow.field("steps", pyarrow.int64()),
                pyarrow.field("error", pyarrow.string()),
            ],
            metadata={"machinist.sweep": self._told},
        )

    def _take(self, file: Path) -> None:
        """Read a file with all variants, if it belongs to this sweep."""
        import pyarrow
        import pyarrow.parquet as parquet

        try:
            table = parquet.read_table(file, partitioning=None)
            told = json.loads(table.schema.metadata[b"machinist.sweep"])["sweep"]
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise SweepError(f"it holds no sweep: {error}", file=str(file)) from error
        self._require(told, file, "`machinist.sweep` in its metadata")
        if table.num_rows != self._count or not table.schema.equals(self._schema):
            raise SweepError("it holds other rows or columns than it tells of", file=str(file))
        self._pieces[0, self._count] = pyarrow.table(table.columns, schema=self._schema)

    def _require(self, told: dict[str, Any], place: Path, where: str) -> None:
        """Reject results of another sweep, and name the differences."""
        found = _identity(told)
        if found == self._of:
            return
        names = {
            name for name in {*found, *self._of}
            if name != "settings" and found.get(name) != self._of.get(name)
        }  # fmt: skip
        theirs, ours = found.get("settings") or {}, self._of["settings"]
        names |= {name for name in {*theirs, *ours} if theirs.get(name) != ours.get(name)}
        raise SweepError(
            f"it holds the results of another sweep, with another {', '.join(sorted(names))}",
            file=str(place),
            hint=f"give another path; {where} says what it is of",
        )

    def _open(self, folder: Path) -> None:
        """Read existing results, if they belong to this sweep."""
        import pyarrow.parquet as parquet

        manifest = folder / _MANIFEST
        try:
            folder.mkdir(parents=True, exist_ok=True)
            if not manifest.exists():
                if any(_PART.match(name) for name in os.listdir(folder)):
                    raise SweepError(
                        "there are parts of a sweep, but not what it is of", file=str(folder)
                    )
                _write(manifest, lambda file: file.write_text(self._told, encoding="utf-8"))
            told = json.loads(manifest.read_text(encoding="utf-8"))["sweep"]
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise SweepError(f"it holds no sweep: {error}", file=str(folder)) from error
        self._require(told, folder, f"{_MANIFEST} there")
        for name in sorted(os.listdir(folder)):
            match = _PART.match(name)
            if not match:
                continue
            first, stop = int(match[1]), int(match[2])
            try:
                table = parquet.read_table(folder / name, partitioning=None)
                if table.num_rows != stop - first or not 0 <= first < stop <= self._count:
                    raise ValueError(f"{table.num_rows} rows")
                if not table.schema.equals(self._schema):
                    raise ValueError("other columns")
            except (OSError, ValueError) as error:
                raise SweepError(
                    f"it is damaged: {error}", file=str(folder / name),
                    hint="delete it, and its variants are run again",
                ) from error  # fmt: skip
            self._pieces[first, stop] = table

    def missing(self) -> list[tuple[int, int]]:
        """Ranges of variants without results."""
        gaps, reached = [], 0
        for first, stop in [*sorted(self._pieces), (self._count, self._count)]:
            if first > reached:
                gaps.append((reached, first))
            reached = max(reached, stop)
        return gaps

    def add(self, piece: Piece) -> None:
        """Add results; with a folder, they are on disk on return."""
        import pyarrow
        import pyarrow.parquet as parquet

        first, stop = piece.first, piece.first + len(piece)
        failed = np.array([error is not None for error in piece.errors], dtype=bool)
        arrays = [
            pyarrow.array(np.arange(first, stop)),
            *(pyarrow.array(np.ascontiguousarray(column)) for column in piece.variants.T),
            *(
                pyarrow.array(np.ascontiguousarray(column), mask=failed)
                for column in piece.values.T
            ),
            pyarrow.array(piece.steps.astype(np.int64)),
            pyarrow.array(piece.errors, pyarrow.string()),
        ]
        table = pyarrow.table(arrays, schema=self._schema)
        self._pieces[first, stop] = table
        if self._folder is not None:
            file = self._folder / f"part-{first:09d}-{stop:09d}.parquet"
            try:
                _write(file, lambda path: parquet.write_table(table, path))
            except OSError as error:
                raise SweepError(str(error), file=str(file)) from error

    def table(self) -> pyarrow.Table:
        """All results in the order of the variants."""
        import pyarrow

        tables = [table for _, table in sorted(self._pieces.items())]
        if not tables:
            return self._schema.empty_table()
        # The provenance of parts may differ; the sweep is the same.
        metadata = self._schema.metadata
        tables = [table.replace_schema_metadata(metadata) for table in tables]
        return pyarrow.concat_tables(tables).combine_chunks()


def _identity(sweep: dict[str, Any]) -> dict[str, Any]:
    """Identity of a sweep; a design counts by its numbers, not by its sampler."""
    design = sweep.get("design") or {}
    return {**sweep, "design": {name: design.get(name) for name in ("names", "sha256")}}


def _write(path: Path, write: Any) -> None:
    """Write a file atomically."""
    beside = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        write(beside)
        os.replace(beside, path)
    finally:
        beside.unlink(missing_ok=True)
