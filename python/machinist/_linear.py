"""Natural motions, and answers to harmonic disturbances."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, overload

import numpy as np
from numpy.typing import NDArray

from . import _svg
from ._run import Picture
from ._tables import html, text
from .errors import AnalysisError

Array = NDArray[np.float64]


@dataclass(frozen=True)
class ModeSlope:
    """How a mode moves with a parameter: derivatives in SI units, each by the parameter's."""

    real: float
    imaginary: float
    natural_frequency: float
    damping_ratio: float


@dataclass(frozen=True, eq=False)
class Mode:
    """One natural motion: dy = Re(shape e^(eigenvalue t))."""

    #: free (nothing restores it), aperiodic or oscillation.
    kind: str
    #: [1/s], with imaginary part not negative.
    eigenvalue: complex
    #: |eigenvalue| [rad/s].
    natural_frequency: float
    #: -Re/|eigenvalue|.
    damping_ratio: float
    #: -1/Re [s].
    decay_time: float
    #: By the names of `Modes.names`: q, q' and z.
    shape: dict[str, complex]
    #: Share of the motion that each coordinate and first-order state has; together 1.
    shares: dict[str, float]
    #: How far the shape is from being one; far above 1e-10 the matrix is defective.
    residual: float
    #: By parameters that were asked for.
    slopes: dict[str, ModeSlope]
    #: Why there are none.
    no_slopes: str | None

    @property
    def moving(self) -> str:
        """The largest shares, for people."""
        order = sorted(self.shares.items(), key=lambda item: -item[1])
        major = [(name, share) for name, share in order if share >= 0.05 * order[0][1]][:4]
        return ", ".join(f"{name} {100 * share:.0f} %" for name, share in major)


_HEADING = ("motion", "moves", "natural [rad/s]", "damped [Hz]", "damping ratio", "decay [s]")


class Modes(Sequence[Mode]):
    """All natural motions of a machine about a point, free ones first, then by frequency."""

    def __init__(self, machine: str, at: str, told: dict[str, Any]) -> None:
        self._machine = machine
        self._at = at
        #: Time of the point [s].
        self.time: float = told["time"]
        #: State of the point.
        self.state: Array = told["state"]
        #: Names of [q, q', z], which shapes are made of.
        self.names: tuple[str, ...] = tuple(told["names"])
        self._matrix: Array | None = told["matrix"]
        n = told["coordinates"]
        moving = self.names[:n] + self.names[2 * n :]
        self._modes = [_mode(row, self.names, moving, told["by"]) for row in told["modes"]]

    @property
    def matrix(self) -> Array:
        """dy'/dy there; an `AnalysisError` of more states than full matrices take."""
        if self._matrix is None:
            raise AnalysisError(f"{len(self.state)} states are too many for a full matrix")
        return self._matrix.reshape(len(self.state), len(self.state))

    @property
    def eigenvalues(self) -> NDArray[np.complex128]:
        """Eigenvalues of all, with imaginary parts not negative [1/s]."""
        return np.array([mode.eigenvalue for mode in self._modes])

    @property
    def natural_frequencies(self) -> Array:
        """|eigenvalue| of all [rad/s]."""
        return np.array([mode.natural_frequency for mode in self._modes])

    @property
    def damping_ratios(self) -> Array:
        """-Re/|eigenvalue| of all; NaN of free motions."""
        return np.array([mode.damping_ratio for mode in self._modes])

    @overload
    def __getitem__(self, index: int) -> Mode: ...
    @overload
    def __getitem__(self, index: slice) -> Sequence[Mode]: ...
    def __getitem__(self, index: int | slice) -> Mode | Sequence[Mode]:
        return self._modes[index]

    def __len__(self) -> int:
        return len(self._modes)

    def __iter__(self) -> Iterator[Mode]:
        return iter(self._modes)

    def _rows(self) -> list[list[str]]:
        def row(mode: Mode) -> list[str]:
            swings = mode.kind == "oscillation"
            numbers = [
                mode.natural_frequency if swings else None,
                mode.eigenvalue.imag / (2 * np.pi) if swings else None,
                mode.damping_ratio if swings else None,
                mode.decay_time if mode.eigenvalue.real else None,
            ]
            shown = ["" if number is None else f"{number:.6g}" for number in numbers]
            return [mode.kind, mode.moving, *shown]

        return [row(mode) for mode in self._modes]

    def _title(self) -> str:
        return f"{len(self)} motions of {self._machine}, {self._at}, t = {self.time:g} s"

    def __repr__(self) -> str:
        return "\n".join([self._title(), *text(_HEADING, self._rows())])

    def _repr_html_(self) -> str:
        return html(self._title(), _HEADING, self._rows())


def _mode(row: dict[str, Any], names: Sequence[str], moving: Sequence[str], by: list[str]) -> Mode:
    real, imaginary = row["shape"]
    slopes = row["slopes"]
    is_told = isinstance(slopes, list)
    return Mode(
        kind=row["kind"],
        eigenvalue=complex(row["real"], row["imaginary"]),
        natural_frequency=row["natural_frequency"],
        damping_ratio=row["damping_ratio"],
        decay_time=row["decay_time"] if row["real"] else float("inf"),
        shape=dict(zip(names, (real + 1j * imaginary).tolist())),
        shares=dict(zip(moving, row["shares"].tolist())),
        residual=row["residual"],
        slopes={n: ModeSlope(*slope) for n, slope in zip(by, slopes)} if is_told else {},
        no_slopes=slopes if isinstance(slopes, str) else None,
    )


class Response:
    """How an output answers a harmonic disturbance: o + a Re(H(w) e^(j w t))."""

    def __init__(
        self,
        title: str,
        told: tuple[str, str, str, list[Array], float | None, tuple[float, float] | None],
    ) -> None:
        self._title = title
        #: What varies, what answers, and the unit of the one over that of the other.
        self.input, self.output, self.unit, arrays, growth, self._largest = told
        #: How fast a motion grows by itself that is not disturbed [1/s], or None: only then do
        #: motions settle to these amplitudes.
        self.growth = growth
        #: Angular frequencies w [rad/s], |H|, and arg H [rad], continuous.
        self.frequencies, self.amplitudes, self.phases = arrays

    @property
    def values(self) -> NDArray[np.complex128]:
        """H(w)."""
        return self.amplitudes * np.exp(1j * self.phases)

    @property
    def peak(self) -> tuple[float, float]:
        """Frequency [rad/s] and size of the largest amplitude in the range of the frequencies,
        which may lie between two of them; infinite at a resonance that nothing damps."""
        if self._largest is not None:
            return self._largest
        place = int(np.argmax(self.amplitudes))
        return float(self.frequencies[place]), float(self.amplitudes[place])

    def plot(self) -> Picture:
        """Amplitude in decibels and phase in degrees over the logarithm of the frequency."""
        with np.errstate(divide="ignore"):
            decibels = 20 * np.log10(self.amplitudes)
        panels = [
            (f"dB of {self.unit}", [(self.output, decibels)]),
            ("deg", [("phase", np.degrees(self.phases))]),
        ]
        title = f"{self._title}: {self.output} answers {self.input}"
        return Picture(_svg.plot(title, self.frequencies, panels, x_label="rad/s", log_x=True))

    def __repr__(self) -> str:
        at, size = self.peak
        return (
            f"{self.output} answers {self.input}: {len(self.frequencies)} frequencies, "
            f"{self.frequencies[0]:.6g} to {self.frequencies[-1]:.6g} rad/s, largest "
            f"{size:.6g} {self.unit} at {at:.6g} rad/s"
        )

    def _repr_svg_(self) -> str:
        return self.plot().svg
