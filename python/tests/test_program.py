"""The program and the package write equal files, and the package reads both."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest

import machinist
from machinist import _derive

parquet = pytest.importorskip("pyarrow.parquet")
SPACE = {"coupling.stiffness": (1e4, 1e5), "coupling.damping": (50.0, 300.0, "log")}


@pytest.mark.parametrize("of_file", [False, True])
def test_a_sweep_by_the_program_is_the_same_table(
    program, gin, model_file, tmp_path: Path, of_file
):
    scene, model = (str(model_file), machinist.load(model_file)) if of_file else ("saw_gin", gin)
    file = tmp_path / "table.parquet"
    ranges = ["coupling.stiffness=1e4..1e5", "coupling.damping=50..300:log"]
    command = [program, "sweep", scene, "--count", "5", "--until", "0.05"]
    command += ["--parameter", ranges[0], "--parameter", ranges[1], "--out", str(file)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if "without Parquet" in done.stderr:
        pytest.skip("the program was built without Parquet")
    assert done.returncode == 0, done.stderr
    written = parquet.read_table(file)
    swept = model.sweep(SPACE, n=5, until=0.05)
    assert written.schema.equals(swept.table.schema)
    for name in written.column_names:
        assert written[name].to_pylist() == swept.table[name].to_pylist(), name
    told, of = (json.loads(table.schema.metadata[b"machinist.sweep"])["sweep"]
                for table in (written, swept.table))  # fmt: skip
    for known in ("model", "fingerprint", "machinist", "outputs", "extremes", "settings"):
        assert told[known] == of[known], known
    # What the program has run is not run again.
    again = model.sweep(SPACE, n=5, until=0.05, path=file)
    assert again.ran == 0 and again.table.equals(swept.table)
    for other, why in [({"rtol": 1e-6}, "rtol"), ({"n": 4}, "design"), ({"until": 0.1}, "until")]:
        with pytest.raises(machinist.SweepError, match=f"with another {why}\n"):
            model.sweep(SPACE, **{"n": 5, "until": 0.05, "path": file, **other})
    units = json.loads(written.schema.metadata[b"machinist.units"])
    assert units["coupling.stiffness"] == "N m/rad"


def test_models_of_the_package_are_those_of_the_program(program, tmp_path):
    for scene in ("saw_gin", "four_bar", "reed_beat_up", "gallery/bicycle"):
        file = Path(__file__).parents[2] / "specs" / "scenes" / f"{scene}.toml"
        out = tmp_path / "by_program.model"
        command = [program, "compile", str(file), "--algebra", "plain", "--no-cache"]
        subprocess.run([*command, "--out", str(out)], check=True, capture_output=True)
        assert out.read_bytes() == _derive.derived(file=file), scene
