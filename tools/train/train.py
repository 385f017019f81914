#!/usr/bin/python3
"""Trains a network of importance and writes its weights.

  tools/train/train.py learned --data out/features --out assets/networks/macula.safetensors
  tools/train/train.py thesis --data out/features --out assets/networks/thesis.safetensors
  tools/train/train.py thesis --as-written --data out/features --out out/thesis_as_written.safetensors

Needs Debian's python3-torch and python3-numpy; --data is what `macula features` wrote. The same data
and seed give the same file on the same machine.
"""

import argparse
import pathlib
import sys
import time

try:
    import numpy as np
    import torch
except ImportError as error:
    sys.exit(f"train: {error}; install Debian's python3-torch and python3-numpy, and use /usr/bin/python3")

import data
import learned
import thesis
import weights

PROBES = 1000  # inputs that tests compare the shader on


def parse():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("model", choices=["learned", "thesis"])
    parser.add_argument("--data", required=True, type=pathlib.Path, help="folder of macula features")
    parser.add_argument("--out", required=True, type=pathlib.Path, help="file of weights")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--steps", type=int, help="default: 4000 (learned), 2000 (thesis)")
    parser.add_argument("--hidden", type=int, nargs=2, default=(16, 16),
                        help="values of the hidden layers (learned), multiples of 4")
    parser.add_argument("--rate", type=float, default=5e-3, help="of learning, at its highest (learned)")
    parser.add_argument("--batch", type=int, default=1024, help="pixels a step (learned)")
    parser.add_argument("--label", choices=["error", "optimal_k", "least_rmse_k"], default="error",
                        help="what the thesis's network is taught: the image's error, or labels; its "
                        "own are optimal_k")
    parser.add_argument("--as-written", action="store_true", help="the thesis's text, word by word")
    parser.add_argument("--probes", type=pathlib.Path, help="also 1,000 inputs and what is said of them")
    parser.add_argument("--must-learn", action="store_true",
                        help="fail unless the validation loss has fallen")
    return parser.parse_args()


def command_of(arguments):
    """The command with what it leaves to defaults, without places of this machine."""
    words = ["tools/train/train.py", arguments.model, "--seed", str(arguments.seed), "--steps",
             str(arguments.steps)]
    if arguments.model == "learned":
        words += ["--hidden", *map(str, arguments.hidden), "--rate", str(arguments.rate), "--batch",
                  str(arguments.batch)]
    else:
        words += ["--as-written"] if arguments.as_written else ["--label", arguments.label]
    return " ".join(words)


def report(split, ratios):
    """How far the corrections lower the error, by scene."""
    scenes = ", ".join(f"{name} {ratio:.3f}" for name, ratio in ratios.items())
    mean = sum(ratios.values()) / max(len(ratios), 1)
    print(f"{split}: RMSE over that of the plain prediction {mean:.3f} ({scenes})")


def write_probes(path, net, half):
    """Inputs around those of the training data, as 16-bit floats, and the raw outputs for them."""
    generator = np.random.default_rng(1)
    spread = 2.0 * generator.uniform(-1.0, 1.0, (PROBES, len(net.mean)))
    inputs = weights.rounded(net.mean.numpy() + spread / net.scale.numpy())
    with torch.no_grad():
        said = net.raw(torch.tensor(inputs))
        said = torch.sigmoid(said) if isinstance(net, thesis.Net) else said
    weights.write_tensors(path, {"features": inputs.astype(np.float16), "outputs": said.numpy()}, {})


def main():
    arguments = parse()
    arguments.hidden = tuple(arguments.hidden)
    if arguments.steps is None:
        arguments.steps = 4000 if arguments.model == "learned" else 2000
    torch.use_deterministic_algorithms(True)
    for path in filter(None, (arguments.out, arguments.probes)):
        weights.check_writable(path)  # before minutes of training, not after
    training = data.Split(arguments.data / "training")
    validation = data.Split(arguments.data / "validation")
    print(f"training: {len(training.scenes)} scenes, {len(training)} pixels; "
          f"validation: {len(validation.scenes)} scenes, {len(validation)} pixels", flush=True)
    start = time.time()

    def say(step, train_loss, held_loss):
        print(f"step {step:6d}/{arguments.steps}  training {train_loss:.6g}  "
              f"validation {held_loss:.6g}  {time.time() - start:.0f} s", flush=True)

    if arguments.model == "learned":
        net, losses = learned.train(training, validation, arguments.hidden, arguments.steps,
                                    arguments.batch, arguments.rate, arguments.seed, say)
        model, outputs, features, activation = (learned.MODEL, learned.OUTPUTS,
                                                training.learned_features, "none")
    else:
        label = "as_written" if arguments.as_written else arguments.label
        net, losses = thesis.train(training, validation, label, arguments.steps, arguments.seed, say)
        model, outputs, features, activation = (thesis.MODEL, thesis.OUTPUTS,
                                                training.thesis_features, "sigmoid")
        print(f"spread of what it says over validation pixels: {thesis.spread(net, validation):.3g} "
              "of its mean")
    # What a file holds is what is judged and probed.
    layers = [(weights.rounded(l.weight.detach().numpy()), weights.rounded(l.bias.detach().numpy()))
              for l in net.layers]
    with torch.no_grad():
        for layer, (weight, bias) in zip(net.layers, layers):
            layer.weight.copy_(torch.tensor(weight))
            layer.bias.copy_(torch.tensor(bias))
    weights.write_network(arguments.out, model, features, outputs, net.mean.numpy(),
                          net.scale.numpy(), layers, activation, command_of(arguments),
                          data.hash_of(arguments.data))
    if arguments.probes:
        write_probes(arguments.probes, net, True)
    if arguments.model == "learned":
        report("validation", learned.judge(net, validation))
        if (arguments.data / "test").is_dir():  # looked at, not learned from
            report("test", learned.judge(net, data.Split(arguments.data / "test")))
    print(f"{arguments.out}: {arguments.out.stat().st_size} bytes, validation loss "
          f"{losses[0]:.6g} to {losses[-1]:.6g}")
    if arguments.must_learn and not losses[-1] < losses[0]:
        sys.exit("train: the validation loss has not fallen")


if __name__ == "__main__":
    try:
        main()
    except (data.BadData, OSError) as error:
        sys.exit(f"train: {error}")
