#!/usr/bin/env python3
"""Keys, clicks and text within one slow frame of the walkthrough, and what a recording shows.

usage: walk_input_test.py PROGRAM [FOLDER]

A frame is made slow by stopping the program while xdotool presses, clicks and types: the next frame
finds all of it at once. Exit status 77: not run.
"""
import json
import os
import shlex
import shutil
import signal
import subprocess
import sys
import time

from walk_panels_test import MACULA, PANEL, check, differing, read_png, run, walk

TIMEOUT = 60  # seconds until a test that waits for ever is given up
RED = bytes((235, 60, 50))  # of the dot that stands for a recording


def xdotool(*words):
    subprocess.run(["xdotool", *map(str, words)], check=True, stdout=subprocess.DEVNULL,
                   timeout=TIMEOUT)


class Walk:
    """A walk that stays open until Ctrl Q."""

    def __init__(self, name, *options):
        self.name = name
        self.process = subprocess.Popen(
            [MACULA, "walk", "layers-4", "--size", "640x480", "--gaze", "0.8,0.5", "--method",
             "ab-sbuffer", "--json", f"{name}.json", *options], stderr=subprocess.PIPE, text=True)
        self.shows("layers-4")
        # The panels stand in their places when the first picture is written.
        picture = f"{name}-ready.png"
        xdotool("key", "F12")
        while not os.path.exists("macula_001.png"):
            assert self.process.poll() is None, self.process.stderr.read()
            time.sleep(0.01)
        os.replace("macula_001.png", picture)

    def shows(self, scene):
        """Waits until that scene is in the window."""
        xdotool("search", "--sync", "--onlyvisible", "--name", f"^Macula: {scene}$")

    def in_one_frame(self, *commands):
        os.kill(self.process.pid, signal.SIGSTOP)
        for command in commands:
            xdotool(*command)
        os.kill(self.process.pid, signal.SIGCONT)

    def numbers(self):
        """Of the last frame; the walk must have been told to end."""
        _, said = self.process.communicate(timeout=TIMEOUT)
        check(self.process.returncode == 0, f"{self.name}: ends with status 0 {said}")
        with open(f"{self.name}.json", encoding="utf-8") as f:
            return json.load(f)


LEAVE = ("key", "ctrl+q")


def click(x, y):
    return ("mousemove", x, y, "click", 1)


def path_field():
    """Where the field for a path is on the scene tab: so far above the end of its panel."""
    bare = read_png(walk("bare", "", "--no-panels", size="640x480")[1])
    shown = read_png(walk("scene", "1 tab scene\n", size="640x480")[1])
    rows = [y for y in range(8, 440) if differing(bare, shown, (PANEL[0], y, PANEL[2], y + 1)) > 0.5]
    return click(100, rows[-1] - 47)


def test_text():
    field = path_field()
    opened = Walk("refused-path", "--panel", "scene")
    # M, H, G, R and W are commands where no text is typed.
    opened.in_one_frame(field, ("type", "nomhgrw.glbx"), ("key", "BackSpace"), ("key", "Return"), LEAVE)
    numbers = opened.numbers()
    check(numbers["message"].startswith("nomhgrw.glb: no such file"),
          f"typed and entered in one frame: {numbers['message']}")
    check("heatmap" not in numbers["command_line"] and numbers["method"] == "ab-sbuffer" and
          numbers["gaze"]["source"] == "0.8,0.5", "no letter that is typed is a command")

    opened = Walk("empty-path", "--panel", "scene")
    opened.in_one_frame(field, ("key", "Return"), LEAVE)
    numbers = opened.numbers()
    check("empty" in numbers["message"], f"Return in an empty field: {numbers['message']}")

    opened = Walk("entered-path", "--panel", "scene")
    opened.in_one_frame(field, ("type", "layers-2"), ("key", "KP_Enter"))
    opened.shows("layers-2")
    opened.in_one_frame(LEAVE)
    check(opened.numbers()["scene"] == "layers-2", "Return loads what was typed")


def test_keys():
    still, _ = walk("still", "", "--no-panels", size="640x480")
    opened = Walk("tap")
    opened.in_one_frame(("key", "w"), LEAVE)
    numbers = opened.numbers()
    check(numbers["camera"]["position"] != still["camera"]["position"],
          "a key that was tapped within a frame moves the camera")

    opened = Walk("looked")
    opened.in_one_frame(("mousemove", 500, 300), ("mousedown", 3), ("mousemove", 540, 300),
                        ("mouseup", 3), LEAVE)
    numbers = opened.numbers()
    check(numbers["camera"]["position"] == still["camera"]["position"] and
          numbers["camera"]["target"] != still["camera"]["target"],
          "a drag that began and ended within a frame turns the camera")

    opened = Walk("ordered")
    opened.in_one_frame(("key", "m"), ("key", "slash"), ("type", "exposure"), ("key", "Escape"),
                        ("key", "F6"), LEAVE)
    numbers = opened.numbers()
    check(numbers["search_hits"] == 1, f"typed behind '/': {numbers['search_hits']} found")
    check(numbers["method"] != "ab-sbuffer" and numbers["tab"] == "camera" and
          numbers["error"] is None, "commands before and after the text are done, in order")

    opened = Walk("clicked")
    opened.in_one_frame(click(157, 44), ("mousemove", 500, 300), LEAVE)
    check(opened.numbers()["tab"] == "camera", "a click that came and went within a frame counts")


def red_rows(picture, height):
    """Rows from the lower edge that hold the colour of a recording's dot at the left."""
    rows = picture[2]
    return [y for y in range(height) if RED in rows[len(rows) - 1 - y][:60]]


def recorded(name, *options):
    done = subprocess.run(
        [MACULA, "walk", "layers-4", "--size", "640x480", "--frames", "3", "--gaze", "0.8,0.5",
         "--record", name, "--screenshot", f"{name}.png", *options], capture_output=True, text=True,
        check=True)
    return done.stdout, read_png(f"{name}.png")


def test_recording():
    said, bare = recorded("recorded bare", "--no-panels")
    check(red_rows(bare, 40), "a recording is seen without the panels")
    _, panels = recorded("recorded")
    check(red_rows(panels, 80) and min(red_rows(panels, 80)) > min(red_rows(bare, 40)),
          "and with them, above the bar of keys")
    none = read_png(walk("unrecorded", "", "--no-panels", size="640x480")[1])
    check(not red_rows(none, 80), "nothing red is there without a recording")
    lines = said.splitlines()
    check(len(lines) == 2 and lines[0].startswith("recorded: recorded bare: 3 frames, ") and
          lines[0].endswith(" gaze samples"), f"summed up at the end: {said}")
    words = shlex.split(lines[1].partition(": ")[2])
    check(words[:2] == ["macula", "replay"], f"with the command that replays it: {lines[1]}")
    again = subprocess.run([MACULA, *words[1:]], capture_output=True, text=True)
    check(again.returncode == 0 and again.stdout.startswith("3 frames"), again.stdout + again.stderr)
    walk("path", "1 record\n", "--no-panels", size="640x480", frames=4)
    check(red_rows(read_png("path.png"), 40) and os.path.exists("camera_001.csv"),
          "a camera path that is being recorded is seen, and written at the end")


if __name__ == "__main__":
    if shutil.which("xdotool") is None:
        print("skipped: xdotool is not installed (apt-get install xdotool)")
        sys.exit(77)
    run((test_text, test_keys, test_recording))
