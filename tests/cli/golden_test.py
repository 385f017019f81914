#!/usr/bin/env python3
"""Small images of every method and procedural scene against stored ones, tolerance 0, and their
counts of fragments.

The rasteriser compiles for the processor it finds, and wider vectors or fused multiply-adds change
last bits. So the images are drawn with its code pinned to SSE 4.1, which every x86-64 machine in
use runs. MACULA_UPDATE=1 writes the stored images and counts; a missing one fails.
"""
import json
import os
import shutil
import sys
import tempfile

import golden_cases as cases

PINNED = {"GALLIUM_OVERRIDE_CPU_CAPS": "sse4.1", "LP_NATIVE_VECTOR_WIDTH": "128",
          "LIBGL_ALWAYS_SOFTWARE": "1"}


def main():
    failures = 0
    update = os.environ.get("MACULA_UPDATE") == "1"
    counts = {} if update else cases.stored_counts()
    with tempfile.TemporaryDirectory() as folder:
        for scene, method in cases.CASES:
            report = cases.draw(folder, scene, method, PINNED)
            gl = report["gl"]
            if "llvmpipe" not in gl["renderer"] or "Mesa 22.3" not in gl["version"]:
                print("skipped: the stored images are those of Mesa 22.3's llvmpipe, this is",
                      gl["renderer"], gl["version"])
                sys.exit(77)
            name = f"{scene}_{method}"
            made = cases.drawn_image(folder)
            stored = cases.stored_image(scene, method)
            if update:
                shutil.copyfile(made, stored)
                counts[name] = cases.counts(report)
                continue
            if not os.path.exists(stored):
                print("FAILED: missing", stored)
                failures += 1
                continue
            if not cases.equal(stored, made):  # or by another library, with the same pixels
                error = cases.difference(stored, made)
                if error["max"] != 0:
                    print(f"FAILED {name}: {error}")
                    failures += 1
            if cases.counts(report) != counts.get(name):
                print(f"FAILED {name}: {cases.counts(report)}, stored {counts.get(name)}")
                failures += 1
    if update:
        with open(cases.COUNTS, "w", encoding="utf-8") as f:
            json.dump(counts, f, indent=1)
            f.write("\n")
    print("golden:", "updated" if update else f"{len(cases.CASES)} images, {failures} differ")
    sys.exit(failures > 0)


if __name__ == "__main__":
    main()
