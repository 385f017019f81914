"""Sharing a budget out by price."""


def spend(slots_at, budget, low=-40.0, high=4.0):
    """Slots at the price (log2) at which they come to the budget. slots_at: price to slots a row."""
    for _ in range(30):
        middle = 0.5 * (low + high)
        if slots_at(middle).sum() <= budget:
            high = middle
        else:
            low = middle
    return slots_at(high)
