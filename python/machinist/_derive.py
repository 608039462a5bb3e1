"""Models from specs."""

from __future__ import annotations

import warnings
from pathlib import Path

from . import _machinist
from .errors import Mistake, ModelFileError, SpecError, SpecWarning


def derived(
    *, file: Path | None = None, name: str | None = None, keep_all: bool = False
) -> bytes | None:
    """Model, as bytes, of a spec file or of a spec that comes with the package; None if no such
    spec has this name."""
    answer = _machinist.derive(file, name, keep_all)
    if answer is None:
        return None
    content, told = answer
    mistakes = [_mistake(*one) for one in told]
    if content is None:
        raise _refused(mistakes)
    for mistake in mistakes:
        # For the caller of `load`.
        warnings.warn(SpecWarning(mistake), stacklevel=3)
    return content


def _mistake(
    code: str, file: str, line: int, column: int, length: int, message: str, hint: str, report: str
) -> Mistake:
    return Mistake(
        code=code or None,
        message=message,
        file=file or None,
        line=line or None,
        column=column or None,
        length=length or None,
        hint=hint or None,
        report=report,
    )


def _refused(mistakes: list[Mistake]) -> SpecError:
    """Exception for the errors of a spec, at the place of the first."""
    first = mistakes[0]
    error = SpecError(
        "; ".join(mistake.message for mistake in mistakes),
        code=first.code,
        file=first.file,
        line=first.line,
        hint=first.hint,
    )
    error.mistakes = tuple(mistakes)
    error.report = "\n".join(mistake.report for mistake in mistakes)
    return error


def read(path: Path, mark: bytes) -> tuple[bytes, bool]:
    """Content of a model file, and whether it starts with the model mark."""
    try:
        content = path.read_bytes()
    except OSError as error:
        raise ModelFileError(error.strerror or str(error), file=str(path)) from error
    return content, content.startswith(mark)
