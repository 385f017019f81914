#!/usr/bin/env python3
"""Runs every command that README.md and docs/ show, and compares what they print.

A fenced block marked `sh` is run line by line, page by page in one folder each. Comments in front of
it say what is done otherwise; there are no others:

  <!-- instead: COMMAND -->   this runs in place of the block: a shorter form of a long command
  <!-- not run: REASON -->    set-up, or what needs a device; such blocks are listed

A block `text` behind it is what the last command printed: `...` stands for any lines, times in ms are
not compared. `text near` allows for other rasterisers, `text keys` compares the words before two blanks.
A window is replaced by a few frames under Xvfb.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile

from documents import SOURCE, difference, fences, pages

MACULA = os.path.abspath(sys.argv[1])
LEAST_COMMANDS = 25


def keys(text):
    """The first column of a table that is aligned by blanks."""
    return "\n".join(re.split(r" {2,}", line.strip())[0] for line in text.splitlines())


def commands_of(before, body):
    instead = re.findall(r"<!-- instead: (.*?) -->", before)
    text = "\n".join(instead) if instead else body.replace("\\\n", " ")
    lines = (line.strip() for line in text.splitlines())
    return [line for line in lines if line and not line.startswith("#")]


class Runner:
    def __init__(self):
        self.ran = self.compared = 0
        self.left_out = []
        self.faults = []

    def run(self, command, folder):
        """@returns what it printed, or None where it could not be run"""
        if command.startswith("macula walk"):
            if shutil.which("xvfb-run") is None:
                self.left_out.append(command + ": no xvfb-run")
                return None
            command = f"xvfb-run -a {command} --size 160x120 --frames 2"
        print("$", command, flush=True)
        path = folder + os.pathsep + os.environ["PATH"]
        done = subprocess.run(command, shell=True, cwd=folder, env={**os.environ, "PATH": path},
                              stdout=subprocess.PIPE, text=True, check=False)
        self.ran += 1
        if done.returncode != 0:
            self.faults.append(f"{command}: status {done.returncode}")
        return done.stdout

    def compare(self, page, info, shown, printed):
        if "keys" in info:
            shown, printed = keys(shown), keys(printed)
        fault = difference(shown, printed, "near" in info)
        if fault:
            self.faults.append(f"{page.relative_to(SOURCE)}: {fault}")
        self.compared += 1

    def page(self, page):
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(SOURCE / "assets", os.path.join(folder, "assets"))
            os.symlink(MACULA, os.path.join(folder, "macula"))
            printed = None
            for before, info, body in fences(page.read_text(encoding="utf-8")):
                if info[:1] == ["sh"]:
                    printed = None
                    unknown = re.sub(r"<!-- (?:instead|not run): .*? -->", "", before).strip()
                    if unknown:
                        self.faults.append(f"{page.name}: {unknown} is no comment of a block")
                    if "<!-- not run: " in before:
                        self.left_out.append(f"{page.name}: {body.splitlines()[0]}")
                        continue
                    for command in commands_of(before, body):
                        printed = self.run(command, folder)
                elif info[:1] == ["text"] and printed is not None:
                    self.compare(page, info, body, printed)
                    printed = None


def main():
    runner = Runner()
    for page in pages("docs"):
        runner.page(page)
    for line in runner.left_out:
        print("not run:", line)
    for fault in runner.faults:
        print("FAILED", fault)
    if runner.faults:
        sys.exit(1)
    assert runner.ran >= LEAST_COMMANDS, f"only {runner.ran} commands found"
    print(f"documents: {runner.ran} commands ran, {runner.compared} outputs compared")


main()
