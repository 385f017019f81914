"""The network of the thesis (Tsopouridis 2021, chapter 4): 12-128-64-1, ReLU, sigmoid.

`as_written` follows the text: raw features, label k / F (F: fragments of the view), mean squared
error, SGD at 0.001, batches of 512, L1 and L2 of 0.3 and 0.35 on the hidden layers. It cannot learn:
the labels are some millionths, which a sigmoid near 1/2 is far from, and the regularisers outweigh
them by five orders of magnitude, so that every weight goes to 0 and every pixel gets the same.

`mended` keeps features, network, loss and batches, and mends what stands in its way: features and
labels are scaled (the label is k over the mean number of fragments of a pixel, over LABEL_SCALE, so
that it lies in the sigmoid's range), the regularisers go, Adam takes the place of SGD.
"""

import numpy as np
import torch

MODEL = "thesis"
OUTPUTS = ["importance"]
HIDDEN = (128, 64)
BATCH = 512
L1, L2 = 0.3, 0.35
SGD_RATE = 0.001
ADAM_RATE = 0.002
# The most layers that a pixel can be given, in mean fragments of a pixel: more saturates.
LABEL_SCALE = 16.0
FRAGMENTS_SHARE, RESERVED_SHARE = 0, 1  # places among the features


class Rows:
    """A row for each sampled pixel and budget."""

    def __init__(self, split, label):
        features, shares, means, weights = [], [], [], []
        for scene in split.scenes:
            view = scene["view"]
            mean = (scene["view_fragments"] / scene["view_pixels"])[view].astype(np.float32)
            for b, share in enumerate(split.shares):
                x = scene["thesis"].copy()
                x[:, RESERVED_SHARE] = share
                features.append(x)
                shares.append(scene[label][:, b] / mean)
                means.append(np.full(len(x), 1.0) / scene["view_pixels"][view])
                weights.append(np.full(len(x), 1.0 / max(len(x), 1)))
        self.features = torch.tensor(np.concatenate(features))
        self.shares = torch.tensor(np.concatenate(shares).astype(np.float32))  # k / (F / pixels)
        self.each = torch.tensor(np.concatenate(means).astype(np.float32))  # 1 / pixels
        cumulated = np.cumsum(np.concatenate(weights))
        self.cumulated = torch.tensor(cumulated / cumulated[-1])

    def draw(self, count, generator):
        place = torch.rand(count, dtype=torch.float64, generator=generator)
        return torch.searchsorted(self.cumulated, place).clamp(max=len(self.shares) - 1)


class Net(torch.nn.Module):
    def __init__(self, mean, scale):
        super().__init__()
        self.mean, self.scale = mean, scale
        sizes = [len(mean), *HIDDEN, 1]
        self.layers = torch.nn.ModuleList(
            torch.nn.Linear(a, b) for a, b in zip(sizes[:-1], sizes[1:]))

    def raw(self, x):
        x = (x - self.mean) * self.scale
        for layer in self.layers[:-1]:
            x = torch.relu(layer(x))
        return self.layers[-1](x)

    def forward(self, x):
        return torch.sigmoid(self.raw(x))[:, 0]


def train(training, validation, label, as_written, steps, seed, say):
    """Returns the network and its validation losses."""
    torch.manual_seed(seed)
    generator = torch.Generator().manual_seed(seed)
    rows, held = Rows(training, label), Rows(validation, label)
    if as_written:
        # The features of the text: the first one is a share of all fragments.
        mean = torch.zeros(rows.features.shape[1])
        scale = torch.ones(rows.features.shape[1])
        scale[FRAGMENTS_SHARE] = float(rows.each.mean())
        labels = [r.shares * r.each for r in (rows, held)]
    else:
        mean = rows.features.mean(0)
        scale = 1.0 / (rows.features.std(0) + 1e-3)
        labels = [(r.shares / LABEL_SCALE).clamp(max=1.0) for r in (rows, held)]
    net = Net(mean, scale)
    if as_written:
        optimiser = torch.optim.SGD(net.parameters(), SGD_RATE)
        schedule = None
    else:
        optimiser = torch.optim.Adam(net.parameters(), ADAM_RATE)
        schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, ADAM_RATE,
                                                       total_steps=max(steps, 2))
    losses = []
    for step in range(steps + 1):
        if step % max(steps // 20, 1) == 0 or step == steps:
            with torch.no_grad():
                probe = torch.Generator().manual_seed(seed + 1)
                found = []
                for r, wanted in ((rows, labels[0]), (held, labels[1])):
                    chosen = r.draw(50000, probe)
                    found.append(float(((net(r.features[chosen]) - wanted[chosen])**2).mean()))
                losses.append(found[1])
                say(step, *found)
        if step == steps:
            break
        chosen = rows.draw(BATCH, generator)
        loss = ((net(rows.features[chosen]) - labels[0][chosen])**2).mean()
        if as_written:
            loss = loss + L1 * net.layers[0].weight.abs().sum()
            loss = loss + L2 * (net.layers[1].weight**2).sum()
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
        if schedule:
            schedule.step()
    return net, losses


def spread(net, split):
    """Standard deviation of what it says over all pixels, over their mean: 0 says nothing."""
    with torch.no_grad():
        said = net(torch.tensor(split.rows("thesis")))
    return float(said.std() / said.mean())
