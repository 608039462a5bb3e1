"""Machines whose branches are held, for solvers that step over no switch."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _machinist

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Held:
    """A machine with every comparison and integer of its spec held on a branch.

    Its rate is smooth. A branch ends where its :meth:`margins` falls through zero: stop the solver
    there, hold the new branches and go on.
    """

    _machine: _machinist.Machine
    #: Branch of each relation: -inf below and inf above zero of a comparison, or an integer.
    branches: Array

    def rate(
        self, t: float, y: ArrayLike, p: ArrayLike | None = None, out: Array | None = None
    ) -> Array:
        """Rate y' = f(t, y, p) on these branches."""
        return self._machine.rate(t, y, p, out, self.branches)

    def jacobian(
        self, t: float, y: ArrayLike, p: ArrayLike | None = None, out: Array | None = None
    ) -> Array:
        """Dense Jacobian dy'/dy on these branches."""
        return self._machine.jacobian(t, y, p, out, self.branches)

    def margins(self, t: float, y: ArrayLike, p: ArrayLike | None = None) -> Array:
        """Distance from the end of each branch, negative beyond it."""
        return self._machine.margins(t, y, self.branches, p)
