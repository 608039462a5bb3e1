"""Reference values for tests/gears.rs: a gear pair with backlash, driven by its transmission error.

    pip install numpy scipy
    python3 tests/gears/references.py

x'' + 2 zeta x' + (1 + 2 eps cos(W t)) g(x) = F + E W^2 cos(W t), with g the play of half width 1,
integrated from corner to corner of g by SciPy; periodic motions by shooting with the variational
equations, folds where the determinant of (monodromy - 1) vanishes. Without eps this is the pair of
Kahraman and Singh (J. Sound Vib. 142, 1990) with their zeta, F and E; without E, the pair of
Blankenship and Kahraman (J. Sound Vib. 185, 1995).
"""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

ZETA, MEAN = 0.05, 0.1
ERROR, EPS = 0.05, 0.0


def zone(x):
    return 1 if x > 1 else -1 if x < -1 else 0


def period(start, frequency, cycles=1):
    """State and monodromy after a number of periods, and the least and greatest x."""
    end, t = cycles * 2 * np.pi / frequency, 0.0
    y = np.concatenate([start, np.eye(2).ravel()])
    side = zone(y[0] + 1e-12 * np.sign(y[1])) if abs(abs(y[0]) - 1) < 1e-12 else zone(y[0])
    extremes = []
    while t < end:
        stiffness = 0.0 if side == 0 else 1.0

        def rate(t, y, side=side, k=stiffness):
            m = y[2:].reshape(2, 2)
            k = k * (1 + 2 * EPS * np.cos(frequency * t))
            a = MEAN + ERROR * frequency**2 * np.cos(frequency * t) - 2 * ZETA * y[1] - k * (y[0] - side)
            return np.concatenate([[y[1], a], (np.array([[0, 1], [-k, -2 * ZETA]]) @ m).ravel()])

        events = []
        for corner in (-1.0, 1.0):
            leaves = lambda t, y, corner=corner: y[0] - corner
            leaves.terminal = True
            leaves.direction = {1: -1, -1: 1, 0: corner}[side]
            if side == 0 or side == corner:
                events.append(leaves)
        turns = lambda t, y: y[1]
        events.append(turns)
        run = solve_ivp(rate, (t, end), y, method="DOP853", rtol=1e-12, atol=1e-14, events=events)
        extremes += [e[0] for e in run.y_events[-1]] + [run.y[0, -1]]
        t, y = run.t[-1], run.y[:, -1].copy()
        if run.status == 1:
            corner = round(y[0])
            y[0] = corner
            side = 0 if side != 0 else corner
    return y[:2], y[2:].reshape(2, 2), min(extremes), max(extremes)


def motion(start, frequency):
    solve = lambda x: period(x, frequency)[0] - x
    slope = lambda x: period(x, frequency)[1] - np.eye(2)
    x, info, ok, text = fsolve(solve, start, fprime=slope, xtol=1e-13, full_output=True)
    return x, np.linalg.norm(info["fvec"])


def fold(start, frequency):
    def equations(z):
        end, m, *_ = period(z[:2], z[2])
        return [*(end - z[:2]), np.linalg.det(m - np.eye(2))]
    z, info, ok, text = fsolve(equations, [*start, frequency], xtol=1e-12, full_output=True)
    _, _, least, greatest = period(z[:2], z[2])
    return z, np.linalg.norm(info["fvec"]), greatest - least


def show(state, frequency):
    _, m, least, greatest = period(state, frequency)
    modulus = np.abs(np.linalg.eigvals(m)).max()
    print(f"{frequency:.2f}: amplitude {(greatest - least) / 2:.12f}, modulus {modulus:.12f}")


if __name__ == "__main__":
    steady = lambda state, frequency: motion(period(state, frequency, 60)[0], frequency)[0]
    for ERROR, EPS in [(0.05, 0.0), (0.0, 0.15)]:
        print(f"E = {ERROR}, eps = {EPS}")
        below = above = np.array([1.1, 0.0])
        # The last motions before the jump down.
        for frequency in np.arange(1.3, 0.6, -0.01):
            found = steady(above, frequency)
            _, _, least, greatest = period(found, frequency)
            if greatest - least < 0.2:
                if frequency < 1:
                    break
            above, lowest = found, frequency
            if round(frequency, 2) in (1.2, 0.9, 0.84):
                show(above, frequency)
        frequency, step = 0.65, 0.01
        below = steady(below, frequency)
        show(below, frequency)
        while step > 2e-5:
            x, off = motion(below, frequency + step)
            if off < 1e-10 and np.abs(x - below).max() < 0.1:
                below, frequency = x, frequency + step
            else:
                step /= 2
        for name, start, guess in [("lower", above, lowest), ("upper", below, frequency)]:
            (x, v, place), off, range_ = fold(start, guess)
            print(f"{name} fold at {place:.13f}, amplitude {range_ / 2:.13f}, residual {off:.0e}")
