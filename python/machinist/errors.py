"""What goes wrong, as exceptions: a message, and where there are some, a hint, a file, a line."""

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
    """Base of all that this package raises."""

    #: What is wrong.
    message: str
    #: What may help, or nothing.
    hint: str | None
    #: The file that is wrong, or nothing.
    file: str | None
    #: The line in it, from 1, or nothing.
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
    """What was asked for makes no sense."""

    #: What there are no derivatives by, and why, if that is what was asked for.
    undifferentiable: tuple[str, str] | None = None


class UnknownNameError(InputError, KeyError):
    """No parameter, state, output, method or scene has this name."""


class ShapeError(InputError):
    """An array has another shape than is needed."""


class ModelFileError(InputError):
    """A file is no model, is damaged, or is of another version."""


class SpecError(InputError):
    """A spec is wrong; `report` is all that the program says of it."""

    report: str = ""


class ToolMissingError(MachinistError, FileNotFoundError):
    """The program `machinist`, which derives models from specs, was not found."""


class StoppedError(MachinistError, RuntimeError):
    """A run could not go on. `run` is what there is of it, `time` how far it came [s]."""

    time: float = float("nan")
    run: Run | None = None


class AnalysisError(MachinistError, ArithmeticError):
    """There is no equilibrium, or an analysis has no result."""


class SweepError(MachinistError, RuntimeError):
    """A sweep cannot be stored or continued where it was to be."""
