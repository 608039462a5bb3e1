"""Plots as SVG, for notebooks without a plotting package."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from html import escape

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

_WIDTH, _HEIGHT, _LEFT, _RIGHT, _GAP = 640, 130, 76, 14, 26
_COLOURS = ("#1f5fa8", "#b5462f", "#3c7d3e", "#7a4f9c")
#: Beyond this number of samples, each pixel column shows its minimum and maximum.
_MOST = 2 * _WIDTH


def plot(
    title: str,
    times: Array,
    panels: Sequence[tuple[str, Sequence[tuple[str, Array]]]],
    *,
    x_label: str = "t [s]",
    marks: Sequence[float] = (),
    log_x: bool = False,
) -> str:
    """Stacked panels, one per unit, with named curves; `marks` are times."""
    height = 24 + len(panels) * (_HEIGHT + _GAP) + 16
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {_WIDTH} {height}" width="{_WIDTH}" '
        f'height="{height}" font-family="sans-serif" font-size="11" role="img">',
        f"<title>{escape(title)}</title>",
        f'<rect width="{_WIDTH}" height="{height}" fill="#ffffff"/>',
        f'<text x="{_LEFT}" y="15" font-size="12" fill="#222">{escape(title)}</text>',
    ]
    x = np.log10(times) if log_x else times
    finite = x[np.isfinite(x)]
    span = (float(finite[0]), float(finite[-1])) if finite.size else (0.0, 1.0)
    for number, (unit, curves) in enumerate(panels):
        top = 24 + number * (_HEIGHT + _GAP)
        parts.append(_panel(unit, x, span, curves, top, marks, log_x))
    parts.append(f'<text x="{_WIDTH - _RIGHT}" y="{height - 4}" text-anchor="end" fill="#222">')
    parts.append(f"{escape(x_label)}</text></svg>")
    return "".join(parts)


def _panel(
    unit: str,
    x: Array,
    span: tuple[float, float],
    curves: Sequence[tuple[str, Array]],
    top: int,
    marks: Sequence[float],
    log_x: bool,
) -> str:
    low, high = _limits([values for _, values in curves])
    wide = (span[1] - span[0]) or 1.0

    def at_x(value: float) -> float:
        return _LEFT + (value - span[0]) / wide * (_WIDTH - _LEFT - _RIGHT)

    def at_y(value: float) -> float:
        return top + _HEIGHT - (value - low) / (high - low) * _HEIGHT

    parts = [
        f'<rect x="{_LEFT}" y="{top}" width="{_WIDTH - _LEFT - _RIGHT}" height="{_HEIGHT}" '
        'fill="none" stroke="#999"/>',
        f'<text x="12" y="{top + _HEIGHT / 2}" fill="#222" text-anchor="middle" '
        f'transform="rotate(-90 12 {top + _HEIGHT / 2})">{escape(unit)}</text>',
    ]
    for value in ticks(low, high, 4):
        y = at_y(value)
        parts.append(f'<path d="M{_LEFT} {y:.1f}H{_WIDTH - _RIGHT}" stroke="#e4e4e4"/>')
        parts.append(
            f'<text x="{_LEFT - 5}" y="{y + 4:.1f}" text-anchor="end" fill="#444">'
            f"{value:.6g}</text>"
        )
    for value in ticks(*span, 6):
        shown = f"{10**value:.3g}" if log_x else f"{value:.6g}"
        parts.append(
            f'<text x="{at_x(value):.1f}" y="{top + _HEIGHT + 14}" text-anchor="middle" '
            f'fill="#444">{shown}</text>'
        )
    for mark in marks:
        if span[0] <= mark <= span[1]:
            parts.append(
                f'<path d="M{at_x(mark):.1f} {top}V{top + _HEIGHT}" stroke="#bbb" '
                'stroke-dasharray="3 3"/>'
            )
    for number, (name, values) in enumerate(curves):
        colour = _COLOURS[number % len(_COLOURS)]
        path = _path(x, values, at_x, at_y, span)
        parts.append(f'<path d="{path}" fill="none" stroke="{colour}" stroke-width="1.3"/>')
        parts.append(
            f'<text x="{_WIDTH - _RIGHT - 6}" y="{top + 14 + 13 * number}" text-anchor="end" '
            f'fill="{colour}">{escape(name)}</text>'
        )
    return "".join(parts)


def _path(
    x: Array,
    values: Array,
    at_x: Callable[[float], float],
    at_y: Callable[[float], float],
    span: tuple[float, float],
) -> str:
    """Path of a curve, interrupted at values that are not finite."""
    keep = _thinned(x, values, span)
    pieces, pen = [], "M"
    for place in keep:
        if not (math.isfinite(values[place]) and math.isfinite(x[place])):
            pen = "M"
            continue
        pieces.append(f"{pen}{at_x(x[place]):.1f} {at_y(values[place]):.1f}")
        pen = "L"
    return "".join(pieces)


def _thinned(x: Array, values: Array, span: tuple[float, float]) -> Sequence[int]:
    """Indices to draw: all, or first, minimum, maximum and last of each pixel column."""
    if len(x) <= _MOST:
        return range(len(x))
    wide = (span[1] - span[0]) or 1.0
    columns = np.nan_to_num((x - span[0]) / wide * _WIDTH).astype(int)
    starts = np.flatnonzero(np.diff(columns, prepend=-1))
    keep: set[int] = set()
    for start, stop in zip(starts, [*starts[1:], len(x)]):
        piece = np.where(np.isfinite(values[start:stop]), values[start:stop], 0.0)
        keep |= {int(start), int(stop) - 1}
        keep |= {int(start + piece.argmin()), int(start + piece.argmax())}
    return sorted(keep)


def _limits(curves: Sequence[Array]) -> tuple[float, float]:
    finite = [values[np.isfinite(values)] for values in curves]
    finite = [values for values in finite if values.size]
    if not finite:
        return 0.0, 1.0
    low, high = min(float(v.min()) for v in finite), max(float(v.max()) for v in finite)
    room = 0.05 * (high - low) or 0.5 * abs(high) or 0.5
    return low - room, high + room


def ticks(low: float, high: float, about: int) -> list[float]:
    """Round tick values within a range."""
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        return []
    rough = (high - low) / about
    size = 10.0 ** math.floor(math.log10(rough))
    step = next(size * k for k in (1, 2, 5, 10) if size * k >= rough)
    first = math.ceil(low / step)
    return [k * step for k in range(first, math.floor(high / step) + 1)]
