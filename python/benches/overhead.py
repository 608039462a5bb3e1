"""Overhead of a run from Python, compared with the same run inside the native code.

    python python/benches/overhead.py
"""

from __future__ import annotations

import statistics
import time

import machinist

ROUNDS = 400


def measure(what: str, **ask: object) -> None:
    gin = machinist.load("saw_gin")

    def outside() -> float:
        start = time.perf_counter()
        gin.simulate(**ask)
        return time.perf_counter() - start

    def inside() -> float:
        return gin._machine.time_runs(dict(ask), 1)[0]

    # Neighbours are compared, by turns the one first and the other: a machine's pace drifts by more
    # than what is looked for, and a run finds in the caches what the one before it left there.
    rounds = []
    for turn in range(ROUNDS):
        if turn % 2:
            rounds.append((outside(), inside()))
        else:
            rounds.append((inside(), outside())[::-1])
    python, rust = (1e6 * statistics.median(times) for times in zip(*rounds))
    least = 1e6 * (min(python for python, _ in rounds) - min(rust for _, rust in rounds))
    more = 1e6 * statistics.median(python - rust for python, rust in rounds)
    print(f"{what}: {python:.1f} us from Python, {rust:.1f} us within; {more:+.1f} us a pair, {least:+.1f} us at least")


measure("0.05 s, 11 points", until=0.05, points=11)
measure("0.05 s, 2001 points", until=0.05)
measure("2 s, 2001 points", parameters={"coupling.stiffness": 3e4})
