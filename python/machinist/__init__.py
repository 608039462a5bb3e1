"""Machinist: simulators of machines defined by their Lagrangians.

>>> import machinist
>>> gin = machinist.load("saw_gin")
>>> run = gin.simulate(until=0.5, parameters={"coupling.stiffness": 3e4})
>>> run["twist"].max() < 0.1
True
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from . import _machinist
from ._machinist import __version__, built_in_names
from .errors import (
    AnalysisError,
    InputError,
    MachinistError,
    Mistake,
    ModelFileError,
    ShapeError,
    SpecError,
    SpecWarning,
    StoppedError,
    SweepError,
    UnknownNameError,
)

if TYPE_CHECKING:
    from ._cycle import Branch, BranchPoint, Cycle, Multiplier, Sections, branch, cycle, sections
    from ._designs import Design, design
    from ._fit import Fit
    from ._held import Held
    from ._linear import Mode, Modes, Response
    from ._model import Model, load
    from ._run import Run
    from ._scatter import Scatter, scatter
    from ._sensitivities import Sensitivities
    from ._state_space import Estimator, LinearPiece, Regulator, StateSpace
    from ._stepper import Stepper
    from ._sweep import Sweep, sweep

#: Modules of the names that are imported on first use: the program `machinist` does without NumPy.
_LATER = {
    "Branch": "_cycle",
    "BranchPoint": "_cycle",
    "Cycle": "_cycle",
    "Design": "_designs",
    "Estimator": "_state_space",
    "Fit": "_fit",
    "Held": "_held",
    "LinearPiece": "_state_space",
    "Mode": "_linear",
    "Model": "_model",
    "Modes": "_linear",
    "Multiplier": "_cycle",
    "Regulator": "_state_space",
    "Response": "_linear",
    "Run": "_run",
    "Sections": "_cycle",
    "Scatter": "_scatter",
    "Sensitivities": "_sensitivities",
    "StateSpace": "_state_space",
    "Stepper": "_stepper",
    "Sweep": "_sweep",
    "branch": "_cycle",
    "cycle": "_cycle",
    "design": "_designs",
    "load": "_model",
    "scatter": "_scatter",
    "sections": "_cycle",
    "sweep": "_sweep",
}

__all__ = [
    "AnalysisError",
    "Branch",
    "BranchPoint",
    "Cycle",
    "Design",
    "Estimator",
    "Fit",
    "Held",
    "InputError",
    "LinearPiece",
    "MachinistError",
    "Mistake",
    "Mode",
    "Model",
    "ModelFileError",
    "Modes",
    "Multiplier",
    "Regulator",
    "Response",
    "Run",
    "Scatter",
    "Sensitivities",
    "ShapeError",
    "SpecError",
    "SpecWarning",
    "StateSpace",
    "Stepper",
    "StoppedError",
    "Sweep",
    "SweepError",
    "UnknownNameError",
    "__version__",
    "branch",
    "built_in_names",
    "cycle",
    "design",
    "load",
    "methods",
    "scatter",
    "sweep",
]


def __getattr__(name: str) -> Any:
    module = _LATER.get(name)
    if module is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f".{module}", __name__), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *_LATER})


def methods() -> dict[str, str]:
    """Integration methods by name, with a short description of each."""
    return {name: doc for name, _, _, doc in _machinist.methods()}
