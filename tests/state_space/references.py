"""References of `tests/state_space.rs`: gains by SciPy, refined in 60 digits by Newton's method.

    python3 tests/state_space/references.py > tests/state_space/references.json

Needs numpy, scipy and mpmath. Each system has matrices, deviations of its inputs and outputs, a
period if it is sampled, the gain K, the largest relative difference of SciPy's own gain from it,
and poles. Square continuous systems have zeros by `scipy.linalg.eig` of Rosenbrock's pencil, and
sampled matrices by `scipy.signal.cont2discrete`.
"""

import json
import sys

import mpmath as mp
import numpy as np
import scipy.linalg as la
import scipy.signal as signal

mp.mp.dps = 60


def second_order(mass, damping, stiffness, force):
    n = len(mass)
    inverse = np.linalg.inv(mass)
    a = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ stiffness, -inverse @ damping]])
    return a, np.vstack([np.zeros((n, force.shape[1])), inverse @ force])


def chain(count, masses, springs, damping):
    stiffness = np.zeros((count, count))
    for i, k in enumerate(springs):
        for r, c, s in ((i, i, 1), (i + 1, i + 1, 1), (i, i + 1, -1), (i + 1, i, -1)):
            stiffness[r, c] += s * k
    force = np.zeros((count, 1))
    force[0, 0] = 1
    return second_order(np.diag(masses), damping * stiffness, stiffness, force)


def systems():
    draw = np.random.default_rng(51)
    eye = np.eye

    def case(name, a, b, c, d=None, inputs=None, outputs=None, period=None):
        d = np.zeros((c.shape[0], b.shape[1])) if d is None else d
        inputs = [1.0] * b.shape[1] if inputs is None else inputs
        outputs = [1.0] * c.shape[0] if outputs is None else outputs
        return dict(name=name, a=a, b=b, c=c, d=d, inputs=inputs, outputs=outputs, period=period)

    a = np.array([[0.0, 1.0], [0.0, 0.0]])
    b = np.array([[0.0], [1.0]])
    yield case("double integrator", a, b, eye(2), inputs=[0.3], outputs=[0.1, 2.0])

    a, b = chain(2, [4.2, 1.244], [17000.0], 2e-4)
    c = np.array([[1.0, -1.0, 0, 0], [0, 0, 0, 1.0], [0, 1.0, 0, 0]])
    yield case("two-mass drive", a, b, c, inputs=[50.0], outputs=[1e-3, 0.5, 0.1])

    cart, ball, length, g = 2.0, 0.3, 0.7, 9.81
    mass = np.array([[cart + ball, ball * length], [ball * length, ball * length**2]])
    stiffness = np.diag([0.0, -ball * g * length])
    pendulum = second_order(mass, np.diag([0.4, 0.0]), stiffness, np.array([[1.0], [0.0]]))
    c = np.array([[1.0, 0, 0, 0], [0, 1.0, 0, 0]])
    yield case("pendulum on a cart", *pendulum, c, inputs=[20.0], outputs=[0.2, 0.05])

    # Electrical 1e-4 s, mechanical 50 s; the angle in 1e-6 rad, the current in kA.
    r, l, k, j, damp = 0.5, 5e-5, 0.02, 1e-2, 2e-4
    a = np.array([[0.0, 1, 0], [0, -damp / j, k / j], [0, -k / l, -r / l]])
    b = np.array([[0.0], [0], [1 / l]])
    t = np.diag([1e-6, 1.0, 1e3])
    motor = la.inv(t) @ a @ t, la.inv(t) @ b
    c = np.array([[1e-6, 0, 0], [0, 0, 1e3]])
    yield case("stiff motor, badly scaled", *motor, c, inputs=[24.0], outputs=[0.01, 10.0])

    a, b = chain(4, [1.0, 0.1, 5.0, 0.02], [1e6, 1e2, 1e5], 1e-5)
    c = np.zeros((2, 8))
    c[0, 3] = c[1, 4] = 1
    yield case("stiff chain of masses", a, b, c, inputs=[100.0], outputs=[1e-3, 1.0])

    # A hydraulic cylinder: pressures of 1e7 Pa beside ways of 1 mm.
    area, volume, bulk, load, leak = 1.2e-3, 4e-4, 1.4e9, 250.0, 2e-12
    a = np.array([
        [0.0, 1, 0, 0],
        [0, -800 / load, area / load, -area / load],
        [0, -bulk * area / volume, -bulk * leak / volume, bulk * leak / volume],
        [0, bulk * area / volume, bulk * leak / volume, -bulk * leak / volume],
    ])
    b = np.array([[0, 0], [0, 1 / load], [bulk / volume, 0], [-bulk / volume, 0]])
    a[2, 2] -= bulk * 1e-12 / volume
    a[3, 3] -= bulk * 1e-12 / volume
    c = np.array([[1.0, 0, 0, 0], [0, 0, 1.0, -1.0]])
    yield case("hydraulic cylinder", a, b, c, inputs=[1e-4, 50.0], outputs=[1e-3, 1e6])

    a, b = draw.normal(size=(9, 9)), draw.normal(size=(9, 3))
    c, d = draw.normal(size=(3, 9)), draw.normal(size=(3, 3))
    yield case("random with feedthrough", a, b, c, d, [0.5, 1.0, 2.0], [1.0, 0.1, 3.0])

    def held(a, b, h):
        whole = la.expm(np.block([[a, b], [np.zeros((b.shape[1], a.shape[1] + b.shape[1]))]]) * h)
        n = len(a)
        return whole[:n, :n], whole[:n, n:]

    c = np.array([[1.0, 0, 0, 0], [0, 1.0, 0, 0]])
    yield case("sampled pendulum", *held(*pendulum, 0.01), c, inputs=[20.0], outputs=[0.2, 0.05],
               period=0.01)

    c = np.array([[1e-6, 0, 0], [0, 0, 1e3]])
    yield case("sampled motor, badly scaled", *held(*motor, 1e-3), c, inputs=[24.0],
               outputs=[0.01, 10.0], period=1e-3)

    # Three delays of a double integrator: A is singular.
    a, b = held(np.array([[0.0, 1], [0, 0]]), np.array([[0.0], [1]]), 0.1)
    a = np.block([[a, b, np.zeros((2, 2))], [np.zeros((3, 5))]])
    a[2, 3] = a[3, 4] = 1
    b = np.array([[0.0], [0], [0], [0], [1]])
    c = eye(5)[:1]
    yield case("sampled with delays", a, b, c, outputs=[0.1], period=0.1)

    a, b = draw.normal(size=(7, 7)) / 2, draw.normal(size=(7, 2))
    c, d = draw.normal(size=(2, 7)), draw.normal(size=(2, 2))
    yield case("sampled at random", a, b, c, d, [0.5, 2.0], [1.0, 0.1], period=1.0)


def weights(of):
    qy = np.diag(1 / np.square(of["outputs"]))
    ru = np.diag(1 / np.square(of["inputs"]))
    c, d = of["c"], of["d"]
    return c.T @ qy @ c, ru + d.T @ qy @ d, c.T @ qy @ d


def refined(of, x):
    """Newton's method in 60 digits, each step a linear system of all entries."""
    a, b, c, d, x = (mp.matrix(m.tolist()) for m in (of["a"], of["b"], of["c"], of["d"], x))
    qy = mp.diag([1 / mp.mpf(size) ** 2 for size in of["outputs"]])
    ru = mp.diag([1 / mp.mpf(size) ** 2 for size in of["inputs"]])
    q, r, n = c.T * qy * c, ru + d.T * qy * d, c.T * qy * d
    sampled = of["period"]
    size = a.rows
    for _ in range(12):
        if sampled:
            gain = mp.inverse(r + b.T * x * b) * (a.T * x * b + n).T
            residual = a.T * x * a - x - gain.T * (r + b.T * x * b) * gain + q
        else:
            gain = mp.inverse(r) * (x * b + n).T
            residual = a.T * x + x * a - gain.T * r * gain + q
        closed = a - b * gain
        whole = mp.zeros(size * size)
        for i in range(size):
            for j in range(size):
                for k in range(size):
                    if sampled:
                        for m in range(size):
                            whole[i * size + j, k * size + m] += closed[k, i] * closed[m, j]
                    else:
                        whole[i * size + j, k * size + j] += closed[k, i]
                        whole[i * size + j, i * size + k] += closed[k, j]
                if sampled:
                    whole[i * size + j, i * size + j] -= 1
        right = mp.matrix([-residual[i, j] for i in range(size) for j in range(size)])
        change = mp.lu_solve(whole, right)
        step = mp.matrix(size, size)
        for i in range(size):
            for j in range(size):
                step[i, j] = change[i * size + j]
        x += (step + step.T) / 2
        if mp.norm(step, 1) < mp.mpf(10) ** -40 * mp.norm(x, 1):
            return np.array(gain.tolist(), dtype=float)
    raise ArithmeticError("Newton's method does not converge")


def reference(of):
    a, b, period = of["a"], of["b"], of["period"]
    q, r, n = weights(of)
    solve = la.solve_discrete_are if period else la.solve_continuous_are
    x = solve(a, b, q, r, s=n)
    if period:
        own = la.solve(r + b.T @ x @ b, (a.T @ x @ b + n).T)
    else:
        own = la.solve(r, (x @ b + n).T)
    gain = refined(of, x)
    of["scipy"] = float(np.abs(own - gain).max() / np.abs(gain).max())
    of["gain"] = gain
    if not period and b.shape[1] == of["c"].shape[0]:
        size = len(a)
        pencil = np.block([[a, b], [of["c"], of["d"]]])
        mass = np.zeros_like(pencil)
        mass[:size, :size] = np.eye(size)
        with np.errstate(divide="ignore", invalid="ignore"):
            values = la.eig(pencil, mass, right=False, homogeneous_eigvals=True)
        finite = np.abs(values[1]) > 1e-9 * np.abs(values[0])
        zeros = values[0][finite] / values[1][finite]
        of["zeros"] = [[z.real, z.imag] for z in zeros]
    if not period:
        for method, name in (("zoh", "zoh"), ("bilinear", "tustin")):
            h = of["step"] = 0.3 / max(1.0, np.abs(la.eigvals(a)).max())
            found = signal.cont2discrete((a, b, of["c"], of["d"]), h, method)
            of[name] = [m.tolist() for m in found[:4]]
    print(of["name"], of["scipy"], file=sys.stderr)
    return {k: v.tolist() if isinstance(v, np.ndarray) else v for k, v in of.items()}


print(json.dumps([reference(of) for of in systems()], indent=1))
