"""What tests share: a machine that is built in, and one of a spec where the program is there."""

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
    """The spec of a scene that is built in too; without the program that derives, no test."""
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
