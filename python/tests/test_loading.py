"""Loading machines by name, from model files and from specs; errors for anything else."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest

import machinist


def test_every_scene_that_is_built_in_runs_and_shows_itself():
    for name in machinist.built_in_names():
        model = machinist.load(name)
        run = model.simulate(points=20)
        assert np.isfinite(run.y).all(), name
        assert "<svg" in run._repr_html_()
        assert name in repr(model) and name in model._repr_html_()


def test_a_machine_lists_parameters_states_and_outputs_with_units(gin):
    stiffness = gin.parameters["coupling.stiffness"]
    assert (stiffness.value, stiffness.unit, stiffness.tunable) == (23065.2, "N m/rad", True)
    assert gin.states["motor.omega"].unit == "rad/s"
    assert gin.outputs["twist"].unit == "rad"
    assert "coupling.stiffness" in repr(gin.parameters)
    assert gin.p({"coupling.stiffness": 1.0})[gin.parameters.index("coupling.stiffness")] == 1.0


def test_what_only_the_start_or_a_constraint_depends_on_is_not_tunable():
    linkage = machinist.load("four_bar")
    tunable = [p.name for p in linkage.parameters.values() if p.tunable]
    fixed = [p.name for p in linkage.parameters.values() if not p.tunable]
    assert any("mass" in name for name in tunable)
    assert any("length" in name for name in fixed), fixed


def test_a_spec_and_its_model_file_are_the_machine_that_is_built_in(gin, spec, model_file):
    of_spec, of_file = machinist.load(spec), machinist.load(model_file)
    assert of_spec.fingerprint == of_file.fingerprint
    assert of_file.running == "compiled"
    runs = [model.simulate(until=0.1, points=11) for model in (gin, of_spec, of_file)]
    for run in runs[1:]:
        np.testing.assert_allclose(run.y, runs[0].y, rtol=1e-7, atol=1e-9)


def test_a_machine_is_loaded_once_and_found_again_behind_a_pickle(gin, model_file):
    for model in (gin, machinist.load(model_file)):
        assert pickle.loads(pickle.dumps(model)) is model


def test_a_spec_that_is_wrong_is_told_with_file_line_and_hint(spec, tmp_path):
    bad = tmp_path / "bad.toml"
    bad.write_text(spec.read_text().replace('"motor.omega"', '"motor.omegga"', 1))
    with pytest.raises(machinist.SpecError) as told:
        machinist.load(bad)
    error = told.value
    assert Path(error.file).name == "bad.toml"
    assert "omegga" in bad.read_text().splitlines()[error.line - 1]
    assert "omega" in error.hint
    assert "omegga" in error.report


@pytest.mark.parametrize(
    ("name", "kind", "told"),
    [
        ("saw_ginn", machinist.UnknownNameError, "did you mean `saw_gin`"),
        ("zzz", machinist.UnknownNameError, "built in are"),
        ("missing.model", machinist.ModelFileError, "missing.model: No such file"),
        (3, TypeError, "PathLike"),
    ],
)
def test_what_is_no_machine_is_refused_by_name(name, kind, told):
    with pytest.raises(kind, match=told):
        machinist.load(name)


def test_a_model_file_that_is_damaged_or_of_another_version_is_refused(model_file, tmp_path):
    good = model_file.read_bytes()
    cases = {
        "foreign": (b"something else", "not a model"),
        "short": (good[:-7], "cut off"),
        "header": (good[:18], "cut off"),
        "altered": (good[:100] + bytes([good[100] ^ 1]) + good[101:], "altered"),
        "version": (good[:16] + (99).to_bytes(4, "little") + good[20:], "version 99"),
    }
    for name, (content, told) in cases.items():
        file = tmp_path / f"{name}.model"
        file.write_bytes(content)
        with pytest.raises(machinist.ModelFileError, match=told) as error:
            machinist.load(file)
        assert error.value.file == str(file)
        assert "machinist compile" in error.value.hint


def test_damaged_bytes_never_crash(model_file, tmp_path):
    """Repairs the header, so that the damaged content is read."""
    import hashlib

    good = model_file.read_bytes()
    random = np.random.default_rng(1)
    refused = 0
    for _ in range(150):
        content = bytearray(good[60:])
        for _ in range(random.integers(1, 4)):
            content[random.integers(len(content))] = random.integers(256)
        file = tmp_path / "damaged.model"
        file.write_bytes(good[:28] + hashlib.sha256(content).digest() + content)
        try:
            machinist.load(file).simulate(until=1e-3, points=2, max_steps=100, time_limit=1)
        except machinist.MachinistError:
            refused += 1
    assert refused > 50


def test_fields_are_cut_as_wanted_and_only_where_there_are_some(gin):
    coarse = machinist.load("reed_beat_up", elements=4, order=2)
    assert len(coarse.states) < len(machinist.load("reed_beat_up").states)
    with pytest.raises(machinist.InputError, match="no fields"):
        machinist.load("saw_gin", elements=4)
    with pytest.raises(machinist.InputError, match="elements"):
        machinist.load("reed_beat_up", elements=0)
