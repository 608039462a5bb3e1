"""Eigenmodes and frequency responses."""

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
    """Derivatives of an eigenmode by a parameter, in SI units per unit of the parameter."""

    real: float
    imaginary: float
    natural_frequency: float
    damping_ratio: float


@dataclass(frozen=True, eq=False)
class Mode:
    """Eigenmode dy = Re(shape e^(eigenvalue t))."""

    #: free (no restoring force), aperiodic or oscillation.
    kind: str
    #: Eigenvalue with nonnegative imaginary part [1/s].
    eigenvalue: complex
    #: |eigenvalue| [rad/s].
    natural_frequency: float
    #: -Re/|eigenvalue|.
    damping_ratio: float
    #: -1/Re [s].
    decay_time: float
    #: Mode shape by the names of `Modes.names`: q, q' and z.
    shape: dict[str, complex]
    #: Share of each coordinate and first-order state in the motion; the sum is 1.
    shares: dict[str, float]
    #: Residual of the eigenpair; a value far above 1e-10 indicates a defective matrix.
    residual: float
    #: Derivatives by the requested parameters.
    slopes: dict[str, ModeSlope]
    #: Reason if there are no derivatives, else None.
    no_slopes: str | None

    @property
    def moving(self) -> str:
        """Largest shares as text."""
        order = sorted(self.shares.items(), key=lambda item: -item[1])
        major = [(name, share) for name, share in order if share >= 0.05 * order[0][1]][:4]
        return ", ".join(f"{name} {100 * share:.0f} %" for name, share in major)


_HEADING = ("motion", "moves", "natural [rad/s]", "damped [Hz]", "damping ratio", "decay [s]")


class Modes(Sequence[Mode]):
    """Eigenmodes of a machine at an operating point: free ones first, then by frequency."""

    def __init__(self, machine: str, at: str, told: dict[str, Any]) -> None:
        self._machine = machine
        self._at = at
        #: Time of the operating point [s].
        self.time: float = told["time"]
        #: State at the operating point.
        self.state: Array = told["state"]
        #: Names of [q, q', z], the entries of mode shapes.
        self.names: tuple[str, ...] = tuple(told["names"])
        self._matrix: Array | None = told["matrix"]
        n = told["coordinates"]
        moving = self.names[:n] + self.names[2 * n :]
        self._modes = [_mode(row, self.names, moving, told["by"]) for row in told["modes"]]

    @property
    def matrix(self) -> Array:
        """dy'/dy at the operating point; raises `AnalysisError` if too large for a dense matrix."""
        if self._matrix is None:
            raise AnalysisError(f"{len(self.state)} states are too many for a full matrix")
        return self._matrix.reshape(len(self.state), len(self.state))

    @property
    def eigenvalues(self) -> NDArray[np.complex128]:
        """All eigenvalues with nonnegative imaginary part [1/s]."""
        return np.array([mode.eigenvalue for mode in self._modes])

    @property
    def natural_frequencies(self) -> Array:
        """|eigenvalue| of all eigenmodes [rad/s]."""
        return np.array([mode.natural_frequency for mode in self._modes])

    @property
    def damping_ratios(self) -> Array:
        """-Re/|eigenvalue| of all eigenmodes; NaN for free motions."""
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
    """Frequency response H(w): for the input disturbance a cos(w t), the output is
    o + a Re(H(w) e^(j w t)).
    """

    def __init__(
        self,
        title: str,
        told: tuple[str, str, str, list[Array], float | None, tuple[float, float] | None],
    ) -> None:
        self._title = title
        #: Input, output, and the unit of H.
        self.input, self.output, self.unit, arrays, growth, self._largest = told
        #: Largest growth rate of the undisturbed motion [1/s], or None if no motion grows. Motions
        #: settle to these amplitudes only in the latter case.
        self.growth = growth
        #: Angular frequencies w [rad/s], |H|, and the continuous phase arg H [rad].
        self.frequencies, self.amplitudes, self.phases = arrays

    @property
    def values(self) -> NDArray[np.complex128]:
        """H(w)."""
        return self.amplitudes * np.exp(1j * self.phases)

    @property
    def peak(self) -> tuple[float, float]:
        """Frequency [rad/s] and value of the largest amplitude in the frequency range, possibly
        between two frequencies; infinite at an undamped resonance."""
        if self._largest is not None:
            return self._largest
        place = int(np.argmax(self.amplitudes))
        return float(self.frequencies[place]), float(self.amplitudes[place])

    def plot(self) -> Picture:
        """Bode plot: amplitude in decibels and phase in degrees over logarithmic frequency."""
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
