#!/usr/bin/env python3
"""Frame times of two builds of Macula, by turns, as ratios: what a change costs or saves.

  tools/compare_programs.py BEFORE AFTER [--rounds 10] [--size 512x512] [--out NAME.csv] CASE...

CASE is DRIVER:SCENE:METHOD[:OPTIONS], with llvmpipe or zink for the driver. In a round each program draws
the case once, in an order that alternates; a ratio is of one round. Printed and written: the medians of the
frame times, and the median, least and most of the ratios. Images of both programs must be equal.
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
    """@returns the median frame time in ms, the hash of the last image, and the report"""
    driver, scene, method, *options = case.split(":")
    runtime = os.path.join(folder, "runtime")
    os.makedirs(runtime, mode=0o700, exist_ok=True)
    environment = {**os.environ, **DRIVERS[driver], "LIBGL_ALWAYS_SOFTWARE": "1", "XDG_RUNTIME_DIR": runtime}
    out = os.path.join(folder, "out")
    subprocess.run([program, "replay", scene, "--method", method, "--size", size, "--frames", "3", "--warmup",
                    "1", "--out", out, "--force", *" ".join(options).split()],
                   env=environment, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    report = json.loads(pathlib.Path(out, "report.json").read_text(encoding="utf-8"))
    return statistics.median(f["ms"]["total"] for f in report["frames"]), report["frames"][-1], report


def compare(options, case, folder):
    times = {options.before: [], options.after: []}
    for i in range(options.rounds):
        images = set()
        for program in (options.before, options.after)[::1 if i % 2 == 0 else -1]:
            ms, frame, report = draw(program, case, options.size, folder)
            times[program].append(ms)
            images.add(frame["image_sha256"])
            if program == options.after:
                newest = report
        if len(images) != 1:
            sys.exit(f"{case}: the images differ")
    ratios = [after / before for before, after in zip(times[options.before], times[options.after])]
    driver, scene, method, *more = case.split(":")
    row = {"driver": driver, "scene": scene, "method": " ".join([method, *more]),
           "before_ms": f"{statistics.median(times[options.before]):.1f}",
           "after_ms": f"{statistics.median(times[options.after]):.1f}",
           "ratio": f"{statistics.median(ratios):.3f}", "ratio_least": f"{min(ratios):.3f}",
           "ratio_most": f"{max(ratios):.3f}"}
    print(", ".join(f"{key} {value}" for key, value in row.items()), flush=True)
    return row, newest


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("before")
    parser.add_argument("after")
    parser.add_argument("cases", nargs="+")
    parser.add_argument("--rounds", type=int, default=10)
    parser.add_argument("--size", default="512x512")
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
            "rounds": options.rounds}, COLUMNS, [row for row, _ in compared])


if __name__ == "__main__":
    main()
