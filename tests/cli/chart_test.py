#!/usr/bin/env python3
"""macula chart from outside: results, oracles, what is kept, refusals."""
import csv
import hashlib
import json
import os
import re
import subprocess
import tempfile

from chart_cases import BROWSER, MACULA, SWEPT, TINY, chart, opened, results

# Where the budget stores everything, this target says nothing.
FITS = """
[[variant]]
id = "filled"
settings = { oit.method = "kb-variable", oit.fill = true }
budgets = true
[[target]]
name = "the budget is used twice over"
kind = "value"
metric = "budget_used"
of = "filled"
budgets = ["share 1"]
limit = ">= 2"
unless_all_stored = true
"""


def check_results(folder):
    done = chart(folder, TINY)
    assert "4 points: 4 measured now, 0 kept, 1 refused" in done.stdout, done.stdout
    assert "nowhere.glb: no such file" in done.stdout, done.stdout
    made = results(folder)
    assert [(p["variant"], p["budget"]) for p in made["points"]] == [
        ("exact", None), ("limited", "k_ave 4"), ("limited", "share 0.5"), ("limited", "8000 MiB")]
    exact, narrow, half, refused = made["points"]
    assert exact["error"]["rmse"] == 0 and exact["error"]["psnr_db"] is None, exact["error"]
    assert narrow["bytes"]["budget"] == 4 * 64 * 64 * 16
    assert half["bytes"]["budget"] == 0.5 * 16 * 64 * 64 * 16, half["bytes"]
    assert exact["difference_white"] == 0 < narrow["difference_white"] <= narrow["error"]["max"] + 1e-6
    assert narrow["error"]["rmse"] > 0 and narrow["fragments"]["loss"] > 0
    assert narrow["fragments"]["stored"] * 16 <= narrow["bytes"]["budget"]
    assert refused["status"] == "refused" and "lower" in refused["reason"], refused
    for point in (exact, narrow, half):
        for spread in (point["ms"]["total"], point["ms"]["transparency"]):
            assert 0 < spread["p5"] <= spread["median"] <= spread["p95"], spread
        assert point["rounds"] == 2
        for file in point["images"].values():
            assert os.path.exists(os.path.join(folder, "out", file)), file
    assert [t["state"] for t in made["targets"]] == ["met", "missed"], made["targets"]
    with open(os.path.join(folder, "out", "results.csv"), encoding="utf-8", newline="") as f:
        rows = list(csv.DictReader(f))
    assert len(rows) == 4
    assert float(rows[1]["rmse"]) == narrow["error"]["rmse"]
    assert float(rows[1]["ms.transparency"]) == narrow["ms"]["transparency"]["median"]
    assert rows[3]["reason"] == refused["reason"]
    made_from = made["provenance"]
    assert made_from["command"].startswith("macula chart "), made_from
    assert made_from["commit"] == made["commit"] and made_from["version"], made_from
    own = hashlib.sha256(TINY.encode()).hexdigest()
    assert made_from["experiment"]["sha256"] == own, made_from
    # A file that is not there was not read.
    assert [s["name"] for s in made_from["scene"]] == ["layers-16"], made_from["scene"]
    assert [c["name"] for c in made_from["camera"]] == ["auto"] and made_from["seed"] == [1]


def check_oracles(folder):
    """With room for every fragment an oracle's image is the exact one; with less it is not."""
    done = chart(folder, TINY.replace("[[target]]", """[[variant]]
id = "optimal-k"
oracle = "optimal-k"
budgets = true
[[variant]]
id = "least-rmse-tail"
oracle = "least-rmse-tail"
budgets = true
[[target]]""", 1).replace("{ mib = 8000 }", "{ share = 1.0 }") + FITS)
    row = results(folder)["targets"][-1]
    assert (row["state"], row["reason"]) == ("n/a", "everything fits"), row
    assert re.search(r"^  n/a: everything fits +[0-9.]+  layers-16", done.stdout, re.M), done.stdout
    assert "targets: 1 met, 1 missed, 1 n/a, 0 unmeasured" in done.stdout, done.stdout
    if BROWSER is not None:
        dom = opened(folder, os.path.join(folder, "out", "report.html"))
        assert "1 met, 1 missed, 1 n/a, 0 not measured" in dom and ">n/a: everything fits<" in dom
    points = [p for p in results(folder)["points"] if p["variant"] in ("optimal-k", "least-rmse-tail")]
    assert len(points) == 6
    if all(p["status"] == "refused" and "not part of this build" in p["reason"] for p in points):
        print("skipped: this build has no oracles")
        return
    for point in points:
        assert point["status"] == "oracle" and "ms" not in point, point
        rmse, fragments = point["error"]["rmse"], point["fragments"]
        # half-floats in storage: 11 bits
        assert rmse < 0.002 if point["budget"] == "share 1" else rmse > 0.005, (point["variant"], rmse)
        assert fragments["generated"] == 16 * 64 * 64, fragments
        assert (fragments["lost"] == 0) == (point["budget"] == "share 1" or "tail" in point["variant"])


def check_kept(folder):
    before = results(folder)["points"]
    assert "4 points: 0 measured now, 4 kept" in chart(folder, TINY).stdout
    assert results(folder)["points"] == before, "kept points change no number"
    assert json.loads(chart(folder, TINY, "--json", "-").stdout) == results(folder)
    changed = chart(folder, TINY.replace("frames = 2", "frames = 3")).stdout
    assert "4 points: 4 measured now, 0 kept" in changed, changed
    chart(folder, TINY)
    lost = before[1]["images"]["image"]
    os.remove(os.path.join(folder, "out", lost))
    assert "4 points: 4 measured now, 0 kept" in chart(folder, TINY).stdout, "a lost image"
    assert os.path.exists(os.path.join(folder, "out", lost))


def check_refusals(folder):
    def refuses(experiment, word):
        done = chart(folder, experiment, check=False)
        lines = done.stderr.splitlines()
        assert done.returncode == 2 and len(lines) == 1 and word in lines[0], done.stderr
        print("ok", lines[0])

    refuses(TINY.replace("oit.method = \"kb-v", "oit.metod = \"kb-v"), "experiment.toml:11: ")
    refuses(TINY.replace("kb-variable", "kb-variabel"), "experiment.toml:11: ")
    refuses(TINY.replace("layers-16", "smok"), "smok")
    refuses(TINY.replace("layers-16", "smok"), "the nearest is 'smoke' of gallery, ")
    refuses(TINY.replace("layers-16", "nowhere/smoke"), "no such file; check the path")
    refuses(TINY.replace("frames = 2", "frames = 2\nsettings = { oit.kAve = 2, oit.memoryMiB = 8 }"),
            "drop oit.kAve to keep 8 MiB, or oit.memoryMiB to keep 2 fragments/sample")
    refuses(TINY.replace("kb-variable\" }", "kb-variable\", oit.memoryMiB = 8 }"),
            "measured at the budgets of its study")
    refuses("settings = { oit.memoryMiB = 8 }\n" + SWEPT, "cannot hold together")
    refuses(SWEPT.replace("4.5, 2]", "0, 2]"), "experiment.toml:13: ")
    refuses(SWEPT.replace("oit.kAve = [8", "oit.kAev = [8"), "'oit.kAve'")
    refuses(SWEPT.replace("oit.kAve = [8, 3]", "frame.seed = [8, 3]"), "decides what is loaded")
    refuses(TINY.replace("kb-variable\" }", "kb-variable\", frame.seed = 7 }"), "decides what is loaded")
    refuses(TINY.replace("frames = 2", "frame = 2"), "'frames'")
    refuses(TINY.replace("frames = 2", "path_frames = 1"), "experiment.toml:4: ")
    refuses(TINY.replace("frames = 2", "optional_scenes = [\"smoke\"]"), "name it under scenes")
    done = subprocess.run([MACULA, "chart", "quik", "--out", folder], capture_output=True, text=True)
    assert done.returncode == 2 and "did you mean 'quick'" in done.stderr, done.stderr


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_results(folder)
        check_kept(folder)
        check_refusals(folder)
        check_oracles(folder)
    print("chart: all checks passed")


main()
