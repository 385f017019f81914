#!/usr/bin/env python3
"""Linked programs of earlier runs: where they are kept, that no image depends on them, and that folders
which cannot be used are no error."""
import json
import os
import subprocess
import sys
import tempfile

MACULA = os.path.abspath(sys.argv[1])


def check(right, what):
    if not right:
        sys.exit("failed: " + what)


def replay(folder, **variables):
    """@returns the image's hash"""
    environment = {name: value for name, value in os.environ.items() if name != "MACULA_SHADER_CACHE"}
    environment.update(variables)
    out = os.path.join(folder, "out")
    done = subprocess.run([MACULA, "replay", "layers-5", "--size", "64x48", "--frames", "1", "--out", out],
                          env=environment, capture_output=True, text=True, check=False)
    check(done.returncode == 0, f"replay with {variables}: {done.stderr}")
    check("cache" not in done.stderr, f"nothing is said of the cache: {done.stderr}")
    with open(os.path.join(out, "report.json"), encoding="utf-8") as file:
        return json.load(file)["frames"][0]["image_sha256"]


def main():
    with tempfile.TemporaryDirectory() as folder:
        cache = os.path.join(folder, "cache")
        kept = os.path.join(cache, "macula", "shaders")
        wanted = replay(folder, XDG_CACHE_HOME=cache, MACULA_SHADER_CACHE="off")
        check(not os.path.exists(kept), "off writes nothing")  # Mesa has a cache of its own beside it
        check(replay(folder, XDG_CACHE_HOME=cache) == wanted, "an empty cache changes no image")
        if not os.path.isdir(kept):
            print("this driver has no program binaries")
            sys.exit(77)
        files = sorted(os.listdir(kept))
        check(len(files) > 5 and all(name.endswith(".program") for name in files), f"programs: {files}")
        check(replay(folder, XDG_CACHE_HOME=cache) == wanted, "a filled cache changes no image")
        check(sorted(os.listdir(kept)) == files, "the second run finds all of its programs")
        other = os.path.join(folder, "other")
        check(replay(folder, MACULA_SHADER_CACHE=other) == wanted, "a chosen folder changes no image")
        check(sorted(os.listdir(other)) == files, "a folder can be chosen")
        for unusable in ("/proc/self", "/dev/null/shaders"):  # where not even root can write
            check(replay(folder, MACULA_SHADER_CACHE=unusable) == wanted, unusable)
        print(f"{len(files)} programs, 6 runs of one image")


main()
