#!/usr/bin/env python3
"""Studies of macula chart: sweeps, camera paths, heat maps, learned importance."""
import csv
import os
import re
import tempfile

from chart_cases import BROWSER, SOURCE, SWEPT, chart, opened, results

MOVING = """title = "Moving"
scenes = ["smoke", "layers-8"]
optional_scenes = ["nowhere.glb", "neither.gltf"]
sizes = ["64x64", "48x48"]
frames = 1
path_frames = 4
path_fps = 10
flip_maps = true
budgets = [{ k_ave = 4 }]
[[variant]]
id = "exact"
settings = { oit.method = "ab-sbuffer" }
[[variant]]
id = "limited"
settings = { oit.method = "kb-fixed" }
budgets = true
[[variant]]
id = "refused"
settings = { oit.method = "kb-variable", oit.memoryMiB = 8000 }
[[variant]]
id = "best"
oracle = "optimal-k"
budgets = true
[[target]]
name = "motion is not free"
kind = "value"
metric = "flicker"
of = "limited"
scenes = ["smoke"]
limit = "> 0"
[[target]]
name = "the path is about as far off as the still frame"
kind = "mean"
metric = "path_rmse"
of = "limited"
against = "limited"
against_metric = "rmse"
limit = "<= 2"
"""


def check_sweep(folder):
    """Points of a sweep, their speed-ups, targets on them, and their chart."""
    done = chart(folder, SWEPT)
    assert "6 points: 6 measured now, 0 kept" in done.stdout, done.stdout
    made = results(folder)
    assert [(p["label"], p["sweep"]) for p in made["points"]] == [
        ("exact", None), ("more kAve=12", 12), ("more kAve=4.5", 4.5), ("more kAve=2", 2),
        ("less kAve=8", 8), ("less kAve=3", 3)]
    exact = made["points"][0]
    for point in made["points"]:
        assert point["batch"] == exact["batch"], "their frames are interleaved"
        assert point["speedup"] == exact["ms"]["total"]["median"] / point["ms"]["total"]["median"]
        assert point["sweep"] is None or point["settings"]["oit.kAve"] == point["sweep"], point["settings"]
        assert point["error"]["flip_gaze"] >= 0 and point["ms"]["shading"]["median"] >= 0
    ratio, curve = made["targets"]
    errors = [p["error"]["rmse"] for p in made["points"][1:4]]
    assert errors[0] < errors[1] < errors[2], errors
    assert ratio["where"] == "layers-16 64x64, kAve=2" and ratio["state"] == "met", ratio
    assert abs(ratio["value"] - errors[2] / errors[0]) < 1e-9, ratio
    # Times decide whether the curves share a speed-up at all.
    assert curve["state"] in ("met", "unmeasured") and curve["note"], curve
    with open(os.path.join(folder, "out", "results.csv"), encoding="utf-8", newline="") as f:
        rows = list(csv.DictReader(f))
    assert [row["sweep"] for row in rows] == ["", "12.0", "4.5", "2.0", "8.0", "3.0"], rows
    assert float(rows[2]["speedup"]) == made["points"][2]["speedup"]
    assert float(rows[2]["ms.shading"]) == made["points"][2]["ms"]["shading"]["median"]
    assert "6 points: 0 measured now, 6 kept" in chart(folder, SWEPT).stdout
    changed = SWEPT.replace("pixels_per_degree = 30", "pixels_per_degree = 31")
    assert "6 points: 6 measured now, 0 kept" in chart(folder, changed).stdout
    if BROWSER is None:
        return
    dom = opened(folder, os.path.join(folder, "out", "report.html"))
    at = dom.index('id="by-speed"')
    part = dom[at:dom.index("</figure>", at)]
    assert "<canvas" in part and part.count('class="dot') == 6, part.count('class="dot')
    for label in ("12", "4.5", "2", "exact"):
        assert re.search(rf"<text[^>]*>{label}</text>", part), f"{label} stands at no point"


def check_moving(folder):
    """Frames along the camera's path, optional scenes, FLIP maps, means over scenes."""
    done = chart(folder, MOVING)
    for name in ("nowhere.glb", "neither.gltf"):
        lines = [line for line in done.stdout.splitlines() if name in line]
        assert lines == [f"skipped: {name}: optional, and not here"], done.stdout
    made = results(folder)
    assert [s["what"] for s in made["skipped"]] == ["nowhere.glb", "neither.gltf"], made["skipped"]
    assert len(made["points"]) == 16, len(made["points"])
    for point in made["points"]:
        if point["status"] == "refused":
            assert "path" not in point
            continue
        assert os.path.exists(os.path.join(folder, "out", point["images"]["flip"])), point["images"]
        if point["status"] == "oracle":
            assert "path" not in point, "oracles do not walk"
            continue
        path = point["path"]
        assert (path["frames"], path["fps"]) == (4, 10), path
        assert point["rounds"] == 1, "frames of the path are no rounds"
        if point["variant"] == "exact":
            assert path["flicker"] == 0 and path["rmse"] == 0, path
        else:
            # Layers are seen by a camera that stays.
            assert (path["flicker"] > 0) == (point["scene"] == "smoke") and path["rmse"] > 0, path
    moves, mean = made["targets"][:2], made["targets"][2:]
    assert [t["state"] for t in moves] == ["met"] * 2, moves
    assert [t["where"] for t in mean] == [
        f"mean of 2 scenes, {size}, k_ave 4" for size in ("64x64", "48x48")], mean
    ratios = [p["path"]["rmse"] / p["error"]["rmse"] for p in made["points"]
              if p["variant"] == "limited" and p["width"] == 64]
    assert abs(mean[0]["value"] - sum(ratios) / 2) < 1e-9, (mean[0], ratios)
    with open(os.path.join(folder, "out", "results.csv"), encoding="utf-8", newline="") as f:
        rows = list(csv.DictReader(f))
    for row, point in zip(rows, made["points"], strict=True):
        number = point.get("path", {}).get("flicker")
        assert row["flicker"] == "" if number is None else float(row["flicker"]) == number, row
    assert "16 points: 0 measured now, 16 kept" in chart(folder, MOVING).stdout
    slower = chart(folder, MOVING.replace("path_fps = 10", "path_fps = 5")).stdout
    assert "16 points: 12 measured now, 4 kept" in slower, slower  # oracles are kept
    if BROWSER is None:
        return
    dom = opened(folder, os.path.join(folder, "out", "report.html"))
    maps = dom[dom.index('id="maps"'):dom.index('id="table"')]
    assert maps.count("<img") == 4, "the exact picture and three maps"
    passes = dom[dom.index('id="pass-times"'):dom.index('id="maps"')]
    assert "oit.capture" in passes and passes.count("<tr>") == 3, "a row for each that was timed"
    assert ">Flicker<" in dom and dom.count("nowhere.glb: optional, and not here") == 1


def check_heatmap(folder):
    """A variant with a heat map shows it, and its errors and differences are those of its image."""
    chart(folder, """title = "Mapped"
scenes = ["layers-8"]
sizes = ["64x64"]
frames = 1
budgets = [{ k_ave = 4 }]
[[variant]]
id = "plain"
settings = { oit.method = "kb-variable" }
budgets = true
[[variant]]
id = "mapped"
settings = { oit.method = "kb-variable", view.heatmap = "k" }
budgets = true
""")
    plain, mapped = results(folder)["points"]
    pictures = {}
    for point in (plain, mapped):
        for role in ("image", "difference"):
            with open(os.path.join(folder, "out", point["images"][role]), "rb") as f:
                pictures[point["variant"], role] = f.read()
    assert plain["error"] == mapped["error"] and plain["error"]["rmse"] > 0
    assert pictures["plain", "image"] != pictures["mapped", "image"]
    assert pictures["plain", "difference"] == pictures["mapped", "difference"]


def check_learned(folder):
    """The ready-made experiment of networks, cut down; the models are not beside this folder."""
    with open(os.path.join(SOURCE, "assets", "experiments", "learned.toml"), encoding="utf-8") as f:
        text = f.read()
    for whole, less in ((r'"(512x512|1024x1024|384x384)"', '"48x48"'),
                        (r'"smoke", "bottles", "hair", "greenhouse"', '"layers-12", "layers-20"'),
                        (r"(?m)^frames = \d+", "frames = 1"), (r"path_frames = \d+", "path_frames = 2"),
                        (r"\{ share = 0\.3 \}, \{ share = 0\.5 \}", "{ share = 0.3 }")):
        text, count = re.subn(whole, less, text)
        assert count > 0, f"learned.toml has no {whole} to cut down"
    done = chart(folder, text)
    assert "0 refused" in done.stdout, done.stdout
    assert done.stdout.count("LittlestTokyo.glb: optional, and not here") == 1, done.stdout
    made = results(folder)
    learned = [p for p in made["points"] if "learned" in p["variant"]]
    assert learned and all(p["error"]["rmse"] > 0 for p in learned)
    for point in learned:
        assert point["ms"]["passes"]["oit.network"]["median"] >= 0
    walked = [p for p in made["points"] if p.get("path")]
    assert {p["study"] for p in walked} == {"flicker"} and len(walked) == 12, len(walked)
    assert all(t["state"] != "unmeasured" for t in made["targets"]), made["targets"]


def main():
    with tempfile.TemporaryDirectory() as folder:
        for check in (check_sweep, check_moving, check_heatmap, check_learned):
            own = os.path.join(folder, check.__name__)
            os.mkdir(own)
            check(own)
    print("chart studies: all checks passed")


main()
