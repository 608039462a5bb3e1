"""Eight people who derive and run different machines at once, each compared with a fair share.

    python python/benches/at_once.py [path of the program]

Each has one process at a time, ten in sequence, which use c seconds of processor time. Each is
entitled to an equal share of the cores, and to more when others have ended; f is when they would
end so. The table shows the time t that they took, and t/f. If processes wait for each other, such
as for a lock, t/f exceeds 1 by far. The program fails if any exceeds 1.3. Other work on the machine
takes cores away: the cores to share are the processor time used and left idle, per time. Times are
medians of rounds.
"""

from __future__ import annotations

import os
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SCENES = Path(__file__).parents[2] / "specs" / "scenes"
MACHINES = ["bicycle", "conveyor", "crane", "engine", "motor", "pump", "robot_arm", "wind_turbine"]
RUNS = 10
ROUNDS = 3
LIMIT = 1.3


def repeatedly(program: str, machine: str, folder: str) -> float:
    """Processor time of runs of a machine [s]."""
    command = [program, "run", str(SCENES / "gallery" / f"{machine}.toml"), "--no-cache"]
    used = 0.0
    for _ in range(RUNS):
        child = subprocess.Popen(
            command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL
        )
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode:
            raise SystemExit(f"{machine} failed")
        used += usage.ru_utime + usage.ru_stime
    return used


def timed(program: str, machines: list[str], folder: str) -> list[tuple[float, float]]:
    """Time until the last process of each machine has ended, and processor time [s]."""
    begun = time.perf_counter()

    def work(machine: str) -> tuple[float, float]:
        used = repeatedly(program, machine, folder)
        return time.perf_counter() - begun, used

    with ThreadPoolExecutor(len(machines)) as pool:
        return list(pool.map(work, machines))


def idle() -> float:
    """Time that the cores of this machine were idle since its start, together [s]."""
    words = Path("/proc/stat").read_text().split("\n")[0].split()
    return (int(words[4]) + int(words[5])) / os.sysconf("SC_CLK_TCK")


def ratios(program: str, folder: str) -> tuple[float, list[tuple[float, ...]]]:
    """Number of cores to share; processor time, fair share and time of each machine, at once."""
    before = idle()
    done = timed(program, MACHINES, folder)
    took, used = [list(column) for column in zip(*done)]
    cores = (sum(used) + idle() - before) / max(took)
    return cores, list(zip(used, fair(used, cores), took))


def medians(rounds: list[list[float]]) -> list[float]:
    return [statistics.median(column) for column in zip(*rounds)]


def fair(used: list[float], cores: float) -> list[float]:
    """Ends of work that needs `used` seconds of a core each and shares `cores` equally."""
    left, now = dict(enumerate(used)), 0.0
    ends = [0.0] * len(used)
    while left:
        share = min(1.0, cores / len(left))
        least = min(left.values())
        now += least / share
        left = {index: need - least for index, need in left.items()}
        for index in [index for index, need in left.items() if need <= 1e-12]:
            ends[index] = now
            del left[index]
    return ends


def main() -> None:
    program = sys.argv[1] if len(sys.argv) > 1 else shutil.which("machinist")
    if not program:
        raise SystemExit("there is no `machinist` on PATH; name the program")
    program = str(Path(program).resolve())
    with tempfile.TemporaryDirectory() as folder:
        timed(program, MACHINES, folder)
        singly = [[timed(program, [m], folder)[0][0] for m in MACHINES] for _ in range(ROUNDS)]
        at_once = [ratios(program, folder) for _ in range(ROUNDS)]
    alone = medians(singly)
    cores = statistics.median(cores for cores, _ in at_once)
    print(f"{len(MACHINES)} machines on {cores:.1f} cores; medians of {ROUNDS} rounds [s]\n")
    print("| machine | alone | processor time at once | fair share | at once | at once / fair share |")
    print("| --- | --- | --- | --- | --- | --- |")
    worst = 0.0
    for index, (machine, single) in enumerate(zip(MACHINES, alone)):
        rows = [row[index] for _, row in at_once]
        used, fairly, took = medians([list(row) for row in rows])
        ratio = statistics.median(took / fairly for _, fairly, took in rows)
        worst = max(worst, ratio)
        print(f"| {machine} | {single:.2f} | {used:.2f} | {fairly:.2f} | {took:.2f} | {ratio:.2f} |")
    if worst > LIMIT:
        raise SystemExit(f"one took {worst:.2f} times a fair share, above {LIMIT}")


if __name__ == "__main__":
    main()
