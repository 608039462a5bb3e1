"""Compares a sweep on a Dask cluster, one of whose workers is killed, with the same sweep on
threads of this process: equal results, no variant run twice, and the overhead of the cluster.

    python python/benches/cluster.py [VARIANTS] [WORKERS]
"""

from __future__ import annotations

import os
import signal
import statistics
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from pathlib import Path

from dask.distributed import Client, LocalCluster

import machinist

SPACE = {"coupling.stiffness": (5e3, 1e5, "log"), "coupling.damping": (10.0, 500.0)}


def cpu(client: Client) -> float:
    """CPU time [s] of this process, scheduler included, and of the workers, independent of other
    load."""
    return time.process_time() + sum(client.run(time.process_time).values())


def told(row: Sequence[float]) -> str:
    wall, costs, share = row
    return (
        f"{100 * (wall - 1):+.1f} % by the clock, {100 * (costs - 1):+.1f} % of processor time, "
        f"workers compute for {100 * share:.1f} % of the time"
    )


def main() -> None:
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 20_000
    workers = int(sys.argv[2]) if len(sys.argv) > 2 else 2
    gin = machinist.load("saw_gin")
    ask = {"kind": "sobol", "n": count, "outputs": ["twist", "coupling_torque"], "rtol": 1e-8}
    with (
        tempfile.TemporaryDirectory() as folder,
        LocalCluster(
            n_workers=workers, threads_per_worker=1, dashboard_address=None
        ) as cluster,
        Client(cluster) as client,
    ):
        root = Path(folder)
        rows = []
        for round in range(5):
            before = cpu(client)
            plain = gin.sweep(SPACE, path=root / f"plain{round}", threads=workers, **ask)
            between = cpu(client)
            spread = gin.sweep(SPACE, path=root / f"spread{round}", client=client, **ask)
            costs = (cpu(client) - between) / (between - before)
            assert spread.table.equals(plain.table)
            parts = len(list((root / f"spread{round}").glob("part-*")))
            share = spread.computing / workers / spread.seconds
            rows.append((spread.seconds / plain.seconds, costs, share))
            print(
                f"{workers} threads {plain.seconds:.2f} s, {workers} workers "
                f"{spread.seconds:.2f} s in {parts} parts: {told(rows[-1])}"
            )
        print(f"medians: {told([statistics.median(column) for column in zip(*rows)])}")

        one = gin.sweep(SPACE, path=root / "one", threads=1, **ask)
        pids = client.run(os.getpid)

        def kill() -> None:
            while sum(1 for _ in (root / "killed").glob("part-*")) < 12:
                time.sleep(0.01)
            os.kill(next(iter(pids.values())), signal.SIGKILL)
            print("one worker is killed")

        killer = threading.Thread(target=kill)
        killer.start()
        killed = gin.sweep(SPACE, path=root / "killed", client=client, **ask)
        killer.join()
        print(
            f"one worker killed: {killed.ran} run in {killed.seconds:.2f} s, equal to one thread's "
            f"({one.seconds:.2f} s): {killed.table.equals(one.table)}"
        )
        again = gin.sweep(SPACE, path=root / "killed", client=client, **ask)
        print(f"again: {again.ran} run in {again.seconds:.2f} s")
        assert killed.table.equals(one.table) and again.ran == 0


if __name__ == "__main__":
    main()
