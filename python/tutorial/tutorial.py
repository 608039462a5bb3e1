# %% [markdown]
# # Machinist from Python
#
# A saw gin, a motor that drives a toothed cylinder through an elastic coupling, is built in. It runs up from
# rest, and at 1.2 s the load engages. A file of one's own is loaded the same way: `machinist.load("drive.toml")`
# where the program `machinist` is installed, `machinist.load("drive.model")` anywhere.

# %%
import time

import numpy as np

import machinist

gin = machinist.load("saw_gin")
gin

# %%
gin.parameters

# %% [markdown]
# ## A run
#
# What is not asked for is as the scene says: 2 s, 2001 points, relative tolerance 1e-8. Columns are NumPy arrays,
# the memory of the run itself.

# %%
run = gin.simulate()
run.plot(["motor_speed", "motor_torque", "coupling_torque", "twist"])

# %%
run["twist"].max(), run.work["steps"], run.states["motor.omega"][-1]

# %% [markdown]
# Any parameter may be changed, and any initial value. `to_pandas` and `to_polars` make frames.

# %%
soft = gin.simulate(until=0.5, parameters={"coupling.stiffness": 1e4}, points=6)
soft.to_pandas()[["twist", "coupling_torque"]]

# %% [markdown]
# What makes no sense is an exception that says so, and where it can, what was meant. A run that stops early
# comes with what there is of it.

# %%
try:
    gin.simulate(parameters={"coupling.stifness": 1e4})
except machinist.UnknownNameError as error:
    print(error)

try:
    gin.simulate(max_steps=500)
except machinist.StoppedError as error:
    print(error)
    print(f"{len(error.run)} points until {error.run.t[-1]} s")

# %% [markdown]
# Events are listed. A mass bounces on a plate that shakes:

# %%
bounce = machinist.load("bouncing_mass").simulate()
bounce.events[:3]

# %% [markdown]
# ## Another's method on our rate
#
# `rate(t, y, p)` and `jacobian(t, y, p)` are plain functions of arrays, for SciPy's `solve_ivp` and whatever
# else takes some. Beside it, a method of ours at the same tolerance; the reference is ours at 1e-13.

# %%
from scipy.integrate import solve_ivp

times = np.linspace(0.0, 1.0, 11)
exact = gin.simulate(until=1.0, times=times, rtol=1e-13, method="dop853").y
size = np.abs(exact).max(axis=1, keepdims=True)


def timed(job, runs=5):
    """The result, and the least time of some runs."""
    least = np.inf
    for _ in range(runs):
        start = time.perf_counter()
        result = job()
        least = min(least, time.perf_counter() - start)
    return result, least


rows = []
for method in ("DOP853", "LSODA", "Radau"):
    more = {} if method == "DOP853" else {"jac": gin.jacobian}
    found, seconds = timed(
        lambda: solve_ivp(
            gin.rate, (0, 1), gin.initial_state(), method=method, t_eval=times, rtol=1e-8, atol=1e-9, **more
        ),
        runs=2,
    )
    rows.append((f"SciPy's {method}", seconds, np.abs((found.y - exact) / size).max()))
for method in ("tsit5", "dop853", "taylor"):
    found, seconds = timed(lambda: gin.simulate(until=1.0, times=times, rtol=1e-8, method=method))
    rows.append((f"ours, {method}", seconds, np.abs((found.y - exact) / size).max()))
best = min(seconds for _, seconds, _ in rows)
for name, seconds, off in rows:
    print(f"{name:16} {seconds / best:8.1f} times the fastest, off by {off:.1e}")
assert all(off < 1e-5 for _, _, off in rows)

# %% [markdown]
# What it costs to call from Python, beside the same run with nothing in between:

# %%
ask = {"until": 0.05, "points": 11}
ours, inside = [], []
for _ in range(300):
    start = time.perf_counter()
    gin.simulate(**ask)
    ours.append(time.perf_counter() - start)
    inside += gin._machine.time_runs(ask, 1)
extra = 1e6 * (np.median(ours) - np.median(inside))
print(f"{extra:.1f} microseconds more")

# %% [markdown]
# ## Natural motions and answers to disturbances

# %%
modes = gin.modes(slopes=["coupling.stiffness"])
modes

# %%
coupled = modes[3]
coupled.slopes["coupling.stiffness"]

# %%
gin.response("motor.phase_voltage", "coupling_torque")

# %% [markdown]
# ## What matters, and parameters from measurements
#
# Derivatives along a run are exact, through events too. Effects are relative: the change of an output over its
# largest size, for a relative change of a parameter.

# %%
gin.sensitivities(until=1.0, points=201, outputs=["twist"])

# %% [markdown]
# A run with other values and some noise stands for a measurement; `fit` finds the values, and says how well the
# data tell them. A pandas or polars frame does as well as columns by name.

# %%
noise = np.random.default_rng(1)
truth = gin.simulate(until=0.5, points=251, parameters={"coupling.stiffness": 3e4, "motor.inertia": 5.0})
measured = {
    "t": truth.t,
    "twist": truth["twist"] + 1e-5 * noise.standard_normal(251),
    "motor_speed": truth["motor_speed"] + 1e-2 * noise.standard_normal(251),
}
fit = gin.fit(measured, ["coupling.stiffness", "motor.inertia"])
print(fit)
assert abs(fit.parameters["coupling.stiffness"] / 3e4 - 1) < 0.01

# %% [markdown]
# ## Many variants
#
# A sweep runs on all cores. The numbers are to the last bit those of single runs; a variant that fails is a row with
# its reason. With `path`, results are kept as Parquet files, and what is there is not run again.

# %%
import tempfile

space = {"coupling.stiffness": (5e3, 1e5, "log"), "coupling.damping": (10.0, 500.0)}
folder = tempfile.mkdtemp()
swept = gin.sweep(space, kind="sobol", n=512, outputs=["twist"], extremes=True, points=201, path=folder)
swept

# %%
gin.sweep(space, kind="sobol", n=512, outputs=["twist"], extremes=True, points=201, path=folder).ran

# %% [markdown]
# The same call with a Dask client runs on its workers: processes here, or machines of a cluster.

# %%
from dask.distributed import Client, LocalCluster

with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
    there = gin.sweep(
        space, kind="sobol", n=512, outputs=["twist"], extremes=True, points=201, client=client
    )
assert there.table.equals(swept.table)
there.to_pandas().nsmallest(3, "twist.greatest")
