#!/usr/bin/python3
"""Real reports of every kind are valid by docs/report.schema.json; broken copies are not.

usage: report_test.py PROGRAM

Exit status 77: no jsonschema to validate with.
"""
import csv
import json
import os
import subprocess
import sys
import tempfile

from interrupted import interrupted

MACULA = sys.argv[1]
SOURCE = os.environ["MACULA_SOURCE"]
SMALL = ("--size", "48x32", "--warmup", "0")
SESSION = {
    "schema": 1, "commit": "300cf30ad6fe", "started": "2026-11-22T11:14:15Z",
    "scene": {"name": "layers-3", "file": None, "sha256": None}, "environment_sha256": None,
    "gl": {"renderer": "llvmpipe", "version": "4.5"}, "content_scale": {"x": 1.0, "y": 1.0},
    "settings": {"oit.method": "kb-variable", "oit.kAve": 2}, "options": {"scene": "layers-3"}}
FRAME = {
    "index": 0, "time_s": 0.0, "width": 48, "height": 32, "reset": "restart", "cut": False,
    "camera": {"position": [0, 0, 3], "target": [0, 0, 0], "up": [0, 1, 0], "vfov": 0.9,
               "near": 0.1, "far": 100},
    "gaze": {"x": 0.5, "y": 0.5, "raw_x": "nan", "raw_y": "nan", "state": "none", "age_s": "inf",
             "radius": 0.1, "saccade": False}, "r": 1}


def replay(folder, name, *options, check=True):
    out = os.path.join(folder, name)
    subprocess.run([MACULA, "replay", *options, "--out", out], check=check,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with open(os.path.join(out, "report.json"), encoding="utf-8") as f:
        return json.load(f)


def recording_in(folder):
    recording = os.path.join(folder, "recording")
    os.mkdir(recording)
    with open(os.path.join(recording, "session.json"), "w", encoding="utf-8") as f:
        json.dump(SESSION, f)
    with open(os.path.join(recording, "frames.jsonl"), "w", encoding="utf-8") as f:
        for index in range(2):
            reset = "restart" if index == 0 else "none"
            f.write(json.dumps({**FRAME, "index": index, "time_s": index / 60, "reset": reset}) + "\n")
    return recording


def reports(folder):
    """Name and report of every kind of run."""
    log = os.path.join(SOURCE, "assets", "gallery_gaze.csv")
    network = os.path.join(SOURCE, "assets", "networks", "macula.safetensors")
    kinds = {
        "plain": ("layers-4", "--frames", "2"),
        "reference": ("layers-4", "--frames", "2", "--reference", "--k-ave", "2"),
        "equal images": ("layers-4", "--frames", "1", "--reference", "--method", "ab-sbuffer"),
        "linear": ("layers-4", "--frames", "1", "--reference", "--hdr"),
        "heat map": ("layers-4", "--frames", "1", "--heatmap", "depth-complexity", "--images", "png"),
        "without counts": ("layers-4", "--frames", "1", "--method", "blend"),
        "lists": ("layers-4", "--frames", "1", "--method", "ab-list"),
        "racy": ("layers-4", "--frames", "1", "--method", "kb-racy", "--k-ave", "2"),
        "locks": ("layers-4", "--frames", "1", "--method", "kb-fixed", "--oit.sync", "spinlock"),
        "reduced rate": ("car", "--frames", "1", "--lod.r", "2"),
        "gaze log": ("layers-4", "--frames", "2", "--gaze", log),
        "named file": ("layers-4", "--frames", "1", "--oit.network", network),
        "nothing transparent": ("car", "--frames", "1", "--reference"),
    }
    for name, options in kinds.items():
        yield name, replay(folder, name, *options, *SMALL)
    yield "recording", replay(folder, "recorded", recording_in(folder), "--reference")
    cut = os.path.join(folder, "cut")
    status, seen = interrupted([MACULA, "replay", "layers-4", *SMALL, "--frames", "100000",
                                "--out", cut], folder, 1)
    assert status == 130, seen[-300:]
    with open(os.path.join(cut, "report.json"), encoding="utf-8") as f:
        report = json.load(f)
    assert report["interrupted"] is True
    yield "interrupted", report


def broken(report):
    """Copies of a report that the schema must refuse."""
    def copy(change):
        other = json.loads(json.dumps(report))
        change(other)
        return other
    yield "an unknown key", copy(lambda r: r["frames"][0].update(unknown=1))
    yield "an unknown key of the run", copy(lambda r: r.update(unknown=1))
    yield "a missing metric", copy(lambda r: r["frames"][0].pop("lock_failures"))
    yield "a text for a number", copy(lambda r: r["frames"][0]["k"].update(mean="2"))
    yield "a count below 0", copy(lambda r: r["frames"][0]["fragments"].update(lost=-1))
    yield "another version", copy(lambda r: r.update(schema=2))
    yield "no state of the gaze", copy(lambda r: r["frames"][0]["gaze"].update(state="away"))
    yield "null for what always is", copy(lambda r: r["frames"][0].update(exact=None))


def check_reports(folder, schema):
    from jsonschema import Draft202012Validator
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    count = 0
    for name, report in reports(folder):
        errors = [f"{name}: {'/'.join(map(str, e.absolute_path))}: {e.message}"
                  for e in validator.iter_errors(report)]
        assert not errors, "\n".join(errors[:10])
        count += 1
    for name, report in broken(report):
        assert not validator.is_valid(report), name
    return count


def check_hold(folder):
    """Metrics beside what hold has of its own."""
    out = os.path.join(folder, "held")
    subprocess.run([MACULA, "hold", "layers-4", "--size", "48x32", "--warmup", "1", "--frames", "30",
                    "--target-ms", "9000", "--load", "none", "--method", "kb-fixed", "--oit.sync",
                    "spinlock", "--out", out], check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(out, "results.csv"), encoding="utf-8", newline="") as f:
        rows = list(csv.DictReader(f))
    with open(os.path.join(out, "results.json"), encoding="utf-8") as f:
        summary = json.load(f)["summary"]
    assert len(rows) == 30
    for name in ("generated", "stored", "merged", "lost"):
        assert summary["fragments"][name] == sum(int(row[f"fragments.{name}"]) for row in rows), name
    assert summary["fragments"]["generated"] == 30 * 4 * 48 * 32, summary
    assert summary["lock_failures"] == sum(int(row["lock_failures"]) for row in rows), summary
    assert {row["exact"] for row in rows} <= {"true", "false"}


def main():
    with open(os.path.join(SOURCE, "docs", "report.schema.json"), encoding="utf-8") as f:
        schema = json.load(f)
    with tempfile.TemporaryDirectory() as folder:
        check_hold(folder)
        try:
            count = check_reports(folder, schema)
        except ImportError:
            print("skipped: no validator (apt-get install python3-jsonschema)")
            sys.exit(77)
    print(f"report: {count} kinds of reports are valid")


main()
