#!/usr/bin/env python3
"""What happens to the folder of --out, and to a run that is interrupted.

usage: output_test.py PROGRAM

Ctrl-C comes when the bar on the terminal says that a first step is done, so nothing here waits for
a time.
"""
import csv
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile

from interrupted import interrupted as run_interrupted

MACULA = sys.argv[1]
SOURCE = os.environ["MACULA_SOURCE"]
LOG = os.path.join(SOURCE, "assets", "gallery_gaze.csv")
SMALL = ("--size", "32x32")
REPLAY = ("replay", "layers-2", *SMALL, "--warmup", "0")
EXPERIMENT = """title = "Long"
scenes = ["layers-2", "layers-3"]
sizes = ["32x32"]
frames = 10000
[[variant]]
id = "exact"
settings = { oit.method = "ab-sbuffer" }
"""


def macula(*options, status=0, folder="."):
    done = subprocess.run([MACULA, *options], capture_output=True, text=True, cwd=folder)
    assert done.returncode == status, (options, done.returncode, done.stderr)
    if status == 2:
        assert done.stderr.count("\n") == 1, done.stderr
    return done.stderr if status else done.stdout


def read_json(*path):
    with open(os.path.join(*path), encoding="utf-8") as f:
        return json.load(f)


def tree(folder):
    return {os.path.relpath(os.path.join(path, name), folder): os.path.getmtime(os.path.join(path, name))
            for path, _, names in os.walk(folder) for name in names}


def check_replay_again(folder):
    """The same folder again and again, however it is written, and the frames of a longer run go."""
    os.mkdir(os.path.join(folder, "out"))  # there, and empty
    for out, frames in (("out", 3), ("out/", 2), ("./out", 1), (os.path.join(folder, "out"), 1)):
        macula(*REPLAY, "--frames", str(frames), "--images", "png", "--out", out, folder=folder)
        names = {f"frame_{i:05}.png" for i in range(frames)}
        assert set(os.listdir(os.path.join(folder, "out"))) == {"report.json", "macula-output.txt", *names}
        assert read_json(folder, "out", "report.json")["interrupted"] is False
    mine = os.path.join(folder, "out", "frame_00009.png")
    open(mine, "w").close()
    before = tree(os.path.join(folder, "out"))
    macula("replay", "no-such-scene", "--out", "out", status=2, folder=folder)
    assert tree(os.path.join(folder, "out")) == before, "a refused run leaves what was there"
    macula(*REPLAY, "--frames", "1", "--out", "out", folder=folder)
    assert not os.path.exists(os.path.join(folder, "out", "frame_00000.png"))
    assert os.path.exists(mine), "what no manifest names stays"
    os.mkdir(os.path.join(folder, "logged"))
    with open(os.path.join(folder, "logged", "log.txt"), "w") as log:  # of the run itself
        subprocess.run([MACULA, *REPLAY, "--frames", "1", "--out", "logged"], check=True, cwd=folder,
                       stdout=log)


def check_refused(folder):
    """Every subcommand: a folder with something else, and one with another's output."""
    with open(os.path.join(folder, "long.toml"), "w", encoding="utf-8") as f:
        f.write(EXPERIMENT.replace("10000", "1"))
    commands = {
        "replay": (*REPLAY, "--frames", "1"),
        "hold": ("hold", "layers-2", *SMALL, "--frames", "30", "--warmup", "1"),
        "chart": ("chart", "long.toml"),
        "features": ("features", "--training", "layers-2", *SMALL, "--views", "1"),
        "gaze study": ("gaze", "study", LOG, "--latencies", "0"),
    }
    other = os.path.join(folder, "other")
    os.mkdir(other)
    with open(os.path.join(other, "notes.txt"), "w") as f:
        f.write("mine")
    before = tree(other)
    for name, command in commands.items():
        message = macula(*command, "--out", "other", status=2, folder=folder)
        assert "'notes.txt'" in message and "--force" in message, message
        message = macula(*command, "--out", "logged", status=0 if name == "replay" else 2, folder=folder)
        assert name == "replay" or "holds the output of 'macula replay'" in message, message
    macula("hold", "--plant", "--seeds", "1", "--out", "other", status=2, folder=folder)
    assert tree(other) == before, "nothing was written"
    for name, command in commands.items():
        macula(*command, "--out", "other", "--force", folder=folder)
        macula(*command, "--out", "other", folder=folder)  # its own now
    assert {"notes.txt", "report.json", "results.json", "report.html", "points.jsonl",
            "training"} <= set(os.listdir(other)), os.listdir(other)
    with open(os.path.join(other, "notes.txt")) as f:
        assert f.read() == "mine"
    assert "--out" in macula("hold", "layers-2", "--force", status=2, folder=folder)


def interrupted(folder, *command, after=1):
    return run_interrupted([MACULA, *command], folder, after)


def rows_of(*path):
    with open(os.path.join(*path), encoding="utf-8", newline="") as f:
        return list(csv.DictReader(f))


def check_page(folder, words):
    with open(os.path.join(folder, "report.html"), encoding="utf-8") as f:
        page = f.read()
    banner = re.search(r'<p id="interrupted" role="alert">(.*?)</p>', page)
    assert banner and words in banner.group(1), banner
    chromium = shutil.which("chromium") or shutil.which("google-chrome")
    if chromium is None:
        print("skipped: no chromium for the page (apt-get install chromium)")
        return
    dom = subprocess.run(
        [chromium, "--headless=new", "--no-sandbox", "--disable-gpu", "--proxy-server=127.0.0.1:9",
         f"--user-data-dir={folder}-profile", "--virtual-time-budget=5000", "--dump-dom",
         "file://" + os.path.join(folder, "report.html")], capture_output=True, text=True, timeout=240).stdout
    errors = re.search(r'<p id="script-errors"[^>]*>(.*?)</p>', dom, re.S)
    assert errors and errors.group(1) == "" and "hidden" in errors.group(0), errors and errors.group(0)


def check_interrupted_replay(folder):
    out = os.path.join(folder, "cut")
    status, seen = interrupted(folder, *REPLAY, "--frames", "100000", "--images", "png", "--out", out,
                               "--json", "cut.json")
    report = read_json(out, "report.json")
    frames = len(report["frames"])
    assert status == 130 and f"interrupted after {frames} of 100000 frames" in seen, (status, seen[-300:])
    assert report["interrupted"] is True and 1 <= frames < 100000
    assert report == read_json(folder, "cut.json")
    images = [f"frame_{i:05}.png" for i in range(frames)]
    assert set(os.listdir(out)) == {"report.json", "macula-output.txt", *images}
    macula(*REPLAY, "--frames", "1", "--out", out, folder=folder)
    assert set(os.listdir(out)) == {"report.json", "macula-output.txt"}


def check_interrupted_hold(folder):
    out = os.path.join(folder, "held")
    status, seen = interrupted(folder, "hold", "layers-2", *SMALL, "--frames", "100000", "--load", "none",
                               "--warmup", "1", "--out", out)
    results = read_json(out, "results.json")
    frames = results["frames"]
    assert status == 130 and f"{frames} of 100000 frames were drawn" in seen, (status, seen[-300:])
    assert results["interrupted"] is True and results["steps"] == []
    assert len(rows_of(out, "results.csv")) == frames >= 1
    check_page(out, f"{frames} of 100000 frames were drawn")


def check_interrupted_plant(folder):
    """Cases that every law was run on."""
    out = os.path.join(folder, "plant")
    command = ("hold", "--plant", "--out", out)
    whole = json.loads(macula(*command, "--seeds", "1", "--json", "-"))
    assert whole["interrupted"] is False
    laws, cases = len(whole["laws"]), len(next(iter(whole["laws"].values())))
    before = tree(out)
    status, seen = interrupted(folder, *command)
    assert status == 130 and "nothing was written" in seen, (status, seen[-300:])
    assert tree(out) == before, "no case is finished, and what was there stays"
    status, seen = interrupted(folder, *command, after=laws)
    results = read_json(out, "results.json")
    finished = {tuple(of) for of in results["laws"].values()}
    assert len(results["laws"]) == laws and len(finished) == 1, finished
    words = f"{len(finished.pop())} of {cases} cases were run"
    assert status == 130 and words in seen and results["interrupted"] is True, (status, seen[-300:])
    check_page(out, words)


def check_interrupted_study(folder):
    out = os.path.join(folder, "study")
    latencies = ",".join(str(i) for i in range(1000))
    status, seen = interrupted(folder, "gaze", "study", LOG, LOG, "--latencies", latencies, "--out", out)
    results = read_json(out, "results.json")
    points = sum(len(log["points"]) for log in results["logs"])
    assert status == 130 and f"{points} of 8000 points were found" in seen, (status, seen[-300:])
    assert results["interrupted"] is True and 1 <= points < 8000
    assert len(rows_of(out, "results.csv")) == points
    check_page(out, f"{points} of 8000 points were found")


def check_interrupted_features(folder):
    """The scene that was being drawn is left out; those before it stay."""
    out = os.path.join(folder, "features")
    scenes = [f"layers-{n}" for n in range(2, 200)]
    status, seen = interrupted(folder, "features", *SMALL, "--views", "1", "--training", *scenes, "--out",
                               out, "--json", "features.json")
    report = read_json(folder, "features.json")
    assert status == 130 and report["interrupted"] is True, (status, seen[-300:])
    files = [os.path.relpath(s["file"], out) for s in report["scenes"]]
    assert 1 <= len(files) < len(scenes)
    assert sorted(os.listdir(os.path.join(out, "training"))) == sorted(os.path.basename(f) for f in files)


def check_interrupted_chart(folder):
    """Nothing is finished yet: nothing is written, and the same command goes on."""
    with open(os.path.join(folder, "long.toml"), "w", encoding="utf-8") as f:
        f.write(EXPERIMENT)
    status, seen = interrupted(folder, "chart", "long.toml", "--out", "chart")
    assert status == 130 and "nothing was written" in seen, (status, seen[-300:])
    assert not os.path.exists(os.path.join(folder, "chart", "results.json"))


def check_interrupted_conversion(folder):
    """No file at all, or the one that was there."""
    long = os.path.join(folder, "long.csv")
    with open(long, "w", encoding="utf-8") as f:
        f.write("time_s,x,y,valid\n")
        f.writelines(f"{i / 1000},0.25,0.75,1\n" for i in range(1000000))
    with open(os.path.join(folder, "gaze.csv"), "w", encoding="utf-8") as f:
        f.write("old")
    run = subprocess.Popen([MACULA, "gaze", "convert", long, "--out", "gaze.csv"], cwd=folder,
                           stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    while run.poll() is None and not os.path.exists(os.path.join(folder, "gaze.part.csv")):
        pass
    run.send_signal(signal.SIGTERM)
    _, stderr = run.communicate()
    assert run.returncode == 130 and "gaze.csv was not written" in stderr, (run.returncode, stderr)
    assert not os.path.exists(os.path.join(folder, "gaze.part.csv"))
    with open(os.path.join(folder, "gaze.csv"), encoding="utf-8") as f:
        assert f.read() == "old"


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_replay_again(folder)
        check_refused(folder)
        check_interrupted_replay(folder)
        check_interrupted_hold(folder)
        check_interrupted_plant(folder)
        check_interrupted_study(folder)
        check_interrupted_features(folder)
        check_interrupted_chart(folder)
        check_interrupted_conversion(folder)
    print("output: all checks passed")


main()
