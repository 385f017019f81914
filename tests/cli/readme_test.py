#!/usr/bin/env python3
"""Runs the commands that README.md shows, in its order.

A fenced block marked `sh` is run line by line; lines that begin with `tools/` are the set-up and
are left out. `macula` is the program under test; a window is replaced by a few frames under Xvfb.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

MACULA = sys.argv[1]
SOURCE = os.environ["MACULA_SOURCE"]


def commands():
    with open(os.path.join(SOURCE, "README.md"), encoding="utf-8") as f:
        text = f.read()
    for block in re.findall(r"```sh\n(.*?)```", text, re.S):
        for line in block.replace("\\\n", " ").splitlines():
            line = line.strip()
            if line and not line.startswith(("#", "tools/", "cmake", "export")):
                yield line


def main():
    ran = 0
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(os.path.join(SOURCE, "assets"), os.path.join(folder, "assets"))
        os.symlink(MACULA, os.path.join(folder, "macula"))
        path = folder + os.pathsep + os.environ["PATH"]
        for command in commands():
            if command.startswith("macula walk"):
                if shutil.which("xvfb-run") is None:
                    print("skipped (no xvfb-run):", command)
                    continue
                command = f"xvfb-run -a {command} --size 320x240 --frames 2"
            print("$", command, flush=True)
            done = subprocess.run(command, shell=True, cwd=folder, env={**os.environ, "PATH": path},
                                  stdout=subprocess.DEVNULL)
            if done.returncode != 0:
                print("FAILED with status", done.returncode)
                sys.exit(1)
            ran += 1
    assert ran >= 8, f"only {ran} commands found"
    print(f"readme: {ran} commands ran")


main()
