"""Chunks of sweeps on a Dask cluster.

A task loads the machine, and the workers share its result. Each worker receives it once. If the
worker that holds it is lost, it is loaded again. The scheduler reassigns tasks of lost workers.
Chunks whose workers died too often run again at the end, one at a time, so a failure has one cause.
A chunk that kills its workers again is halved until the failing variant is found.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from dask.distributed import KilledWorker, as_completed

from ._model import Model, _restored
from ._sweep import FIRST, Array, Piece, Plan, next_size, run_piece

if TYPE_CHECKING:
    from dask.distributed import Client, Future

#: Chunks in flight per thread of the cluster.
_AHEAD = 2


def on_cluster(
    client: Client,
    model: Model,
    plan: Plan,
    variants: Array,
    missing: list[tuple[int, int]],
    seconds: float,
) -> Iterator[Piece]:
    """Completed chunks, in any order."""
    if not missing:
        return
    loaded = client.submit(_restored, model._key, pure=False)
    threads = max(1, sum(client.nthreads().values()))
    size = FIRST
    rest = list(reversed(missing))
    handed: dict[Any, tuple[int, int]] = {}
    suspects: list[tuple[int, int]] = []
    piece: Piece | None

    def submit(first: int, stop: int) -> Future[Piece]:
        future = client.submit(
            run_piece, loaded, plan, first, variants[first:stop], 1, pure=False
        )
        handed[future.key] = (first, stop)
        return future

    def next_piece() -> tuple[int, int] | None:
        if not rest:
            return None
        left = sum(stop - first for first, stop in rest)
        first, last = rest.pop()
        # The last chunks are smaller, so that workers finish at similar times.
        share = -(-left // (_AHEAD * threads))
        stop = min(last, first + max(1, size // 8, min(size, share)))
        if stop < last:
            rest.append((stop, last))
        return first, stop

    done = as_completed()
    try:
        for _ in range(_AHEAD * threads):
            following = next_piece()
            if following is not None:
                done.add(submit(*following))
        for future in done:
            first, stop = handed.pop(future.key)
            try:
                piece = future.result()
                size = next_size(size, piece, seconds)
            except KilledWorker:
                piece = None
                suspects.append((first, stop))
            following = next_piece()
            if following is not None:
                done.add(submit(*following))
            if piece is not None:
                yield piece
        while suspects:
            first, stop = suspects.pop()
            try:
                yield submit(first, stop).result()
            except KilledWorker as error:
                middle = (first + stop) // 2
                if first == middle:
                    yield _died(plan, first, variants[first:stop], error)
                else:
                    suspects += [(first, middle), (middle, stop)]
    finally:
        # Cancel pending tasks if the caller stops early.
        client.cancel([*done.futures, loaded])


def _died(plan: Plan, first: int, variant: Array, error: KilledWorker) -> Piece:
    """Result of a variant whose workers died repeatedly."""
    values = np.full((1, len(plan.columns)), np.nan)
    told = f"the workers that ran it died, the last of them {error.last_worker.address}"
    return Piece(first, variant, values, np.zeros(1, np.uint64), [told], 0.0)

