"""Runs of an arm that falls for 1 s, by Pinocchio with scipy and by MuJoCo.

Arguments: its URDF, and the table of its motion. Each line of output is a method, its setting, the
largest error of the final state and the least time of some runs in milliseconds.
"""

import csv
import sys
import time

import mujoco
import numpy as np
import pinocchio
from scipy.integrate import solve_ivp

urdf, table = sys.argv[1:]
rows = [row for row in csv.reader(open(table)) if row[0][0].isdigit()]
start, end = (np.array([float(cell) for cell in row[1:]]) for row in (rows[0], rows[-1]))
duration = float(rows[-1][0])


def measured(name, setting, run):
    least, state = float("inf"), None
    for _ in range(5):
        begin = time.perf_counter()
        state = run()
        least = min(least, time.perf_counter() - begin)
    print(name, setting, np.abs(state - end).max(), least * 1e3)


def with_scipy():
    model = pinocchio.buildModelFromUrdf(urdf)
    data, n = model.createData(), model.nv
    torque = np.zeros(n)

    def rate(_, y):
        return np.concatenate([y[n:], pinocchio.aba(model, data, y[:n], y[n:], torque)])

    for method in ("DOP853", "LSODA"):
        for digits in range(3, 13):
            rtol = 10.0**-digits
            run = lambda: solve_ivp(rate, (0, duration), start, method, rtol=rtol, atol=rtol).y[:, -1]
            measured(f"Pinocchio+{method}", rtol, run)


def with_mujoco():
    model = mujoco.MjModel.from_xml_path(urdf)
    model.opt.integrator = mujoco.mjtIntegrator.mjINT_RK4
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
    data, n = mujoco.MjData(model), model.nv
    for steps in (100, 200, 500, 1000, 2000, 5000, 10000, 20000):
        model.opt.timestep = duration / steps

        def run():
            mujoco.mj_resetData(model, data)
            data.qpos[:], data.qvel[:] = start[:n], start[n:]
            mujoco.mj_step(model, data, steps)
            return np.concatenate([data.qpos, data.qvel])

        measured("MuJoCo+RK4", duration / steps, run)


with_scipy()
with_mujoco()
