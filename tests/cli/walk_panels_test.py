#!/usr/bin/env python3
"""The walkthrough's panels, views, files and refusals, driven by scripts in a real window.

usage: walk_panels_test.py PROGRAM [FOLDER]

Screenshots and numbers stay in FOLDER where one is given. Nothing is decided by time: frames that
wait for a thread are not counted. Exit status 77: not run.
"""
import json
import os
import shlex
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

MACULA = sys.argv[1]
KEEP = sys.argv[2] if len(sys.argv) > 2 else None
SOURCE = os.environ["MACULA_SOURCE"]
SIZE = (640, 480)
TABS = ["view", "scene", "gaze", "camera", "compare", "settings"]
# Where the tabs' panel is at 640x480: within this, and nothing of it right of it.
PANEL = (8, 8, 290, 300)
BESIDE = (298, 60, 420, 360)
faults = 0


def check(good, what):
    global faults
    print("ok    " if good else "FAULT ", what, flush=True)
    faults += not good


def read_png(path):
    """Width, height and rows of RGB bytes of an 8-bit RGB PNG (W3C PNG, 9.2: filters)."""
    with open(path, "rb") as f:
        data = f.read()
    at, packed, header = 8, b"", None
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", body)
        elif kind == b"IDAT":
            packed += body
        at += length + 12
    width, height, depth, colour = header[:4]
    assert depth == 8 and colour == 2, header
    raw, stride, rows = zlib.decompress(packed), width * 3, []
    before = bytearray(stride)
    for y in range(height):
        kind = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left = row[i - 3] if i >= 3 else 0
            up = before[i]
            if kind == 1:
                row[i] = (row[i] + left) & 255
            elif kind == 2:
                row[i] = (row[i] + up) & 255
            elif kind == 3:
                row[i] = (row[i] + (left + up) // 2) & 255
            elif kind == 4:
                corner = before[i - 3] if i >= 3 else 0
                guess = left + up - corner
                a, b, c = abs(guess - left), abs(guess - up), abs(guess - corner)
                row[i] = (row[i] + (left if a <= b and a <= c else up if b <= c else corner)) & 255
        rows.append(bytes(row))
        before = row
    return width, height, rows


def differing(a, b, box):
    """Share of the pixels of a box (left, top, right, bottom) that differ."""
    count = 0
    for y in range(box[1], box[3]):
        p, q = a[2][y], b[2][y]
        if p[3 * box[0]:3 * box[2]] != q[3 * box[0]:3 * box[2]]:
            count += sum(p[3 * x:3 * x + 3] != q[3 * x:3 * x + 3] for x in range(box[0], box[2]))
    return count / ((box[2] - box[0]) * (box[3] - box[1]))


def start(name, script, *options):
    with open(f"{name}.script", "w", encoding="utf-8") as f:
        f.write(script)
    return subprocess.run(
        [MACULA, "walk", *options, "--script", f"{name}.script", "--screenshot", f"{name}.png",
         "--json", f"{name}.json"], stderr=subprocess.PIPE, text=True, check=False)


def walk(name, script, *options, scene="layers-4", size="320x240", frames=3, gaze="0.8,0.5"):
    """Numbers and the picture's file of a run that must succeed."""
    done = start(name, script, scene, "--size", size, "--frames", str(frames), "--gaze", gaze,
                 *options)
    if done.returncode != 0:
        print(done.stderr)
        sys.exit(f"{name}: status {done.returncode}")
    check("user error" not in done.stderr.lower(), f"{name}: OpenGL is used rightly")
    with open(f"{name}.json", encoding="utf-8") as f:
        return json.load(f), f"{name}.png"


def compare(a, b):
    done = subprocess.run([MACULA, "compare", a, b, "--json", "-"], stdout=subprocess.PIPE,
                          text=True, check=True)
    return json.loads(done.stdout[done.stdout.index("{"):done.stdout.rindex("}") + 1])


def test_panels():
    bare = read_png(walk("bare", "", "--no-panels", size="640x480")[1])
    check(bare[:2] == SIZE, "bare: the picture is the window")
    shown = {}
    for tab in TABS:
        numbers, picture = walk(f"tab-{tab}", f"1 tab {tab}\n", size="640x480")
        shown[tab] = read_png(picture)
        check(shown[tab][:2] == SIZE and numbers["tab"] == tab, f"{tab}: is open")
        check(differing(bare, shown[tab], PANEL) > 0.5, f"{tab}: is drawn in its place")
        check(differing(bare, shown[tab], BESIDE) == 0.0, f"{tab}: leaves the picture beside it")
    for a, b in zip(TABS, TABS[1:]):
        check(differing(shown[a], shown[b], PANEL) > 0.02, f"{a} and {b} are different tabs")
    numbers = read_png(walk("numbers", "1 press F9\n", size="640x480")[1])
    check(differing(shown["view"], numbers, (350, 60, 620, 400)) > 0.5, "F9 opens the numbers")
    page = read_png(walk("keys", "1 press F2\n", size="640x480")[1])
    check(differing(shown["view"], page, (200, 60, 480, 420)) > 0.5, "F2 shows the keys")
    large = read_png(walk("large", "", "--ui-scale", "2", size="640x480")[1])
    check(differing(shown["view"], large, (8, 8, 290, 460)) > 0.1, "--ui-scale changes the panels")
    found, _ = walk("search", "1 search exposure\n")
    check(found["search_hits"] == 1 and found["tab"] == "settings", "search finds the exposure")
    found, _ = walk("search-none", "1 search exposure nothinghasthis\n")
    check(found["search_hits"] == 0, "search finds nothing where a word is missing")


def test_scenes():
    numbers, _ = walk("switch", "1 scene hairball\n", "--no-panels")
    check(numbers["scene"] == "hairball", "switch: the scene is another one")
    check(numbers["loading_frames"] > 1, "switch: frames go on while a scene loads")
    numbers, _ = walk("replaced", "1 scene hairball\n1 scene layers-2\n", "--no-panels")
    check(numbers["scene"] == "layers-2", "a scene asked for later takes the place of one that loads")
    numbers, _ = walk("cancelled", "1 scene hairball\n1 press Esc\n", "--no-panels")
    check(numbers["scene"] == "layers-4" and "cancelled" in numbers["message"], "Esc ends loading")
    numbers, _ = walk("reseeded", "1 set frame.seed=5\n", "--no-panels", scene="smoke")
    check("--seed 5" in numbers["command_line"] and numbers["loading_frames"] > 1,
          "a setting of the scene loads it again")
    numbers, _ = walk("no-sky", "1 set scene.environment=nowhere.hdr\n", "--no-panels")
    check("nowhere.hdr" in numbers["message"] and "environment" not in numbers["command_line"],
          "an environment that is not there is taken back")
    with open("no_log.csv", "w", encoding="utf-8") as f:
        f.write("a,b\n1,2\n")
    numbers, _ = walk("refused-log", "1 drop no_log.csv\n", gaze="mouse")
    check("no_log.csv" in numbers["message"] and "line 1" in numbers["message"],
          "a file that is no gaze log is refused by file and line")
    check("read as a gaze log" in numbers["message"], "and it is said why it was taken for one")
    check(numbers["gaze"]["source"] == "mouse", "the gaze source before stays")
    for name, step, words in (
            ("nothing", "drop", "no file is named"), ("missing", "drop no.glb", "no such file"),
            ("folder", "drop .", "is a folder with 0 scene files"),
            ("path-missing", "play no.csv", "no such file"), ("path-folder", "play .", "is a folder"),
            ("log-missing", "gaze no.csv", "no such file"), ("log-folder", "gaze .", "is a folder"),
            ("twice", "scene hairball\n1 scene hairball", "already loading hairball")):
        numbers, _ = walk(f"refused-{name}", f"1 {step}\n")
        check(words in numbers["message"], f"1 {step!r}: {numbers['message']}")
    numbers, _ = walk("refused-scene", "1 scene nowhere.glb\n")
    check("nowhere.glb" in numbers["message"] and numbers["scene"] == "layers-4",
          "a scene that is not there leaves the one before")
    subprocess.run([MACULA, "scene", "make", "layers-2", "--out", "two.glb"], check=True,
                   stdout=subprocess.DEVNULL)
    log = os.path.join(SOURCE, "assets", "gallery_gaze.csv")
    numbers, _ = walk("dropped", f"1 drop two.glb\n2 drop {log}\n", frames=4)
    check(numbers["scene"] == "two.glb", "a dropped scene is shown")
    check(numbers["gaze"]["source"].endswith("gallery_gaze.csv") and
          numbers["gaze"]["state"] == "ok", "a dropped gaze log is followed")
    with open("core.csv", "w", encoding="utf-8") as f:
        f.write("gaze_timestamp,confidence,norm_pos_x,norm_pos_y\n1,1,0.25,0.75\n")
    numbers, _ = walk("scene-camera", "1 drop core.csv\n", gaze="mouse")
    check("scene camera" in numbers["message"] and len(numbers["gaze"]["warnings"]) == 1,
          "gaze of a scene camera is announced")
    done = start("first", "", "nowhere.glb", "--frames", "1")
    check(done.returncode == 2 and len(done.stderr.strip().splitlines()) == 1,
          "without a first scene: one line and status 2")
    done = start("first-gaze", "", "layers-2", "--frames", "1", "--gaze", "no_log.csv")
    check(done.returncode == 2 and "no_log.csv" in done.stderr, "the same for the first gaze log")
    done = start("bad-script", "1 prss F2\n", "layers-2", "--frames", "1")
    check(done.returncode == 2 and "bad-script.script, line 1" in done.stderr,
          "a script with an unknown action is refused")


def test_views():
    walk("a", "1 png a-only.png\n2 set oit.method=blend\n2 png b-only.png\n", "--no-panels",
         "--method", "ab-sbuffer", frames=4)
    walk("split", "1 set-second oit.method=blend\n1 view split\n2 png split-only.png\n",
         "--no-panels", "--method", "ab-sbuffer", frames=4)
    a, b, split = (read_png(f"{n}-only.png") for n in ("a", "b", "split"))
    whole = (0, 0, 320, 240)
    check(differing(a, b, whole) > 0.1, "split: the two methods differ in this scene")
    check(differing(a, split, (0, 0, 160, 240)) == 0.0, "split: the left half is method A")
    check(differing(b, split, (160, 0, 320, 240)) == 0.0, "split: the right half is method B")
    walk("difference", "1 view difference\n2 png difference-only.png\n", "--no-panels", "--method",
         "ab-sbuffer", frames=4)
    grey = read_png("difference-only.png")
    legend = 70  # rows at the top that a legend may take
    check(all(row[0::3] == row[1::3] == row[2::3] for row in grey[2][legend:]),
          "difference: a method and itself leave only grey")
    # Equal images by methods whose k differs.
    walk("map", "1 set view.heatmap=k\n2 png map-only.png\n4 set-second oit.method=kb-fixed\n"
         "4 set-second oit.kAve=8\n4 view difference\n6 png map-difference-only.png\n",
         "--no-panels", "--method", "ab-sbuffer", frames=8)
    heat = read_png("map-only.png")
    check(differing(a, heat, whole) > 0.5, "heat map: it is shown")
    coldest = any(row[i] == 68 and row[i + 1] < 8 for row in heat[2][:legend]
                  for i in range(0, len(row), 3))
    check(coldest, "heat map: its legend is on the picture")  # four slots are the hottest colour
    check(all(row[0::3] == row[1::3] == row[2::3]
              for row in read_png("map-difference-only.png")[2][legend:]),
          "heat map: differences are those of the images")
    numbers, _ = walk("difference-two", "1 set-second oit.method=blend\n1 view difference\n"
                      "2 press ,\n3 png hot-only.png\n", "--no-panels", "--method", "ab-sbuffer",
                      frames=5)
    hot = read_png("hot-only.png")
    check(differing(grey, hot, whole) > 0.1 and numbers["second"]["difference_scale"] == 16,
          "difference: two methods give colours, amplified by a key")
    numbers, _ = walk("side", "1 view side\n", "--no-panels")
    check(numbers["second"]["view"] == "side" and numbers["second"]["method"] == "ab-sbuffer",
          "side by side: method B begins as the exact one")

    exact, _ = walk("exact", "1 press X\n", "--method", "ab-sbuffer")
    check(exact["error"]["rmse"] == 0 and exact["error"]["psnr_db"] is None,
          "the exact method has no error against itself")
    numbers, _ = walk("measured", "1 press X\n2 map flip\n", "--method", "blend", frames=4)
    known = compare("a-only.png", "b-only.png")
    check(known["rmse"] > 0 and abs(numbers["error"]["rmse"] - known["rmse"]) < 1e-9,
          "the error on demand is that of 'macula compare'")
    check(abs(numbers["error"]["flip"] - known["flip"]) < 1e-9, "and so is FLIP")
    check(0 < numbers["error"]["frame"] < numbers["frame"] and
          f"at frame {numbers['error']['frame']};" in numbers["message"],
          "errors say at which frame they were measured")
    check(numbers["frames_per_second"] > 0, "the frame rate is known")
    numbers, _ = walk("measured-second", "1 view split\n1 set-second oit.method=wboit\n"
                      "2 measure second\n", "--method", "blend", frames=4)
    check(numbers["error"]["reference"] == "wboit", "errors against method B")
    check(numbers["ms"]["total"] > 0 and numbers["second"]["ms"]["total"] > 0,
          "both methods have a time of their own")


def test_files_and_keys():
    numbers, _ = walk("exr", "1 exr linear.exr\n", "--no-panels", "--method", "ab-sbuffer",
                      frames=2)
    if "writes no EXR" in numbers["message"]:
        print("skipped: EXR (this build has no OpenImageIO)")
    else:
        check(compare("linear.exr", "a-only.png")["rmse"] < 0.003, "the EXR shows the same picture")
    check(not [name for name in os.listdir(".") if ".part" in name], "nothing half-written is left")
    walk("numbered", "1 press F12\n2 press F12\n", "--no-panels")
    check(os.path.exists("macula_001.png") and os.path.exists("macula_002.png"),
          "pictures are numbered")
    numbers, _ = walk("nowhere", "1 png no/such/folder/x.png\n")
    check("no/such/folder" in numbers["message"], "a folder that is not there is named")

    script = ("1 set oit.method=kb-fixed\n1 set scene.background=0,0.5,0\n"
              "1 set tonemap.exposure=-1\n1 set oit.tail=mean\n1 press C\n")
    numbers, _ = walk("command", script)
    words = shlex.split(numbers["command_line"])
    check(words == ["macula", "walk", "layers-4", "--size", "320x240", "--gaze", "0.8,0.5",
                    "--method", "kb-fixed", "--oit.tail", "mean", "--exposure=-1", "--background",
                    "0,0.5,0"], f"as a command: {numbers['command_line']}")
    done = start("again", "", *words[2:], "--frames", "2")
    with open("again.json", encoding="utf-8") as f:
        again = json.load(f)
    check(done.returncode == 0 and again["command_line"] == numbers["command_line"],
          "the command gives the same walk")

    numbers, _ = walk("next", "1 press M\n", "--oit.fill", "on", "--method", "kb-learned")
    check(numbers["method"] == "kb-plus", "M skips the methods that the options refuse")
    numbers, _ = walk("refused-set", "1 set oit.method=peel\n", "--oit.fill", "on")
    check(numbers["method"] == "kb-variable", "a method that is refused is taken back")

    numbers, _ = walk("rivals", "1 set oit.memoryMiB=8\n2 set oit.kAve=2\n", frames=4)
    check("oit.memoryMiB is 0 again" in numbers["message"], f"one budget: {numbers['message']}")
    check("--k-ave 2" in numbers["command_line"] and "memory" not in numbers["command_line"],
          f"the budget that was set last holds: {numbers['command_line']}")
    numbers, _ = walk("rival-kept", "1 set oit.memoryMiB=0.000001\n", "--k-ave", "2")
    check("--k-ave 2" in numbers["command_line"] and "memory" not in numbers["command_line"],
          "a budget that is refused leaves the other")

    still, _ = walk("still", "")
    numbers, _ = walk("orbit", "", "--camera", "auto", scene="smoke")
    check(numbers["camera"]["playing"] and not still["camera"]["playing"], "the orbit plays")
    numbers, _ = walk("record", "1 record\n3 record\n3 play\n", frames=4)
    with open("camera_001.csv", encoding="utf-8") as f:
        check(f.readline().startswith("time_s,x,y,z,"), "a camera path is recorded")
    done = start("bad-path", "", "layers-2", "--frames", "1", "--camera", "no_log.csv")
    check(done.returncode == 2 and "no_log.csv, line 1" in done.stderr,
          "a file that is no camera path is refused")


def run(tests):
    """Runs tests in a folder of their own, on a display of their own."""
    if shutil.which("Xvfb") is None:
        print("skipped: Xvfb is not installed (apt-get install xvfb)")
        sys.exit(77)
    os.environ.pop("WAYLAND_DISPLAY", None)
    os.environ["MESA_DEBUG"] = "1"  # Mesa then prints what a program does wrong with OpenGL
    ends = os.pipe()
    # The server itself chooses a free display and says which once it takes connections.
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(ends[1]), "-screen", "0", "1280x800x24", "-nolisten", "tcp",
         "-noreset"], pass_fds=[ends[1]], stderr=subprocess.DEVNULL)
    os.close(ends[1])
    with tempfile.TemporaryDirectory() as folder:
        try:
            with os.fdopen(ends[0], encoding="ascii") as said:
                os.environ["DISPLAY"] = ":" + said.readline().strip()
            os.chdir(folder)
            for test in tests:
                test()
        finally:
            server.terminate()
            server.wait()
            if KEEP:
                os.makedirs(KEEP, exist_ok=True)
                for name in os.listdir(folder):
                    if name.endswith((".png", ".json")):
                        shutil.copy(os.path.join(folder, name), KEEP)
            os.chdir("/")
    if faults:
        sys.exit(f"{faults} faults")


if __name__ == "__main__":
    run((test_panels, test_scenes, test_views, test_files_and_keys))
