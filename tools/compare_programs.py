#!/usr/bin/env python3
"""Frame times of two builds of Macula, by turns, as ratios: what a change costs or saves.

  tools/compare_programs.py BEFORE AFTER [--rounds 10] [--size 512x512] [--rmse LIMIT] [--out NAME.csv]
      CASE...

CASE is DRIVER:SCENE:METHOD[:OPTIONS], with llvmpipe or zink for the driver. In a round each program draws
the case once, in an order that alternates; a ratio is of one round. Printed and written: the medians of the
frame times, and the median, least and most of the ratios. Images of both programs must be equal, or, with
--rmse LIMIT, differ by no more than that in linear colour; then the difference is written, too. A scene is a
name or a file, so that a program that does not know the name reads what `macula scene make` wrote.
The commit of AFTER must be clean and an ancestor of HEAD for tools/benchmarks.py to take the file.
"""
import argparse
import datetime
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

import benchmark_files as files

COLUMNS = ["driver", "scene", "method", "before_ms", "after_ms", "ratio", "ratio_least", "ratio_most"]
DRIVERS = {"llvmpipe": {"GALLIUM_DRIVER": "llvmpipe"},
           "zink": {"MESA_LOADER_DRIVER_OVERRIDE": "zink", "GALLIUM_DRIVER": "zink"}}


def draw(program, case, size, folder):
    """@returns the median frame time in ms, the last image, and the report"""
    driver, scene, method, *options = case.split(":")
    words = " ".join(options).split()
    if "--size" not in words:
        words += ["--size", size]
    runtime = os.path.join(folder, "runtime")
    os.makedirs(runtime, mode=0o700, exist_ok=True)
    environment = {**os.environ, **DRIVERS[driver], "LIBGL_ALWAYS_SOFTWARE": "1", "XDG_RUNTIME_DIR": runtime}
    out = tempfile.mkdtemp(dir=folder)
    subprocess.run([program, "replay", scene, "--method", method, "--frames", "3", "--warmup", "1", "--out", out,
                    "--images", "exr", *words], env=environment, check=True,
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    report = json.loads(pathlib.Path(out, "report.json").read_text(encoding="utf-8"))
    return statistics.median(f["ms"]["total"] for f in report["frames"]), sorted(pathlib.Path(out).glob("*.exr"))[-1], report


def difference(program, images, hashes):
    """Linear RMSE of two images."""
    if hashes[0] == hashes[1]:
        return 0.0
    text = subprocess.run([program, "compare", "--hdr", "--json", "-", *map(str, images)], check=True,
                          capture_output=True, text=True).stdout
    return json.loads(text[text.index("{"):])["rmse"]


def compare(options, case, folder):
    programs = (options.before, options.after)
    times = {program: [] for program in programs}
    rmse = 0.0
    for i in range(options.rounds):
        images, hashes = {}, {}
        for program in programs[::1 if i % 2 == 0 else -1]:
            ms, images[program], report = draw(program, case, options.size, folder)
            times[program].append(ms)
            hashes[program] = report["frames"][-1]["image_sha256"]
            if program == options.after:
                newest = report
        rmse = max(rmse, difference(options.after, [images[p] for p in programs], [hashes[p] for p in programs]))
        if rmse > options.rmse:
            sys.exit(f"{case}: the images differ by {rmse:.2g}")
    ratios = [after / before for before, after in zip(times[options.before], times[options.after])]
    driver, scene, method, *more = case.split(":")
    row = {"driver": driver, "scene": scene, "method": " ".join([method, *more]),
           "before_ms": f"{statistics.median(times[options.before]):.1f}",
           "after_ms": f"{statistics.median(times[options.after]):.1f}",
           "ratio": f"{statistics.median(ratios):.3f}", "ratio_least": f"{min(ratios):.3f}",
           "ratio_most": f"{max(ratios):.3f}"}
    if options.rmse > 0.0:
        row["rmse"] = f"{rmse:.1e}"
    print(", ".join(f"{key} {value}" for key, value in row.items()), flush=True)
    return row, newest


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("cases", nargs="+")
    parser.add_argument("--rounds", type=int, default=10)
    parser.add_argument("--size", default="512x512")
    parser.add_argument("--rmse", type=float, default=0.0)
    parser.add_argument("--title", default="Before and after")
    parser.add_argument("--before-commit", default="")
    parser.add_argument("--out")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        compared = [compare(options, case, folder) for case in options.cases]
    if options.out:
        commit = compared[-1][1]["provenance"]["commit"]
        files.write(pathlib.Path(options.out), {
            "kind": "table", "title": options.title, "commit": commit,
            "command": "tools/compare_programs.py", "before": options.before_commit,
            "date": datetime.date.today().isoformat(), "sizes": options.size,
            "rounds": options.rounds}, COLUMNS + ["rmse"] * (options.rmse > 0.0), [row for row, _ in compared])


if __name__ == "__main__":
    main()
