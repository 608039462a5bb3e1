"""Runs that are advanced piece by piece, with inputs set in between."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _machinist
from ._run import Happened
from .errors import InputError, UnknownNameError

if TYPE_CHECKING:
    from ._model import Model

Array = NDArray[np.float64]


class Stepper:
    """A run that stands at :attr:`time` and is advanced from there, returned by
    :meth:`Model.start`.

    A call that fails changes nothing. The run can be copied, pickled and saved; a copy continues
    bit for bit. Threads may advance runs of one machine at the same time, each its own.
    """

    def __init__(self, model: Model, native: _machinist.Stepper) -> None:
        self._model = model
        self._native = native

    @property
    def model(self) -> Model:
        """The machine."""
        return self._model

    @property
    def time(self) -> float:
        """Time reached [s]."""
        return self._native.time

    @property
    def method(self) -> str:
        """Integration method."""
        return self._native.manner[0]

    @property
    def rtol(self) -> float:
        """Relative tolerance."""
        return self._native.manner[1]

    @property
    def y(self) -> Array:
        """State [q, q', z] as an array, in the order of `model.states`."""
        return self._native.state

    @property
    def rate(self) -> Array:
        """Rate y', with comparisons on the branches that the run holds, also while it slides."""
        return self._native.rate

    @property
    def parameters(self) -> dict[str, float]:
        """Present values of all parameters."""
        return dict(zip(self._model.parameters, self._native.parameters.tolist()))

    @property
    def states(self) -> dict[str, float]:
        """States by name, modes among them."""
        return dict(zip(self._model.states, self._native.state.tolist()))

    @property
    def outputs(self) -> dict[str, float]:
        """Outputs by name, at the present state and parameters."""
        return dict(zip(self._model.outputs, self._native.outputs.tolist()))

    @property
    def modes(self) -> dict[str, int]:
        """Modes by name: the integers that events change, such as whether a brake sticks."""
        pairs = zip(self._model.states.values(), self._native.state.tolist())
        return {state.name: round(value) for state, value in pairs if state.kind == "mode"}

    @property
    def is_sliding(self) -> bool:
        """Whether the motion slides along a switching surface of a comparison."""
        return self._native.is_sliding

    def __getitem__(self, name: str) -> float:
        for values in (self.states, self.outputs):
            if name in values:
                return values[name]
        hint = _machinist.did_you_mean(str(name), [*self._model.states, *self._model.outputs])
        raise UnknownNameError(f"{self._model.name} has no state or output `{name}`{hint}")

    def set(
        self, values: Mapping[str, float] | ArrayLike | None = None, /, **named: float
    ) -> None:
        """Set parameters from now on: inputs of the machine, or any that are `tunable`.

        Outputs show them at once. Comparisons, modes and speeds respond at the start of the next
        piece, whose list has the events.

        :param values: some by name, or all in order; SI units.
        :param named: parameters whose names are identifiers.
        :raises UnknownNameError: no parameter has this name.
        :raises InputError: a value is not finite or is refused by the machine, or a parameter
            cannot change during a run. No parameter is then changed.
        """
        if values is None:
            values = named
        elif named:
            if not isinstance(values, Mapping):
                raise InputError("give parameters by name, or all in order, but not both")
            values = {**values, **named}
        self._native.set(values)

    def advance(self, until: float, *, to_event: bool = False) -> list[Happened]:
        """Advance to a time [s] and return the events until then, as `events` of a run.

        Events happen within the piece. The method restarts at its start. Releases the GIL, and
        Ctrl-C ends the piece.

        :param until: at least :attr:`time`.
        :param to_event: stop after the first event, which has then happened; simultaneous ones
            are listed together.
        :raises StoppedError: the method cannot continue, or a limit of the piece is reached. The
            run stays where it was; `time` of the error is the time reached.
        """
        return [Happened(*event) for event in self._native.advance(until, to_event)]

    def step(self, dt: float, *, to_event: bool = False) -> list[Happened]:
        """Advance by a time [s], see :meth:`advance`.

        Sums of steps round: `advance(k*dt)` keeps to a grid of times.
        """
        until = self.time + dt
        if not until > self.time:
            raise InputError(f"a step of {dt!r} s from t = {self.time!r} s does not go forward")
        return self.advance(until, to_event=to_event)

    def save(self) -> bytes:
        """The run as bytes, from which :meth:`Model.restore` continues it bit for bit."""
        return self._native.save()

    def copy(self) -> Stepper:
        """A copy of the run that continues on its own."""
        return Stepper(self._model, self._native.copy())

    def __copy__(self) -> Stepper:
        return self.copy()

    def __deepcopy__(self, memo: dict[int, Any]) -> Stepper:
        return self.copy()

    def __reduce__(self) -> tuple[Any, ...]:
        return (_restored, (self._model, self.save()))

    def __repr__(self) -> str:
        sliding = ", sliding" if self.is_sliding else ""
        return f"<run of {self._model.name} at t = {self.time!r} s, {self.method}{sliding}>"


def _restored(model: Model, data: bytes) -> Stepper:
    return model.restore(data)
