#!/usr/bin/env python3
"""Small images of every method and procedural scene against stored ones, tolerance 0.

The rasteriser compiles for the processor it finds, and wider vectors or fused multiply-adds change
last bits. So the images are drawn with its code pinned to SSE 4.1, which every x86-64 machine in
use runs. MACULA_UPDATE=1 writes the stored images; a missing one fails.
"""
import json
import os
import subprocess
import sys
import tempfile

MACULA = sys.argv[1]
GOLDEN = os.path.join(os.environ["MACULA_SOURCE"], "tests", "golden")
CASES = [(scene, method) for scene in ("layers-6", "smoke", "bottles", "gallery")
         for method in ("blend", "ab-sbuffer", "kb-variable")]
PINNED = {"GALLIUM_OVERRIDE_CPU_CAPS": "sse4.1", "LP_NATIVE_VECTOR_WIDTH": "128",
          "LIBGL_ALWAYS_SOFTWARE": "1"}


def draw(folder, scene, method):
    subprocess.run([MACULA, "replay", scene, "--method", method, "--k-ave", "1", "--camera",
                    "scene", "--gaze", "0.4,0.6", "--frames", "1", "--size", "96x64", "--images",
                    "png", "--platform", "surfaceless", "--out", folder], check=True,
                   stdout=subprocess.DEVNULL, env={**os.environ, **PINNED})
    with open(os.path.join(folder, "report.json")) as f:
        return json.load(f)["gl"]


def main():
    failures = 0
    update = os.environ.get("MACULA_UPDATE") == "1"
    with tempfile.TemporaryDirectory() as folder:
        for scene, method in CASES:
            gl = draw(folder, scene, method)
            if "llvmpipe" not in gl["renderer"] or "Mesa 22.3" not in gl["version"]:
                print("skipped: the stored images are those of Mesa 22.3's llvmpipe, this is",
                      gl["renderer"], gl["version"])
                sys.exit(77)
            made = os.path.join(folder, "frame_00000.png")
            stored = os.path.join(GOLDEN, f"{scene}_{method}.png")
            if update:
                os.replace(made, stored)
                continue
            if not os.path.exists(stored):
                print("FAILED: missing", stored)
                failures += 1
                continue
            printed = subprocess.run([MACULA, "compare", stored, made, "--json", "-"], check=True,
                                     capture_output=True, text=True).stdout
            error = json.loads(printed)
            if error["max"] != 0:
                print(f"FAILED {scene} {method}: {error}")
                failures += 1
    print("golden:", "updated" if update else f"{len(CASES)} images, {failures} differ")
    sys.exit(failures > 0)


main()
