#!/usr/bin/env python3
"""Latency from outside: replay reports its error, gaze study charts it."""
import csv
import hashlib
import json
import os
import subprocess
import sys
import tempfile

MACULA = sys.argv[1]
LOG = os.path.join(os.environ["MACULA_SOURCE"], "assets", "gallery_gaze.csv")


def replay(folder, latency):
    out = os.path.join(folder, "run")
    subprocess.run([MACULA, "replay", "smoke", "--size", "64x48", "--frames", "90", "--gaze", LOG, "--k-ave", "0.5",
                    "--gaze-latency-ms", str(latency), "--out", out], check=True,
                   stdout=subprocess.DEVNULL)
    with open(os.path.join(out, "report.json")) as f:
        return json.load(f)


def check_replay(folder):
    at_once, late, again = replay(folder, 0), replay(folder, 60), replay(folder, 60)
    assert at_once["summary"]["gaze_error_deg"]["max"] == 0, at_once["summary"]
    assert at_once["summary"]["gaze_error_deg"]["basis"].startswith("0 by definition")
    assert "597x336 mm (assumed)" in late["summary"]["gaze_error_deg"]["basis"], late["summary"]
    assert late["gaze_log"]["display"]["distance_by"] == "assumed", late["gaze_log"]
    assert late["summary"]["gaze_error_deg"]["median"] > 0.05, late["summary"]
    assert late["settings"]["gaze.latencyMs"] == 60
    hashes = [[f["image_sha256"] for f in r["frames"]] for r in (at_once, late, again)]
    assert hashes[1] == hashes[2]
    assert hashes[0] != hashes[1]
    radii = [f["fovea"]["radius"] for f in late["frames"]]
    assert min(radii) >= 0.1 and max(radii) > 0.2, (min(radii), max(radii))


def check_study(folder):
    out = os.path.join(folder, "study")
    subprocess.run([MACULA, "gaze", "study", LOG, "--latencies", "0,60,150", "--out", out],
                   check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(out, "results.csv")) as f:
        rows = list(csv.DictReader(f))
    assert len(rows) == 4 * 3, len(rows)
    errors = [float(r["mean_deg"]) for r in rows if r["way"] == "as recorded"]
    assert errors[0] == 0 and errors[1] > 0.5 and errors[2] > errors[1], errors
    with open(os.path.join(out, "results.json")) as f:
        results = json.load(f)
    made = results["provenance"]
    with open(LOG, "rb") as f:
        log_hash = hashlib.sha256(f.read()).hexdigest()
    assert made["command"].startswith(f"macula gaze study {LOG} --latencies 0,60,150"), made
    assert made["gaze"] == [{"name": LOG, "path": LOG, "sha256": log_hash, "files": []}], made
    assert made["fps"] == 60 and made["seed"] is None and made["commit"] == results["commit"], made
    landing = results["logs"][0]["landing_error_deg"]
    assert landing["predicted"]["frames"] > 50
    assert landing["predicted"]["mean"] < landing["unpredicted"]["mean"], landing
    with open(os.path.join(out, "report.html")) as f:
        page = f.read()
    assert "{{" not in page.split("<script>")[0] and "gallery_gaze.csv" in page
    assert "How this was made" in page
    bad = subprocess.run([MACULA, "gaze", "study", LOG, "--latencies", "-5", "--out", out],
                         capture_output=True, text=True)
    assert bad.returncode == 2 and len(bad.stderr.splitlines()) == 1, bad


def check_end(folder):
    log, out = os.path.join(folder, "short.csv"), os.path.join(folder, "short")
    with open(log, "w") as f:
        f.write("time_s,x,y,valid\n0,0.2,0.3,1\n0.02,0.21,0.3,1\n0.04,0.22,0.3,1\n")
    done = subprocess.run([MACULA, "replay", "layers-2", "--size", "32x32", "--frames", "60", "--gaze", log,
                           "--out", out], check=True, capture_output=True, text=True)
    assert done.stderr.startswith("gaze log ended at 0.04 s, before frame 3 of 60;"), done.stderr
    with open(os.path.join(out, "report.json")) as f:
        states = [frame["gaze"]["state"] for frame in json.load(f)["frames"]]
    assert list(dict.fromkeys(states)) == ["ok", "held", "easing", "ended"], states


def check_scene_camera(folder):
    log, out = os.path.join(folder, "core.csv"), os.path.join(folder, "core")
    with open(log, "w") as f:
        f.write("gaze_timestamp,confidence,norm_pos_x,norm_pos_y\n1,1,0.25,0.75\n1.5,1,0.3,0.75\n")
    replayed = subprocess.run([MACULA, "replay", "layers-2", "--size", "32x32", "--frames", "3", "--gaze", log,
                               "--gaze-latency-ms", "5", "--out", out], check=True, capture_output=True, text=True)
    assert "scene camera" in replayed.stderr, replayed.stderr
    with open(os.path.join(out, "report.json")) as f:
        report = json.load(f)
    assert report["gaze_log"]["of"] == "scene camera" and report["gaze_log"]["warnings"]
    assert report["summary"]["gaze_error_deg"]["max"] is None, report["summary"]
    info = [MACULA, "gaze", "info", log, "--json", "-"]
    refused = json.loads(subprocess.run(info, check=True, capture_output=True).stdout)
    assert refused["saccades"]["mean_deg"] is None and refused["fixations"]["count"] is None
    accepted = json.loads(subprocess.run(info + ["--gaze.sceneCameraAsDisplay", "on"], check=True,
                                         capture_output=True).stdout)
    assert accepted["fixations"]["count"] is not None and accepted["warnings"], accepted
    studied = os.path.join(folder, "core_study")
    study = [MACULA, "gaze", "study", log, "--out", studied]
    bad = subprocess.run(study, capture_output=True, text=True)
    assert bad.returncode == 2 and "--gaze.sceneCameraAsDisplay on" in bad.stderr, bad
    subprocess.run(study + ["--gaze.sceneCameraAsDisplay", "on"], check=True, capture_output=True)
    with open(os.path.join(studied, "report.html")) as f:
        assert "in the picture of a scene camera" in f.read()


with tempfile.TemporaryDirectory() as temporary:
    check_end(temporary)
    check_scene_camera(temporary)
    check_replay(temporary)
    check_study(temporary)
print("ok")
