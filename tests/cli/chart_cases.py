"""Experiments for the tests of macula chart, and what they share."""
import json
import os
import re
import shutil
import subprocess
import sys

MACULA = sys.argv[1]
SOURCE = os.environ["MACULA_SOURCE"]
BROWSER = shutil.which("chromium") or shutil.which("google-chrome")
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


def chart(folder, experiment, *options, check=True):
    path = os.path.join(folder, "experiment.toml")
    with open(path, "w", encoding="utf-8") as f:
        f.write(experiment)
    return subprocess.run([MACULA, "chart", path, "--out", os.path.join(folder, "out"), *options],
                          check=check, capture_output=True, text=True, cwd=folder)


def results(folder):
    with open(os.path.join(folder, "out", "results.json"), encoding="utf-8") as f:
        return json.load(f)


def opened(folder, page):
    """The page after its scripts have run, without a network."""
    profile = os.path.join(folder, "profile")
    done = subprocess.run(
        [BROWSER, "--headless=new", "--no-sandbox", "--disable-gpu", "--window-size=1400,1600",
         f"--user-data-dir={profile}", "--proxy-server=127.0.0.1:9", "--virtual-time-budget=5000",
         "--dump-dom", "file://" + page], capture_output=True, text=True, timeout=240)
    assert "<html" in done.stdout, done.stderr[-2000:]
    errors = re.search(r'<p id="script-errors"[^>]*>(.*?)</p>', done.stdout, re.S)
    assert errors and errors.group(1) == "" and "hidden" in errors.group(0), errors and errors.group(0)
    return done.stdout
