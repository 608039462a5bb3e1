"""Fits of parameters to measured runs."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _machinist, _svg
from ._run import Picture, Run
from ._tables import html, text
from .errors import InputError, UnknownNameError

if TYPE_CHECKING:
    from ._model import Model

Array = NDArray[np.float64]
#: A pandas or polars DataFrame, or columns by name.
Measured = Any

_NAMED = re.compile(r"^\s*(?P<name>.*?)\s*(?:\[(?P<unit>[^\[\]]*)\])?\s*$")
_TIMES = ("t", "time")


@dataclass(frozen=True)
class Found:
    """Fitted parameter or initial value."""

    name: str
    unit: str
    start: float
    value: float
    #: None if the parameter is not identifiable or at a bound.
    standard_error: float | None
    confidence_95: tuple[float, float] | None
    is_at_bound: bool


@dataclass(frozen=True)
class Residual:
    """Residual of an output after the fit, in its unit; NaN if there are too few values."""

    output: str
    unit: str
    values: int
    rms: float
    largest: float
    #: Weight of the residuals: a standard deviation, or the root mean square of all.
    scale: float
    #: Whether the residuals are at the level of the integration error.
    is_rounding: bool
    #: p-value of the runs test; a small value indicates a deficient model.
    probability_of_runs: float


_HEADING = ("", "unit", "start", "fitted", "95 % interval", "error")


class Fit:
    """Result of a fit: parameters, confidence intervals, correlations and residuals."""

    def __init__(
        self,
        model: Model,
        told: dict[str, Any],
        measured: list[tuple[Array, list[tuple[str, Array]]]],
        settings: dict[str, Any],
    ) -> None:
        findings = json.loads(told["findings"])
        self._model = model
        self._measured = measured
        self._settings = settings
        #: Reason for termination: converged, steps (limit reached), interrupted or stuck.
        self.end: str = told["end"]
        #: Number of search steps and of evaluations.
        self.steps: int = told["steps"]
        self.runs: int = told["runs"]
        #: Number of failed simulations, and the reason of the first failure.
        self.failed: int = told["failed"]
        self.why_failed: str | None = told["why_failed"]
        #: Number of values compared.
        self.values: int = findings["values"]
        #: Fitted parameters and initial values, by name.
        self.found: dict[str, Found] = {}
        for row in findings["parameters"]:
            interval = row.pop("confidence_95")
            found = Found(**row, confidence_95=None if interval is None else tuple(interval))
            self.found[found.name] = found
        #: Correlation matrix; NaN where a parameter is not identifiable.
        self.correlations: Array = np.array(
            [[np.nan if c is None else c for c in row] for row in findings["correlations"]]
        ).reshape(len(self.found), len(self.found))
        #: Poorly identifiable combinations of relative changes, with their standard errors.
        self.untold: list[tuple[dict[str, float], float]] = [
            (
                dict(map(tuple, row["shares"])),
                np.inf if row["standard_error"] is None else row["standard_error"],
            )
            for row in findings["untold"]
        ]
        #: Residuals by output.
        self.residuals: dict[str, Residual] = {}
        for row in findings["outputs"]:
            kept = {name: row[name] for name in Residual.__dataclass_fields__}
            if kept["probability_of_runs"] is None:
                kept["probability_of_runs"] = float("nan")
            self.residuals[row["output"]] = Residual(**kept)

    @property
    def converged(self) -> bool:
        """Whether the search converged to a local minimum."""
        return self.end == "converged"

    @property
    def parameters(self) -> dict[str, float]:
        """Fitted parameters, for `simulate(parameters=...)`."""
        known = self._model.parameters
        return {name: found.value for name, found in self.found.items() if name in known}

    @property
    def initial(self) -> dict[str, float]:
        """Fitted initial values, for `simulate(initial=...)`."""
        known = self._model.parameters
        return {name: found.value for name, found in self.found.items() if name not in known}

    def simulate(self, **settings: Any) -> Run:
        """Simulate with the fitted values and the settings of the fit, overridden by `settings`."""
        merged = {**self._settings, **settings}
        for kind, found in (("parameters", self.parameters), ("initial", self.initial)):
            if found:
                given = merged.get(kind) or {}
                if not isinstance(given, Mapping):
                    raise InputError(f"give {kind} by name: the fit has found some of them")
                merged[kind] = {**given, **found}
        return self._model.simulate(**merged)

    def plot(self, run: int = 0) -> Picture:
        """Plot the measurements of a run with the fitted model."""
        times, columns = self._measured[run]
        fitted = self.simulate(until=float(times[-1]), points=1001)
        units = {column.name: column.unit for column in fitted.columns}
        panels = []
        for name, values in columns:
            shown = np.interp(fitted.t, times, values, left=np.nan)
            panels.append((units[name], [(f"{name}, measured", shown), ("fitted", fitted[name])]))
        return Picture(_svg.plot(f"{self._model.title}, fitted", fitted.t, panels))

    def _rows(self) -> list[list[str]]:
        def row(found: Found) -> list[str]:
            if found.confidence_95:
                low, high = found.confidence_95
                interval = f"{low:.6g} .. {high:.6g}"
            else:
                interval = "at its bound" if found.is_at_bound else "not told"
            error = ""
            if found.standard_error is not None:
                relative = found.value != 0
                size = found.standard_error / abs(found.value) if relative else found.standard_error
                error = f"{100 * size:.2g} %" if relative else f"{size:.2g}"
            return [
                found.name, found.unit, f"{found.start:.9g}", f"{found.value:.8g}", interval, error,
            ]  # fmt: skip

        return [row(found) for found in self.found.values()]

    def _title(self) -> str:
        return (
            f"{self._model.name} fitted to {self.values} values: {self.end} after {self.steps} "
            f"steps, {self.runs} evaluations"
        )

    def __repr__(self) -> str:
        lines = [self._title(), *text(_HEADING, self._rows())]
        for shares, error in self.untold:
            change = ", ".join(f"{name} {share:+.2g}" for name, share in shares.items())
            told = "not at all" if np.isinf(error) else f"only to {100 * error:.2g} %"
            lines.append(f"the data tell {told} of this relative change: {change}")
        for residual in self.residuals.values():
            lines.append(f"{residual.output} is off by {residual.rms:.4g} {residual.unit} (rms)")
        if self.why_failed:
            lines.append(f"{self.failed} variants could not be simulated: {self.why_failed}")
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        return html(self._title(), _HEADING, self._rows())


def measured_runs(
    model: Model,
    data: Measured | Sequence[Measured],
    mapped: Mapping[str, str],
    outputs: Sequence[str],
) -> list[tuple[Array, list[tuple[str, Array]]]]:
    """Times and columns of measured runs."""
    runs = data if isinstance(data, (list, tuple)) else [data]
    if not runs:
        raise InputError("there is nothing measured")
    return [_measured(model, run, mapped, outputs) for run in runs]


def _measured(
    model: Model, data: Measured, mapped: Mapping[str, str], outputs: Sequence[str]
) -> tuple[Array, list[tuple[str, Array]]]:
    columns = _columns(data)
    times: Array | None = None
    found: dict[str, Array] = {}
    for header, values in columns.items():
        match = _NAMED.match(header)
        column, unit = (match["name"], match["unit"]) if match else (header, None)
        if column.lower() in _TIMES and column not in mapped:
            times = _numbers(header, values, unit, "s")
            continue
        name = mapped.get(column, mapped.get(header, column))
        if (outputs and name not in outputs) or (name == column and name.startswith("energy.")):
            continue
        known = model.outputs.get(name) or model.states.get(name)
        if known is None:
            names = [*model.outputs, *model.states]
            raise UnknownNameError(
                f"column `{column}` is no output and no state of `{model.name}`"
                f"{_machinist.did_you_mean(name, names)}",
                hint="`map={column: output}` names it, `outputs=` takes only some columns",
            )
        if name in found:
            raise InputError(f"`{name}` stands in two columns")
        found[name] = _numbers(header, values, unit, known.unit)
    if times is None:
        raise InputError("there is no column `t` or `time`, and no index of this name")
    missing = [name for name in outputs if name not in found]
    if missing or not found:
        raise InputError(f"there is no column `{missing[0]}`" if missing else "no column but time")
    return times, list(found.items())


def _columns(data: Measured) -> dict[str, ArrayLike]:
    """Columns by name, including an index that holds the time."""
    if isinstance(data, Run):
        return {"t": data.t, **{c.name: data[c.name] for c in data.columns}}
    if isinstance(data, Mapping):
        return {str(name): values for name, values in data.items()}
    if not hasattr(data, "columns"):
        kind = type(data).__name__
        raise InputError(f"data is a DataFrame, columns by name, or a run, not {kind}")
    columns = {str(name): data[name].to_numpy() for name in data.columns}
    index = getattr(data, "index", None)
    if index is not None and str(index.name).lower() in _TIMES:
        columns = {str(index.name): index.to_numpy(), **columns}
    return columns


def _numbers(header: str, values: ArrayLike, unit: str | None, wanted: str) -> Array:
    if unit is not None and unit != wanted:
        raise InputError(f"column `{header}` is in {unit}, not in {wanted}")
    try:
        return np.ascontiguousarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise InputError(f"column `{header}` is not of numbers: {error}") from None
