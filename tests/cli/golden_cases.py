"""What the stored golden images show, and how one is drawn; for the tests on each driver."""
import json
import os
import subprocess
import sys

MACULA = sys.argv[1]
GOLDEN = os.path.join(os.environ["MACULA_SOURCE"], "tests", "golden")
COUNTS = os.path.join(GOLDEN, "counts.json")
CASES = [(scene, method) for scene in ("layers-6", "smoke", "bottles", "gallery")
         for method in ("blend", "ab-sbuffer", "kb-variable")]


def draw(folder, scene, method, environment):
    """Draws one case. @returns its report"""
    subprocess.run([MACULA, "replay", scene, "--method", method, "--k-ave", "1", "--camera",
                    "scene", "--gaze", "0.4,0.6", "--frames", "1", "--size", "96x64", "--images",
                    "png", "--platform", "surfaceless", "--out", folder], check=True,
                   stdout=subprocess.DEVNULL, env={**os.environ, **environment})
    with open(os.path.join(folder, "report.json"), encoding="utf-8") as f:
        return json.load(f)


def drawn_image(folder):
    return os.path.join(folder, "frame_00000.png")


def stored_image(scene, method):
    return os.path.join(GOLDEN, f"{scene}_{method}.png")


def counts(report):
    """What may differ on no driver: fragments, k and exactness."""
    return {key: report["frames"][0][key] for key in ("fragments", "k", "exact")}


def without_hash(frame):
    """The counts of a stored configuration's frame."""
    return {key: value for key, value in frame.items() if key != "image_sha256"}


def stored_counts():
    with open(COUNTS, encoding="utf-8") as f:
        return json.load(f)


def equal(stored, made):
    """Whether two image files are the same bytes, as equal pixels written by one library are."""
    with open(stored, "rb") as a, open(made, "rb") as b:
        return a.read() == b.read()


def difference(stored, made):
    """@returns the errors between two images, as `macula compare` says them"""
    printed = subprocess.run([MACULA, "compare", stored, made, "--json", "-"], check=True,
                             capture_output=True, text=True).stdout
    return json.loads(printed)
