"""Exceptions of the package, with a message and optionally a hint, a file and a line."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._run import Run

__all__ = [
    "AnalysisError",
    "InputError",
    "MachinistError",
    "ModelFileError",
    "ShapeError",
    "SpecError",
    "StoppedError",
    "SweepError",
    "ToolMissingError",
    "UnknownNameError",
]


class MachinistError(Exception):
    """Base class of all exceptions of this package."""

    #: Description of the error.
    message: str
    #: Suggested remedy, or None.
    hint: str | None
    #: Invalid file, or None.
    file: str | None
    #: Line in the file, from 1, or None.
    line: int | None

    def __init__(
        self,
        message: str,
        *,
        hint: str | None = None,
        file: str | None = None,
        line: int | None = None,
    ) -> None:
        what, mark, told = message.partition(" Hint: ")
        self.message = what if mark else message
        self.hint = hint or (told if mark else None)
        self.file = file
        self.line = line
        where = "" if file is None else f"{file}:{line}: " if line else f"{file}: "
        more = f"\nhint: {self.hint}" if self.hint else ""
        super().__init__(f"{where}{self.message}{more}")

    def __str__(self) -> str:
        return str(self.args[0])

    def __reduce__(self) -> tuple[Any, ...]:
        state = {k: v for k, v in self.__dict__.items() if k != "run"}
        return (_restored, (type(self), self.args, state))


def _restored(
    kind: type[MachinistError], args: tuple[Any, ...], state: dict[str, Any]
) -> MachinistError:
    error = kind.__new__(kind)
    error.args = args
    error.__dict__.update(state)
    return error


class InputError(MachinistError, ValueError):
    """An argument is invalid."""

    #: Name without derivatives and the reason, if the call requested derivatives by it.
    undifferentiable: tuple[str, str] | None = None


class UnknownNameError(InputError, KeyError):
    """No parameter, state, output, method or scene has this name."""


class ShapeError(InputError):
    """An array has the wrong shape."""


class ModelFileError(InputError):
    """A file is not a model, is damaged or has another version."""


class SpecError(InputError):
    """A spec is invalid; `report` is the complete output of the program."""

    report: str = ""


class ToolMissingError(MachinistError, FileNotFoundError):
    """The program `machinist`, which derives models from specs, was not found."""


class StoppedError(MachinistError, RuntimeError):
    """A run stopped early. `run` is the partial run, `time` the time reached [s]."""

    time: float = float("nan")
    run: Run | None = None


class AnalysisError(MachinistError, ArithmeticError):
    """No equilibrium exists, or an analysis has no result."""


class SweepError(MachinistError, RuntimeError):
    """A sweep cannot be stored or resumed at its path."""
