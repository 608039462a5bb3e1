"""Machinist: simulators of machines defined by their Lagrangians.

>>> import machinist
>>> gin = machinist.load("saw_gin")
>>> run = gin.simulate(until=0.5, parameters={"coupling.stiffness": 3e4})
>>> run["twist"].max() < 0.1
True
"""

from __future__ import annotations

from . import _machinist
from ._machinist import __version__, built_in_names
from ._designs import Design, design
from ._fit import Fit
from ._linear import Mode, Modes, Response
from ._model import Model, load
from ._run import Run
from ._sensitivities import Sensitivities
from ._state_space import StateSpace
from ._sweep import Sweep, sweep
from .errors import (
    AnalysisError,
    InputError,
    MachinistError,
    ModelFileError,
    ShapeError,
    SpecError,
    StoppedError,
    SweepError,
    ToolMissingError,
    UnknownNameError,
)

__all__ = [
    "AnalysisError",
    "Design",
    "Fit",
    "InputError",
    "MachinistError",
    "Mode",
    "Model",
    "ModelFileError",
    "Modes",
    "Response",
    "Run",
    "Sensitivities",
    "ShapeError",
    "SpecError",
    "StateSpace",
    "StoppedError",
    "Sweep",
    "SweepError",
    "ToolMissingError",
    "UnknownNameError",
    "__version__",
    "built_in_names",
    "design",
    "load",
    "methods",
    "sweep",
]


def methods() -> dict[str, str]:
    """Integration methods by name, with a short description of each."""
    return {name: doc for name, _, _, doc in _machinist.methods()}
