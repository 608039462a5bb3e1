"""Shared fixtures: a built-in machine, its spec and model file, and the program."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import machinist
from machinist import _derive

SPECS = Path(__file__).parents[2] / "specs" / "scenes"

Run = Callable[..., "subprocess.CompletedProcess[str]"]


@pytest.fixture(scope="session", autouse=True)
def _cache(tmp_path_factory: pytest.TempPathFactory):
    """Cache of derived models that is empty at first."""
    before = os.environ.get("MACHINIST_CACHE")
    os.environ["MACHINIST_CACHE"] = str(tmp_path_factory.mktemp("cache"))
    yield
    if before is None:
        del os.environ["MACHINIST_CACHE"]
    else:
        os.environ["MACHINIST_CACHE"] = before


@pytest.fixture(scope="session")
def gin() -> machinist.Model:
    return machinist.load("saw_gin")


@pytest.fixture(scope="session")
def spec() -> Path:
    """Spec of a scene that is also built in."""
    return SPECS / "saw_gin.toml"


@pytest.fixture(scope="session")
def model_file(spec: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    content = _derive.derived(file=spec)
    assert content is not None
    file = tmp_path_factory.mktemp("models") / "gin.model"
    file.write_bytes(content)
    return file


@pytest.fixture(scope="session")
def script() -> str:
    """Console script of the package under test, beside the interpreter."""
    found = shutil.which("machinist", path=str(Path(sys.executable).parent))
    assert found, "the package has no console script"
    return found


@pytest.fixture
def commanded(script: str, tmp_path: Path) -> Run:
    """Runs a command of the console script in an empty folder."""

    def run(*arguments: str, **environment: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run(
            [script, *arguments],
            cwd=tmp_path,
            env={**os.environ, "NO_COLOR": "1", **environment},
            capture_output=True,
            text=True,
            check=False,
        )

    return run


@pytest.fixture(scope="session")
def program() -> str:
    """The program built by Cargo, named by MACHINIST; skips the test without it."""
    named = os.environ.get("MACHINIST")
    if not named:
        pytest.skip("MACHINIST names no program")
    return named
