"""Macula's own network: layers that a pixel should keep at some prices of a slot.

It is not taught numbers of layers. Its layers, at a price drawn at random, are charged what they
leave of the true squared error and what their slots cost; the least of this, over all pixels, is the
least error for a budget. Numbers of layers that hardly matter then hardly count.
"""

import numpy as np
import torch

import curves
import data

MODEL = "macula"
KNOTS = 6
HIGHEST = -3.0  # log2 of the price of the first knot; LEARNED_KNOT_HIGHEST of shared/network.h
STEP = 4.0  # octaves between knots
OUTPUTS = [f"layers_at_{HIGHEST - i * STEP:.0f}" for i in range(KNOTS)]
TAIL_SLOTS = 1.0  # a tail takes one slot of 16 bytes
# A tail instead of one layer can cost a black pixel its white surface, 3; at the lowest price that
# would weigh as much as a million slots, and one such pixel would drown all others of its batch.
MOST_COST = 1e4


class Rows:
    """Features and errors as the trainer takes them: only pixels that have a choice."""

    def __init__(self, split):
        features, starts, counts, hulls, weights = [], [], [], [], []
        at = 0
        for scene in split.scenes:
            begin = scene["errors_begin"]
            hull = curves.hulls(begin, scene["errors"])
            rows = np.nonzero(scene["fragments"] > 1)[0]
            features.append(scene["learned"][rows])
            counts.append(scene["fragments"][rows])
            starts.append(begin[rows].astype(np.int64) + at)
            hulls.append(hull)
            weights.append(np.full(len(rows), 1.0 / max(len(rows), 1)))
            at += len(hull)
        self.features = torch.tensor(np.concatenate(features))
        self.counts = torch.tensor(np.concatenate(counts).astype(np.float32))
        self.starts = torch.tensor(np.concatenate(starts))
        self.hulls = torch.tensor(np.concatenate(hulls))
        cumulated = np.cumsum(np.concatenate(weights))
        if not len(cumulated):
            raise data.BadData(f"{split.folder}: no pixel has two fragments; choose other scenes")
        self.cumulated = torch.tensor(cumulated / cumulated[-1])

    def draw(self, count, generator):
        """Rows at random, each scene as often as any other."""
        place = torch.rand(count, dtype=torch.float64, generator=generator)
        return torch.searchsorted(self.cumulated, place).clamp(max=len(self.counts) - 1)

    def errors(self, rows, slots):
        """Squared error of a number of slots, which need not be whole."""
        slots = torch.minimum(slots.clamp(min=1.0), self.counts[rows])
        below = slots.detach().floor().clamp(min=1.0)
        below = torch.minimum(below, (self.counts[rows] - 1.0).clamp(min=1.0))
        at = self.starts[rows] + below.long()
        return self.hulls[at] + (self.hulls[at + 1] - self.hulls[at]) * (slots - below)


class Net(torch.nn.Module):
    def __init__(self, mean, scale, hidden):
        super().__init__()
        self.mean, self.scale = mean, scale
        sizes = [len(mean), *hidden, KNOTS]
        self.layers = torch.nn.ModuleList(
            torch.nn.Linear(a, b) for a, b in zip(sizes[:-1], sizes[1:]))

    def raw(self, x):
        x = (x - self.mean) * self.scale
        for layer in self.layers[:-1]:
            x = torch.relu(layer(x))
        return self.layers[-1](x)

    def forward(self, x):
        """Layers at each knot; a lower price never buys fewer."""
        return torch.cumsum(torch.nn.functional.softplus(self.raw(x)), 1)


def layers_at(knots, prices):
    """On straight lines between knots. prices: log2."""
    at = ((HIGHEST - prices) / STEP).clamp(0.0, KNOTS - 1.0 - 1e-4)
    first = at.long()
    low = knots.gather(1, first[:, None])[:, 0]
    high = knots.gather(1, first[:, None] + 1)[:, 0]
    return low + (high - low) * (at - first)


def loss_of(net, rows, chosen, generator, prices_each=4):
    """Mean of error / price + slots, in slots."""
    knots = net(rows.features[chosen])
    total = 0.0
    for _ in range(prices_each):
        price = HIGHEST - STEP * (KNOTS - 1) * torch.rand(len(chosen), generator=generator)
        # The shader rounds layers down: on average half a one less.
        slots = layers_at(knots, price) + (TAIL_SLOTS - 0.5)
        cost = rows.errors(chosen, slots) * torch.exp2(-price)
        paid = torch.minimum(slots, rows.counts[chosen]).clamp(min=TAIL_SLOTS)
        # Beyond what a pixel has nothing changes; a weak pull keeps the slope alive there.
        beyond = torch.relu(slots - rows.counts[chosen]) + torch.relu(TAIL_SLOTS - slots)
        total = total + ((cost + paid).clamp(max=MOST_COST) + 0.02 * beyond).mean()
    return total / prices_each


def judge(net, split):
    """RMSE of the network's slots over that of the best slots, mean over views and budgets."""
    ratios = []
    with torch.no_grad():
        for scene in split.scenes:
            begin, errors = scene["errors_begin"], scene["errors"]
            hull = curves.hulls(begin, errors)
            knots = net(torch.tensor(scene["learned"]))
            fragments = scene["fragments"].astype(np.int64)
            for view in np.unique(scene["view"]):
                rows = np.nonzero(scene["view"] == view)[0]
                ratios += _judge_view(knots[rows], fragments[rows], begin, errors, hull, rows,
                                      split.shares)
    return float(np.mean(ratios))


def _judge_view(knots, fragments, begin, errors, hull, rows, shares):
    counts = np.diff(begin).astype(np.int64)[rows]
    ends = np.cumsum(counts)
    flat = np.repeat(begin[rows].astype(np.int64) - (ends - counts), counts) + np.arange(ends[-1])
    own = np.concatenate([[0], ends])
    own_errors, own_hull = errors[flat], hull[flat]
    inside = np.ones(len(flat) - 1, dtype=bool)
    gains = own_hull[:-1] - own_hull[1:]
    inside[own[1:-1] - 1] = False  # from a row's last to the next one's first
    inside[own[:-1][own[:-1] < len(inside)]] = False  # the first slot is everyone's
    row_of = np.repeat(np.arange(len(rows)), counts)[:-1]

    def best(price):
        taken = inside & (gains > 2.0**price)
        return np.minimum(fragments, 1 + np.bincount(row_of[taken], minlength=len(rows)))

    def said(price):
        at = torch.full((len(rows),), float(np.clip(price, HIGHEST - STEP * (KNOTS - 1), HIGHEST)))
        layers = layers_at(knots, at).numpy()
        return np.clip(np.floor(layers + TAIL_SLOTS).astype(np.int64), 1, fragments)

    ratios = []
    for share in shares:
        budget = share * fragments.sum()
        if budget < 1.2 * len(rows):
            continue  # little more than a slot each: nothing to choose
        least = curves.rmse_at(curves.spend(best, budget), own, own_errors, len(rows))
        if least < 1e-4:
            continue  # below what any display shows
        ratios.append(curves.rmse_at(curves.spend(said, budget), own, own_errors, len(rows)) / least)
    return ratios


def train(training, validation, hidden, steps, batch, rate, seed, say):
    """Returns the network. say(step, training loss, validation loss) shows progress."""
    torch.manual_seed(seed)
    generator = torch.Generator().manual_seed(seed)
    rows, held = Rows(training), Rows(validation)
    mean = rows.features.mean(0)
    scale = 1.0 / (rows.features.std(0) + 1e-3)
    net = Net(mean, scale, hidden)
    optimiser = torch.optim.Adam(net.parameters(), rate)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, rate, total_steps=max(steps, 2))
    losses = []
    for step in range(steps + 1):
        if step % max(steps // 20, 1) == 0 or step == steps:
            with torch.no_grad():
                probe = torch.Generator().manual_seed(seed + 1)
                chosen = held.draw(20000, probe)
                losses.append(float(loss_of(net, held, chosen, probe)))
                chosen = rows.draw(20000, probe)
                say(step, float(loss_of(net, rows, chosen, probe)), losses[-1])
        if step == steps:
            break
        loss = loss_of(net, rows, rows.draw(batch, generator), generator)
        optimiser.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(net.parameters(), 1.0)
        optimiser.step()
        schedule.step()
    return net, losses
