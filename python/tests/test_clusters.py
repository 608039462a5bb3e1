"""Sweeps on a Dask cluster of worker processes, one of which is killed."""

from __future__ import annotations

import os
import signal
import threading
import time

import pytest

import machinist

pytest.importorskip("pyarrow")
distributed = pytest.importorskip("dask.distributed")
SPACE = {"coupling.stiffness": (1e4, 1e5, "log"), "coupling.damping": (50.0, 300.0)}
ASK = {"kind": "random", "n": 1500, "outputs": ["twist"], "chunk_seconds": 0.1}


@pytest.fixture(scope="module")
def client():
    with (
        distributed.LocalCluster(
            n_workers=2, threads_per_worker=1, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        yield client


@pytest.mark.skipif(os.name == "nt", reason="signals")
def test_a_worker_that_is_killed_changes_nothing(gin, client, tmp_path):
    here = gin.sweep(SPACE, path=tmp_path / "here", threads=1, **ASK)
    workers = client.run(os.getpid)

    def kill() -> None:
        while len(list((tmp_path / "there").glob("part-*"))) < 4:
            time.sleep(0.01)
        os.kill(next(iter(workers.values())), signal.SIGKILL)

    killer = threading.Thread(target=kill)
    killer.start()
    there = gin.sweep(SPACE, path=tmp_path / "there", client=client, **ASK)
    killer.join()
    assert there.ran == 1500 and there.table.equals(here.table)
    client.wait_for_workers(2, timeout=30)
    assert set(client.run(os.getpid).values()) != set(workers.values())
    assert gin.sweep(SPACE, path=tmp_path / "there", client=client, **ASK).ran == 0


def test_rows_of_failed_variants_come_back_from_workers(gin, client):
    swept = gin.sweep({"motor.inertia": [0.0, 4.2]}, until=0.05, client=client)
    assert set(swept.failed) == {0} and "not a finite number" in swept.failed[0]


def test_errors_of_the_package_cross_processes(client):
    def ask() -> None:
        machinist.load("saw_gin").simulate(parameters={"coupling.stifness": 1.0})

    with pytest.raises(machinist.UnknownNameError, match="did you mean"):
        client.submit(ask).result()


def test_models_of_files_reach_workers(client, model_file):
    model = machinist.load(model_file)
    ask = {"kind": "random", "n": 40, "until": 0.05, "outputs": ["twist"]}
    assert model.sweep(SPACE, client=client, **ask).table.equals(model.sweep(SPACE, **ask).table)


@pytest.mark.skipif(os.name == "nt", reason="signals")
def test_a_variant_that_kills_its_workers_is_found_and_no_other_is_blamed(gin, monkeypatch):
    import dask
    from machinist import _dask

    plain = _dask.run_piece

    def deadly(model, plan, first, variants, threads):
        if (variants[:, 1] == 300.0).any():
            os._exit(1)
        return plain(model, plan, first, variants, threads)

    monkeypatch.setattr(_dask, "run_piece", deadly)
    space = {"coupling.stiffness": [1e4, 2e4], "coupling.damping": [50.0, 300.0]}
    table = machinist.design(space, "table")
    with (
        dask.config.set({"distributed.scheduler.allowed-failures": 0}),
        distributed.LocalCluster(
            n_workers=1, threads_per_worker=1, dashboard_address=None
        ) as cluster,
        distributed.Client(cluster) as client,
    ):
        swept = gin.sweep(table, until=0.05, outputs=["twist"], client=client)
    assert set(swept.failed) == {1} and "workers that ran it died" in swept.failed[1]
    assert swept["twist"][0] == gin.sweep(table, until=0.05, outputs=["twist"])["twist"][0]
