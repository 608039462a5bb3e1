"""Reference values for tests/gears.rs: a gear pair with backlash, driven by its transmission error.

    pip install numpy scipy
    python3 tests/gears/references.py

x'' + 2 zeta x' + (1 + 2 eps cos(W t)) g(x) = F + E W^2 cos(W t), with g the play of half width 1,
integrated from corner to corner of g by SciPy; periodic motions by shooting with the variational
equations, folds where the determinant of (monodromy - 1) vanishes. Without eps this is the pair of
Kahraman and Singh (J. Sound Vib. 142, 1990) with their zeta, F and E; without E, the pair of
Blankenship and Kahraman (J. Sound Vib. 185, 1995). Harmonic balance is their method; its folds
with one term are those of the describing functions, and with more terms tend to those of shooting.
"""

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, fsolve

ZETA, MEAN = 0.05, 0.1
ERROR, EPS = 0.05, 0.0


def zone(x):
    return 1 if x > 1 else -1 if x < -1 else 0


def period(start, frequency, cycles=1, end=None):
    """State and monodromy after a number of periods, and the least and greatest x."""
    end, t = cycles * 2 * np.pi / frequency if end is None else end, 0.0
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


def harmonics(terms, angles):
    """Rows 1, cos, sin, cos 2, sin 2, .. at the angles."""
    rows = [np.ones_like(angles)]
    for k in range(1, terms + 1):
        rows += [np.cos(k * angles), np.sin(k * angles)]
    return np.array(rows)


def quadrature(motion):
    """Angles and weights of Gauss's rule between the corners of the play that a motion passes."""
    grid = np.linspace(0, 2 * np.pi, 2049)
    off = np.abs(motion(grid)) - 1
    corners = [brentq(lambda t: abs(motion(t)) - 1, grid[k], grid[k + 1], xtol=1e-15)
               for k in range(2048) if off[k] * off[k + 1] < 0]
    ends = np.unique(np.concatenate([np.linspace(0, 2 * np.pi, 9), corners]))
    x, w = np.polynomial.legendre.leggauss(32)
    half, middle = np.diff(ends) / 2, (ends[1:] + ends[:-1]) / 2
    return (middle[:, None] + half[:, None] * x).ravel(), (half[:, None] * w).ravel()


def balanced_fold(state, frequency, terms):
    """Fold of harmonic balance with a number of terms, from a motion near it."""
    orders = np.repeat(np.arange(terms + 1), 2)[1:]
    norms = np.where(orders == 0, 2 * np.pi, np.pi)
    turned = np.zeros((2 * terms + 1, 2 * terms + 1))
    for k in range(1, terms + 1):
        turned[2 * k - 1, 2 * k], turned[2 * k, 2 * k - 1] = k, -k

    def residual(z, frequency):
        angles, weights = quadrature(lambda t: z @ harmonics(terms, np.asarray(t)))
        basis = harmonics(terms, angles)
        weights = basis * weights / norms[:, None] * (1 + 2 * EPS * np.cos(angles))
        x = z @ basis
        force = weights @ (np.maximum(x - 1, 0) + np.minimum(x + 1, 0))
        rest = force - frequency**2 * orders**2 * z + 2 * ZETA * frequency * (turned @ z)
        rest[:2] -= MEAN, ERROR * frequency**2
        slopes = (weights * (np.abs(x) > 1)) @ basis.T
        return rest, slopes - np.diag(frequency**2 * orders**2) + 2 * ZETA * frequency * turned

    def equations(w):
        n = 2 * terms + 1
        rest, slopes = residual(w[:n], w[-1])
        return [*rest, *(slopes @ w[n:-1]), w[n:-1] @ w[n:-1] - 1]

    angles = np.arange(64) * 2 * np.pi / 64
    run = [period(state, frequency, end=t / frequency)[0][0] if t > 0 else state[0] for t in angles]
    basis = harmonics(terms, angles)
    z = (basis / (basis**2).sum(1, keepdims=True)) @ run
    slopes = residual(z, frequency)[1]
    null = np.linalg.svd(slopes)[2][-1]
    w, info, ok, text = fsolve(equations, [*z, *null, frequency], xtol=1e-12, full_output=True)
    return w[-1], np.linalg.norm(info["fvec"])


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
            for terms in (1, 2, 4, 8, 16):
                balanced, off = balanced_fold(np.array([x, v]), place, terms)
                print(f"    of {terms} harmonics at {balanced:.9f}, residual {off:.0e}")
