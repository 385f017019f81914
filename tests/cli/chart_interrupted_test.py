#!/usr/bin/env python3
"""A chart that is killed or asked to stop, and goes on where it was."""
import json
import os
import shutil
import signal
import subprocess
import tempfile
import time

from chart_cases import MACULA, TINY, chart, results


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


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_asked_to_stop(folder, check_interrupted(folder))
    print("chart interrupted: all checks passed")


main()
