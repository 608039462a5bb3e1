"""Sweeps on threads: designs, results, result folders and failing variants."""

from __future__ import annotations

import json

import numpy as np
import pytest

import machinist

pytest.importorskip("pyarrow")
SPACE = {"coupling.stiffness": (1e4, 1e5, "log"), "coupling.damping": (50.0, 300.0)}
SHORT = {"until": 0.05, "outputs": ["twist", "motor.omega"]}


def test_designs_fill_their_space_and_come_out_the_same_again():
    grid = machinist.design({"a": (1.0, 100.0, "log"), "b": [5.0, 6.0]}, "grid", 3)
    assert grid.values.tolist() == [[1, 5], [1, 6], [10, 5], [10, 6], [100, 5], [100, 6]]
    for kind in ("random", "latin", "sobol"):
        if kind != "random":
            pytest.importorskip("scipy")
        made = machinist.design({"a": (1.0, 3.0), "b": (1e-3, 1e3, "log")}, kind, 100, seed=4)
        again = machinist.design({"a": (1.0, 3.0), "b": (1e-3, 1e3, "log")}, kind, 100, seed=4)
        other = machinist.design({"a": (1.0, 3.0), "b": (1e-3, 1e3, "log")}, kind, 100, seed=5)
        np.testing.assert_array_equal(made.values, again.values)
        assert (made.values != other.values).any()
        assert (made.values >= [1, 1e-3]).all() and (made.values <= [3, 1e3]).all()
        assert 35 < (made.values[:, 1] < 1).sum() < 65
    latin = machinist.design({"a": (0.0, 1.0)}, "latin", 50)
    assert sorted(np.floor(50 * latin.values[:, 0])) == list(range(50))
    table = machinist.design({"a": [3.0, 1.0], "b": [1.0, 2.0]}, "table")
    assert table.values.tolist() == [[3, 1], [1, 2]]


@pytest.mark.parametrize("method", [None, "taylor"])
@pytest.mark.parametrize("time_limit", [None, 60.0])
def test_a_row_is_to_the_last_bit_what_a_run_of_its_own_gives(gin, method, time_limit):
    settings = {"method": method} if method else {}
    swept = machinist.sweep(
        gin, SPACE, kind="random", n=40, time_limit=time_limit, **SHORT, **settings
    )
    assert not swept.failed and len(swept) == swept.ran == 40
    for row in (0, 17, 39):
        values = dict(zip(swept.design.names, swept.design.values[row]))
        run = gin.simulate(until=0.05, points=2, parameters=values, **settings)
        assert swept["twist"][row] == run["twist"][-1]
        assert swept["motor.omega"][row] == run["motor.omega"][-1]
        assert swept["steps"][row] == run.work["steps"]
    one = machinist.sweep(gin, SPACE, kind="random", n=40, threads=1, **SHORT, **settings)
    assert one.table.equals(swept.table)


def test_models_and_fields_are_swept_too(model_file):
    model = machinist.load(model_file)
    swept = model.sweep(SPACE, kind="random", n=5, **SHORT)
    run = model.simulate(
        until=0.05, points=2, parameters=dict(zip(swept.design.names, swept.design.values[4]))
    )
    assert swept["twist"][4] == run["twist"][-1]
    shaft = machinist.load("shaft_with_rotors", elements=4)
    name = list(shaft.parameters)[0]
    value = shaft.parameters[name].value
    swept = shaft.sweep({name: [value, 1.1 * value]}, until=0.01)
    assert not swept.failed


def test_extremes_are_over_the_output_times(gin):
    swept = gin.sweep({"coupling.damping": [50.0, 60.0]}, extremes=True, points=11, **SHORT)
    run = gin.simulate(until=0.05, points=11, parameters={"coupling.damping": 60.0})
    assert swept["twist.least"][1] == run["twist"].min()
    assert swept["twist.greatest"][1] == run["twist"].max()


def test_a_variant_that_fails_or_takes_too_long_is_a_row_with_its_reason(gin):
    swept = gin.sweep(
        {"motor.inertia": [0.0, 4.2, -1.0]}, until=0.3, max_steps=10**9, time_limit=0.3
    )
    assert set(swept.failed) == {0, 2}
    assert "not a finite number" in swept.failed[0]
    assert "limit of 0.3 s" in swept.failed[2]
    assert np.isnan(swept["twist"][[0, 2]]).all() and np.isfinite(swept["twist"][1])
    assert "2 failed" in repr(swept)
    lanes = gin.sweep(
        {"motor.inertia": [4.2]}, until=1e6, method="taylor", time_limit=0.3, max_steps=10**9
    )
    assert "limit of 0.3 s" in lanes.failed[0]


def test_masses_of_the_wrong_sign_are_told_of():
    drive = machinist.load("two_mass")
    swept = drive.sweep({"driver.inertia": [0.05, -1.0, -2.0]}, until=0.01)
    (note,) = swept.notes
    assert note.startswith("2 of 3 variants, the first is 1: the inertia of `driver.phi` is negative")
    assert f"note: {note}" in repr(swept)
    assert drive.sweep({"driver.inertia": [0.05, 0.1]}, until=0.01).notes == []


def test_what_is_in_a_folder_is_not_run_again(gin, tmp_path):
    ask = {"kind": "latin", "n": 60, "path": tmp_path, "chunk_seconds": 1e-3, **SHORT}
    pytest.importorskip("scipy")
    first = gin.sweep(SPACE, **ask)
    parts = sorted(tmp_path.glob("part-*.parquet"))
    assert first.ran == 60 and len(parts) > 2
    assert gin.sweep(SPACE, **ask).ran == 0
    parts[1].unlink()
    again = gin.sweep(SPACE, **ask)
    assert 0 < again.ran < 60
    assert again.table.equals(first.table)


def test_a_folder_says_what_it_is_of_and_is_not_mixed_up(gin, tmp_path):
    import pyarrow.parquet as parquet

    ask = {"path": tmp_path, **SHORT}
    gin.sweep({"coupling.damping": [50.0, 60.0]}, **ask)
    told = json.loads((tmp_path / "sweep.json").read_text())
    assert told["sweep"]["fingerprint"] == gin.fingerprint
    assert told["sweep"]["machinist"] == machinist.__version__
    assert len(told["sweep"]["design"]["sha256"]) == 64 and told["made_by"]["pyarrow"]
    schema = parquet.read_schema(next(tmp_path.glob("part-*.parquet")))
    assert json.loads(schema.metadata[b"machinist.sweep"])["key"] == told["key"]
    assert schema.field("twist").metadata[b"unit"] == b"rad"
    others = [
        ({"coupling.damping": [50.0, 61.0]}, ask),
        (machinist.design({"coupling.damping": [50.0, 61.0]}, "table"), ask),
        ({"coupling.damping": [50.0, 60.0]}, {**ask, "rtol": 1e-6}),
        ({"coupling.damping": [50.0, 60.0]}, {**ask, "outputs": ["twist"]}),
    ]
    for space, other in others:
        with pytest.raises(machinist.SweepError, match="another sweep"):
            gin.sweep(space, **other)


def test_damaged_parts_and_folders_are_refused(gin, tmp_path):
    ask = {"path": tmp_path, **SHORT}
    space = {"coupling.damping": [50.0, 60.0]}
    gin.sweep(space, **ask)
    part = next(tmp_path.glob("part-*.parquet"))
    whole = part.read_bytes()
    part.write_bytes(whole[: len(whole) // 2])
    with pytest.raises(machinist.SweepError, match="damaged") as told:
        gin.sweep(space, **ask)
    assert told.value.file == str(part) and "delete it" in told.value.hint
    (tmp_path / "sweep.json").write_text("{")
    with pytest.raises(machinist.SweepError, match="holds no sweep"):
        gin.sweep(space, **ask)
    (tmp_path / "sweep.json").unlink()
    with pytest.raises(machinist.SweepError, match="not what it is of"):
        gin.sweep(space, **ask)
    with pytest.raises(machinist.SweepError):
        gin.sweep(space, path=part, **SHORT)


@pytest.mark.parametrize(
    ("space", "more", "kind", "told"),
    [
        ({"coupling.dampng": [1.0]}, {}, machinist.UnknownNameError, "coupling.damping"),
        ({"coupling.damping": [np.nan]}, {}, machinist.InputError, "no finite"),
        ({"coupling.damping": ["a"]}, {}, machinist.InputError, "no numbers"),
        ({"coupling.damping": (1.0, 2.0)}, {}, machinist.InputError, "at least 2"),
        ({"coupling.damping": (-1.0, 2.0, "log")}, {"n": 3}, ValueError, "equal ratios"),
        ({"coupling.damping": (1.0, 2.0, "ln")}, {"n": 3}, ValueError, "linear or log"),
        ({"coupling.damping": [1.0]}, {"kind": "random", "n": 3}, ValueError, "a range is"),
        ({"coupling.damping": (1.0, 2.0)}, {"kind": "random"}, ValueError, "n is how many"),
        ({"coupling.damping": (1.0, 2.0)}, {"kind": "dart", "n": 2}, ValueError, "dart"),
        ({}, {}, machinist.InputError, "no parameters"),
        (3, {}, machinist.InputError, "not int"),
        ({"coupling.damping": [1.0]}, {"outputs": ["twst"]}, LookupError, "`twist`"),
        ({"coupling.damping": [1.0]}, {"rtol": 7.0}, machinist.InputError, "tolerance"),
        ({"coupling.damping": [1.0]}, {"untl": 7.0}, machinist.InputError, "no setting"),
        ({"coupling.damping": [1.0]}, {"threads": 0}, machinist.InputError, "at least one"),
        ({"coupling.damping": [1.0]}, {"chunk_seconds": 0}, machinist.InputError, "above 0"),
    ],
)
def test_what_makes_no_sense_is_refused(gin, space, more, kind, told):
    with pytest.raises(kind, match=told):
        gin.sweep(space, **more)
