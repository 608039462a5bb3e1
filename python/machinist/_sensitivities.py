"""Relative sensitivities of outputs to parameters."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from . import _svg
from ._run import Picture, Run
from ._tables import html, text

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Effect:
    """Change of an output relative to its largest magnitude, per relative parameter change."""

    parameter: str
    output: str
    #: Values over time.
    values: Array
    #: Root mean square over the output times.
    rms: float
    #: Value of the largest magnitude, with sign, and its time [s].
    largest: float
    at: float
    #: Value at the end of the run.
    end: float


_HEADING = ("parameter", "output", "rms", "largest", "at [s]", "end")


class Sensitivities:
    """Relative effects of parameters on outputs, largest first."""

    def __init__(
        self, run: Run, values: dict[str, float], outputs: list[str], left_out: dict[str, str]
    ) -> None:
        #: The run, whose columns include the derivatives in their units.
        self.run = run
        #: Parameters left out, with reasons.
        self.left_out = left_out
        effects = [_effect(run, o, p, value) for o in outputs for p, value in values.items()]
        #: Effects, largest first.
        self.effects: list[Effect] = sorted(effects, key=lambda effect: -effect.rms)

    def __getitem__(self, pair: tuple[str, str]) -> Effect:
        """Effect of a parameter on an output: `[output, parameter]`."""
        output, parameter = pair
        for effect in self.effects:
            if (effect.output, effect.parameter) == (output, parameter):
                return effect
        raise KeyError(pair)

    def plot(self, top: int = 6) -> Picture:
        """Plot the largest effects over time."""
        shown = self.effects[:top]
        panels: dict[str, list[tuple[str, Array]]] = {}
        for effect in shown:
            panels.setdefault(effect.output, []).append((effect.parameter, effect.values))
        title = f"{self.run.machine}: relative effects"
        return Picture(_svg.plot(title, self.run.t, list(panels.items())))

    def _rows(self, top: int) -> list[list[str]]:
        def row(e: Effect) -> list[str]:
            numbers = [f"{value:.4g}" for value in (e.rms, e.largest, e.at, e.end)]
            return [e.parameter, e.output, *numbers]

        return [row(effect) for effect in self.effects[:top]]

    def __repr__(self) -> str:
        lines = text(_HEADING, self._rows(20))
        if len(self.effects) > 20:
            lines.append(f"and {len(self.effects) - 20} more")
        lines += [f"left out: {name}, which {why}" for name, why in self.left_out.items()]
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        return html("relative effects", _HEADING, self._rows(20))


def _effect(run: Run, output: str, parameter: str, value: float) -> Effect:
    course, slopes = run[output], run.sensitivity(output, parameter)
    scale = np.abs(course).max()
    values = np.where(slopes == 0, 0.0, value / scale * slopes) if scale else np.zeros_like(slopes)
    place = int(np.argmax(np.abs(values)))
    return Effect(
        parameter, output, values, float(np.sqrt(np.mean(values**2))), float(values[place]),
        float(run.t[place]), float(values[-1]),
    )  # fmt: skip
