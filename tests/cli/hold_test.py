#!/usr/bin/env python3
"""macula hold SCENE: its files, what they say of one another, and its refusals.

usage: hold_test.py PROGRAM

Nothing here asserts on a time: a target that anything meets, and one that nothing meets.
"""
import csv
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile

MACULA = sys.argv[1]
SOURCE = os.environ["MACULA_SOURCE"]
SMALL = ("--size", "64x36", "--warmup", "2")
SHORT = (*SMALL, "--frames", "40")


def hold(folder, *options, status=0):
    done = subprocess.run([MACULA, "hold", *options], capture_output=True, text=True, cwd=folder)
    assert done.returncode == status, (done.returncode, done.stderr)
    if status == 2:
        assert done.stderr.count("\n") == 1, done.stderr
    return done


def rows_of(path):
    with open(path, encoding="utf-8", newline="") as f:
        return list(csv.DictReader(f))


def check_example(folder):
    """The example of engine/control/README.md: its keys are those that are written."""
    with open(os.path.join(SOURCE, "engine/control/README.md"), encoding="utf-8") as f:
        text = f.read()
    command = re.search(r"```sh\nmacula (hold smoke .*?)\n```", text).group(1).split()
    example = json.loads(re.search(r"```json\n(.*?)```", text, re.S).group(1))
    done = hold(folder, *command[1:], "--out", "held")
    assert "settled" in done.stdout and "report: held/report.html" in done.stdout, done.stdout
    with open(os.path.join(folder, "held", "results.json"), encoding="utf-8") as f:
        results = json.load(f)

    def shape(value):
        if isinstance(value, dict):
            return {key: shape(inner) for key, inner in value.items()}
        return [shape(value[0])] if isinstance(value, list) and value else None

    for name in ("settings", "notices"):  # as many as there are
        example.pop(name), results[name]
        del results[name]
    assert shape(results) == shape(example), (shape(results), shape(example))
    table = set(re.findall(r"^\| `([a-z_]+)`", text, re.M))
    assert set(results) <= table, set(results) - table
    rows = rows_of(os.path.join(folder, "held", "results.csv"))
    assert len(rows) == results["frames"] == 40
    loads = [int(row["load"]) for row in rows]
    assert loads == [1] * 20 + [2] * 20, loads
    for row in rows:
        passes = sum(float(v) for k, v in row.items() if k.startswith("ms.") and v)
        assert 0.0 < passes <= float(row["ms"]) * 1.001, row
        assert float(row["resizable_ms"]) <= float(row["ms"]), row
    check_agreement(folder, "held", done.stdout)
    return os.path.join(folder, "held", "report.html")


def check_agreement(folder, name, text, most=4):
    """The terminal, results.json and the page's data say the same: one ideal r a load, with what
    limits it, and "held" only of what was held."""
    with open(os.path.join(folder, name, "results.json"), encoding="utf-8") as f:
        results = json.load(f)
    with open(os.path.join(folder, name, "report.html"), encoding="utf-8") as f:
        data = json.loads(re.search(r'id="data">(.*?)</script>', f.read(), re.S).group(1))
    for key in ("loads", "parts", "verdict", "reason", "gate"):
        assert data[key] == results[key], key
    loads = {load["times"]: load for load in results["loads"]}
    assert len(loads) == len(results["loads"])
    said = re.findall(r"^load (\d+): .* ideal r ([\d.]+) \((.*)\)$", text, re.M)
    assert [(int(times), r, limit) for times, r, limit in said] == [
        (load["times"], f"{load['ideal_r']:.2f}", load["limit"]) for load in results["loads"]], text
    for load in loads.values():
        room = results["target_ms"] - load["rest_ms"]
        meets = (load["work_ms"] / room) ** 0.5 if room > 0 else float("inf")
        ideal, limit = ((1, "nothing is computed at 1/r") if load["work_ms"] == 0 else
                        (most, "floor of the cost that does not shrink") if room <= 0 else
                        (most, f"r at its end {most}") if meets > most else
                        (1, "r at its end 1") if meets <= 1 else (meets, "target within reach"))
        assert abs(load["ideal_r"] - ideal) < 1e-9 and load["limit"] == limit, load
    said = re.findall(r"^frames (\d+) to (\d+), load (\d+): (held|not held|)", text, re.M)
    words = {True: "held", False: "not held", None: ""}
    assert [(int(a), int(b) + 1, int(load), word) for a, b, load, word in said] == [
        (p["begin"], p["end"], p["load"], words[p["met"]]) for p in results["parts"]], text
    for part in results["parts"]:
        assert part["ideal_r"] == loads[part["load"]]["ideal_r"], part
        assert part["met"] == (part["within"] >= 0.9 if part["judged_frames"] else None), part
    met = {part["met"] for part in results["parts"]} - {None}
    verdict = {frozenset([True]): "held", frozenset([False]): "not held",
               frozenset(): "not judged"}.get(frozenset(met), "held in part")
    assert results["verdict"] == verdict, results
    assert text.split("(to reach: 90 %): ")[1].split(", for")[0].split("\n")[0] == verdict, text
    judged = sum(part["judged_frames"] * part["within"] for part in results["parts"])
    assert abs(judged - results["gate"]["within"] * results["held"]["judged_frames"]) < 1e-6
    return results


def check_easy(folder):
    """What full rate meets leaves every quality control at rest, and is met."""
    results = json.loads(hold(folder, "smoke", "--target-ms", "9000", "--load", "none", *SHORT,
                              "--json", "-", "--out", "easy").stdout)
    assert results["gate"]["met"] is True and len(results["parts"]) == 1, results["gate"]
    assert results["steps"] == [] and results["held"]["over_102_share"] == 0
    made = results["provenance"]
    assert made["command"].startswith("macula hold smoke --target-ms 9000 "), made
    assert made["commit"] == results["commit"] and made["version"], made
    assert [made[role]["name"] for role in ("scene", "gaze", "camera")] == ["smoke", "center", "auto"]
    assert made["fps"] == 60 and made["seed"] == 1, made
    for row in rows_of(os.path.join(folder, "easy", "results.csv")):
        assert (float(row["r"]), float(row["fovea_slope"]), float(row["layer_share"])) == (1, 1, 1)


def check_hopeless(folder):
    """What nothing meets is said, with every quality control at its end."""
    results = json.loads(hold(folder, "smoke", "--target-ms", "0.01", "--load", "none", *SMALL,
                              "--k-ave", "2", "--frames", "130", "--json", "-",
                              "--out", "hopeless").stdout)
    assert results["gate"]["met"] is False and results["held"]["over_110_share"] == 1
    assert "out of reach" in results["notices"][-1]["text"], results["notices"]
    last = rows_of(os.path.join(folder, "hopeless", "results.csv"))[-1]
    assert float(last["layer_share"]) == 0.25, last
    assert float(last["fovea_slope"]) == 1, "nothing is foveated"


def check_fixed(folder):
    """r as it is set, in every frame, and what is computed at 1/r has a time."""
    done = hold(folder, "car", "--size", "64x64", "--warmup", "1", "--frames", "30", "--law",
                "fixed", "--control.fixedR", "2", "--load", "10:2", "--load", "15:1", "--out", "fixed")
    results = check_agreement(folder, "fixed", done.stdout)
    assert len(results["loads"]) == 2 and len(results["parts"]) == 3, results["parts"]
    assert [part["met"] is None for part in results["parts"]] == [True, True, False]
    for row in rows_of(os.path.join(folder, "fixed", "results.csv")):
        assert float(row["r"]) == 2 and float(row["lever_resize"]) == 2, row
        assert float(row["resizable_ms"]) > 0, row


def check_nothing(folder):
    """Where nothing can be computed at 1/r (no surface has veins), r is not asked for."""
    results = json.loads(hold(folder, "smoke", "--target-ms", "0.01", "--load", "none",
                              "--lod.what", "noise", *SHORT, "--json", "-",
                              "--out", "nothing").stdout)
    for row in rows_of(os.path.join(folder, "nothing", "results.csv")):
        assert float(row["r"]) == 1 and float(row["lever_resize"]) == 1, row
        assert float(row["resizable_ms"]) == 0, row
    assert "nothing is computed at 1/r" in results["notices"][0]["text"], results["notices"]
    assert results["notices"][0]["frame"] == 0, results["notices"]


def check_off(folder):
    results = json.loads(hold(folder, "smoke", "--law", "off", *SHORT, "--json", "-").stdout)
    assert results["gate"]["met"] is None and results["notices"] == []
    assert results["verdict"] == "not judged" and results["reason"] == "nothing is controlled"
    assert all(part["met"] is None for part in results["parts"]), results["parts"]


def check_share(folder):
    results = json.loads(hold(folder, "smoke", "--target-share", "0.5", "--load", "0:3", *SHORT,
                              "--json", "-").stdout)
    assert results["loads"][0]["times"] == 3 and len(results["loads"]) == 1
    assert abs(results["target_ms"] / results["loads"][0]["full_rate_ms"] - 0.5) < 1e-9


def check_plant(folder):
    """The settings of the laws reach the simulated GPU."""
    def used(*options):
        results = json.loads(hold(folder, "--plant", "--seeds", "1", "--json", "-",
                                  *options).stdout)
        return {law: cases["unreachable"] for law, cases in results["laws"].items()}, results
    usual, _ = used()
    other, results = used("--control.mostResize", "2", "--control.leastAim", "0.9")
    assert results["most_r"] == 2 and results["least_aim"] == 0.9, results
    assert results["provenance"]["command"].startswith("macula hold --plant --seeds 1"), results
    assert usual["unity"] != other["unity"]
    assert used("--control.resizeStep", "0.5")[0]["macula"] != usual["macula"]
    assert used("--control.expectedWorkMs", "90")[0]["yang2008"] != usual["yang2008"]


def check_refusals(folder):
    for options, words in (
            ((), "name a scene"),
            (("smoke", "--plant"), "plant"),
            (("--plant", "--size", "64x64"), "--size"),
            (("--plant", "--load", "none"), "--load"),
            (("smokee",), "smoke"),
            (("smoke", "--load", "20"), "'20' is no step"),
            (("smoke", "--load", "20:0"), "'20:0' is no step"),
            (("smoke", "--load", "20:2x"), "'20:2x' is no step"),
            (("smoke", "--load", "40:2", "--frames", "40"), "beyond the last"),
            (("smoke", "--load", "20:2", "--load", "10:3"), "does not come after"),
            (("smoke", "--load", "none", "--load", "10:3"), "stands alone"),
            (("smoke", "--target-ms", "0"), "target-ms"),
            (("smoke", "--target-share", "3"), "target-share"),
            (("smoke", "--target-share", "90"), "write 0.9 for 90 %"),
            (("smoke", "--target-share", "90%"), "write 0.9 for 90 %"),
            (("smoke", "--control.leastAim", "95%"), "write 0.95 for 95 %"),
            (("smoke", "--camera", "orbit"), "give auto, scene, a path file or a recording"),
            (("smoke", "--law", "yang"), "nearest: 'yang2008'"),
            (("smoke", "--target-share", "0.5", "--target-ms", "10"), "target"),
            (("smoke", "--law", "maccula"), "macula"),
            (("smoke", "--control.mostResize", "9"), "control.mostResize"),
            (("smoke", "--size", "0x0"), "--size"),
            (("smoke", "--camera", "nowhere.csv"), "nowhere.csv"),
            (("--seeds", "2", "smoke"), "plant")):
        message = hold(folder, *options, "--out", "refused", status=2).stderr
        assert words in message, (options, message)
        assert not os.path.exists(os.path.join(folder, "refused")), options


def check_report(folder, page):
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if browser is None:
        print("skipped: no chromium for the report (apt-get install chromium)")
        return
    done = subprocess.run(
        [browser, "--headless=new", "--no-sandbox", "--disable-gpu",
         f"--user-data-dir={os.path.join(folder, 'profile')}", "--proxy-server=127.0.0.1:9",
         "--virtual-time-budget=5000", "--dump-dom", "file://" + page],
        capture_output=True, text=True, timeout=240)
    errors = re.search(r'<p id="script-errors"[^>]*>(.*?)</p>', done.stdout, re.S)
    assert errors and errors.group(1) == "" and "hidden" in errors.group(0), done.stderr[-2000:]
    assert done.stdout.count('class="uplot') >= 2 and "smoke: " in done.stdout
    with open(os.path.join(os.path.dirname(page), "results.json"), encoding="utf-8") as f:
        results = json.load(f)
    word = results["verdict"]
    title = re.search(r'<h1 id="title">(.*?)</h1>', done.stdout).group(1)
    assert title.endswith(f" ms {word} by macula") or word == "not judged", title
    assert f">{word.capitalize()}: <" in done.stdout, word
    cells = {key: [re.findall(r"<td[^>]*>(.*?)</td>", row) for row in re.findall(
        r"<tr>(.*?)</tr>", re.search(f'id="{key}">(.*?)</table>', done.stdout, re.S).group(1))
        if "<td" in row] for key in ("loads", "parts")}
    assert [row[-2:] for row in cells["loads"]] == [
        [f"{load['ideal_r']:.2f}", load["limit"]] for load in results["loads"]], cells["loads"]
    words = {True: "held", False: "not held", None: "not judged"}
    assert [(row[2], row[4]) for row in cells["parts"]] == [
        (words[p["met"]], f"{p['ideal_r']:.2f}") for p in results["parts"]], cells["parts"]
    foot = done.stdout[done.stdout.index("How this was made"):]
    assert "macula hold smoke" in foot and "scene" in foot and "seed" in foot, foot[:2000]


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_refusals(folder)
        check_plant(folder)
        page = check_example(folder)
        check_easy(folder)
        check_hopeless(folder)
        check_fixed(folder)
        check_nothing(folder)
        check_off(folder)
        check_share(folder)
        check_report(folder, page)
    print("hold: all checks passed")


main()
