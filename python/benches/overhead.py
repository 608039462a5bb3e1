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
    outside, inside = [], []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        gin.simulate(**ask)
        outside.append(time.perf_counter() - start)
        inside += gin._machine.time_runs(dict(ask), 1)
    python, rust = (1e6 * statistics.median(times) for times in (outside, inside))
    print(f"{what}: {python:.1f} us from Python, {rust:.1f} us within, {python - rust:+.1f} us")


measure("0.05 s, 11 points", until=0.05, points=11)
measure("0.05 s, 2001 points", until=0.05)
measure("2 s, 2001 points", parameters={"coupling.stiffness": 3e4})
