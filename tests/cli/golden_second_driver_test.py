#!/usr/bin/env python3
"""The stored golden images and counts on a second driver: Mesa's zink on lavapipe, where k-buffers
take the spinlock because the renderer is not known to order fragments.

Fragments, k, r and exactness must be equal. Of an image's 8-bit values at most one in a hundred may
differ, by one step: GL and Vulkan leave the rounding of a shader's arithmetic and the order of its
terms to the compiler, so colours differ in their last bits, and where one lies at the border of two
steps, the step differs. Exit status 77: the driver is not there, or is another than the one below.
"""
import concurrent.futures
import json
import os
import subprocess
import sys
import tempfile

import configurations_test as configurations
import golden_cases as cases

STEP = 1.0 / 255
LARGEST = 1.01 * STEP
RMSE = 0.01 ** 0.5 * STEP  # one value in a hundred by one step
# The code that lavapipe makes depends on the processor, too. golden_test.py also asks for SSE 4.1
# and narrow vectors, with which lavapipe 22.3 runs illegal instructions and writes out of bounds.
DRIVER = {"MESA_LOADER_DRIVER_OVERRIDE": "zink", "GALLIUM_DRIVER": "zink",
          "LIBGL_ALWAYS_SOFTWARE": "1", "GALLIUM_OVERRIDE_CPU_CAPS": "avx"}
# Of the configurations: the methods that take the lock, with every storage, tail and count.
LOCKED = ("kb-fixed", "kb-plus", "kb-variable", "kb-learned")


def skipped(environment):
    """Why nothing can be compared here, or None."""
    done = subprocess.run([cases.MACULA, "devices", "--platform", "surfaceless", "--json", "-"],
                          capture_output=True, text=True, check=False,
                          env={**os.environ, **environment})
    if done.returncode != 0:
        return f"zink on lavapipe does not start ({done.stderr.strip()})"
    device = json.loads(done.stdout)
    if "zink" not in device["renderer"] or "Mesa 22.3" not in device["version"]:
        return f"the driver is {device['renderer']} {device['version']}, not zink of Mesa 22.3"
    if device["sync"] != "spinlock":
        return f"oit.sync auto is {device['sync']} here, not the spinlock"
    return None


def golden(job):
    """@returns faults, the errors, and whether the lock was taken"""
    folder, (scene, method), environment, stored = job
    out = os.path.join(folder, f"{scene}_{method}")
    report = cases.draw(out, scene, method, environment)
    name = f"{scene} {method}"
    faults = []
    wanted = stored[f"{scene}_{method}"]
    if cases.counts(report) != wanted:
        faults.append(f"{name}: {cases.counts(report)}, stored {wanted}")
    error = cases.difference(cases.stored_image(scene, method), cases.drawn_image(out))
    if not (error["max"] <= LARGEST and error["rmse"] <= RMSE):
        faults.append(f"{name}: {error}, at most {LARGEST} and an RMSE of {RMSE}")
    return faults, error, report["sync"] == "spinlock"


def configuration(job):
    """@returns faults, and whether the lock was taken"""
    folder, index, (scene, options), environment, stored = job
    result, report = configurations.draw(folder, index, scene, options, environment)
    name = f"{scene}: {options}"
    if report is None:
        return [f"{name}: {result['error']}"], False
    made = [cases.without_hash(frame) for frame in result["frames"]]
    wanted = [cases.without_hash(frame) for frame in stored[name]["frames"]]
    faults = [] if made == wanted else [f"{name}: {made}, stored {wanted}"]
    return faults, report["sync"] == "spinlock"


def main():
    with tempfile.TemporaryDirectory() as folder, \
            concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        environment = {**DRIVER, "XDG_RUNTIME_DIR": folder}
        reason = skipped(environment)
        if reason:
            print("skipped:", reason)
            sys.exit(77)
        stored = cases.stored_counts()
        images = list(pool.map(golden, [(folder, case, environment, stored)
                                        for case in cases.CASES]))
        rows = [row for row in configurations.configurations()
                if row[0] == "bottles" and row[1].split()[0] in LOCKED]
        with open(configurations.STORED, encoding="utf-8") as f:
            stored = json.load(f)
        counted = list(pool.map(configuration, [(folder, index, row, environment, stored)
                                                for index, row in enumerate(rows)]))
    faults = [fault for result in images + counted for fault in result[0]]
    for fault in faults:
        print("FAILED", fault)
    locked = sum(result[-1] for result in images + counted)
    largest, rmse = (max(image[1][key] / STEP for image in images) for key in ("max", "rmse"))
    print(f"second driver: {len(images)} images within {largest:.2f} of 255, RMSE {rmse:.4f} of 255; "
          f"counts of {len(images) + len(counted)} draws, {locked} of them by the spinlock, "
          f"{len(faults)} faults")
    assert locked >= len(rows), "the spinlock was hardly taken"
    sys.exit(bool(faults))


main()
