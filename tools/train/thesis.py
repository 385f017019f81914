"""The network of the thesis (Tsopouridis 2021, chapter 4): 12-128-64-1, ReLU, sigmoid.

`as_written` follows the text: raw features, label k / F (F: fragments of the view), mean squared
error, SGD at 0.001, batches of 512, L1 and L2 of 0.3 and 0.35 on the hidden layers. It cannot learn:
the labels are some millionths, which a sigmoid near 1/2 is far from, and the regularisers outweigh
them by many orders of magnitude, so that every weight goes to 0 and every pixel gets the same.

The corrected training keeps features and network. What stood in its way goes: features are normalised, the share
of a pixel is taken of the mean over the covered pixels, the regularisers go, Adam takes the place of
SGD. It is taught either labels, as the text has it (k of Optimal K or of least RMSE over the mean k
of the covered pixels, over LABEL_SCALE so that it fits the sigmoid), or, by default, nothing but the
squared error of the image that its importance leads to: a batch is pixels of one view, which share
that view's budget in proportion to what it says of them.
"""

import copy

import numpy as np
import torch

MODEL = "thesis"
OUTPUTS = ["importance"]
HIDDEN = (128, 64)
BATCH = 512
L1, L2 = 0.3, 0.35
SGD_RATE = 0.001
ADAM_RATE = 0.002
# More than this many times the mean number of layers saturates.
LABEL_SCALE = 16.0
FRAGMENTS_SHARE, RESERVED_SHARE = 0, 1  # places among the features
DEPTHS, BLEND, NEAREST = slice(2, 6), slice(6, 9), slice(9, 12)
# Pixels of a view in a batch that shares a budget: its sums are then right to some per cent.
SHARED_BATCH = 2048
# A view with fewer sampled pixels says too little of how a budget is shared.
LEAST_PIXELS = 200
# Views in a step of training by the image's error: one alone pulls the weights its own way.
VIEWS_A_STEP = 4
# Hidden values left out of a step, so that scenes are not learned by heart; of the text's network
# nothing is left out when it is asked.
DROPOUT = 0.1
# Views by which training is judged; of the validation scenes it is all of them.
JUDGED_VIEWS = 60


class Rows:
    """A row for each sampled pixel and budget."""

    def __init__(self, split, label):
        features, labels, as_written, shares, weights = [], [], [], [], []
        for scene in split.scenes:
            view = scene["view"]
            fragments = scene["view_fragments"][view].astype(np.float64)
            covered = scene["view_covered"][view].astype(np.float64)
            for b, share in enumerate(split.shares):
                x = scene["thesis"].copy()
                x[:, RESERVED_SHARE] = share
                k = scene[label][:, b].astype(np.float64)
                features.append(x)
                labels.append(np.minimum(k * covered / (share * fragments) / LABEL_SCALE, 1.0))
                as_written.append(k / fragments)
                shares.append(1.0 / covered)
                weights.append(np.full(len(x), 1.0 / max(len(x), 1)))
        self.features = torch.tensor(np.concatenate(features))
        self.labels = torch.tensor(np.concatenate(labels).astype(np.float32))
        self.as_written = torch.tensor(np.concatenate(as_written).astype(np.float32))
        self.per_pixel = float(np.mean([s.mean() for s in shares]))
        cumulated = np.cumsum(np.concatenate(weights))
        self.cumulated = torch.tensor(cumulated / cumulated[-1])

    def draw(self, count, generator):
        place = torch.rand(count, dtype=torch.float64, generator=generator)
        return torch.searchsorted(self.cumulated, place).clamp(max=len(self.labels) - 1)


class Views:
    """Pixels of each view with their squared errors for every number of layers."""

    def __init__(self, split):
        self.shares = split.shares
        self.views = []
        for scene in split.scenes:
            begin = scene["errors_begin"].astype(np.int64)
            errors = torch.tensor(scene["errors_plain"])
            for view in np.unique(scene["view"]):
                rows = np.nonzero(scene["view"] == view)[0]
                if len(rows) > LEAST_PIXELS:
                    self.views.append((torch.tensor(scene["thesis"][rows]),
                                       torch.tensor(scene["fragments"][rows].astype(np.float32)),
                                       torch.tensor(begin[rows]), errors))

    def loss(self, net, view, share, generator, varied):
        """Squared error of a view under a budget over that of the same k everywhere."""
        features, counts, begin, errors = self.views[view]
        if len(features) > SHARED_BATCH:
            rows = torch.randperm(len(features), generator=generator)[:SHARED_BATCH]
            features, counts, begin = features[rows], counts[rows], begin[rows]
        x = features.clone()
        x[:, RESERVED_SHARE] = share
        if varied:
            _vary(x, generator)
        mean = share * counts.mean()

        def squares(k):
            # The importance map's slots are rounded down, and one is the least.
            k = torch.minimum((k - 0.5).clamp(min=1.0), counts)
            below = torch.minimum(k.detach().floor(), (counts - 1.0).clamp(min=1.0))
            at = begin + below.long()
            more = torch.where(counts > 1.0, errors[at + (counts > 1.0).long()], errors[at])
            return (errors[at] + (more - errors[at]) * (k - below)).sum()

        said = net(x)
        return squares(said / said.mean() * mean) / squares(mean.expand_as(said)).clamp(min=1e-3)


def _vary(x, generator):
    """The same pixels as of a scene of other colours and another extent, which need the same layers:
    else a few scenes are learned by heart."""
    order = torch.randperm(3, generator=generator)
    x[:, BLEND] = x[:, BLEND][:, order]
    x[:, NEAREST] = x[:, NEAREST][:, order]
    scale = torch.exp2(2.0 * torch.rand(1, generator=generator) - 1.0)
    x[:, DEPTHS] = x[:, DEPTHS] * scale + 0.3 * (torch.rand(1, generator=generator) - 0.5)


class Net(torch.nn.Module):
    def __init__(self, mean, scale, dropout=0.0):
        super().__init__()
        self.mean, self.scale, self.dropout = mean, scale, dropout
        sizes = [len(mean), *HIDDEN, 1]
        self.layers = torch.nn.ModuleList(
            torch.nn.Linear(a, b) for a, b in zip(sizes[:-1], sizes[1:]))

    def raw(self, x):
        x = (x - self.mean) * self.scale
        for layer in self.layers[:-1]:
            x = torch.relu(layer(x))
            if self.training and self.dropout > 0.0:
                x = torch.nn.functional.dropout(x, self.dropout)
        return self.layers[-1](x)

    def forward(self, x):
        return torch.sigmoid(self.raw(x))[:, 0]


def train(training, validation, label, steps, seed, say):
    """Returns the network and its validation losses.

    label: an array of labels, "error" for the image's error, or "as_written".
    """
    torch.manual_seed(seed)
    generator = torch.Generator().manual_seed(seed)
    array = label if label in ("optimal_k", "least_rmse_k") else "optimal_k"
    rows, held = Rows(training, array), Rows(validation, array)
    as_written = label == "as_written"
    mean = torch.zeros(rows.features.shape[1])
    scale = torch.ones(rows.features.shape[1])
    if as_written:
        scale[FRAGMENTS_SHARE] = rows.per_pixel  # back to a share of all fragments
    else:
        mean = rows.features.mean(0)
        scale = 1.0 / (rows.features.std(0) + 1e-3)
    net = Net(mean, scale, DROPOUT if label == "error" else 0.0)
    if as_written:
        optimiser = torch.optim.SGD(net.parameters(), SGD_RATE)
        schedule = None
    else:
        optimiser = torch.optim.Adam(net.parameters(), ADAM_RATE)
        schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, ADAM_RATE,
                                                       total_steps=max(steps, 2))
    losses_of = _image_losses if label == "error" else _label_losses
    step_loss, judged = losses_of(net, training, validation, rows, held, as_written, generator)
    losses = []
    best = None
    for step in range(steps + 1):
        if step % max(steps // 20, 1) == 0 or step == steps:
            net.eval()
            with torch.no_grad():
                found = judged()
            net.train()
            losses.append(found[1])
            say(step, *found)
            if losses[-1] == min(losses):
                best = copy.deepcopy(net.state_dict())
        if step == steps:
            break
        loss = step_loss()
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
        if schedule:
            schedule.step()
    if not as_written:  # the text stops at the end; else the weights that do best on other scenes
        net.load_state_dict(best)
        losses.append(min(losses))
    net.eval()
    return net, losses


def _label_losses(net, training, validation, rows, held, as_written, generator):
    def wanted(r):
        return r.as_written if as_written else r.labels

    def step_loss():
        chosen = rows.draw(BATCH, generator)
        loss = ((net(rows.features[chosen]) - wanted(rows)[chosen])**2).mean()
        if as_written:
            loss = loss + L1 * net.layers[0].weight.abs().sum()
            loss = loss + L2 * (net.layers[1].weight**2).sum()
        return loss

    def judged():
        probe = torch.Generator().manual_seed(0)
        found = []
        for r in (rows, held):
            chosen = r.draw(50000, probe)
            found.append(float(((net(r.features[chosen]) - wanted(r)[chosen])**2).mean()))
        return found

    return step_loss, judged


def _image_losses(net, training, validation, rows, held, as_written, generator):
    learned, kept = Views(training), Views(validation)
    some = range(0, len(learned.views), max(len(learned.views) // JUDGED_VIEWS, 1))

    def one_loss():
        view = int(torch.randint(len(learned.views), (1,), generator=generator))
        share = learned.shares[int(torch.randint(len(learned.shares), (1,), generator=generator))]
        return learned.loss(net, view, share, generator, True)

    def step_loss():
        return sum(one_loss() for _ in range(VIEWS_A_STEP)) / VIEWS_A_STEP

    def judged():
        probe = torch.Generator().manual_seed(0)
        return [
            float(np.mean([float(views.loss(net, view, share, probe, False))
                           for view in judged_views for share in views.shares]))
            for views, judged_views in ((learned, some), (kept, range(len(kept.views))))
        ]

    return step_loss, judged


def spread(net, split):
    """Standard deviation of what it says over all pixels, over their mean: 0 says nothing."""
    with torch.no_grad():
        said = net(torch.tensor(split.rows("thesis")))
    return float(said.std() / said.mean())
