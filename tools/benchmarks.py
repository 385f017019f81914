#!/usr/bin/env python3
"""BENCHMARKS.md, and the numbers that documents quote, from docs/benchmarks/*.csv.

  tools/benchmarks.py                  writes BENCHMARKS.md, the marked numbers and the marked tables again
  tools/benchmarks.py --check          changes nothing; status 1 where one of them is not current
  tools/benchmarks.py --from DIR NAME  takes the results in DIR over as docs/benchmarks/NAME.csv first

DIR is the --out of `macula chart` or of `macula hold --plant`, made by a program that was built from a
clean commit: results of changed sources cannot be repeated, and are refused.
"""
import argparse
import csv
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tomllib

import benchmark_files as files

PAGE = files.ROOT / "BENCHMARKS.md"
NOTES = files.FOLDER / "notes.toml"
TABLE = re.compile(r"<!-- table (?P<name>[\w.-]+\.csv) -->.*?<!-- end of table -->", re.DOTALL)
# What is kept of results.csv: where a point stands, and the metrics that documents speak of.
POINT = ["study", "scene", "width", "height", "light", "variant", "label", "budget", "sweep",
         "status", "ms.transparency", "ms.transparency.p5", "ms.transparency.p95", "ms.shading",
         "ms.total", "ms.total.p5", "ms.total.p95", "speedup", "shading.shaded_share",
         "shading.holes_share", "bytes.oit", "bytes.overhead", "fragments.generated",
         "fragments.loss", "k.mean", "rmse", "psnr_db", "max", "flip", "flip_gaze", "flicker",
         "path_rmse"]
CLAIM = ["claim", "papers", "metric", "study", "where", "value", "limit", "state", "reason", "note"]
INTRO = """# Benchmarks

Made by `tools/benchmarks.py` from the result files in [docs/benchmarks](docs/benchmarks/README.md). A claim is judged on every scene, light and budget of its experiment; each cell is one of them. **Bold** is a miss, and the text says why. `n/a` means that the claim says nothing there, with the reason.

Times are of Mesa's software rasteriser: they say how methods compare on it, not what a GPU needs ([GPU status](docs/gpu-status.md)). The variants of a study draw one frame in turn, so that other load on the machine falls on all alike; a ratio is of the medians of the same rounds. Errors are against `ab-sbuffer`, on display values 0..1.
"""


def fail(message):
    sys.exit(f"benchmarks.py: {message}")


def git(*arguments):
    return subprocess.run(["git", "-C", files.ROOT, *arguments], capture_output=True, text=True,
                          check=False)


def check_commit(path, commit):
    """Refuses what nobody can measure again."""
    if not re.fullmatch(r"[0-9a-f]{7,40}", commit):
        fail(f"{path}: measured by commit '{commit}'; commit the changes, build, and measure again")
    if git("merge-base", "--is-ancestor", commit, "HEAD").returncode != 0:
        fail(f"{path}: commit {commit} is no ancestor of HEAD; measure this branch instead")


def take_over(folder, name):
    """Copies the results of one run to docs/benchmarks."""
    path = pathlib.Path(folder) / "results.json"
    with open(path, encoding="utf-8") as file:
        results = json.load(file)
    check_commit(path, results["commit"])
    if results.get("interrupted"):
        fail(f"{path}: the run was interrupted; run the same command again, which finishes it")
    with open(path.with_name("results.csv"), encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    command = re.sub(r" --(out|json) \S+", "", results["provenance"]["command"])
    about = {"commit": results["commit"], "command": command}
    if "laws" in results:
        about |= {"title": "Control laws on the simulated GPU", "seeds": results["seeds"]}
        files.write(files.FOLDER / f"{name}.csv", about, list(rows[0]), rows)
        return
    rounds = sorted({point["rounds"] for point in results["points"] if point.get("rounds")})
    about |= {
        "title": results["title"], "date": results["date"], "renderer": results["gl"]["renderer"],
        "version": results["gl"]["version"], "times": results["gl"]["time_source"],
        "processor": f"{results['machine']['processor']}, {results['machine']['cores']} cores",
        "sizes": ", ".join(sorted({f"{row['width']}x{row['height']}" for row in rows})),
        "warm_up_rounds": results["warm_up_rounds"],
        "rounds": ", ".join(str(r) for r in rounds)}
    missing = [column for column in POINT if column not in rows[0]]
    if missing:
        fail(f"{path.with_name('results.csv')}: no column {', '.join(missing)}")
    files.write(files.FOLDER / f"{name}.csv", about, POINT, rows)
    claims = [{**row, "claim": row["name"]} for row in results["targets"]]
    files.write(files.FOLDER / f"{name}.claims.csv", about, CLAIM, claims)


def shown(value):
    return f"{float(value):.3g}"


def cell(row):
    """A claim at one place: the measured number, bold where it misses."""
    if row["state"] == "n/a":
        return f"n/a: {row['reason']}"
    if row["state"] == "unmeasured":
        return f"unmeasured: {row['note']}"
    text = shown(row["value"]) if row["value"] else ", ".join(re.findall(r"[\d.e-]+(?= \()", row["note"]))
    return f"**{text}**" if row["state"] == "missed" else text


def place(row):
    """Column and row of a place: "smoke 192x192 four, 1.23 MiB" is smoke, and "four"."""
    scene, _, rest = row["where"].partition(" ")
    if row["where"].startswith("mean of"):
        scene, _, rest = row["where"].partition(", ")
    rest = re.sub(r"\d+x\d+,? ?|, [\d.]+ MiB", "", rest).strip(" ,")
    return pathlib.Path(scene).stem, rest


def claim_lines(name, rows, notes):
    """One claim: its limit, what explains its misses, and a table of places."""
    counts = {state: sum(row["state"] == state for row in rows)
              for state in ("met", "missed", "n/a", "unmeasured")}
    summary = ", ".join(f"{n} {state}" for state, n in counts.items() if n)
    text = f"**{name}** ({rows[0]['metric']} {rows[0]['limit']}): {summary}."
    if rows[0]["papers"]:
        text += f" Papers: {rows[0]['papers']}."
    if counts["missed"]:
        if name not in notes:
            raise files.BenchmarkError(f"{NOTES}: the misses of '{name}' are not explained")
        text += f" *Missed:* {notes[name]}"
    places = [place(row) for row in rows]
    columns = list(dict.fromkeys(scene for scene, _ in places))
    labels = list(dict.fromkeys(label for _, label in places))
    if len(labels) == 1:  # a table of one row
        of = f" ({labels[0]})" if labels[0] else ""
        return [text, "", "; ".join(f"{at} {cell(row)}" for row, (at, _) in zip(rows, places)) + f"{of}.", ""]
    lines = [text, "", "| | " + " | ".join(columns) + " |", "|---|" + "---|" * len(columns)]
    for label in labels:
        cells = ["; ".join(cell(row) for row, at in zip(rows, places) if at == (scene, label)) or "-"
                 for scene in columns]
        lines.append(f"| {label} | " + " | ".join(cells) + " |")
    return [*lines, ""]


def heading(about):
    """How a file was measured, in one line."""
    text = f"`{about['command']}`, commit {about['commit']}"
    if "renderer" in about:
        text += (f", {about['date']}; {about['renderer']}, {about['version']}; {about['processor']}; "
                 f"{about['sizes']}; {about['warm_up_rounds']} rounds of warm-up, then {about['rounds']}")
    return ["", f"## {about['title']}", "", text + ".", ""]


def spread_lines(rows):
    """How far the times of a run spread, so that a reader knows what a ratio is worth; nothing where every
    point was measured once."""
    spreads = [(float(row["ms.total.p95"]) - float(row["ms.total.p5"])) / float(row["ms.total"])
               for row in rows if row["ms.total.p5"] and row["ms.total"] != row["ms.total.p5"]]
    if not spreads:
        return []
    return [f"Frame times of a point spread, from the 5th to the 95th percentile, by "
            f"{statistics.median(spreads):.0%} of its median (median of {len(spreads)} points).", ""]


def plant_lines(about, rows):
    """The laws on the simulated GPU: how the load doubling is met, and how often r swings."""
    lines = heading(about)
    lines += [f"Frames from a doubled load to a settled time, later frames more than 2 % over the target, and "
              f"pixels in shares of the ideal's: {about['seeds']} seeds. Limit cycles: of all cases of the protocol.",
              "", "| law | settled after | over | pixels | limit cycles |", "|---|---|---|---|---|"]
    for law in dict.fromkeys(row["law"] for row in rows):
        own = [row for row in rows if row["law"] == law]
        step = next(row for row in own if row["case"] == "work-doubles")
        cycles = sum(row["limit_cycle"] == "true" for row in own)
        settled = f"{step['settle_frames']} frames" if step["settle_frames"] else "never"
        lines.append(f"| `{law}` | {settled} | {100 * float(step['over_share']):.1f} % | "
                     f"{100 * float(step['used_pixels']):.0f} % | {cycles} of {len(own)} |")
    return lines


def table_lines(about, rows):
    """A file that is its own table."""
    text = f"`{about['command']}`, commit {about['commit']}"
    if about.get("before"):
        text += f" after {about['before']}"
    lines = ["", f"## {about['title']}", "", f"{text}, {about['date']}; {about['sizes']}; n = {about['rounds']}.", "",
             "| " + " | ".join(rows[0]) + " |", "|---" * len(rows[0]) + "|"]
    return [*lines, *("| " + " | ".join(row.values()) + " |" for row in rows)]


def with_tables(text):
    """A document with its tables of result files as the files have them."""
    def table(match):
        about, rows = files.read(match["name"])
        return "\n".join([f"<!-- table {match['name']} -->", *table_lines(about, rows)[4:], "<!-- end of table -->"])
    return TABLE.sub(table, text)


def page():
    """BENCHMARKS.md as the files have it."""
    notes = tomllib.loads(NOTES.read_text(encoding="utf-8"))
    lines = INTRO.rstrip("\n").split("\n")
    for path in sorted(files.FOLDER.glob("*.csv")):
        about, rows = files.read(path.name)
        if "law" in rows[0]:
            lines += plant_lines(about, rows)
        elif about.get("kind") == "table" and "page" not in about:
            lines += table_lines(about, rows)
        elif path.name.endswith(".claims.csv"):
            lines += heading(about)
            points = path.name.replace(".claims", "")
            lines += spread_lines(files.read(points)[1])
            for name in dict.fromkeys(row["claim"] for row in rows):
                own = [row for row in rows if row["claim"] == name]
                lines += claim_lines(name, own, notes.get(path.name.split(".")[0], {}))
            lines.pop()
    if notes["unmeasured"]["text"]:
        lines += ["", "## Not measured by this version", "", notes["unmeasured"]["text"].strip()]
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--from", dest="run", nargs=2, metavar=("DIR", "NAME"))
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.run:
        take_over(*options.run)
    texts = {PAGE: page()}
    for path in files.documents():
        texts[path] = with_tables(files.MARKER.sub(files.corrected, path.read_text(encoding="utf-8")))
    stale = [path for path, text in texts.items()
             if not path.is_file() or path.read_text(encoding="utf-8") != text]
    for path in stale:
        print(f"{path.relative_to(files.ROOT)}: {'not current' if options.check else 'written'}")
        if not options.check:
            path.write_text(texts[path], encoding="utf-8")
    if options.check and stale:
        fail("run tools/benchmarks.py")


if __name__ == "__main__":
    try:
        main()
    except (files.BenchmarkError, OSError) as error:
        fail(error)
