"""Models from specs, compiled by the program `machinist`."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from .errors import ModelFileError, SpecError, ToolMissingError

_WHERE = re.compile(r"\[(?P<file>[^\[\]\n]+?):(?P<line>\d+):\d+\]")
_MESSAGE = re.compile(r"^\s*(?:Error:\s*)?[×x]\s+(?P<message>.+)$", re.MULTILINE)
_HELP = re.compile(r"^\s*help:\s*(?P<help>.+?)(?=^\s*$|\Z)", re.MULTILINE | re.DOTALL)


def program() -> str:
    """Path of the program `machinist`, from the environment variable MACHINIST or else PATH."""
    named = os.environ.get("MACHINIST")
    found = shutil.which(named) if named else shutil.which("machinist")
    if found:
        return found
    told = f"MACHINIST names `{named}`, which is no program" if named else "it is not on PATH"
    raise ToolMissingError(
        f"a spec is derived by the program `machinist`: {told}",
        hint="`cargo install --path app` in Machinist's sources installs it; or let "
        "`machinist compile SCENE --out FILE.model` write a model elsewhere, and load that",
    )


def derived(scene: str | os.PathLike[str], *, keep_all: bool = False) -> bytes:
    """Model, as bytes, of a spec or of a built-in scene of the program."""
    tool = program()
    with tempfile.TemporaryDirectory(prefix="machinist-") as folder:
        out = Path(folder) / "machine.model"
        command = [tool, "compile", os.fspath(scene), "--out", str(out)]
        if keep_all:
            command.append("--keep-all")
        environment = {**os.environ, "NO_COLOR": "1"}
        try:
            done = subprocess.run(
                command, capture_output=True, text=True, errors="replace", env=environment
            )
        except OSError as error:
            raise ToolMissingError(f"{tool} cannot be run: {error}") from error
        if done.returncode == 0 and out.is_file():
            return out.read_bytes()
        raise _refused(str(scene), done.stderr or done.stdout, done.returncode)


def _refused(scene: str, report: str, code: int) -> SpecError:
    """Error reported by the program for a spec, with the first file and line it gives."""
    messages = [found["message"].strip() for found in _MESSAGE.finditer(report)]
    told = [message for message in messages if not message.endswith("errors in the spec")]
    message = "; ".join(told) or report.strip() or f"`machinist compile` ended with code {code}"
    where = _WHERE.search(report)
    file, line = (where["file"], int(where["line"])) if where else (scene, None)
    # The program omits the root directory from file names.
    if where and not Path(file).exists() and Path(os.sep, file).exists():
        file = str(Path(os.sep, file))
    advice = _HELP.search(report)
    hint = " ".join(advice["help"].split()) if advice else None
    error = SpecError(message, file=file, line=line, hint=hint)
    error.report = report
    return error


def read(path: Path, mark: bytes) -> tuple[bytes, bool]:
    """Content of a model file, and whether it starts with the model mark."""
    try:
        content = path.read_bytes()
    except OSError as error:
        raise ModelFileError(error.strerror or str(error), file=str(path)) from error
    return content, content.startswith(mark)
