#!/usr/bin/python3
"""NumPy reads what Macula writes: types, shapes and values of a .npz with an array of each type.

Run by Debian's Python, the one that its package python3-numpy belongs to.
"""
import json
import os
import subprocess
import sys
import tempfile
import zipfile

try:
    import numpy
except ImportError:
    print("skipped: python3-numpy is not installed")
    sys.exit(77)

SAMPLE = os.path.join(os.environ["MACULA_BUILD"], "npz_sample")
EXPECTED = {
    "singles": ("<f4", [[0, 0.5, -1], [1e-40, 3.25, 1e30]]),
    "bytes": ("|u1", [0, 1, 255]),
    "shorts": ("<u2", [[[258], [65535]]]),
    "words": ("<u4", 4278255873),
    "longs": ("<u8", [1, 2**64 - 2]),
    "none": ("<f4", numpy.zeros((0, 4))),
}


def main():
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "sample.npz")
        subprocess.run([SAMPLE, path], check=True)
        with zipfile.ZipFile(path) as archive:
            assert archive.testzip() is None
            assert all(info.compress_type == zipfile.ZIP_DEFLATED for info in archive.infolist())
        with numpy.load(path, allow_pickle=False) as arrays:
            assert list(arrays) == [*EXPECTED, "about"], list(arrays)
            for name, (kind, values) in EXPECTED.items():
                expected = numpy.array(values, dtype=kind)
                found = arrays[name]
                assert found.dtype.str == kind, (name, found.dtype.str)
                assert found.shape == expected.shape, (name, found.shape)
                assert found.flags.c_contiguous, name
                assert (found == expected).all(), (name, found)
            assert json.loads(arrays["about"].tobytes())["scene"] == "café"
    print(len(EXPECTED) + 1, "arrays read by NumPy", numpy.__version__)


main()
