#!/usr/bin/env python3
"""macula chart from outside: results, report in a browser without network, interruption, refusals."""
import csv
import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

MACULA = sys.argv[1]
SOURCE = os.environ["MACULA_SOURCE"]
TINY = """title = "Tiny </script> & <b>small</b>"
scenes = ["layers-16", "nowhere.glb"]
sizes = ["64x64"]
frames = 2
budgets = [{ k_ave = 4 }, { share = 0.5 }, { mib = 8000 }]
[[variant]]
id = "exact"
settings = { oit.method = "ab-sbuffer" }
[[variant]]
id = "limited"
settings = { oit.method = "kb-variable" }
budgets = true
[[target]]
name = "exact means exact"
kind = "value"
metric = "rmse"
of = "exact"
limit = "<= 0"
[[target]]
name = "a budget that nothing can meet"
kind = "value"
metric = "fragments.loss"
of = "limited"
budgets = ["k_ave 4"]
limit = "<= 0.01"
"""


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


SWEPT = """title = "Swept"
scenes = ["layers-16"]
sizes = ["64x64"]
frames = 2
base = "exact"
pixels_per_degree = 30
[[variant]]
id = "exact"
settings = { oit.method = "ab-sbuffer" }
[[variant]]
id = "more"
settings = { oit.method = "kb-variable" }
sweep = { "oit.kAve" = [12, 4.5, 2] }
[[variant]]
id = "less"
settings = { oit.method = "kb-variable", oit.tail = "none" }
sweep = { oit.kAve = [8, 3] }
[[target]]
name = "one point"
kind = "ratio"
metric = "rmse"
of = "more"
at = 2
against = "more"
against_at = 12
limit = "> 1"
[[target]]
name = "a curve"
kind = "curve"
metric = "psnr_db"
of = "more"
against = "less"
statistic = "mean"
limit = "> -1000"
"""

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

# What a reader does with the report, all of it.
USE = """<script>
for (const select of document.querySelectorAll('#view select')) {
  for (let i = select.options.length - 1; i >= 0; --i) {
    select.selectedIndex = i;
    select.dispatchEvent(new Event('change'));
  }
}
for (let i = 0; i < document.querySelectorAll('.tabs button').length; ++i) document.querySelectorAll('.tabs button')[i].click();
for (let i = 0; i < 2 * document.querySelectorAll('#table th').length; ++i) document.querySelectorAll('#table th')[i >> 1].click();
setTimeout(() => {  // charts draw after the present task
const viewer = document.getElementById('viewer');
let pictures = 0;
for (const opener of document.querySelectorAll('.dot, #table tbody tr')) {
  opener.dispatchEvent(new MouseEvent('mousemove', {clientX: 5, clientY: 5, bubbles: true}));
  opener.click();
  if (!viewer.open) continue;
  if ([...viewer.querySelectorAll('img')].every(i => i.src.startsWith('data:image/jpeg'))) ++pictures;
  viewer.querySelector('input').value = 30;
  viewer.querySelector('input').dispatchEvent(new Event('input'));
  viewer.close();
}
document.body.append(`used: ${pictures} pictures, divider at ${document.querySelector('.slider').style.getPropertyValue('--at')}`);
}, 300);
</script></body>"""


# Before all scripts: what charts write on their canvases.
RECORD = """<script>
const written = [];
const fillText = CanvasRenderingContext2D.prototype.fillText;
CanvasRenderingContext2D.prototype.fillText = function(text, ...at) { written.push(text); fillText.call(this, text, ...at); };
</script>"""

# What a reader without a mouse does, and where zeros stand.
KEYS = """<script>
setTimeout(() => {
  const facts = [];
  const lane = document.querySelector('#by-time .zero-lane');
  const edge = lane ? Number(lane.getAttribute('y')) : Infinity;
  for (const dot of document.querySelectorAll('#by-time .dot')) {
    facts.push((dot.classList.contains('exact') ? 'zero ' : 'other ') + (parseFloat(dot.style.top) > edge ? 'in' : 'out'));
  }
  facts.sort();
  const heading = name => [...document.querySelectorAll('#table th')].find(h => h.textContent === name);
  for (const times of [1, 2]) {
    const button = heading('RMSE').querySelector('button');
    button.focus();
    button.click();  // as Enter and the space bar do
    facts.push(`${heading('RMSE').getAttribute('aria-sort')} ${heading('RMSE').contains(document.activeElement)}`);
  }
  const viewer = document.getElementById('viewer');
  for (const key of ['Enter', ' ', 'x']) {
    const row = document.querySelector('#table tbody tr[tabindex="0"]');
    row.focus();
    row.dispatchEvent(new KeyboardEvent('keydown', {key, bubbles: true, cancelable: true}));
    facts.push(`${document.activeElement === row || viewer.open} ${viewer.open}`);
    viewer.close();
  }
  for (const row of document.querySelectorAll('#table tbody tr[tabindex="0"]')) {
    row.click();
    facts.push(viewer.querySelector('.pictures figcaption').textContent.split(':')[0] + '; '
      + (getComputedStyle(viewer.querySelector('.difference')).display === 'none') + '; ' + viewer.querySelector('.scale').textContent);
    viewer.close();
  }
  document.body.append(`written: ${JSON.stringify(written)}`, element('pre', {id: 'facts'}, facts.join('\\n')));
}, 300);
</script></body>"""


def chart(folder, experiment, *options, check=True):
    path = os.path.join(folder, "experiment.toml")
    with open(path, "w", encoding="utf-8") as f:
        f.write(experiment)
    return subprocess.run([MACULA, "chart", path, "--out", os.path.join(folder, "out"), *options],
                          check=check, capture_output=True, text=True, cwd=folder)


def results(folder):
    with open(os.path.join(folder, "out", "results.json"), encoding="utf-8") as f:
        return json.load(f)


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
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if browser is not None:
        dom = opened(browser, folder, os.path.join(folder, "out", "report.html"))
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


def opened(browser, folder, page):
    """The page after its scripts have run, without a network."""
    profile = os.path.join(folder, "profile")
    done = subprocess.run(
        [browser, "--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1400,1600",
         f"--user-data-dir={profile}", "--proxy-server=127.0.0.1:9", "--virtual-time-budget=5000",
         "--dump-dom", "file://" + page], capture_output=True, text=True, timeout=240)
    assert "<html" in done.stdout, done.stderr[-2000:]
    errors = re.search(r'<p id="script-errors"[^>]*>(.*?)</p>', done.stdout, re.S)
    assert errors and errors.group(1) == "" and "hidden" in errors.group(0), errors and errors.group(0)
    return done.stdout


def check_report(folder):
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if browser is None:
        print("skipped: no chromium for the report (apt-get install chromium)")
        return False
    page = os.path.join(folder, "out", "report.html")
    with open(page, encoding="utf-8") as f:
        text = f.read()
    addresses = set(re.findall(r"""(?:src|href)=["']?(?!data:)([a-z]+:)?//[^"' >]+""", text))
    assert not addresses, f"the page asks the network: {addresses}"
    dom = opened(browser, folder, page)
    foot = dom[dom.index("How this was made"):]
    assert "macula chart " in foot and "experiment.toml" in foot and "layers-16" in foot, foot[:2000]
    for chart_id, count in (("by-time", 3), ("by-bytes", 3)):
        at = dom.index(f'id="{chart_id}"')
        part = dom[at:dom.index("</figure>", at)]
        assert "<canvas" in part, f"{chart_id} is not drawn"
        assert part.count('class="dot') == count, f"{chart_id}: {part.count('class=')}"
        assert "<text" in part, f"{chart_id} has no labels"
    assert dom.count('class="bar-row"') == 6, "three rows in each of two bar charts"
    table = dom[dom.index('id="table"'):]
    made = results(folder)["points"]
    for point in made:
        assert f'<tr data-key="{point["key"]}"' in table, point["key"]
    assert "refused: " in table
    assert "MISSED" in dom and "1 met, 1 missed" in dom
    assert "nowhere.glb" in dom
    assert "<h1>Tiny &lt;/script&gt; &amp; &lt;b&gt;small&lt;/b&gt;</h1>" in dom
    used = page.replace("report.html", "used.html")
    with open(used, "w", encoding="utf-8") as f:
        f.write(text.replace("</body>", USE))
    # three points in two charts and three rows
    found = re.search(r"used: \d+ pictures, divider at [^<]*", opened(browser, folder, used))
    assert found and found.group(0) == "used: 9 pictures, divider at 30%", found
    check_alone(browser, folder, text, made)
    return True


def check_alone(browser, folder, text, made):
    """The page in an empty folder, read without a mouse: lanes of zeros, units, sorting, no dead links."""
    alone = os.path.join(folder, "alone")
    os.makedirs(alone)
    page = os.path.join(alone, "report.html")
    with open(page, "w", encoding="utf-8") as f:
        f.write(text.replace("<head>", "<head>" + RECORD).replace("</body>", KEYS))
    dom = opened(browser, folder, page)
    assert not re.search(r"<a [^>]*href=", dom[dom.index("</script>"):]), "a link to a file that is not there"
    written = json.loads(re.search(r"written: (\[.*?\])<", dom).group(1))
    assert "0" in written, "the lane of zeros has no label"
    for label in ("transparency, ms", "storage + overhead, MiB", "RMSE (display values, 0 to 1)"):
        assert label in written, (label, written)
    facts = re.search(r'<pre id="facts">(.*?)</pre>', dom, re.S).group(1).split("\n")
    assert facts[:8] == ["other out", "other out", "zero in", "ascending true", "descending true",
                         "true true", "true true", "true false"], facts
    exact = next(p for p in made if p["variant"] == "exact")
    assert exact["images"]["difference"] in dom and "Full size, in the folder of the results: " in dom
    assert sorted(fact.split(";")[0] for fact in facts[8:]) == [
        "Difference from the exact picture"] * 2 + ["No difference from the exact picture"], facts
    for fact in facts[8:]:
        _, hidden, scale = fact.split("; ")
        assert (hidden == "true") == fact.startswith("No") == (scale == ""), fact
        assert scale == "" or scale.endswith("and more, of 1 (99th percentile)"), fact


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
        assert point["batch"] == exact["batch"], "they took turns"
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
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if browser is None:
        return
    dom = opened(browser, folder, os.path.join(folder, "out", "report.html"))
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
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if browser is None:
        return
    dom = opened(browser, folder, os.path.join(folder, "out", "report.html"))
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


def check_interrupted(folder):
    """Killed in the middle: what was finished stays, the rest is measured by the next run."""
    scenes = ", ".join(f'"layers-{n}"' for n in range(2, 12))
    experiment = TINY.replace('"layers-16", "nowhere.glb"', scenes).replace("{ mib = 8000 }", "")
    experiment = experiment.replace("frames = 2", "frames = 60\npath_frames = 2")
    path = os.path.join(folder, "experiment.toml")
    with open(path, "w", encoding="utf-8") as f:
        f.write(experiment)
    points = os.path.join(folder, "out", "points.jsonl")
    run = subprocess.Popen([MACULA, "chart", path, "--out", os.path.join(folder, "out")],
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=folder)
    while run.poll() is None and (not os.path.exists(points) or os.path.getsize(points) == 0):
        time.sleep(0.005)
    run.kill()
    run.wait()
    assert not os.path.exists(os.path.join(folder, "out", "report.html")), "killed too late"
    with open(points, encoding="utf-8") as f:
        finished = [json.loads(line)["key"] for line in f if line.endswith("\n")]
    assert 3 <= len(finished) < 30, len(finished)
    with open(points, "a", encoding="utf-8") as f:
        f.write('{"key":"half a li')
    done = chart(folder, experiment)
    assert f"30 points: {30 - len(finished)} measured now, {len(finished)} kept" in done.stdout, done.stdout
    keys = [p["key"] for p in results(folder)["points"]]
    assert len(set(keys)) == 30 and set(finished) <= set(keys)
    return experiment


def check_asked_to_stop(folder, experiment):
    """SIGINT: the results so far are written, and the program says how to go on."""
    shutil.rmtree(os.path.join(folder, "out"))
    points = os.path.join(folder, "out", "points.jsonl")
    run = subprocess.Popen([MACULA, "chart", os.path.join(folder, "experiment.toml"), "--out",
                            os.path.join(folder, "out")], stdout=subprocess.DEVNULL,
                           stderr=subprocess.PIPE, text=True, cwd=folder)
    while run.poll() is None and (not os.path.exists(points) or os.path.getsize(points) == 0):
        time.sleep(0.005)
    run.send_signal(signal.SIGINT)
    _, stderr = run.communicate()
    finished = len(results(folder)["points"])
    assert run.returncode == 130 and stderr.startswith("macula: interrupted"), (run.returncode, stderr)
    assert 3 <= finished < 30 and results(folder)["interrupted"] is True
    page = os.path.join(folder, "out", "report.html")
    with open(page, encoding="utf-8") as f:
        assert f">Interrupted: {finished} of 30 points are finished" in f.read()
    done = chart(folder, experiment).stdout
    assert f"{30 - finished} measured now, {finished} kept" in done, done
    assert results(folder)["interrupted"] is False
    with open(page, encoding="utf-8") as f:
        assert 'id="interrupted"' not in f.read()


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
        seen = check_report(folder)
        with tempfile.TemporaryDirectory() as swept:
            check_sweep(swept)
        with tempfile.TemporaryDirectory() as moving:
            check_moving(moving)
        with tempfile.TemporaryDirectory() as mapped:
            check_heatmap(mapped)
        with tempfile.TemporaryDirectory() as learned:
            check_learned(learned)
        check_kept(folder)
        check_refusals(folder)
        check_oracles(folder)
    with tempfile.TemporaryDirectory() as folder:
        check_asked_to_stop(folder, check_interrupted(folder))
    print("chart: all checks passed", "" if seen else "(the report was not opened)")


main()
