"""Scatters: results for parameters with probability distributions, with their statistics."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _machinist
from ._designs import Design, _made
from ._store import Store
from ._sweep import Plan, Sweep, provenance, run_piece, runs
from ._tables import html, text
from .errors import InputError, UnknownNameError

if TYPE_CHECKING:
    import os

    from dask.distributed import Client

    from ._model import Model

Array = NDArray[np.float64]


@dataclass(frozen=True)
class ScatterPlan(Plan):
    """Plan whose results are expressions over a run, then both sides of each requirement."""

    of: tuple[str, ...]
    limits: tuple[str, ...]
    units: tuple[str, ...]

    def run(self, model: Model, variants: Array, threads: int) -> tuple[Any, Any, Any]:
        return _machinist.scatter_piece(
            model._machine, self.settings, list(self.names), variants,
            (list(self.of), list(self.limits)), threads,
        )  # fmt: skip

    def units_of(self, model: Model) -> dict[str, str]:
        units = {name: model.parameters[name].unit for name in self.names}
        return {**units, **dict(zip(self.wanted, self.units))}


@dataclass(frozen=True)
class Estimate:
    """Estimate with its confidence interval; an end is infinite where the samples do not bound it."""

    value: float
    low: float
    high: float

    def __float__(self) -> float:
        return self.value

    def _cells(self) -> list[str]:
        ends = ("?" if math.isinf(end) else f"{end:.6g}" for end in (self.low, self.high))
        return [f"{self.value:.6g}", *ends]


@dataclass(frozen=True)
class Distributed:
    """A parameter that varies."""

    #: Kind of the distribution.
    distribution: str
    #: Mean, in the SI unit of the parameter.
    mean: float
    #: Standard deviation.
    deviation: float
    #: SI unit.
    unit: str
    #: Distribution with its numbers.
    law: str


@dataclass(frozen=True)
class Effect:
    """Elementary effects of one parameter on a result, per unit of probability (Morris)."""

    #: Mean of the absolute effects, mu*.
    mean_absolute: Estimate
    #: Mean of the effects.
    mean: float
    #: Standard deviation of the effects; large for curvature and interactions.
    deviation: float
    #: Number of effects.
    count: int


@dataclass(frozen=True)
class Share:
    """Contribution of one parameter to the linear propagation."""

    #: Derivative of the result; NaN if there is none.
    slope: float
    #: Change of the result for one standard deviation.
    contribution: float
    #: Share of the variance.
    share: float


@dataclass(frozen=True)
class Linear:
    """Linear propagation of the standard deviations to one result, by sensitivities."""

    #: Value at the means of the parameters.
    value: float
    #: Standard deviation to first order.
    deviation: float
    #: Contributions by parameter.
    shares: dict[str, Share]
    #: Parameters without a derivative, with reasons.
    left_out: tuple[str, ...]


@dataclass(frozen=True)
class Statistics:
    """Statistics of one result."""

    #: Unit of the result.
    unit: str
    #: Number of runs with a result.
    count: int
    mean: Estimate
    #: Standard deviation.
    deviation: Estimate
    least: float
    greatest: float
    #: Quantiles by probability.
    quantiles: dict[float, Estimate]
    #: Sobol indices of first order by parameter; empty unless requested.
    first: dict[str, Estimate]
    #: Sobol indices of total order by parameter; empty unless requested.
    total: dict[str, Estimate]
    #: Elementary effects by parameter; empty unless requested.
    effects: dict[str, Effect]
    #: Linear propagation; None unless requested.
    linear: Linear | None


@dataclass(frozen=True)
class Requirement:
    """Probability that a requirement is missed."""

    #: Number of runs that miss it.
    failures: int
    #: Number of runs with a result.
    count: int
    probability: Estimate


def scatter(
    model: Model,
    of: Sequence[str] | str = (),
    *,
    limits: Sequence[str] | str = (),
    vary: Mapping[str, str] | None = None,
    samples: int = 1024,
    sampler: str = "sobol",
    seed: int = 1,
    indices: bool = False,
    morris: int | None = None,
    linear: bool = False,
    confidence: float = 0.95,
    quantiles: Sequence[float] = (0.05, 0.5, 0.95),
    path: str | os.PathLike[str] | None = None,
    client: Client | None = None,
    threads: int | None = None,
    time_limit: float | None = None,
    chunk_seconds: float = 1.0,
    given: Mapping[str, float] | None = None,
    **settings: Any,
) -> Scatter:
    """Run a machine with values of its parameters drawn from their probability distributions.

    Samples, results and statistics are those of the command `machinist scatter`.

    :param of: expressions over a run, such as `max(force)`; default: final values of all outputs.
    :param limits: requirements, such as `max(force) < 38 [kN]`, whose probability of failure is
        computed.
    :param vary: distributions by parameter, such as `normal(5 %)` or `10 +- 0.5 [mm]`. They take
        precedence over those of the spec, which are read from its file.
    :param samples: number of samples; Sobol points are rounded up to 32 times a power of two.
    :param sampler: `sobol`, `latin` or `random`.
    :param indices: compute Sobol indices; takes `samples` times the number of parameters plus 2
        runs.
    :param morris: number of paths of a screening by elementary effects, 10 to 50 are usual; each
        takes one run per parameter and one more.
    :param linear: propagate the standard deviations by the sensitivities of one run.
    :param confidence: confidence of intervals.
    :param quantiles: probabilities of the quantiles.
    :param path: folder for the runs as Parquet files, as for :func:`machinist.sweep`: an existing
        scatter is resumed, one of other settings is rejected.
    :param client: a Dask client, as for :func:`machinist.sweep`, and so are `threads`,
        `time_limit`, `chunk_seconds` and `given`.
    :param settings: settings of every run, as for :meth:`Model.simulate`. `points` defaults to 2
        if the results need only the ends of runs.
    """
    texts, limited = _texts(of), _texts(limits)
    for name in (*(vary or {}), *(given or {})):
        model.parameters.index(name)
    wrong = [p for p in (confidence, *quantiles) if not 0 < p < 1]
    if wrong:
        raise InputError(f"a probability lies between 0 and 1, not at {wrong[0]}")
    columns, units, ends_only, at_most = _machinist.scatter_results(model._machine, texts, limited)
    if "times" not in settings and ends_only:
        settings.setdefault("points", 2)
    set_by = {"parameters": dict(given) if given else None, "time_limit": time_limit, **settings}
    set_by = {name: value for name, value in set_by.items() if value is not None}
    if morris is not None and morris < 2:
        raise InputError("morris takes at least 2 paths; 10 to 50 are usual")
    spread = (model._spec, list((vary or {}).items()))
    told = _machinist.scatter_design(
        model._machine, set_by, spread, (sampler, samples, seed, indices)
    )
    names = tuple(told["names"])
    laws = [law for *_, law in told["laws"]]
    drawn = {"kind": "scatter", "names": list(names), "laws": laws, "sampler": sampler, "seed": seed}
    variants = _made(names, np.ascontiguousarray(told["values"]), drawn)
    plan = ScatterPlan(
        names, set_by, tuple(columns), False, tuple(texts), tuple(limited), tuple(units)
    )
    run_piece(model, plan, 0, variants.values[:0], 1)
    store = Store(path, model, variants, plan, provenance(model, variants, plan))
    ran, took = runs(model, plan, variants, store, client, threads, chunk_seconds)
    table = store.table()
    values = np.column_stack([_filled(table[name]) for name in columns])
    design = (told["row_length"], told["replicates"])
    asked = (confidence, list(quantiles))
    found = _machinist.scatter_statistics(values, at_most, design, asked)
    shown = columns[: len(columns) - 2 * len(limited)]
    effects: list[dict[str, Effect]] = [{} for _ in shown]
    if morris is not None:
        paths = _machinist.scatter_paths(model._machine, set_by, spread, (morris, seed))
        of_paths, _, _ = plan.run(model, np.ascontiguousarray(paths), threads or 0)
        effects = [
            _effects(of_paths[:, at], names, (len(names), morris, seed), confidence)
            for at in range(len(shown))
        ]
    linearized: list[Linear | None] = [None for _ in shown]
    if linear:
        propagated = _machinist.scatter_linear(model._machine, set_by, spread, shown)
        linearized = [_linear(names, one) for one in propagated]
    results = {
        name: _statistics(unit, names, result, more)
        for name, unit, result, more in zip(
            shown, units, found["results"], zip(effects, linearized)
        )
    }
    missed = {
        limit: Requirement(failures, count, Estimate(*probability))
        for limit, (failures, count, probability) in zip(limited, found["limits"])
    }
    parameters = {
        name: Distributed(kind, mean, deviation, unit, law)
        for name, unit, (kind, mean, deviation, law) in zip(names, told["units"], told["laws"])
    }
    done = (variants, table, ran, took, path)
    return Scatter(parameters, results, missed, tuple(told["left_out"]), done)


def _texts(given: Sequence[str] | str) -> list[str]:
    return [given] if isinstance(given, str) else list(given)


def _filled(column: Any) -> Array:
    """Column with NaN where there is no result."""
    return np.asarray(column.to_numpy(), dtype=np.float64)


def _effects(
    values: Array, names: tuple[str, ...], design: tuple[int, int, int], confidence: float
) -> dict[str, Effect]:
    found = _machinist.scatter_effects(np.ascontiguousarray(values), design, confidence)
    return {
        name: Effect(Estimate(most, most - error, most + error), mean, deviation, count)
        for name, (most, error, mean, deviation, count) in zip(names, found)
    }


def _linear(names: tuple[str, ...], found: tuple[float, float, list[Any], list[str]]) -> Linear:
    value, deviation, shares, left_out = found
    by_name = {name: Share(*share) for name, share in zip(names, shares)}
    return Linear(value, deviation, by_name, tuple(left_out))


def _statistics(
    unit: str,
    names: tuple[str, ...],
    found: dict[str, Any],
    more: tuple[dict[str, Effect], Linear | None],
) -> Statistics:
    indices = found.get("indices", [])
    return Statistics(
        unit,
        found["count"],
        Estimate(*found["mean"]),
        Estimate(*found["deviation"]),
        found["least"],
        found["greatest"],
        {p: Estimate(*quantile) for p, quantile in found["quantiles"]},
        {name: Estimate(*first) for name, (first, _) in zip(names, indices)},
        {name: Estimate(*total) for name, (_, total) in zip(names, indices)},
        *more,
    )


class Scatter(Sweep):
    """Results of a scatter: statistics, and the table of all runs."""

    def __init__(
        self,
        parameters: dict[str, Distributed],
        results: dict[str, Statistics],
        limits: dict[str, Requirement],
        left_out: tuple[str, ...],
        runs: tuple[Any, ...],
    ) -> None:
        variants, table, ran, took, path = runs
        super().__init__(variants, table, ran, took, path, notes=[])
        #: Parameters that vary.
        self.parameters = parameters
        #: Statistics by expression.
        self.results = results
        #: Probabilities of failure by requirement.
        self.limits = limits
        #: Parameters with a distribution that no output depends on, or that are not tunable.
        self.left_out = left_out

    def statistics(self, of: str) -> Statistics:
        """Statistics of an expression."""
        if of not in self.results:
            hint = _machinist.did_you_mean(of, list(self.results))
            raise UnknownNameError(f"the scatter has no result `{of}`{hint}")
        return self.results[of]

    def _title(self) -> str:
        failed = len(self.failed)
        told = f", {failed} without a result" if failed else ""
        return f"{len(self)} runs over {', '.join(self.parameters)}{told}"

    def _rows(self) -> tuple[list[str], list[list[str]]]:
        rows = []
        for name, result in self.results.items():
            rows.append([f"{name} [{result.unit}]", "mean", *result.mean._cells()])
            rows.append(["", "deviation", *result.deviation._cells()])
            for p, quantile in result.quantiles.items():
                rows.append(["", f"{100 * p:.6g} % quantile", *quantile._cells()])
            for order, indices in (("first", result.first), ("total", result.total)):
                for parameter, index in indices.items():
                    rows.append(["", f"{order} index of {parameter}", *index._cells()])
            for parameter, effect in result.effects.items():
                rows.append(["", f"mu* of {parameter}", *effect.mean_absolute._cells()])
            if result.linear:
                rows.append(["", "linear deviation", f"{result.linear.deviation:.6g}", "", ""])
        for limit, missed in self.limits.items():
            rows.append([limit, "probability of failure", *missed.probability._cells()])
        return ["", "", "estimate", "from", "to"], rows

    def __repr__(self) -> str:
        return "\n".join([self._title(), *text(*self._rows())])

    def _repr_html_(self) -> str:
        return html(self._title(), *self._rows())
