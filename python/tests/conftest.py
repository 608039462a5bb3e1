"""Shared fixtures: a built-in machine, and one from a spec if the program is installed."""

from __future__ import annotations

from pathlib import Path

import pytest

import machinist
from machinist import _derive

SPECS = Path(__file__).parents[2] / "specs" / "scenes"


@pytest.fixture(scope="session")
def gin() -> machinist.Model:
    return machinist.load("saw_gin")


@pytest.fixture(scope="session")
def spec() -> Path:
    """Spec of a scene that is also built in; skips the test without the program."""
    try:
        _derive.program()
    except machinist.ToolMissingError as error:
        pytest.skip(str(error))
    return SPECS / "saw_gin.toml"


@pytest.fixture(scope="session")
def model_file(spec: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    file = tmp_path_factory.mktemp("models") / "gin.model"
    file.write_bytes(_derive.derived(spec))
    return file
