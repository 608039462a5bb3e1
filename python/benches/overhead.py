"""What a run from Python costs beside the same run with nothing in between.

    python python/benches/overhead.py
"""

from __future__ import annotations

import statistics
import time

import machinist

ROUNDS = 400


def measure(what: str, **ask: object) -> None:
    gin = machinist.load("saw_gin")
    gin.simulate(**ask)
    rounds = []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        gin.simulate(**ask)
        python = time.perf_counter() - start
        rounds.append((python, *gin._machine.time_runs(dict(ask), 1)))
    python, rust = (1e6 * statistics.median(times) for times in zip(*rounds))
    # Of neighbours, since a machine's pace drifts by more than what is looked for.
    more = 1e6 * statistics.median(python - rust for python, rust in rounds)
    print(f"{what}: {python:.1f} us from Python, {rust:.1f} us within, {more:+.1f} us a pair")


measure("0.05 s, 11 points", until=0.05, points=11)
measure("0.05 s, 2001 points", until=0.05)
measure("2 s, 2001 points", parameters={"coupling.stiffness": 3e4})
