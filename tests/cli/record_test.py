#!/usr/bin/env python3
"""macula walk --record in a real window, and replay of what it recorded.

usage: record_test.py PROGRAM

Pointer, keys and the window's size are changed while the walk runs; what has been recorded so far
says when, never a clock. Exit status 77: not run.
"""
import json
import os
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time

from interrupted import interrupted

MACULA = sys.argv[1]

for tool in ("Xvfb", "xdotool"):
    if shutil.which(tool) is None:
        print(f"skipped: {tool} is not installed (apt-get install xvfb xdotool)")
        sys.exit(77)


class Display:
    """An X server without a screen that chose a free display itself."""

    def __enter__(self):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", "800x600x24", "-nolisten", "tcp",
             "-noreset"], pass_fds=[write], stderr=subprocess.DEVNULL)
        os.close(write)
        with os.fdopen(read) as number:
            os.environ["DISPLAY"] = ":" + number.readline().strip()
        os.environ.pop("WAYLAND_DISPLAY", None)
        return self

    def __exit__(self, *_):
        self.server.terminate()
        self.server.wait()


def xdotool(*words):
    return subprocess.run(["xdotool", *map(str, words)], check=True, capture_output=True,
                          text=True).stdout


def lines_of(path):
    """Whole lines; the one that is being written does not count."""
    if not os.path.exists(path):
        return []
    with open(path, encoding="utf-8") as f:
        return [line for line in f if line.endswith("\n")]


class Walk:
    """A walk that is recorded, steered from outside."""

    def __init__(self, folder, scene, *options):
        self.frames_file = os.path.join(folder, "frames.jsonl")
        self.process = subprocess.Popen(
            [MACULA, "walk", scene, "--record", folder, "--record-hashes", *options],
            stderr=subprocess.PIPE, text=True)

    def wait_for(self, frames):
        """Until that many more frames are recorded."""
        wanted = len(lines_of(self.frames_file)) + frames
        while len(lines_of(self.frames_file)) < wanted:
            assert self.process.poll() is None, self.process.stderr.read()
            time.sleep(0.005)

    def press(self, key):
        """Down for two frames, so that a key of the camera moves it in each."""
        xdotool("keydown", key)
        self.wait_for(2)
        xdotool("keyup", key)
        self.wait_for(2)

    def window(self):
        return xdotool("search", "--name", "Macula: ").split()[0]

    def kill(self):
        self.process.send_signal(signal.SIGKILL)
        self.process.wait()


def replay(folder, out, *options, status=0):
    done = subprocess.run([MACULA, "replay", folder, "--out", out, *options],
                          capture_output=True, text=True)
    assert done.returncode == status, (done.returncode, done.stderr)
    assert status == 0 or done.stderr.count("\n") == 1, done.stderr
    if status == 2:
        return done.stderr
    with open(os.path.join(out, "report.json"), encoding="utf-8") as f:
        return json.load(f)


def timeless(report):
    for frame in report["frames"]:
        del frame["ms"]
    del report["summary"]["ms"], report["summary"]["load_ms"], report["summary"]["first_frame_ms"]
    return report


def check_equal(report, frames, truncated=0):
    recording = report["recording"]
    assert recording["frames"] == len(report["frames"]) == frames, recording
    assert recording["truncated_lines"] == truncated, recording
    assert recording["unrecorded_frames"] == 0, recording
    assert recording["hashes_equal"] == recording["hashes_compared"] == frames, recording
    assert recording["first_difference"] is None, recording


def check_steered_and_killed(folder):
    """Everything that a person does, then kill -9: what was drawn is there, and replays."""
    record = os.path.join(folder, "steered")
    xdotool("mousemove", 790, 590)  # outside the window
    walk = Walk(record, "smoke", "--size", "320x240", "--method", "kb-variable", "--k-ave", "2",
                "--no-panels")
    walk.wait_for(4)
    for x in range(40, 240, 40):
        xdotool("mousemove", x, 120)
        walk.wait_for(1)
    walk.press("w")
    walk.press("h")
    xdotool("windowsize", walk.window(), 280, 200)
    walk.wait_for(4)
    walk.press("r")
    for _ in range(3):  # after kb-variable comes the last of the table, and then the first
        walk.press("m")
    walk.kill()

    frames = [json.loads(line) for line in lines_of(os.path.join(record, "frames.jsonl"))]
    assert [f["index"] for f in frames] == list(range(len(frames)))
    assert frames[0]["reset"] == "restart"
    assert len({f["gaze"]["x"] for f in frames}) >= 4, "the pointer was followed"
    assert {(f["width"], f["height"]) for f in frames} >= {(320, 240), (280, 200)}
    assert len({json.dumps(f["camera"]) for f in frames}) >= 3, "w flew ahead"
    assert sum(f["cut"] for f in frames[1:]) == 1, "r is a cut"
    changed = [f for f in frames if "settings" in f]
    methods = [f["settings"]["oit.method"] for f in changed if "oit.method" in f["settings"]]
    assert methods == ["kb-learned", "blend", "wboit"], methods
    assert any("view.heatmap" in f["settings"] for f in changed)
    assert all(f["reset"] == "history" for f in changed), "settings give up history"

    # The pointer's place is written before the frame that uses it is drawn: rows without a frame
    # count the frames that were lost.
    rows = lines_of(os.path.join(record, "gaze_raw.csv"))
    assert rows[0] == "time_s,x,y,valid,confidence,pupil_mm\n", rows[0]
    seen = sum(f["gaze"]["state"] == "ok" for f in frames)
    assert seen <= len(rows) - 1 <= seen + 1, (seen, len(rows) - 1)
    info = subprocess.run([MACULA, "gaze", "info", os.path.join(record, "gaze_raw.csv"), "--json",
                           "-"], check=True, capture_output=True, text=True)
    assert json.loads(info.stdout)["samples"] == len(rows) - 1

    out = os.path.join(folder, "out")
    first = replay(record, out)
    check_equal(first, len(frames))
    for got, recorded in zip(first["frames"], frames):
        assert got["time_s"] == recorded["time_s"]
        assert got["image_sha256"] == recorded["image_sha256"]
    assert len({f["image_sha256"] for f in first["frames"]}) > 8, "the walk showed something"
    second = replay(record, os.path.join(folder, "again"), "--reference", "--images", "png")
    assert os.path.exists(os.path.join(folder, "again", "frame_00000.png"))
    check_equal(second, len(frames))
    assert second["summary"]["error"]["rmse"] is not None
    third = replay(record, out)
    assert timeless(first) == timeless(third), "two replays differ"
    return record, frames


def check_camera(folder, record, frames):
    """The camera and the gaze of a recording serve elsewhere."""
    out = os.path.join(folder, "elsewhere")
    options = ["--frames", "4", "--fps", str(4 / frames[-1]["time_s"]), "--size", "64x48", "--gaze",
               os.path.join(record, "gaze_raw.csv")]

    def images(camera):
        subprocess.run([MACULA, "replay", "smoke", "--camera", camera, "--out", out, *options],
                       check=True, stdout=subprocess.DEVNULL)
        with open(os.path.join(out, "report.json"), encoding="utf-8") as f:
            return [frame["image_sha256"] for frame in json.load(f)["frames"]]

    flown = images(record)
    assert len(set(flown)) > 1 and flown != images("scene"), "the camera moved"


def check_refused_change(folder):
    """A change that the renderer refuses leaves nothing behind that a replay would not know."""
    record = os.path.join(folder, "refused")
    walk = Walk(record, "layers-12", "--size", "160x120", "--method", "ab-sbuffer", "--k-ave",
                "0.5", "--no-panels", "--set", "importance.noisePerFrame=on")
    walk.wait_for(3)
    xdotool("mousemove", 80, 60)
    walk.press("m")  # kb-racy and others refuse half a layer for each sample, and are passed over
    walk.press("m")
    walk.kill()
    frames = [json.loads(line) for line in lines_of(os.path.join(record, "frames.jsonl"))]
    restarts = [f["index"] for f in frames if f["reset"] == "restart"]
    assert len(restarts) >= 2 and restarts[0] == 0, restarts
    methods = [f["settings"]["oit.method"] for f in frames if "settings" in f]
    assert len(methods) == 2 and "kb-racy" not in methods, f"refused ones are not kept: {methods}"
    check_equal(replay(record, os.path.join(folder, "out")), len(frames))


def check_script(folder):
    """Everything in one walk: methods, scenes, settings of the scene, views and stills between."""
    script = os.path.join(folder, "script.txt")
    with open(script, "w", encoding="utf-8") as f:
        f.write("0 set frame.seed=5\n2 press M\n2 press H\n2 press F12\n2 press F12\n"
                "4 scene layers-3\n6 set frame.seed=6\n8 view side\n9 press X\n10 view one\n"
                "11 set scene.lighting=unlit\n12 gaze 0.2,0.8\n13 set gaze.latencyMs=40\n")
    record = os.path.join(folder, "scripted")
    done = subprocess.run([MACULA, "walk", "smoke", "--size", "200x150", "--k-ave", "0.5",
                           "--script", script, "--frames", "16", "--no-panels", "--record", record,
                           "--record-hashes"], cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert os.path.exists(os.path.join(folder, "macula_002.png")), "both pictures are there"
    with open(os.path.join(record, "frames.jsonl"), encoding="utf-8") as f:
        frames = [json.loads(line) for line in f]
    assert sum("scene" in f for f in frames) >= 3, "the scene was loaded again"
    report = replay(record, os.path.join(folder, "out"))["recording"]
    assert report["hashes_equal"] == report["hashes_compared"] == len(frames), report


def check_cut_off(folder, record, frames):
    """The line that was being written is dropped and counted; a changed line is an error."""
    cut = os.path.join(folder, "cut")
    shutil.copytree(record, cut)
    path = os.path.join(cut, "frames.jsonl")
    with open(path, "rb+") as f:
        text = f.read()
        f.truncate(len(text) - 40)
    check_equal(replay(cut, os.path.join(folder, "out")), len(frames) - 1, truncated=1)

    lines = text.decode().splitlines(keepends=True)
    sha = frames[3]["image_sha256"]
    lines[3] = lines[3].replace(sha, "0" * 64)
    with open(path, "w", encoding="utf-8") as f:
        f.writelines(lines)
    report = replay(cut, os.path.join(folder, "out"), status=1)
    assert report["recording"]["first_difference"] == 3, report["recording"]
    assert report["recording"]["hashes_equal"] == len(frames) - 1, report["recording"]

    lines[5] = lines[5].replace('"cut"', '"cutt"')
    with open(path, "w", encoding="utf-8") as f:
        f.writelines(lines)
    out = os.path.join(folder, "nothing")
    message = replay(cut, out, status=2)
    assert f"{path}: line 6: 'cut' is missing" in message, message
    assert not os.path.exists(out), "nothing half-written"


def check_interrupted(folder, record, frames):
    """SIGINT after the first frame: the report of what was drawn of a long recording."""
    long = os.path.join(folder, "long")
    shutil.copytree(record, long)
    still = {**frames[-1], "reset": "none"}
    del still["image_sha256"]
    still.pop("settings", None)
    with open(os.path.join(long, "frames.jsonl"), "a", encoding="utf-8") as f:
        for i in range(len(frames), 5000):
            f.write(json.dumps({**still, "index": i, "time_s": frames[-1]["time_s"] + i}) + "\n")
    out = os.path.join(folder, "part")
    status, seen = interrupted([MACULA, "replay", long, "--out", out], folder)
    assert status == 130, (status, seen[-300:])
    with open(os.path.join(out, "report.json"), encoding="utf-8") as f:
        report = json.load(f)
    drawn = len(report["frames"])
    assert f"after {drawn} of 5000 frames" in seen, seen[-300:]
    assert report["interrupted"] is True and 1 <= drawn < 5000
    assert report["recording"]["first_difference"] is None, report["recording"]


def check_refusals(folder, record):
    out = os.path.join(folder, "nothing")
    message = replay(record, out, "--method", "blend", status=2)
    assert "--method" in message or "oit.method" in message, message
    assert "--frames" in replay(record, out, "--frames", "3", status=2)
    assert "session.json" in replay(folder, out, status=2)
    done = subprocess.run([MACULA, "walk", "smoke", "--record", record], capture_output=True,
                          text=True)
    assert done.returncode == 2 and "holds a recording already" in done.stderr, done.stderr
    done = subprocess.run([MACULA, "walk", "smoke", "--record-hashes"], capture_output=True,
                          text=True)
    assert done.returncode == 2, done.stderr


def check_scene_file(folder):
    """A file that has changed since is named; a walk that ends by itself is a recording as well."""
    scene = os.path.join(folder, "four layers.glb")
    subprocess.run([MACULA, "scene", "make", "layers-4", "--out", scene], check=True,
                   stdout=subprocess.DEVNULL)
    record = os.path.join(folder, "of a file")
    walk = Walk(record, scene, "--size", "96x64", "--frames", "5")
    assert walk.process.wait() == 0, walk.process.stderr.read()
    check_equal(replay(record, os.path.join(folder, "out")), 5)
    with open(scene, "ab") as f:
        f.write(b"\0")
    message = replay(record, os.path.join(folder, "out"), status=2)
    assert scene in message and "no longer the file of the recording" in message, message


def check_scene_change(folder):
    """Two recordings, one after the other, are one in which the scene changes."""
    records = []
    for scene in ("layers-12", "smoke"):
        record = os.path.join(folder, "first " + scene)
        walk = Walk(record, scene, "--size", "96x64", "--frames", "4", "--no-panels")
        assert walk.process.wait() == 0, walk.process.stderr.read()
        records.append(record)
    path = os.path.join(records[0], "frames.jsonl")
    frames = [json.loads(line) for line in lines_of(path)]
    for line in lines_of(os.path.join(records[1], "frames.jsonl")):
        frame = json.loads(line)
        if frame["index"] == 0:
            frame["reset"] = "scene"
            frame["scene"] = {"name": "smoke", "file": None, "sha256": None}
        frame["index"] = len(frames)
        frame["settings"] = {"walk.only": 1}  # what no image depends on
        frames.append(frame)

    def write():
        with open(path, "w", encoding="utf-8") as f:
            f.writelines(json.dumps(frame) + "\n" for frame in frames)

    write()
    out = os.path.join(folder, "out")
    done = subprocess.run([MACULA, "replay", records[0], "--out", out], capture_output=True,
                          text=True)
    assert done.returncode == 0 and done.stderr.count("'walk.only' is not known") == 1, done.stderr
    with open(os.path.join(out, "report.json"), encoding="utf-8") as f:
        check_equal(json.load(f), len(frames))

    for change, words in (({"r": 9}, "line 7: 'r' is 9; give 1 to 8"),
                          ({"levers": {"fovea_slop": 1.5}}, "'fovea_slop' is not known; the nearest"),
                          ({"levers": {"layer_share": 0}}, "line 7: the quality control 'layer_share' is 0"),
                          ({"levers": {"resize": "nan"}}, "line 7: the quality control 'resize' is nan")):
        before = dict(frames[6])
        frames[6].update(change)
        write()
        message = replay(records[0], out, status=2)
        assert words in message, message
        frames[6] = before


def check_control(folder):
    """Quality controls as they were used are in the file, and their replay gives the same images."""
    script = os.path.join(folder, "control.txt")
    with open(script, "w", encoding="utf-8") as f:
        f.write("1 set control.fixedR=2.3\n4 set control.law=off\n")
    # On a busy machine the clock may fail its check at the start, which switches control off.
    for attempt in range(3):
        record = os.path.join(folder, f"controlled{attempt}")
        walk = Walk(record, "gallery", "--size", "96x64", "--frames", "7", "--no-panels",
                    "--script", script, "--law", "fixed", "--control.fixedR", "1.37")
        assert walk.process.wait() == 0, walk.process.stderr.read()
        frames = [json.loads(line) for line in lines_of(os.path.join(record, "frames.jsonl"))]
        levers = [frame.get("levers") for frame in frames]
        if any(levers):
            break

    def single(value):  # as a renderer has it
        return struct.unpack("f", struct.pack("f", value))[0]

    first, second = {"resize": single(1.37)}, {"resize": single(2.3)}
    assert levers[0] == first and second in levers and levers[-1] is None, levers
    assert all(lever in (first, second, None) for lever in levers), levers
    assert all(1 <= frame["r"] <= 2.4 for frame in frames), frames
    resets = [frame["reset"] for frame in frames if frame["index"] > 0]
    assert set(resets) == {"none"}, "control gives up no history"
    out = os.path.join(folder, "out")
    report = replay(record, out)
    check_equal(report, len(frames))
    used = [frame["r"] for frame in report["frames"]]
    assert used == [frame["r"] for frame in frames], used


def main():
    with tempfile.TemporaryDirectory() as folder, Display():
        record, frames = check_steered_and_killed(folder)
        check_camera(folder, record, frames)
        check_script(folder)
        check_refused_change(folder)
        check_cut_off(folder, record, frames)
        check_interrupted(folder, record, frames)
        check_refusals(folder, record)
        check_scene_file(folder)
        check_scene_change(folder)
        check_control(folder)
    print(f"record: all checks passed, {len(frames)} steered frames")


main()
