"""Exceptions of the package, with a message and optionally a hint, a file and a line."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._run import Run

__all__ = [
    "AnalysisError",
    "InputError",
    "MachinistError",
    "Mistake",
    "ModelFileError",
    "ShapeError",
    "SpecError",
    "SpecWarning",
    "StoppedError",
    "SweepError",
    "UnknownNameError",
]


class MachinistError(Exception):
    """Base class of all exceptions of this package."""

    #: Description of the error.
    message: str
    #: Code of the kind of error, such as `run::zeno`, if the engine reports it. The chapter "Error
    #: codes" of the book and `machinist explain-error CODE` explain it.
    code: str | None
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
        code: str | None = None,
        hint: str | None = None,
        file: str | None = None,
        line: int | None = None,
    ) -> None:
        what, mark, told = message.partition(" Hint: ")
        self.message = what if mark else message
        self.code = code
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


@dataclass(frozen=True)
class Mistake:
    """An error or a warning of a spec, with its place in the text."""

    #: Code of the kind of error, such as `spec::unknown-name`, or None.
    code: str | None
    message: str
    #: Invalid file, or None.
    file: str | None
    #: Line and column in the file, from 1, or None. Columns are characters.
    line: int | None
    column: int | None
    #: Number of characters at fault, or None.
    length: int | None
    #: Suggested remedy, or None.
    hint: str | None
    #: The mistake with the text around it, as the program prints it.
    report: str


class SpecError(InputError):
    """A spec is invalid. `file`, `line` and `hint` are those of the first of its `mistakes`."""

    mistakes: tuple[Mistake, ...] = ()
    #: All mistakes with the text around them, as the program prints them.
    report: str = ""


class SpecWarning(UserWarning):
    """A spec is valid but questionable; `mistake` is the warning with its place in the text."""

    def __init__(self, mistake: Mistake) -> None:
        self.mistake = mistake
        where = "" if mistake.line is None else f"{mistake.file}:{mistake.line}: "
        more = f"\nhint: {mistake.hint}" if mistake.hint else ""
        super().__init__(f"{where}{mistake.message}{more}")

    def __reduce__(self) -> tuple[Any, ...]:
        return (type(self), (self.mistake,))


class StoppedError(MachinistError, RuntimeError):
    """A run stopped early. `run` is the partial run, `time` the time reached [s]."""

    time: float = float("nan")
    run: Run | None = None


class AnalysisError(MachinistError, ArithmeticError):
    """No equilibrium exists, or an analysis has no result."""


class SweepError(MachinistError, RuntimeError):
    """A sweep cannot be stored or resumed at its path."""
