# %% [markdown]
# # Machinist from Python
#
# The built-in scene `saw_gin` is a motor that drives a toothed cylinder through an elastic coupling. It starts from
# rest, and the load engages at 1.2 s. Load your own machine with `machinist.load("drive.toml")`, or a model file with
# `machinist.load("drive.model")`.

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
# Omitted settings take the scene's values: 2 s, 2001 points, relative tolerance 1e-8. Columns are NumPy arrays that
# view the run's memory.

# %%
run = gin.simulate()
run.plot(["motor_speed", "motor_torque", "coupling_torque", "twist"])

# %%
run["twist"].max(), run.work["steps"], run.states["motor.omega"][-1]

# %% [markdown]
# You can change every parameter and initial value. `to_pandas` and `to_polars` return data frames.

# %%
soft = gin.simulate(until=0.5, parameters={"coupling.stiffness": 1e4}, points=6)
soft.to_pandas()[["twist", "coupling_torque"]]

# %% [markdown]
# Invalid arguments raise an exception, which suggests the correct name where possible. The exception of a run that
# stops early contains the partial run.

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
# A run lists its events. Here a mass bounces on a shaken plate:

# %%
bounce = machinist.load("bouncing_mass").simulate()
bounce.events[:3]

# %% [markdown]
# ## External solvers
#
# `rate(t, y, p)` and `jacobian(t, y, p)` are plain functions of arrays for SciPy's `solve_ivp` and similar solvers.
# The comparison shows Machinist's methods at the same tolerance; the reference is Machinist's `dop853` at 1e-13.

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
# The overhead of a call from Python, compared with the same run inside the native code:

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
# ## Eigenmodes and frequency responses

# %%
modes = gin.modes(slopes=["coupling.stiffness"])
modes

# %%
coupled = modes[3]
coupled.slopes["coupling.stiffness"]

# %%
gin.response("motor.phase_voltage", "coupling_torque")

# %% [markdown]
# ## Sensitivities and parameter fits
#
# Derivatives along a run are exact, also through events. Effects are relative: the change of an output relative to
# its largest magnitude, per relative change of a parameter.

# %%
gin.sensitivities(until=1.0, points=201, outputs=["twist"])

# %% [markdown]
# Here a run with other parameter values and added noise replaces a measurement. `fit` estimates the values and their
# confidence intervals. It accepts columns by name and pandas or polars data frames.

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
# ## Sweeps
#
# A sweep runs many variants on all cores. Its results equal those of single runs to the last bit. The row of a failed
# variant contains the reason. With `path`, a sweep stores results as Parquet files and resumes from them.

# %%
import tempfile

space = {"coupling.stiffness": (5e3, 1e5, "log"), "coupling.damping": (10.0, 500.0)}
folder = tempfile.mkdtemp()
swept = gin.sweep(space, kind="sobol", n=512, outputs=["twist"], extremes=True, points=201, path=folder)
swept

# %%
gin.sweep(space, kind="sobol", n=512, outputs=["twist"], extremes=True, points=201, path=folder).ran

# %% [markdown]
# With a Dask client, the same call runs on its workers: here local processes, elsewhere machines of a cluster.

# %%
from dask.distributed import Client, LocalCluster

with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster, Client(cluster) as client:
    there = gin.sweep(
        space, kind="sobol", n=512, outputs=["twist"], extremes=True, points=201, client=client
    )
assert there.table.equals(swept.table)
there.to_pandas().nsmallest(3, "twist.greatest")
