"""Files of `macula features` (tools/macula/README.md), read and put together."""

import hashlib
import json
import pathlib

import numpy as np

FORMAT = "macula-features"
VERSION = 1
ARRAYS = {"view", "pixel", "fragments", "thesis", "learned", "optimal_k", "least_rmse_k",
          "least_rmse_tail_k", "errors_begin", "errors", "errors_plain", "view_fragments",
          "view_pixels", "view_covered"}


class BadData(Exception):
    """One line that names the file and the fix."""


class Scene:
    """The rows of one file, one a sampled pixel."""

    def __init__(self, path):
        try:
            arrays = np.load(path)
            about = json.loads(bytes(arrays["about"]).decode())
            self.arrays = {name: arrays[name] for name in arrays.files if name != "about"}
        except Exception as error:
            raise BadData(f"{path}: not a file of features ({error}); write it again") from error
        if about.get("format") != FORMAT or about.get("version") != VERSION:
            raise BadData(f"{path}: not {FORMAT} version {VERSION}; write it again")
        if missing := sorted(ARRAYS - set(self.arrays)):
            raise BadData(f"{path}: without {', '.join(missing)}; write it again")
        self.path = path
        self.name = about["scene"]
        self.shares = about["shares"]
        self.thesis_features = about["thesis"]
        self.learned_features = about["learned"]

    def __getitem__(self, name):
        return self.arrays[name]

    def __len__(self):
        return len(self.arrays["pixel"])


class Split:
    """All scenes of a folder. They see the same features at the same budgets."""

    def __init__(self, folder):
        self.folder = folder
        paths = sorted(pathlib.Path(folder).glob("*.npz"))
        if not paths:
            raise BadData(f"{folder}: no .npz files; write them with 'macula features'")
        self.scenes = [Scene(path) for path in paths]
        if not len(self):
            raise BadData(f"{folder}: no pixels; write them with a larger --sample")
        first = self.scenes[0]
        for scene in self.scenes[1:]:
            if (scene.shares, scene.thesis_features, scene.learned_features) != (
                    first.shares, first.thesis_features, first.learned_features):
                raise BadData(f"{scene.path}: other budgets or features than {first.path}; write "
                              "both with one program")
        self.shares = first.shares
        self.thesis_features = first.thesis_features
        self.learned_features = first.learned_features

    def __len__(self):
        return sum(map(len, self.scenes))

    def rows(self, name):
        """The rows of all scenes of an array with one row a pixel."""
        return np.concatenate([scene[name] for scene in self.scenes])

    def weights(self):
        """For every row, so that each scene weighs the same."""
        return np.concatenate([np.full(len(s), 1.0 / max(len(s), 1)) for s in self.scenes])


def hash_of(folder):
    """SHA-256 over the names and contents of a folder's files, in order."""
    digest = hashlib.sha256()
    for path in sorted(pathlib.Path(folder).rglob("*.npz")):
        digest.update(path.relative_to(folder).as_posix().encode() + b"\0")
        digest.update(hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()
