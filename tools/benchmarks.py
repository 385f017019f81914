#!/usr/bin/env python3
"""Turns the results.json of `macula chart` into Markdown.

Usage: tools/benchmarks.py OUT/results.json > BENCHMARKS.md
"""
import json
import sys


def number(value, digits=3):
    return "-" if value is None else f"{value:.{digits}g}"


def mebibytes(value):
    return "-" if value is None else f"{value / 2**20:.1f}"


def place(point):
    """Where a point was measured: scene, size, light, budget."""
    words = [point["scene"], f"{point['width']}x{point['height']}"]
    if point.get("light"):
        words.append("own light" if point["light"] == "own" else point["light"])
    return " ".join(words)


def targets(results):
    lines = ["## Targets", "", "| what | where | measured | limit | |", "|---|---|---|---|---|"]
    for row in results["targets"]:
        state = row["state"] if row["state"] != "missed" else "**missed**"
        if row.get("reason"):
            state += f": {row['reason']}"
        value = number(row["value"]) if row["value"] is not None else row.get("note", "")
        lines.append(f"| {row['name']} | {row['where']} | {value} | {row['limit']} | {state} |")
    return lines


def table(points):
    floor = {}
    for point in points:
        if point["variant"] == "blend" and point.get("ms"):
            floor[place(point)] = point["ms"]["transparency"]["median"]
    lines = [
        "| where | budget | method | transparency ms | / blend | frame ms | RMSE | PSNR dB | FLIP | "
        "lost | storage MiB | overhead MiB |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for point in points:
        ms = point.get("ms")
        error = point.get("error") or {}
        fragments = point.get("fragments") or {}
        memory = point.get("bytes") or {}
        if point["status"] == "refused":
            lines.append(f"| {place(point)} | {point.get('budget') or '-'} | {point['label']} | "
                         "refused |" + " |" * 8)
            continue
        time = ratio = frame = "-"
        if ms:
            own = ms["transparency"]
            time = f"{own['median']:.1f} ({own['p5']:.1f}-{own['p95']:.1f})"
            frame = f"{ms['total']['median']:.1f}"
            if place(point) in floor:
                ratio = f"{own['median'] / floor[place(point)]:.2f}"
        loss = fragments.get("loss")
        lines.append("| " + " | ".join([
            place(point), point.get("budget") or "-", point["label"], time, ratio, frame,
            f"{error['rmse']:.5f}" if "rmse" in error else "-", number(error.get("psnr_db")),
            number(error.get("flip")), "-" if loss is None else f"{100 * loss:.1f} %",
            mebibytes(memory.get("oit")), mebibytes(memory.get("overhead")),
        ]) + " |")
    return lines


def base_of(results, study):
    """The variant that a study's speed-ups are over, or None."""
    return next(s.get("base") for s in results["studies"] if s["id"] == study)


def percent(share):
    return "-" if share is None else f"{100 * share:.1f} %"


def speed_table(points):
    """Studies with speed-ups: what of the shading is left, and what it costs in accuracy."""
    lines = [
        "| where | method | speed-up | frame ms | shading ms | shaded | holes | PSNR dB | RMSE | "
        "FLIP | FLIP gaze |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for point in points:
        if point["status"] == "refused":
            lines.append(f"| {place(point)} | {point['label']} | refused |" + " |" * 8)
            continue
        ms = point["ms"]
        error = point.get("error") or {}
        shading = point.get("shading") or {}
        total = ms["total"]
        speedup = point.get("speedup")
        psnr = "exact" if error.get("rmse") == 0 else number(error.get("psnr_db"))
        lines.append("| " + " | ".join([
            place(point), point["label"], "-" if speedup is None else f"{speedup:.2f}",
            f"{total['median']:.1f} ({total['p5']:.1f}-{total['p95']:.1f})",
            f"{ms['shading']['median']:.1f}", percent(shading.get("shaded_share")),
            percent(shading.get("holes_share")), psnr,
            f"{error['rmse']:.5f}" if "rmse" in error else "-", number(error.get("flip")),
            number(error.get("flip_gaze")),
        ]) + " |")
    return lines


def path_table(points):
    """What the points of a study do along the camera's path; nothing where none walked."""
    walked = [p for p in points if (p.get("path") or {}).get("rmse") is not None]
    if not walked:
        return []
    first = walked[0]["path"]
    lines = ["", f"Along the camera's path, {first['frames']} frames of {first['fps']:g} a second:", "",
             "| where | budget | method | flicker | RMSE |", "|---|---|---|---|---|"]
    for point in walked:
        lines.append(f"| {place(point)} | {point.get('budget') or '-'} | {point['label']} | "
                     f"{point['path']['flicker']:.5f} | {point['path']['rmse']:.5f} |")
    return lines


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        results = json.load(file)
    machine = results["machine"]
    gl = results["gl"]
    rounds = sorted({point["rounds"] for point in results["points"] if point.get("rounds")})
    lines = [
        "# Benchmarks", "",
        f"Made by `tools/benchmarks.py` from the results of `macula chart`: {results['title']}. "
        f"Commit {results['commit']}, {results['date']}, on {gl['renderer']} ({gl['version']}), "
        f"{machine['processor']}, {machine['cores']} cores. The methods of a study draw one frame "
        f"in turn, {results['warm_up_rounds']} rounds of warm-up and then "
        f"{' or '.join(str(r) for r in rounds)} that count; times are medians with the 5th and 95th "
        "percentile, ratios are of medians of the same rounds. \"Transparency\" is the sum of the "
        "passes whose names start with `oit.`, \"shading\" that of `lighting` and `lod.`. Errors are against `ab-sbuffer`, on display values "
        "0..1. Times of a software rasteriser say how methods compare on it, not what a GPU needs.",
        "",
    ]
    lines += targets(results)
    for skipped in results["skipped"]:
        lines += ["", f"Skipped: {json.dumps(skipped)}"]
    for study in results["studies"]:
        points = [p for p in results["points"] if p["study"] == study["id"]]
        if points:
            make = table if base_of(results, study["id"]) is None else speed_table
            lines += ["", f"## {study['title']}", ""] + make(points) + path_table(points)
    print("\n".join(lines))


if __name__ == "__main__":
    main()
