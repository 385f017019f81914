#!/usr/bin/python3
"""macula features: arrays, labels, determinism and refusals.

usage: features_test.py PROGRAM

Run by Debian's Python, the one that its package python3-numpy belongs to.
"""
import hashlib
import json
import os
import subprocess
import sys
import tempfile

try:
    import numpy
except ImportError:
    print("skipped: python3-numpy is not installed")
    sys.exit(77)

MACULA = sys.argv[1]
PIXELS = 48 * 48
VIEWS = 2
SHARES = [0.1, 0.2, 0.3, 0.4, 0.5]
SMALL = ("--size", "48x48", "--views", str(VIEWS))
ARRAYS = {  # type and columns
    "view": ("<u2", ()), "pixel": ("<u4", ()), "fragments": ("<u4", ()),
    "thesis": ("<f4", (12,)), "learned": ("<f4", (60,)),
    "optimal_k": ("<u2", (5,)), "least_rmse_k": ("<u2", (5,)), "least_rmse_tail_k": ("<u2", (5,))}


def features(folder, *options, status=0):
    done = subprocess.run([MACULA, "features", *options], capture_output=True, text=True, cwd=folder)
    assert done.returncode == status, (done.returncode, done.stderr)
    if status == 2:
        assert done.stderr.count("\n") == 1, done.stderr
        return done.stderr
    return done.stdout


def read(*path):
    with numpy.load(os.path.join(*path), allow_pickle=False) as arrays:
        return {name: arrays[name] for name in arrays}


def digest(*path):
    with open(os.path.join(*path), "rb") as f:
        return hashlib.sha256(f.read()).hexdigest()


def check_shapes(scene, name, split):
    about = json.loads(scene["about"].tobytes())
    assert about["format"] == "macula-features" and about["version"] == 1
    assert (about["scene"], about["split"], about["views"]) == (name, split, VIEWS), about
    assert about["shares"] == SHARES and about["size"] == "48x48"
    assert len(about["thesis"]) == 12 and len(about["learned"]) == 60
    rows = len(scene["pixel"])
    assert rows > 0
    for array, (kind, columns) in ARRAYS.items():
        assert scene[array].dtype.str == kind, (array, scene[array].dtype)
        assert scene[array].shape == (rows, *columns), (array, scene[array].shape)
    assert set(scene) == {*ARRAYS, "about", "errors_begin", "errors", "errors_plain",
                          "view_fragments", "view_covered",
                          "view_pixels"}, set(scene)
    assert (scene["view_pixels"] == PIXELS).all() and len(scene["view_pixels"]) == VIEWS
    assert scene["view"].max() < VIEWS and scene["pixel"].max() < PIXELS
    place = scene["view"].astype(int) * PIXELS + scene["pixel"]
    assert (numpy.diff(place) > 0).all(), "each pixel once, in order"


def check_errors(scene):
    """A curve for each pixel: an error for every number of slots, the last one 0."""
    begin = scene["errors_begin"].astype(int)
    assert begin[0] == 0 and begin[-1] == len(scene["errors"])
    assert (numpy.diff(begin) == scene["fragments"] + 1).all()
    assert (scene["errors"][begin[1:] - 1] == 0).all()
    assert (scene["errors"] >= 0).all() and (scene["errors"] <= 3).all(), "display values, squared"


def check_labels(scene):
    """All covered pixels were sampled, so that labels can be summed."""
    for view in range(VIEWS):
        rows = scene["view"] == view
        counts = scene["fragments"][rows].astype(int)
        fragments = int(scene["view_fragments"][view])
        assert counts.sum() == fragments and (counts > 0).all()
        for b, share in enumerate(SHARES):
            budget = int(share * fragments)
            for label in ("optimal_k", "least_rmse_k", "least_rmse_tail_k"):
                k = scene[label][rows, b].astype(int)
                assert (k <= counts).all(), label
                if label == "optimal_k":
                    # Optimal K leaves every pixel its last fragment.
                    assert k.sum() == max(budget, len(counts)), (share, k.sum(), budget)
                    assert (k >= 1).all()
                else:
                    # Slots that would only raise the error stay unused; there are few.
                    assert 0.9 * budget <= k.sum() <= budget, (label, share, k.sum(), budget)


def check_features(scene):
    for view in range(VIEWS):
        rows = scene["view"] == view
        thesis = scene["thesis"][rows]
        fragments = float(scene["view_fragments"][view])
        share = scene["fragments"][rows] * float(scene["view_covered"][view]) / fragments
        assert numpy.allclose(thesis[:, 0], share, rtol=1e-5)
        assert numpy.allclose(thesis[:, 1], SHARES[0]), "the first budget's, for the trainer to change"
        near, far, scene_near, scene_far = thesis[:, 2], thesis[:, 3], thesis[:, 4], thesis[:, 5]
        assert (near <= far).all() and (scene_near <= near).all() and (far <= scene_far).all()
        assert near.min() == scene_near[0] and far.max() == scene_far[0]
        assert (scene["fragments"][rows] > 1).any() and (near < far).any()
        learned = scene["learned"][rows]
        assert numpy.allclose(learned[:, 0], numpy.log2(scene["fragments"][rows]), atol=1e-5)
        assert numpy.allclose(learned[:, 17:25].sum(1), 1, atol=1e-5), "shares of slices"
        assert (numpy.diff(learned[:, 9:17], axis=1) <= 1e-6).all(), "less and less passes"
        assert (learned[:, 33:60] >= 0).all() and (learned[:, 33:60] <= 1).all(), "shown colours"
    assert numpy.isfinite(scene["thesis"]).all() and numpy.isfinite(scene["learned"]).all()


def check_layers(scene):
    """layers-3 by hand: three layers at 1, 5.5 and 10 m, of alpha 1/3, 1/2 and 1, in every pixel."""
    rows = scene["view"] == 0
    assert rows.sum() == PIXELS and (scene["fragments"] == 3).all()
    assert numpy.allclose(scene["thesis"][:, 0], 1)
    learned = scene["learned"][rows]
    # 5.5 m is half of the way: 1 / 1.5 = 0.67, in the sixth of eight slices.
    third = 1 / 3
    assert numpy.allclose(learned[:, 17:25], [third, 0, 0, 0, 0, third, 0, third], atol=1e-5)
    assert numpy.allclose(learned[:, 9:16], [2 * third] * 5 + [third] * 2, atol=1e-3), "passes"


def check_content(folder):
    out = features(folder, *SMALL, "--training", "layers-3", "--test", "medley-2", "--sample", "1",
                   "--out", "all")
    assert out.count(" pixels\n") == 2, out
    for name, split in (("layers-3", "training"), ("medley-2", "test")):
        scene = read(folder, "all", split, name + ".npz")
        check_shapes(scene, name, split)
        check_errors(scene)
        check_labels(scene)
        if split == "test":
            check_features(scene)
        else:
            check_layers(scene)
    return read(folder, "all", "test", "medley-2.npz")


def check_samples(folder, whole):
    """A seed is a sample; a sample has the rows of the whole."""
    def run(out, *options):
        report = json.loads(features(folder, *SMALL, "--test", "medley-2", "--sample", "0.3", "--out",
                                     out, "--json", "-", *options))
        scene = read(folder, out, "test", "medley-2.npz")
        assert report["scenes"] == [{"file": os.path.join(out, "test", "medley-2.npz"),
                                     "split": "test", "pixels": len(scene["pixel"])}], report
        return scene
    first, other = run("first"), run("other", "--seed", "7")
    run("again")
    assert digest(folder, "first", "test", "medley-2.npz") == digest(folder, "again", "test",
                                                                     "medley-2.npz")
    assert set(first["pixel"]) != set(other["pixel"]), "another seed is another sample"
    share = len(first["pixel"]) / len(whole["pixel"])
    assert 0.25 < share < 0.35, share
    place = {(v, p): i for i, (v, p) in enumerate(zip(whole["view"], whole["pixel"]))}
    rows = [place[v, p] for v, p in zip(first["view"], first["pixel"])]
    for array in ARRAYS:
        assert (first[array] == whole[array][rows]).all(), array
    shorter = read(folder, "first", "test", "medley-2.npz")
    assert (shorter["view_fragments"] == whole["view_fragments"]).all()


def check_refusals(folder):
    open(os.path.join(folder, "file"), "w").close()
    for options, words in (
            (("--out", "no"), "name scenes, as --training"),
            (("--training", "layers-3", "--test", "layers-3", "--out", "no"),
             "'layers-3' is named twice"),
            (("--test", "layers-3", "--out", "all"), "was written there as a scene of another split"),
            (("--training", "chess", "--out", "no"), "nothing in 'chess' is transparent"),
            (("--training", "chesss", "--out", "no"), "chess"),
            (("--training", "layers-3", "--out", "file"), "file"),
            (("--training", "layers-3"), "--out"),
            (("--training", "layers-3", "--out", "no", "--sample", "2"), "--sample"),
            (("--training", "layers-3", "--out", "no", "--shares", "1.5"), "--shares"),
            (("--training", "layers-3", "--out", "no", "--views", "0"), "--views"),
            (("--training", "layers-3", "--out", "no", "--size", "0x0"), "--size")):
        # A repeated option is the test's own, which comes last.
        usual = [] if "--size" in options or "--views" in options else SMALL
        message = features(folder, *usual, *options, status=2)
        assert words in message, (options, message)
    for path, _, files in os.walk(os.path.join(folder, "no")):
        assert not files, (path, files)


def check_opaque(folder):
    """What the refusal of an opaque scene proposes works."""
    features(folder, "--size", "48x48", "--views", "1", "--training", "chess", "--scene.opacity", "0.5",
             "--out", "opaque")
    assert read(folder, "opaque", "training", "chess.npz")["fragments"].max() > 1


def main():
    with tempfile.TemporaryDirectory() as folder:
        whole = check_content(folder)
        check_samples(folder, whole)
        check_refusals(folder)
        check_opaque(folder)
    print("features: all checks passed")


main()
