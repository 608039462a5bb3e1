"""Scatters: statistics as those of the program and of closed forms, resumed, and on workers."""

from __future__ import annotations

import pickle
from pathlib import Path

import numpy as np
import pytest

import machinist

pytest.importorskip("pyarrow")

ASK = {"limits": "max(force) < 38 [kN]", "threads": 1}


@pytest.fixture(scope="module")
def trolley(tmp_path_factory) -> machinist.Model:
    """The crane trolley of the book's chapter."""
    chapter = Path(__file__).parents[2] / "docs" / "book" / "src" / "scatter.md"
    text = chapter.read_text()
    spec = text.split("```toml,file=trolley.toml\n")[1].split("```")[0]
    file = tmp_path_factory.mktemp("specs") / "trolley.toml"
    file.write_text(spec)
    return machinist.load(file)


@pytest.fixture(scope="module")
def scattered(trolley) -> machinist.Scatter:
    return trolley.scatter("max(force)", **ASK)


def test_statistics_are_those_of_the_program(scattered):
    # As the command of the chapter prints them.
    force = scattered.statistics("max(force)")
    assert force.unit == "kN" and force.count == len(scattered) == 1024
    of_book = (32.0422, 32.0222, 32.0622)
    found = (force.mean.value, force.mean.low, force.mean.high)
    assert found == pytest.approx(of_book, abs=5e-5)
    assert force.deviation.value == pytest.approx(3.0268, abs=5e-5)
    assert force.quantiles[0.95].value == pytest.approx(37.2067, abs=5e-5)
    missed = scattered.limits["max(force) < 38 [kN]"]
    assert missed.failures == 33 and missed.probability.value == 33 / 1024
    assert scattered.parameters["trolley.mass"].deviation == pytest.approx(300)
    assert "95 % quantile" in repr(scattered) and "<table" in scattered._repr_html_()


def test_samples_have_the_closed_form_of_each_run(scattered):
    mass, stiffness = scattered["trolley.mass"], scattered["buffer.stiffness"]
    peak = scattered["speed"] * np.sqrt(stiffness * mass) / 1000
    # Output times miss the peak by at most half of their distance.
    assert (scattered["max(force)"] <= peak * (1 + 1e-6)).all()
    np.testing.assert_allclose(scattered["max(force)"], peak, rtol=1e-3)
    # Mean of v sqrt(k m) by those of the factors, all independent.
    low, mode, high = 450e3, 500e3, 600e3
    k = np.linspace(low, high, 200_001)
    density = np.where(
        k < mode, 2 * (k - low) / (high - low) / (mode - low),
        2 * (high - k) / (high - low) / (high - mode),
    )  # fmt: skip
    of_stiffness = np.trapezoid(density * np.sqrt(k), k)
    spread = np.log(1 + 0.15**2)
    of_mass = np.sqrt(2000) * np.exp(-spread / 8)
    assert np.mean(peak) == pytest.approx(of_stiffness * of_mass / 1000, rel=1e-3)


def test_indices_are_those_of_the_program(trolley):
    found = trolley.scatter("max(force)", samples=512, indices=True)
    force = found.statistics("max(force)")
    assert len(found) == 2560 and force.count == 1024
    first = {name: index.value for name, index in force.first.items()}
    wanted = {"speed": 0.279, "trolley.mass": 0.646, "buffer.stiffness": 0.0854}
    assert first == pytest.approx(wanted, abs=5e-4)
    assert force.total["trolley.mass"].value == pytest.approx(0.669, abs=5e-4)
    assert "total index of trolley.mass" in repr(found)


def test_screening_and_linear_propagation_are_those_of_the_closed_form(trolley):
    ask = {"samples": 64, "morris": 20, "linear": True, "threads": 1}
    found = trolley.scatter("max(force)", limits="max(force) < 38 [kN]", **ask)
    force = found.statistics("max(force)")
    # v sqrt(k m) at the means, and its relative slopes 1, 1/2, 1/2.
    spreads = {"speed": (1, 0.05), "trolley.mass": (2000, 300)}
    spreads["buffer.stiffness"] = (1.55e6 / 3, 31180.5)
    peak = np.sqrt(2000 * 1.55e6 / 3) / 1000
    assert force.linear is not None
    assert force.linear.value == pytest.approx(peak, rel=1e-6)
    of_one = {
        name: peak * (1 if name == "speed" else 0.5) * deviation / mean
        for name, (mean, deviation) in spreads.items()
    }
    deviation = np.sqrt(sum(change**2 for change in of_one.values()))
    assert force.linear.deviation == pytest.approx(deviation, rel=1e-5)
    for name, change in of_one.items():
        share = force.linear.shares[name]
        assert share.contribution == pytest.approx(change, rel=1e-5)
        assert share.share == pytest.approx((change / deviation) ** 2, rel=1e-5)
    assert force.linear.left_out == ()
    # The force grows with each parameter, most with the mass.
    effects = force.effects
    assert [effects[name].count for name in of_one] == [20, 20, 20]
    for effect in effects.values():
        assert effect.mean == effect.mean_absolute.value > effect.mean_absolute.low
    order = sorted(effects, key=lambda name: effects[name].mean)
    assert order == ["buffer.stiffness", "speed", "trolley.mass"]
    assert "mu* of speed" in repr(found) and "linear deviation" in repr(found)
    plain = trolley.scatter("max(force)", samples=64).statistics("max(force)")
    assert plain.linear is None and plain.effects == {}


def test_a_scatter_is_resumed_and_another_is_refused(trolley, scattered, tmp_path):
    path = tmp_path / "runs"
    first = trolley.scatter("max(force)", path=path, chunk_seconds=0.01, **ASK)
    assert first.ran == 1024 and first.table.equals(scattered.table)
    parts = sorted(path.glob("part-*"))
    assert len(parts) > 1
    parts[-1].unlink()
    again = trolley.scatter("max(force)", path=path, **ASK)
    assert 0 < again.ran < 1024 and again.table.equals(first.table)
    assert again.results == first.results and again.limits == first.limits
    # Statistics are not part of what was run.
    other = trolley.scatter("max(force)", path=path, confidence=0.9, quantiles=[0.5], **ASK)
    assert other.ran == 0 and list(other.statistics("max(force)").quantiles) == [0.5]
    with pytest.raises(machinist.SweepError, match="another sweep, with another design"):
        trolley.scatter("max(force)", path=path, seed=2, **ASK)
    with pytest.raises(machinist.SweepError, match="outputs"):
        trolley.scatter("max(travel)", path=path, **ASK)


def test_workers_return_the_same(trolley, scattered):
    distributed = pytest.importorskip("dask.distributed")
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        there = trolley.scatter("max(force)", limits=ASK["limits"], client=client)
    assert there.table.equals(scattered.table) and there.results == scattered.results


def test_distributions_of_the_call_take_precedence(gin, trolley):
    found = gin.scatter(
        "final(twist)", vary={"coupling.stiffness": "normal(5 %)"}, samples=64, until=0.05
    )
    value = gin.parameters["coupling.stiffness"].value
    assert found.parameters["coupling.stiffness"].deviation == pytest.approx(0.05 * value)
    assert len(found) == 64 and found["coupling.stiffness"].std() > 0.03 * value
    restored = pickle.loads(pickle.dumps(trolley))
    narrow = restored.scatter("max(force)", vary={"speed": "uniform(1, 1.001)"}, samples=64)
    assert set(narrow.parameters) == {"speed", "trolley.mass", "buffer.stiffness"}
    assert narrow["speed"].min() >= 1 and narrow["speed"].max() <= 1.001


@pytest.mark.parametrize(
    ("options", "kind", "told"),
    [
        ({}, machinist.InputError, "no parameter of scene"),
        ({"vary": {"coupling.stif": "normal(5 %)"}}, machinist.UnknownNameError, "no parameter"),
        ({"vary": {"coupling.stiffness": "norml(1)"}}, machinist.InputError, "norml"),
        ({"vary": {"coupling.stiffness": "normal(5 %)"}, "sampler": "sobl"},
         machinist.UnknownNameError, "sobol"),
        ({"vary": {"coupling.stiffness": "normal(5 %)"}, "of": "max(twst)"},
         machinist.InputError, "twst"),
        ({"vary": {"coupling.stiffness": "normal(5 %)"}, "samples": 1},
         machinist.InputError, "samples"),
        ({"vary": {"coupling.stiffness": "normal(5 %)"}, "morris": 1},
         machinist.InputError, "at least 2 paths"),
        ({"vary": {"coupling.stiffness": "normal(5 %)"}, "confidence": 95},
         machinist.InputError, "between 0 and 1"),
        ({"vary": {"coupling.stiffness": "normal(5 %)"}, "given": {"coupling.stiffness": 1.0}},
         machinist.InputError, "has a distribution"),
    ],
)  # fmt: skip
def test_what_makes_no_sense_is_refused(gin, options, kind, told):
    with pytest.raises(kind, match=told):
        gin.scatter(**options)
