#!/usr/bin/env python3
"""Time from the start of `macula replay` to its first frame, without and with the cache of programs.

  tools/first_frame.py build/release/macula [--rounds 5] [--scene gallery] [--size 512x512] [--out NAME.csv]

Runs in turn: `off`, without a cache; `empty`, which fills one; `filled`, which finds all programs. Prints
the median, the least and the most of each in ms, and their ratios to `off` in the same round; and the same
of the processor time of the whole run, which other work on the machine disturbs less. The driver is what the
environment chooses. --out writes a result file, or adds to one. Drivers have caches of their own, which would hide what ours does: Mesa's is
kept in a folder that is emptied before each run. The images of all runs must be equal.
"""
import argparse
import datetime
import json
import os
import pathlib
import resource
import shutil
import statistics
import subprocess
import sys
import tempfile

import benchmark_files as files

COLUMNS = ["renderer", "scene", "method", "cache", "first_frame_ms", "least_ms", "most_ms", "ratio", "processor_ratio"]
WAYS = ("off", "empty", "filled")


def first_frame(program, options, cache, folder):
    """@returns ms to the first frame, ms of the processor, the hash of the image, the device"""
    driver = os.path.join(folder, "driver")
    shutil.rmtree(driver, ignore_errors=True)
    environment = {**os.environ, "MACULA_SHADER_CACHE": cache, "MESA_SHADER_CACHE_DIR": driver}
    out = os.path.join(folder, "out")
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([program, "replay", options.scene, "--method", options.method, "--size", options.size,
                    "--frames", "1", "--warmup", "0", "--out", out], env=environment, check=True,
                   stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    with open(os.path.join(out, "report.json"), encoding="utf-8") as file:
        report = json.load(file)
    return report["summary"]["first_frame_ms"], 1e3 * cpu, report["frames"][0]["image_sha256"], report


def ratio(times, way):
    return statistics.median(ms / off for ms, off in zip(times[way], times["off"]))


def write(options, report, times, processor):
    """Adds a row for each way to the result file."""
    path = pathlib.Path(options.out)
    rows = files.read(path.name, path.parent)[1] if path.exists() else []
    for way in WAYS:
        rows.append({"renderer": report["gl"]["renderer"], "scene": options.scene, "method": options.method,
                     "cache": way, "first_frame_ms": f"{statistics.median(times[way]):.0f}",
                     "least_ms": f"{min(times[way]):.0f}", "most_ms": f"{max(times[way]):.0f}",
                     "ratio": f"{ratio(times, way):.2f}", "processor_ratio": f"{ratio(processor, way):.2f}"})
    files.write(path, {"kind": "table", "title": "Time to the first frame", "commit": report["provenance"]["commit"],
                       "command": "tools/first_frame.py", "date": datetime.date.today().isoformat(),
                       "sizes": options.size, "rounds": options.rounds}, COLUMNS, rows)


def table(title, times):
    for way in WAYS:
        ratios = [ms / off for ms, off in zip(times[way], times["off"])]
        print(f"{title} {way:7} {statistics.median(times[way]):8.0f} ms ({min(times[way]):.0f} to "
              f"{max(times[way]):.0f}), {statistics.median(ratios):.2f} of off ({min(ratios):.2f} to "
              f"{max(ratios):.2f})")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--scene", default="gallery")
    parser.add_argument("--method", default="kb-variable")
    parser.add_argument("--size", default="512x512")
    parser.add_argument("--out")
    options = parser.parse_args()
    program = os.path.abspath(options.program)
    times = {way: [] for way in WAYS}
    processor = {way: [] for way in WAYS}
    images = set()
    with tempfile.TemporaryDirectory() as folder:
        cache = os.path.join(folder, "programs")
        for _ in range(options.rounds):
            shutil.rmtree(cache, ignore_errors=True)
            for way in WAYS:
                used = "off" if way == "off" else cache
                ms, cpu, image, report = first_frame(program, options, used, folder)
                times[way].append(ms)
                processor[way].append(cpu)
                images.add(image)
        files = [entry.stat().st_size for entry in os.scandir(cache)] if os.path.isdir(cache) else []
    print(f"{report['gl']['renderer']}, {report['gl']['version']}: {options.scene}, {options.method}, {options.size}, "
          f"n = {options.rounds}, {len(files)} programs of {sum(files) // 1024} KiB")
    table("first frame", times)
    table("processor  ", processor)
    if len(images) != 1:
        sys.exit("the images differ")
    if options.out:
        write(options, report, times, processor)


if __name__ == "__main__":
    main()
