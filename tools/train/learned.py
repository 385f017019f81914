"""Macula's own network: it corrects the errors that depth slices predict (shaders/lib/predicted_error.glsl).

It is not taught numbers of layers. At a multiplier drawn at random the prediction chooses among a pixel's
possible numbers of slots; the choice, made soft, is charged the true squared error that it leaves and
what its slots cost. The least of this over all pixels is the least error for a budget (Everett 1963),
so that what is trained is the rendered error, and numbers that hardly matter hardly count.
"""

import numpy as np
import torch

import curves
import data

MODEL = "macula"
SLICES, PARTS = 8, 2  # LEARNED_SLICES, LEARNED_PARTS of shaders/shared/network.h
KNOTS = 4  # LEARNED_KNOTS: places of corrections
OUTPUTS = [f"{name}_{i}" for name in ("error", "order") for i in range(KNOTS)]
MOST = 12.0  # LEARNED_MOST: a correction at the most, as log2
UNKNOWN_ORDER = 0.003  # kUnknownOrder of shaders/lib/predicted_error.glsl
# log2 of the multipliers that are tried: from what a visible layer of a dark pixel is worth to
# what no display shows.
LARGEST, SMALLEST = -3.0, -23.0
# How soft the choice is, in slots, and as a share of what the best choice costs.
SOFTNESS, RELATIVE_SOFTNESS = 0.1, 0.05
# A black tail in front of a white surface costs a million slots at the smallest multiplier; one such pixel
# would drown all others of its batch.
MOST_COST = 1e4


class Slices:
    """What the prediction starts from, out of the features (shaders/lib/learned_features.glsl)."""

    def __init__(self, x, fragments):
        count = len(x)
        at = 1 + SLICES
        passes = x[:, at:at + SLICES].clamp(min=1e-30)
        behind_all = -torch.log2(passes)
        tau = torch.cat([behind_all[:, :1], behind_all[:, 1:] - behind_all[:, :-1]], 1).clamp(min=0.0)
        at += SLICES
        share = x[:, at:at + SLICES]
        at += 2 * SLICES
        color = x[:, at:at + 3 * SLICES].reshape(count, SLICES, 3)**2
        behind = x[:, at + 3 * SLICES:]**2

        def parts(values):
            return values.repeat_interleave(PARTS, 1)

        tau = parts(tau / PARTS)
        color = parts(color)
        kept_tau = torch.cat([torch.zeros(count, 1), torch.cumsum(tau, 1)], 1)
        reaches = torch.exp2(-kept_tau)
        last = reaches[:, -1:]
        none = torch.zeros(count, 1, 3)
        kept = torch.cat([none, torch.cumsum((reaches[:, :-1] - reaches[:, 1:])[..., None] * color, 1)], 1)
        sums = torch.cat([none, torch.cumsum(tau[..., None] * color, 1)], 1)
        mean = (sums[:, -1:] - sums).clamp(min=0.0) / (kept_tau[:, -1:] - kept_tau).clamp(min=1e-6)[..., None]
        seen = kept + (reaches - last)[..., None] * mean + (last * behind)[:, None]
        exact = kept[:, -1] + last * behind

        def shown(radiance):
            return torch.sqrt(radiance.clamp(0.0, 1.0))

        off = shown(exact)[:, None] - shown(seen)
        self.squares = (off * off).sum(2)
        self.unknown = (reaches - last)**2
        front = torch.cat([torch.zeros(count, 1), torch.cumsum(parts(share / PARTS), 1)], 1)
        n = fragments[:, None]
        # One slot for the tail.
        slots = torch.minimum(torch.ceil(front * n - 1e-3) + 1.0, n)
        self.slots = torch.cat([slots, n], 1)  # the last: all, without error
        # Slices without fragments are passed over.
        filled = parts((share > 0.0).float())
        self.passed_over = torch.cat([torch.zeros(count, 1), 1.0 - filled], 1) > 0.0

    def errors(self, said):
        """Predicted errors of all numbers of slots. said: corrections, or None."""
        if said is None:
            value = self.squares + UNKNOWN_ORDER * self.unknown
        else:
            place = torch.arange(SLICES * PARTS + 1)
            each = SLICES * PARTS // KNOTS
            knot = (place - 1).clamp(min=0) // each
            beyond = (place - knot * each) / each
            error, order = torch.exp2(said[:, :KNOTS]), torch.exp2(said[:, KNOTS:])
            low = error[:, knot]
            high = error[:, (knot + 1).clamp(max=KNOTS - 1)]
            more = low + (high - low) * beyond
            value = more * (self.squares + UNKNOWN_ORDER * order[:, knot] * self.unknown)
        value = torch.where(self.passed_over, torch.full_like(value, 1e9), value)
        return torch.cat([value, torch.zeros(len(value), 1)], 1)


class Rows:
    """Features and true errors as the trainer takes them: only pixels that have a choice."""

    def __init__(self, split):
        features, starts, counts, errors, weights = [], [], [], [], []
        at = 0
        for scene in split.scenes:
            rows = np.nonzero(scene["fragments"] > 1)[0]
            features.append(scene["learned"][rows])
            counts.append(scene["fragments"][rows])
            starts.append(scene["errors_begin"][rows].astype(np.int64) + at)
            errors.append(scene["errors"])
            weights.append(np.full(len(rows), 1.0 / max(len(rows), 1)))
            at += len(scene["errors"])
        self.features = torch.tensor(np.concatenate(features))
        self.counts = torch.tensor(np.concatenate(counts).astype(np.float32))
        self.starts = torch.tensor(np.concatenate(starts))
        self.true = torch.tensor(np.concatenate(errors))
        cumulated = np.cumsum(np.concatenate(weights))
        if not len(cumulated):
            raise data.BadData(f"{split.folder}: no pixel has two fragments; choose other scenes")
        self.cumulated = torch.tensor(cumulated / cumulated[-1])

    def draw(self, count, generator):
        """Rows at random, each scene as often as any other."""
        place = torch.rand(count, dtype=torch.float64, generator=generator)
        return torch.searchsorted(self.cumulated, place).clamp(max=len(self.counts) - 1)


class Net(torch.nn.Module):
    def __init__(self, mean, scale, hidden):
        super().__init__()
        self.mean, self.scale = mean, scale
        sizes = [len(mean), *hidden, len(OUTPUTS)]
        self.layers = torch.nn.ModuleList(
            torch.nn.Linear(a, b) for a, b in zip(sizes[:-1], sizes[1:]))
        with torch.no_grad():  # begins near the plain prediction
            self.layers[-1].weight.mul_(0.1)
            self.layers[-1].bias.zero_()

    def raw(self, x):
        x = (x - self.mean) * self.scale
        for layer in self.layers[:-1]:
            x = torch.relu(layer(x))
        return self.layers[-1](x)

    def forward(self, x):
        return MOST * torch.tanh(self.raw(x) / MOST)


def loss_of(net, rows, chosen, generator, multipliers_each=4):
    """Mean of what the soft choice costs over what the best one would, in slots."""
    slices = Slices(rows.features[chosen], rows.counts[chosen])
    errors = slices.errors(net(rows.features[chosen]))
    true = rows.true[rows.starts[chosen][:, None] + slices.slots.long()]
    total = 0.0
    for _ in range(multipliers_each):
        multiplier = LARGEST + (SMALLEST - LARGEST) * torch.rand(len(chosen), 1, generator=generator)
        each = torch.exp2(-multiplier)
        cost = errors * each + slices.slots
        softness = SOFTNESS + RELATIVE_SOFTNESS * cost.detach().min(1, keepdim=True)[0]
        choice = torch.softmax(-cost / softness, 1)
        paid = (true * each + slices.slots).clamp(max=MOST_COST)
        total = total + ((choice * paid).sum(1) - paid.min(1)[0]).mean()
    return total / multipliers_each


def judge(net, split):
    """RMSE of the network's slots over that of the plain prediction, by scene: means over views and
    budgets."""
    ratios = {}
    with torch.no_grad():
        for scene in split.scenes:
            begin, true = scene["errors_begin"].astype(np.int64), scene["errors"]
            fragments = scene["fragments"].astype(np.int64)
            x = torch.tensor(scene["learned"])
            slices = Slices(x, torch.tensor(fragments.astype(np.float32)))
            slots = slices.slots.numpy()
            kinds = [slices.errors(None).numpy(), slices.errors(net(x)).numpy()]
            for view in np.unique(scene["view"]):
                rows = np.nonzero(scene["view"] == view)[0]
                for share in split.shares:
                    budget = share * fragments[rows].sum()
                    if budget < 1.2 * len(rows):
                        continue  # little more than a slot each: nothing to choose
                    plain, corrected = (
                        _rmse(e[rows], slots[rows], begin[rows], true, fragments[rows], budget)
                        for e in kinds)
                    if plain > 1e-4:  # less is below what any display shows
                        ratios.setdefault(scene.name, []).append(corrected / plain)
    return {name: float(np.mean(values)) for name, values in ratios.items()}


def _rmse(errors, slots, begin, true, fragments, budget):
    def slots_at(multiplier):
        best = np.argmin(errors + slots * np.float32(2.0**multiplier), 1)
        return np.take_along_axis(slots, best[:, None], 1)[:, 0].astype(np.int64)

    taken = np.minimum(curves.spend(slots_at, budget), fragments)
    return float(np.sqrt(true[begin + taken].sum() / (3.0 * len(begin))))


def train(training, validation, hidden, steps, batch, rate, seed, say):
    """Returns the network and its validation losses. say(step, training loss, validation loss) shows
    progress."""
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
                losses.append(float(loss_of(net, held, held.draw(20000, probe), probe)))
                say(step, float(loss_of(net, rows, rows.draw(20000, probe), probe)), losses[-1])
        if step == steps:
            break
        loss = loss_of(net, rows, rows.draw(batch, generator), generator)
        optimiser.zero_grad()
        loss.backward()
        torch.nn.utils.clip_grad_norm_(net.parameters(), 1.0)
        optimiser.step()
        schedule.step()
    return net, losses
