#!/usr/bin/python3
"""tools/train/train.py: it learns, repeats, writes what macula renders with, and says what is wrong.

usage: train_test.py PROGRAM

Run by Debian's Python, the one that its packages python3-torch and python3-numpy belong to.
"""
import os
import shutil
import subprocess
import sys
import tempfile

try:
    import numpy
    __import__("torch")  # only to know that it is there: the program under test needs it
except ImportError as error:
    print(f"skipped: {error} (Debian's packages python3-torch and python3-numpy)")
    sys.exit(77)

MACULA = sys.argv[1]
TRAIN = os.path.join(os.environ["MACULA_SOURCE"], "tools", "train", "train.py")
WAYS = {"thesis": ("--method", "kb-learned"),
        "learned": ("--oit.importance", "learned", "--oit.fill", "on", "--oit.tail", "mean")}


def train(folder, model, out, *options, data="data"):
    return subprocess.run(["/usr/bin/python3", TRAIN, model, "--data", data, "--out", out,
                           "--steps", "300", "--seed", "3", *options], capture_output=True, text=True,
                          cwd=folder)


def render(folder, model, network):
    return subprocess.run([MACULA, "replay", "layers-5", "--size", "48x48", "--frames", "1", "--out",
                           "frames", *WAYS[model], "--oit.network", network], capture_output=True,
                          text=True, cwd=folder)


def bytes_of(folder, name):
    with open(os.path.join(folder, name), "rb") as f:
        return f.read()


def check_model(folder, model):
    first = train(folder, model, "first.safetensors", "--must-learn", "--probes",
                  "probes.safetensors")
    assert first.returncode == 0, first.stdout + first.stderr
    assert "step    300/300" in first.stdout, first.stdout
    again = train(folder, model, os.path.join("made", "again.safetensors"))
    assert again.returncode == 0, again.stderr
    weights = bytes_of(folder, "first.safetensors")
    assert weights == bytes_of(folder, os.path.join("made", "again.safetensors")), "one seed, one file"
    for place in (folder, "/tmp", "first.safetensors"):
        assert place.encode() not in weights, "nothing of this machine stands in it"
    assert b'"features":{"dtype":"F16","shape":[1000,' in bytes_of(folder, "probes.safetensors")
    assert not [name for name in os.listdir(folder) if name.endswith(".part")]
    done = render(folder, model, "first.safetensors")
    assert done.returncode == 0, done.stderr
    # The other method wants the other network.
    done = render(folder, "learned" if model == "thesis" else "thesis", "first.safetensors")
    assert done.returncode == 2 and done.stderr.count("\n") == 1, done.stderr
    assert "first.safetensors: it is a network for" in done.stderr, done.stderr
    assert "choose another oit.network" in done.stderr, done.stderr


def check_seed(folder):
    """Another seed is another file. Of the network that trains faster."""
    other = train(folder, "learned", "other.safetensors", "--seed", "4")
    assert other.returncode == 0, other.stderr
    assert bytes_of(folder, "first.safetensors") != bytes_of(folder, "other.safetensors")


def check_as_written(folder):
    """The thesis's text word by word says nothing; that is a finding and no error."""
    done = train(folder, "thesis", "written.safetensors", "--as-written", "--steps", "50")
    assert done.returncode == 0 and "spread of what it says" in done.stdout, done.stderr


def check_file(folder):
    """A file that is cut short is no network."""
    with open(os.path.join(folder, "cut.safetensors"), "wb") as f:
        f.write(bytes_of(folder, "first.safetensors")[:-2])
    done = render(folder, "learned", "cut.safetensors")
    assert done.returncode == 2 and done.stderr.count("\n") == 1, done.stderr
    assert "cut.safetensors: " in done.stderr, done.stderr


def damaged(folder, name, change):
    """A copy of the data with a changed training file."""
    shutil.copytree(os.path.join(folder, "data"), os.path.join(folder, name))
    path = os.path.join(folder, name, "training", "layers-3.npz")
    with numpy.load(path) as file:
        arrays = dict(file)
    change(arrays)
    numpy.savez(path, **arrays)
    return name


def check_refusals(folder):
    with open(os.path.join(folder, "data", "training", "layers-3.npz"), "rb") as f:
        whole = f.read()
    for name, content in (("text", b"hello"), ("short", whole[:len(whole) // 2])):
        shutil.copytree(os.path.join(folder, "data"), os.path.join(folder, name))
        with open(os.path.join(folder, name, "training", "layers-3.npz"), "wb") as f:
            f.write(content)

    def no_errors(arrays):
        del arrays["errors"]

    def version(arrays):
        about = arrays["about"].tobytes().replace(b'"version":1', b'"version":2')
        arrays["about"] = numpy.frombuffer(about, dtype=numpy.uint8)

    def shares(arrays):
        about = arrays["about"].tobytes().replace(b"0.1,0.2", b"0.1,0.3")
        arrays["about"] = numpy.frombuffer(about, dtype=numpy.uint8)
    damaged(folder, "lacking", no_errors)
    damaged(folder, "newer", version)
    damaged(folder, "budgets", shares)
    os.makedirs(os.path.join(folder, "empty", "training"))
    shutil.copytree(os.path.join(folder, "data"), os.path.join(folder, "nothing"))
    subprocess.run([MACULA, "features", "--size", "48x48", "--views", "1", "--sample", "0",
                    "--validation", "medley-7", "--out", "nothing"], check=True, cwd=folder,
                   stdout=subprocess.DEVNULL)
    shutil.copytree(os.path.join(folder, "data"), os.path.join(folder, "single"))
    subprocess.run([MACULA, "features", "--size", "48x48", "--views", "1", "--sample", "1",
                    "--validation", "layers-1", "--out", "single"], check=True, cwd=folder,
                   stdout=subprocess.DEVNULL)
    os.remove(os.path.join(folder, "single", "validation", "medley-7.npz"))
    file = os.path.join("training", "layers-3.npz")
    for data, words in (("nowhere", "nowhere/training: no .npz files"),
                        ("empty", "empty/training: no .npz files"),
                        ("text", os.path.join("text", file) + ": not a file of features"),
                        ("short", os.path.join("short", file) + ": not a file of features"),
                        ("lacking", os.path.join("lacking", file) + ": without errors"),
                        ("newer", os.path.join("newer", file) + ": not macula-features version 1"),
                        ("budgets", ": other budgets or features than"),
                        ("nothing", "nothing/validation: no pixels"),
                        ("single", "single/validation: no pixel has two fragments")):
        done = train(folder, "learned", "no.safetensors", data=data)
        assert done.returncode == 1 and done.stderr.count("\n") == 1, (data, done.stderr)
        assert done.stderr.startswith("train: ") and words in done.stderr, (data, done.stderr)
        assert not os.path.exists(os.path.join(folder, "no.safetensors")), data
    done = train(folder, "learned", os.path.join("first.safetensors", "no.safetensors"))
    assert done.returncode == 1 and done.stderr.count("\n") == 1, done.stderr
    assert "first.safetensors" in done.stderr and "step" not in done.stdout, done.stderr


def main():
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([MACULA, "features", "--size", "48x48", "--views", "2", "--sample", "1",
                        "--training", "layers-3", "medley-0", "--validation", "medley-7", "--out",
                        "data"], check=True, cwd=folder, stdout=subprocess.DEVNULL)
        check_model(folder, "thesis")
        check_model(folder, "learned")
        check_seed(folder)
        check_as_written(folder)
        check_file(folder)
        check_refusals(folder)
    print("train: all checks passed")


main()
