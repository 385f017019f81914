"""Allocation of a budget by a Lagrange multiplier."""


def spend(slots_at, budget, low=-40.0, high=4.0):
    """Slots at the multiplier (log2) at which they sum to the budget. slots_at: multiplier to slots
    a row."""
    for _ in range(30):
        middle = 0.5 * (low + high)
        if slots_at(middle).sum() <= budget:
            high = middle
        else:
            low = middle
    return slots_at(high)
