"""The tutorial runs, and the notebook matches its script.

`MACHINIST_TUTORIAL=write python -m pytest tests/test_tutorial.py` rewrites the notebook.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest

nbformat = pytest.importorskip("nbformat")
nbclient = pytest.importorskip("nbclient")
for needed in ("dask.distributed", "pandas", "pyarrow", "scipy"):
    pytest.importorskip(needed)

FOLDER = Path(__file__).parents[1] / "tutorial"


def cells() -> list[tuple[str, str]]:
    """Type and text of the script's cells."""
    found = []
    for part in (FOLDER / "tutorial.py").read_text(encoding="utf-8").split("# %%")[1:]:
        head, _, body = part.partition("\n")
        if head.strip() == "[markdown]":
            lines = [line.removeprefix("#").removeprefix(" ") for line in body.strip().splitlines()]
            found.append(("markdown", "\n".join(lines)))
        else:
            found.append(("code", body.strip()))
    return found


def test_the_tutorial_runs_and_the_notebook_is_its_script():
    book = nbformat.v4.new_notebook()
    book.metadata["kernelspec"] = {
        "name": "python3", "display_name": "Python 3", "language": "python",
    }  # fmt: skip
    make = {"markdown": nbformat.v4.new_markdown_cell, "code": nbformat.v4.new_code_cell}
    for number, (kind, text) in enumerate(cells()):
        cell = make[kind](text)
        cell["id"] = f"cell-{number}"
        book.cells.append(cell)
    nbclient.NotebookClient(book, timeout=300, kernel_name="python3").execute()
    shown = [output for cell in book.cells for output in cell.get("outputs", [])]
    assert any("image/svg+xml" in output.get("data", {}) for output in shown)
    notebook = FOLDER / "tutorial.ipynb"
    if os.environ.get("MACHINIST_TUTORIAL") == "write":
        for cell in book.cells:
            cell.get("metadata", {}).pop("execution", None)
        book.metadata.pop("language_info", None)
        nbformat.write(book, notebook)
    found = nbformat.read(notebook, as_version=4)
    assert [(c.cell_type, c.source) for c in found.cells] == cells(), (
        "tutorial.ipynb is not fresh: MACHINIST_TUTORIAL=write writes it again"
    )
