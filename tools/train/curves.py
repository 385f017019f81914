"""What slots save: convex hulls of a pixel's squared error over its number of slots."""

import numpy as np


def hulls(begin, errors):
    """The lower convex hull of each row's errors from one slot on, at every number of slots.

    begin: where a row's errors for 0, 1, ... n slots begin, and the end of the last.
    Where every pixel pays the same for a slot, what is best for the sum over all pixels lies on
    these hulls (Everett 1963; Shoham & Gersho 1988).
    """
    out = np.array(errors, dtype=np.float64)
    counts = np.diff(begin).astype(np.int64) - 1
    for n in np.unique(counts):
        rows = np.nonzero(counts == n)[0]
        at = begin[rows][:, None].astype(np.int64) + np.arange(n + 1)[None]
        out[at] = _hulls_of(out[at], int(n))
    return out.astype(np.float32)


def _hulls_of(e, n):
    """The same for rows of one length: from each corner to the one that is steepest below it."""
    hull = e.copy()
    slots = np.arange(n + 1)
    corner = np.full(len(e), min(1, n))
    active = np.nonzero(corner < n)[0]
    while len(active):
        here = corner[active][:, None]
        start = np.take_along_axis(e[active], here, 1)
        distance = slots[None] - here
        fall = np.where(distance > 0, (start - e[active]) / np.maximum(distance, 1), -np.inf)
        steepest = n - np.argmax(fall[:, ::-1], 1)  # of equal ones the farthest
        slope = np.take_along_axis(fall, steepest[:, None], 1)
        inside = (distance > 0) & (slots[None] <= steepest[:, None])
        hull[active] = np.where(inside, start - slope * distance, hull[active])
        corner[active] = steepest
        active = active[steepest < n]
    return hull


def rmse_at(k, begin, errors, pixels):
    """RMSE over R, G and B of an image of so many pixels, of which the rows are all that differ."""
    at = begin[:-1].astype(np.int64) + np.minimum(k, np.diff(begin).astype(np.int64) - 1)
    return float(np.sqrt(errors[at].sum() / (3.0 * pixels)))


def spend(slots_at, budget, low=-40.0, high=4.0):
    """Slots at the price (log2) at which they come to the budget. slots_at: price to slots a row."""
    for _ in range(30):
        middle = 0.5 * (low + high)
        if slots_at(middle).sum() <= budget:
            high = middle
        else:
            low = middle
    return slots_at(high)
