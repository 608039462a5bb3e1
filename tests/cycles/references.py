"""Reference values for tests/cycles.rs, by means that share nothing with the program.

    pip install mpmath numpy scipy
    python3 tests/cycles/references.py

Van der Pol: Taylor series of order 40 in 40 digits for mu up to 10, SciPy's Radau for stiff ones.
Duffing: harmonic balance with 30 harmonics by numpy; multipliers by the variational equations in 40
digits.
Wavy spring: harmonic balance with 60 odd harmonics, folds by bisection along the branch.
"""

import numpy as np
from mpmath import mp, mpf, exp, cos, sin, pi, sqrt
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, minimize_scalar

mp.dps = 40
ORDER = 40


def van_der_pol_series(mu, x, v):
    """Coefficients of x'' = mu (1 - x^2) x' - x."""
    a, b, square = [x], [v], []
    for k in range(ORDER):
        a.append(b[k] / (k + 1))
        square.append(sum(a[j] * a[k - j] for j in range(k + 1)))
        product = b[k] - sum(square[j] * b[k - j] for j in range(k + 1))
        b.append((mu * product - a[k]) / (k + 1))
    square.append(sum(a[j] * a[ORDER - j] for j in range(ORDER + 1)))
    return a, b, square


def value(series, h):
    total = mpf(0)
    for term in reversed(series):
        total = total * h + term
    return total


def step(series):
    size = lambda k: abs(series[k]) ** (mpf(1) / k) if series[k] else mpf(0)
    scale = max(size(ORDER), size(ORDER - 1))
    return mpf("0.08") / scale


def round_trip(mu, x):
    """From the crest (x, 0) to the next one: crest, time, integral of x^2."""
    v, time, area, has_fallen = mpf(0), mpf(0), mpf(0), False
    while True:
        a, b, square = van_der_pol_series(mu, x, v)
        h = step(a)
        end = value(b, h)
        if has_fallen and v > 0 >= end:
            for _ in range(60):
                slope = value([k * c for k, c in enumerate(b)][1:], h)
                change = value(b, h) / slope
                h -= change
                if abs(change) < mpf(10) ** -38:
                    break
        area += value([0] + [c / (k + 1) for k, c in enumerate(square)], h)
        x, time = value(a, h), time + h
        if has_fallen and v > 0 >= end:
            return x, time, area
        has_fallen = has_fallen or end < 0 and x < 0
        v = value(b, h)


def van_der_pol(mu):
    x = mpf(2)
    f = lambda x: round_trip(mu, x)[0] - x
    x0, x1 = x, x + mpf("1e-3")
    f0, f1 = f(x0), f(x1)
    for _ in range(20):
        x0, f0, x1 = x1, f1, x1 - f1 * (x1 - x0) / (f1 - f0)
        f1 = f(x1)
        if abs(f1) < mpf(10) ** -32:
            break
    _, period, area = round_trip(mu, x1)
    # Liouville: the product of both multipliers is exp(integral of mu (1 - x^2)).
    return period, exp(mu * (period - area))


def van_der_pol_stiff(mu):
    f = lambda t, y: [y[1], mu * (1 - y[0] ** 2) * y[1] - y[0]]
    jac = lambda t, y: [[0, 1], [-2 * mu * y[0] * y[1] - 1, mu * (1 - y[0] ** 2)]]
    crest = lambda t, y: y[0] - 1.5
    crest.direction = -1
    run = solve_ivp(f, [0, 4 * mu], [2.0, 0.0], method="Radau", jac=jac, rtol=1e-12, atol=1e-14,
                    events=crest)
    times = run.t_events[0]
    return times[-1] - times[-2]


ZETA, FORCE = 0.05, 0.3
HARMONICS, SAMPLES = 30, 512
PHASES = 2 * np.pi * np.arange(SAMPLES) / SAMPLES
K = np.arange(1, HARMONICS + 1)
BASIS = np.hstack([np.ones((SAMPLES, 1)), np.cos(np.outer(PHASES, K)), np.sin(np.outer(PHASES, K))])
INVERSE = np.linalg.pinv(BASIS)


def duffing_residual(c, omega):
    """x'' + 2 zeta x' + x + x^3 = force cos(omega t), by harmonics."""
    x = BASIS @ c
    linear = np.zeros_like(c)
    a, b = c[1:HARMONICS + 1], c[HARMONICS + 1:]
    linear[0] = c[0]
    linear[1:HARMONICS + 1] = (1 - (K * omega) ** 2) * a + 2 * ZETA * K * omega * b
    linear[HARMONICS + 1:] = (1 - (K * omega) ** 2) * b - 2 * ZETA * K * omega * a
    r = linear + INVERSE @ x**3
    r[1] -= FORCE
    return r


def duffing_jacobian(c, omega):
    x = BASIS @ c
    j = INVERSE @ (3 * x[:, None] ** 2 * BASIS)
    j[0, 0] += 1
    for k in K:
        i, l = k, HARMONICS + k
        j[i, i] += 1 - (k * omega) ** 2
        j[l, l] += 1 - (k * omega) ** 2
        j[i, l] += 2 * ZETA * k * omega
        j[l, i] -= 2 * ZETA * k * omega
    by_omega = np.zeros_like(c)
    a, b = c[1:HARMONICS + 1], c[HARMONICS + 1:]
    by_omega[1:HARMONICS + 1] = -2 * K**2 * omega * a + 2 * ZETA * K * b
    by_omega[HARMONICS + 1:] = -2 * K**2 * omega * b - 2 * ZETA * K * a
    return j, by_omega


def duffing_at(amplitude, c, omega):
    """Harmonics and frequency at which the first harmonic has this amplitude."""
    for _ in range(50):
        j, by_omega = duffing_jacobian(c, omega)
        n = len(c)
        whole = np.zeros((n + 1, n + 1))
        whole[:n, :n], whole[:n, n] = j, by_omega
        whole[n, 1], whole[n, HARMONICS + 1] = 2 * c[1], 2 * c[HARMONICS + 1]
        r = np.append(duffing_residual(c, omega), c[1] ** 2 + c[HARMONICS + 1] ** 2 - amplitude**2)
        change = np.linalg.solve(whole, -r)
        c, omega = c + change[:n], omega + change[n]
        if np.abs(change).max() < 1e-14:
            break
    return c, omega


def duffing_fixed(c, omega):
    for _ in range(50):
        change = np.linalg.solve(duffing_jacobian(c, omega)[0], -duffing_residual(c, omega))
        c = c + change
        if np.abs(change).max() < 1e-14:
            break
    return c


def duffing():
    c = np.zeros(2 * HARMONICS + 1)
    c[1], omega = FORCE / (1 - 0.6**2), 0.6
    c = duffing_fixed(c, omega)
    branch = []
    amplitude = np.hypot(c[1], c[HARMONICS + 1])
    # The amplitude of the first harmonic rises up to the peak; beyond, along the other side.
    while True:
        amplitude += 0.005
        try:
            nc, nomega = duffing_at(amplitude, c, omega)
        except np.linalg.LinAlgError:
            break
        if abs(nomega - omega) > 0.05 or not np.isfinite(nomega):
            break
        c, omega = nc, nomega
        branch.append((amplitude, omega, c))
    # Past the peak by the phase: restart from the high frequency end.
    low = []
    c = np.zeros(2 * HARMONICS + 1)
    omega = 2.2
    c[1] = FORCE / (1 - omega**2)
    c = duffing_fixed(c, omega)
    amplitude = np.hypot(c[1], c[HARMONICS + 1])
    while amplitude < 3:
        amplitude += 0.001
        nc, nomega = duffing_at(amplitude, c, omega)
        if abs(nomega - omega) > 0.05 or not np.isfinite(nomega):
            break
        c, omega = nc, nomega
        low.append((amplitude, omega, c))
    peak = max(branch, key=lambda p: p[0])
    return branch, low, peak


def fold(points, sign):
    """Extremum of omega over the amplitude, refined by the zero of its slope."""
    best = max(range(1, len(points) - 1), key=lambda i: sign * points[i][1])
    a, omega, c = points[best]

    def slope(amplitude):
        cc, w = duffing_at(amplitude, c, omega)
        j, by_omega = duffing_jacobian(cc, w)
        # d omega / d(amplitude^2) from the bordered equations
        n = len(cc)
        whole = np.zeros((n + 1, n + 1))
        whole[:n, :n], whole[:n, n] = j, by_omega
        whole[n, 1], whole[n, HARMONICS + 1] = 2 * cc[1], 2 * cc[HARMONICS + 1]
        right = np.zeros(n + 1)
        right[n] = 1
        return np.linalg.solve(whole, right)[n]

    a = brentq(slope, points[best - 1][0], points[best + 1][0], xtol=1e-14, rtol=1e-14)
    c, omega = duffing_at(a, c, omega)
    x = BASIS @ c
    return omega, c, x


def crest(c):
    cosines, sines = c[1:HARMONICS + 1], c[HARMONICS + 1:]
    fine = lambda p: -abs(c[0] + cosines @ np.cos(K * p) + sines @ np.sin(K * p))
    p = PHASES[np.argmax(abs(BASIS @ c))]
    bounds = (p - 0.02, p + 0.02)
    return -minimize_scalar(fine, bounds=bounds, method="bounded", options={"xatol": 1e-12}).fun


def duffing_multipliers(omega, x, v):
    """Periodic motion and multipliers by Taylor series of the variational equations."""
    omega, zeta, force = mpf(omega), mpf(ZETA), mpf(FORCE)
    period = 2 * pi / omega
    count = 60
    h = period / count

    def flow(x, v):
        s = [[mpf(1), mpf(0)], [mpf(0), mpf(1)]]
        for i in range(count):
            t = i * h
            a, b, sq, drive = [x], [v], [], []
            u = [[s[0][d]] for d in (0, 1)]
            w = [[s[1][d]] for d in (0, 1)]
            factorial = mpf(1)
            for k in range(ORDER):
                drive.append(force * cos(omega * t + k * pi / 2) * omega**k / factorial)
                factorial *= k + 1
                sq.append(sum(a[j] * a[k - j] for j in range(k + 1)))
                cube = sum(sq[j] * a[k - j] for j in range(k + 1))
                a.append(b[k] / (k + 1))
                b.append((drive[k] - 2 * zeta * b[k] - a[k] - cube) / (k + 1))
                for d in (0, 1):
                    along = sum(sq[j] * u[d][k - j] for j in range(k + 1))
                    u[d].append(w[d][k] / (k + 1))
                    w[d].append((-2 * zeta * w[d][k] - u[d][k] - 3 * along) / (k + 1))
            x, v = value(a, h), value(b, h)
            s = [[value(u[0], h), value(u[1], h)], [value(w[0], h), value(w[1], h)]]
        return x, v, s

    x, v = mpf(x), mpf(v)
    for _ in range(8):
        ex, ev, s = flow(x, v)
        rx, rv = ex - x, ev - v
        a, b, c, d = s[0][0] - 1, s[0][1], s[1][0], s[1][1] - 1
        det = a * d - b * c
        x, v = x - (d * rx - b * rv) / det, v - (a * rv - c * rx) / det
        if abs(rx) + abs(rv) < mpf(10) ** -30:
            break
    trace, det = s[0][0] + s[1][1], s[0][0] * s[1][1] - s[0][1] * s[1][0]
    root = sqrt(trace**2 / 4 - det + 0j)
    return x, v, trace / 2 + root, trace / 2 - root


def wavy_folds(highest=0.0585, step=0.004):
    """Forces at the folds of x'' + 0.02 x' + x + 0.05 sin(10 x) = F cos t, in their order."""
    odd = np.arange(1, 121, 2)
    count, samples = len(odd), 512
    angles = 2 * np.pi * np.outer(np.arange(samples) / samples, odd)
    basis = np.hstack([np.cos(angles), np.sin(angles)])
    linear = np.diag(np.tile(1.0 - odd**2, 2))
    linear[:count, count:] += np.diag(0.02 * odd)
    linear[count:, :count] -= np.diag(0.02 * odd)
    force = np.zeros(2 * count)
    force[0] = 1

    def residual(p):
        wave = 2 / samples * basis.T @ (0.05 * np.sin(10 * (basis @ p[:-1])))
        return linear @ p[:-1] + wave - p[-1] * force

    def slope(p):
        wave = 0.5 * np.cos(10 * (basis @ p[:-1]))
        return np.column_stack([linear + 2 / samples * basis.T @ (wave[:, None] * basis), -force])

    def tangent(p, old):
        right = np.zeros(2 * count + 1)
        right[-1] = 1
        found = np.linalg.solve(np.vstack([slope(p), old]), right)
        return found / np.linalg.norm(found)

    def along(p, direction, length):
        q = p + length * direction
        for _ in range(20):
            right = np.append(residual(q), direction @ (q - p) - length)
            change = np.linalg.solve(np.vstack([slope(q), direction]), right)
            q = q - change
            if np.linalg.norm(change) < 1e-14:
                break
        return q, tangent(q, direction)

    point = np.zeros(2 * count + 1)
    direction = tangent(point, np.eye(2 * count + 1)[-1])
    folds = []
    while point[-1] < highest or len(folds) < 16:
        following, turned = along(point, direction, step)
        if turned[-1] * direction[-1] < 0:
            low, high = 0.0, step
            for _ in range(60):
                middle = (low + high) / 2
                if along(point, direction, middle)[1][-1] * direction[-1] > 0:
                    low = middle
                else:
                    high = middle
            folds.append(along(point, direction, low)[0][-1])
        point, direction = following, turned
    return folds


if __name__ == "__main__":
    print("wavy spring, folds", wavy_folds(), flush=True)
    np.set_printoptions(precision=16)
    for mu in ("0.01", "0.1", "1", "10"):
        period, multiplier = van_der_pol(mpf(mu))
        print("van der Pol", mu, mp.nstr(period, 18), mp.nstr(multiplier, 18), flush=True)
    for mu in (100, 1000):
        print("van der Pol", mu, van_der_pol_stiff(mu), flush=True)
    up, low, peak = duffing()
    print("Duffing peak near", peak[1], peak[0])
    lowest = min(range(1, len(low) - 1), key=lambda i: low[i][1])
    lower = fold(low, -1)
    # Both folds are on the side of high frequencies; the upper one is just below the peak.
    upper = fold(low[lowest:], 1)
    for name, (omega, c, x) in (("upper", upper), ("lower", lower)):
        print("Duffing fold", name, float(omega), "crest", float(crest(c)), flush=True)
    omega = 1.6
    starts = []
    for points in (up, low):
        signs = [points[i][1] - omega for i in range(len(points))]
        for i in range(1, len(points)):
            if signs[i - 1] * signs[i] <= 0:
                c = duffing_fixed(points[i][2], omega)
                starts.append(c)
    for c in starts:
        x, v = (BASIS @ c)[0], omega * (K @ c[HARMONICS + 1:])
        x, v, one, two = duffing_multipliers(omega, x, v)
        print("Duffing", omega, mp.nstr(x, 18), mp.nstr(v, 18), "crest", float(crest(c)),
              mp.nstr(one, 18), mp.nstr(two, 18), flush=True)
