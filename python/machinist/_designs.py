"""Designs: the variants of a sweep."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import InputError

Array = NDArray[np.float64]
Kind = Literal["grid", "random", "latin", "sobol", "table"]
#: (from, to), (from, to, "log"), or values.
Axis = Sequence[Any] | NDArray[Any]


@dataclass(frozen=True, eq=False)
class Design:
    """Variants of a machine: one row of `values` per variant, one column per name.

    `told` describes the design as plain data; equal descriptions give equal numbers.
    """

    names: tuple[str, ...]
    values: Array
    told: dict[str, Any]

    def __len__(self) -> int:
        return len(self.values)

    def __repr__(self) -> str:
        return f"{self.told['kind']} of {len(self)} variants of {', '.join(self.names)}"


def design(
    space: Mapping[str, Axis] | Any,
    kind: Kind = "grid",
    n: int | None = None,
    *,
    seed: int = 0,
) -> Design:
    """Create the variants of a parameter space.

    :param space: `(from, to)` or `(from, to, "log")` by parameter; for a grid or a table also a
        sequence of values; for a table also a DataFrame.
    :param kind: `grid` (all combinations, the last parameter varies fastest), `random`, `latin`
        (hypercube), `sobol` (both from scipy.stats.qmc) or `table` (the rows as given).
    :param n: number of variants; for a grid, number of values per range.
    :param seed: seed of the random numbers.
    """
    columns = _columns(space)
    if not columns:
        raise InputError("the space has no parameters")
    names = tuple(columns)
    told: dict[str, Any] = {"kind": kind, "names": list(names)}
    if kind == "grid":
        axes = [_axis(name, axis, n) for name, axis in columns.items()]
        told["axes"] = [axis.tolist() for axis in axes]
        _limited(int(np.prod([len(axis) for axis in axes], dtype=float)))
        mesh = np.meshgrid(*axes, indexing="ij")
        return _made(names, np.stack([axis.ravel() for axis in mesh], axis=1), told)
    if kind == "table":
        table = [_values(name, axis) for name, axis in columns.items()]
        if len({len(column) for column in table}) > 1:
            raise InputError("columns of a table are of one length")
        return _made(names, np.stack(table, axis=1), told)
    if kind not in ("random", "latin", "sobol"):
        raise InputError(f"a design is grid, random, latin, sobol or table, not {kind!r}")
    if n is None or n < 1:
        raise InputError(f"n is how many variants a {kind} design has, at least 1")
    _limited(n)
    ranges = {name: _range(name, axis) for name, axis in columns.items()}
    told |= {"n": n, "seed": seed, "ranges": {k: list(r) for k, r in ranges.items()}}
    unit = _drawn(kind, n, len(names), seed)
    scaled = [_scaled(unit[:, k], *ranges[name]) for k, name in enumerate(names)]
    return _made(names, np.stack(scaled, axis=1), told)


def _made(names: tuple[str, ...], values: Array, told: dict[str, Any]) -> Design:
    """Design with a hash of its numbers, independent of the sampler."""
    digest = hashlib.sha256(np.ascontiguousarray(values).tobytes()).hexdigest()
    return Design(names, values, {**told, "variants": len(values), "sha256": digest})


def _limited(count: int) -> None:
    most = 100_000_000
    if count > most:
        raise InputError(f"{count} variants are too many, at most {most}")


def _drawn(kind: str, n: int, d: int, seed: int) -> Array:
    """Sample points in the unit cube."""
    if kind == "random":
        return np.random.default_rng(seed).random((n, d))
    from scipy.stats import qmc

    if kind == "latin":
        return np.asarray(qmc.LatinHypercube(d, seed=seed).random(n))
    sampler = qmc.Sobol(d, scramble=True, seed=seed)
    # Powers of two are balanced; points beyond n are dropped.
    return np.asarray(sampler.random_base2(max(0, (n - 1).bit_length())))[:n]


def _columns(space: Any) -> dict[str, Any]:
    if isinstance(space, Mapping):
        return {str(name): axis for name, axis in space.items()}
    if hasattr(space, "columns"):
        return {str(name): space[name].to_numpy() for name in space.columns}
    raise InputError(f"a space is ranges or values by parameter, not {type(space).__name__}")


def _is_range(axis: Axis) -> bool:
    return isinstance(axis, tuple) and (
        len(axis) == 2 or (len(axis) == 3 and isinstance(axis[2], str))
    )


def _range(name: str, axis: Axis) -> tuple[float, float, str]:
    if not _is_range(axis):
        raise InputError(f"`{name}`: a range is (from, to) or (from, to, 'log'), not {axis!r}")
    low, high = _values(name, axis[:2]).tolist()
    scale = axis[2] if len(axis) == 3 else "linear"
    if scale not in ("linear", "log"):
        raise InputError(f"`{name}`: a range is linear or log, not {scale!r}")
    if scale == "log" and not low * high > 0:
        raise InputError(f"`{name}`: equal ratios do not lead from {low} to {high}")
    return low, high, scale


def _axis(name: str, axis: Axis, n: int | None) -> Array:
    if not _is_range(axis):
        return _values(name, axis)
    low, high, scale = _range(name, axis)
    if n is None or n < 2:
        raise InputError(f"`{name}`: n is how many values a range has in a grid, at least 2")
    _limited(n)
    shares = np.arange(n) / (n - 1)
    if scale == "log":
        # The C library's pow, as in the program; NumPy's can differ in the last bit.
        values = np.array([low * math.pow(high / low, share) for share in shares])
    else:
        values = _scaled(shares, low, high, scale)
    values[0], values[-1] = low, high
    return values


def _scaled(share: Array, low: float, high: float, scale: str) -> Array:
    if scale == "log":
        return low * (high / low) ** share
    return low + (high - low) * share


def _values(name: str, axis: ArrayLike) -> Array:
    try:
        values = np.array(axis, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"`{name}`: {axis!r} are no numbers") from None
    if values.ndim != 1 or not len(values):
        raise InputError(f"`{name}`: values stand in one row, and are some")
    if not np.isfinite(values).all():
        raise InputError(f"`{name}`: {values[~np.isfinite(values)][0]} is no finite number")
    return values
