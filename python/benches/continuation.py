"""Time of `machinist cycle --over` beside pseudo-arclength shooting with SciPy, at equal error.

    pip install numpy scipy
    python python/benches/continuation.py [PROGRAM]

Both follow the response of Duffing's oscillator x'' + 0.1 x' + x + x^3 = 0.3 cos(w t) over w from
0.6 to 2.2 through both folds, with multipliers at every point, and locate the folds. The error is
that of the folds relative to harmonic balance with 30 harmonics (tests/cycles/references.py). SciPy
integrates with DOP853 in compiled vector arithmetic, the right-hand side and its variational
equations are written by hand, and it runs at the loosest of some tolerances whose error is at most
that of the program. The settled start is given to both. PROGRAM is `machinist` by default, built
with `--release`; the time of its process contains start and derivation.
"""

from __future__ import annotations

import csv
import subprocess
import sys
import tempfile
import time
from math import cos, pi
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

#: Lengths along the branch count as in the program: by the ranges of states over the largest motion
#: and the range of w.
RANGES = np.array([3.45 * np.sqrt(2), 5.3 * np.sqrt(2), 1.6])
FOLDS = (1.779719524298572, 1.3242362007705655)
START, END = 0.6, 2.2
CHAPTER = Path(__file__).parents[2] / "docs" / "book" / "src" / "cycles.md"
ROUNDS = 5


def rate(angle: float, y: np.ndarray, w: float) -> list[float]:
    """x, x' over the phase w t, their derivatives by the initial values and by w."""
    x, v, a, b, c, d, p, q = y
    k = 1 + 3 * x * x
    force = -0.1 * v - x - x * x * x + 0.3 * cos(angle)
    return [
        v / w, force / w,
        c / w, d / w, (-k * a - 0.1 * c) / w, (-k * b - 0.1 * d) / w,
        q / w - v / w**2, (-k * p - 0.1 * q) / w - force / w**2,
    ]  # fmt: skip


class Scipy:
    def __init__(self, rtol: float) -> None:
        self.rtol = rtol
        self.runs = 0

    def shot(self, x: float, v: float, w: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Residual of a period, monodromy matrix, derivative by w."""
        self.runs += 1
        y = [x, v, 1.0, 0.0, 0.0, 1.0, 0.0, 0.0]
        end = solve_ivp(
            rate, (0, 2 * pi), y, "DOP853", rtol=self.rtol, atol=self.rtol, args=(w,)
        ).y[:, -1]
        return end[:2] - [x, v], end[2:6].reshape(2, 2), end[6:]

    def jacobian(self, monodromy: np.ndarray, by_w: np.ndarray) -> np.ndarray:
        return np.column_stack([monodromy - np.eye(2), by_w]) * RANGES

    def corrected(self, guess: np.ndarray, across: np.ndarray) -> tuple[np.ndarray, ...]:
        """Point at right angles to a direction, its tangent, multipliers, number of steps."""
        u = guess.copy()
        for count in range(20):
            residual, monodromy, by_w = self.shot(*(u * RANGES + [0, 0, START]))
            matrix = np.vstack([self.jacobian(monodromy, by_w), across])
            tangent = np.linalg.solve(matrix, [0, 0, 1])
            tangent /= np.linalg.norm(tangent)
            if np.abs(residual).max() < 10 * self.rtol:
                return u, tangent, np.linalg.eigvals(monodromy), np.array(count)
            u = u - np.linalg.solve(matrix, [*residual, across @ (u - guess)])
        raise ArithmeticError

    def follow(self) -> tuple[list[float], int]:
        """Folds of the branch, and number of its points."""
        x, v = settled()
        u, tangent, _, _ = self.corrected(np.array([x, v, 0.0]) / RANGES, np.array([0, 0, 1.0]))
        length, longest, folds, points = 0.01, 0.05, [], 1
        while u[2] < 1:
            try:
                v, turned, _, count = self.corrected(u + length * tangent, tangent)
                if tangent @ turned < 0.9:
                    raise ArithmeticError
            except ArithmeticError:
                length /= 2
                continue
            if turned[2] * tangent[2] < 0:
                folds.append(self.fold(u, tangent, length, turned))
            u, tangent, points = v, turned, points + 1
            if count <= 4:
                length = min(1.5 * length, longest)
        return folds, points

    def fold(self, u: np.ndarray, tangent: np.ndarray, length: float, turned: np.ndarray) -> float:
        """Place at which the tangent has no part along w, by secants."""
        a, b, at_a, at_b = 0.0, length, tangent[2], turned[2]
        for _ in range(40):
            s = (a * at_b - b * at_a) / (at_b - at_a)
            v, t, _, _ = self.corrected(u + s * tangent, tangent)
            if t[2] * at_a > 0:
                a, at_a, at_b = s, t[2], at_b / (2 if t[2] * at_a > 0 else 1)
            else:
                b, at_b, at_a = s, t[2], at_a
            if abs(t[2]) < 1e-8 or b - a < 1e-9 * length:
                break
        return float(START + (END - START) * v[2])


def settled() -> tuple[float, float]:
    """Start of the settled motion at the first frequency."""
    span = (0, 2 * pi * 30)
    run = solve_ivp(rate, span, [0.0] * 8, "DOP853", rtol=1e-8, atol=1e-8, args=(START,))
    return float(run.y[0, -1]), float(run.y[1, -1])


def program(command: str, folder: Path) -> tuple[float, list[float], int]:
    """Time, folds and number of points of the program."""
    spec = CHAPTER.read_text().split("```toml,file=duffing.toml\n")[1].split("```")[0]
    (folder / "duffing.toml").write_text(spec)
    ask = [
        command, "cycle", "duffing.toml", "--period", "block.frequency",
        "--over", f"block.frequency={START}..{END}", "--out", "branch.csv",
    ]  # fmt: skip
    start = time.perf_counter()
    subprocess.run(ask, cwd=folder, check=True, stdout=subprocess.DEVNULL)
    took = time.perf_counter() - start
    with open(folder / "branch.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    folds = [float(row["block.frequency [rad/s]"]) for row in rows if row["bifurcation"] == "fold"]
    return took, folds, len(rows)


def error(folds: list[float]) -> float:
    return max(abs(fold / exact - 1) for fold, exact in zip(folds, FOLDS, strict=True))


def main() -> None:
    command = sys.argv[1] if len(sys.argv) > 1 else "machinist"
    with tempfile.TemporaryDirectory() as folder:
        rounds = [program(command, Path(folder)) for _ in range(ROUNDS)]
    ours = min(took for took, _, _ in rounds)
    _, folds, points = rounds[0]
    print(f"machinist: {ours:.3f} s, {points} points, error of the folds {error(folds):.1e}")
    for rtol in (1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11):
        start = time.perf_counter()
        search = Scipy(rtol)
        found, count = search.follow()
        took = time.perf_counter() - start
        told = f"SciPy, rtol {rtol:.0e}: {took:.3f} s, {count} points, {search.runs} runs"
        print(f"{told}, error {error(found):.1e}")
        if error(found) <= max(error(folds), 1e-10):
            print(f"ratio at equal error: {took / ours:.0f}")
            break


if __name__ == "__main__":
    main()
