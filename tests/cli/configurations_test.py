#!/usr/bin/env python3
"""Image hashes and counts of many configurations against stored ones: methods, options, scenes,
rates of shading, window sizes, history.

A change that moves code but not pictures leaves all of them as they are. Where a picture is meant
to change, MACULA_UPDATE=1 writes the stored values again, and the difference is for the reviewer.
As in golden_test.py, the rasteriser's code is pinned to SSE 4.1, and another driver is skipped.
"""
import concurrent.futures
import json
import os
import subprocess
import sys
import tempfile

MACULA = sys.argv[1]
STORED = os.path.join(os.environ["MACULA_SOURCE"], "tests", "golden", "configurations.json")
PINNED = {"GALLIUM_OVERRIDE_CPU_CAPS": "sse4.1", "LP_NATIVE_VECTOR_WIDTH": "128",
          "LIBGL_ALWAYS_SOFTWARE": "1", "LP_NUM_THREADS": "1"}
SIZE = "96x96"
FRAMES = "2"  # the second one has a history
SCARCE = "--k-ave 1.5"

EVERY_METHOD = ["blend", "wboit", "peel --oit.layers 5", "ab-array --oit.layers 6", "ab-list",
                "ab-sbuffer", "kb-stencil --k-ave 4", "kb-atomic --k-ave 2",
                "kb-fixed --k-ave 2", f"kb-plus {SCARCE}", f"kb-variable {SCARCE}",
                f"kb-learned {SCARCE}"]
OPTIONS_OF_K_BUFFERS = [
    "kb-fixed --k-ave 3 --oit.tail mean",
    "kb-fixed --k-ave 2 --oit.fragmentBytes 8",
    "kb-fixed --k-ave 4 --oit.tail mean --oit.fragmentBytes 8",
    "kb-fixed --k-ave 2 --oit.sync spinlock",
    "kb-fixed --k-ave 2 --oit.cull occupancy",
    "kb-atomic --k-ave 3 --oit.tail mean",
    f"kb-plus {SCARCE} --oit.fill on",
    f"kb-plus {SCARCE} --oit.tail mean --oit.fill on",
    f"kb-plus {SCARCE} --oit.cull occupancy --oit.cullWords 4",
    f"kb-variable {SCARCE} --oit.fill on",
    f"kb-variable {SCARCE} --oit.tail mean",
    f"kb-variable {SCARCE} --oit.tail mean --oit.fill on --oit.importance error",
    f"kb-variable {SCARCE} --oit.importance transmittance --oit.fill on",
    f"kb-variable {SCARCE} --oit.importance error --importance.tile 2",
    f"kb-variable {SCARCE} --oit.importance learned --oit.tail mean --oit.fill on",
    f"kb-variable {SCARCE} --oit.fragmentBytes 8 --oit.tail mean --oit.fill on"
    " --oit.importance error",
    "kb-variable --oit-memory 0.4 --oit.count predicted",
    f"kb-variable {SCARCE} --oit.count predicted --oit.fill on --oit.tail mean",
    f"kb-variable {SCARCE} --oit.cull occupancy",
    f"kb-variable {SCARCE} --oit.sync spinlock --oit.tail mean --oit.fill on",
    f"kb-variable {SCARCE} --importance.noisePerFrame on --seed 7",
    f"kb-learned {SCARCE} --oit.fill on --oit.tail mean",
    "kb-variable --oit-memory 0.3 --oit.tail mean --oit.fill on",
]
RATES = [
    "kb-variable {s} --lod.r 2",
    "kb-variable {s} --lod.r 2.5 --lod.transparency on",
    "kb-variable {s} --oit.tail mean --oit.fill on --oit.importance error --lod.r 2"
    " --lod.transparency on",
    "kb-fixed --k-ave 2 --lod.r 3 --lod.transparency on --lod.reconstruction yang2008",
    "blend --lod.r 4 --lod.reconstruction bilinear",
    "blend --foveation on",
    "ab-sbuffer --foveation on --lod.r 2 --lod.holes tap",
    "blend --lod.r 2 --lod.what shadow,ao,noise",
    "kb-plus {s} --lod.r 2 --lod.transparency on --oit.fill on",
    "peel --oit.layers 4 --lod.r 2 --lod.transparency on",
    "wboit --lod.r 2 --lod.transparency on",
]
FRAME = [
    "kb-variable {s} --ssaa 2",
    "kb-variable {s} --heatmap k",
    "kb-variable {s} --heatmap fresnel",
    "kb-variable {s} --tonemap none --background 0.2,0.3,0.4",
    "kb-variable {s} --scene.lighting four --exposure 1",
    "kb-variable {s} --scene.opacity 0.5",
]
OPAQUE = [
    ("car", "blend --lod.r 2 --lod.what shadow"),
    ("chess", "blend --lod.r 2 --lod.what ao"),
    ("marble", "blend --lod.r 2 --lod.what noise"),
    ("marble", "blend"),
    ("chess", "blend --foveation on"),
    ("car", f"kb-variable {SCARCE} --oit.fill on"),
    ("layers-12", "kb-fixed --k-ave 4 --oit.tail mean"),
    ("layers-12", "ab-sbuffer"),
    ("hair", f"kb-variable {SCARCE} --oit.importance error --oit.fill on"),
    ("hair", f"kb-plus {SCARCE}"),
    ("greenhouse", f"kb-variable {SCARCE} --oit.tail mean --oit.fill on --oit.importance error"),
    ("smoke", "ab-list --oit-memory 0.2"),
]


def configurations():
    rows = [("bottles", options) for options in EVERY_METHOD + OPTIONS_OF_K_BUFFERS]
    rows += [("gallery", options.format(s=SCARCE)) for options in RATES + FRAME]
    return rows + OPAQUE


def draw(folder, index, scene, options, environment):
    """@returns one row's result and report; without a report where it could not be drawn"""
    out = os.path.join(folder, str(index))
    method, *rest = options.split()
    run = subprocess.run(
        [MACULA, "replay", scene, "--method", method, *rest, "--camera", "auto", "--gaze",
         "0.4,0.6", "--frames", FRAMES, "--size", SIZE, "--warmup", "1", "--platform",
         "surfaceless", "--out", out], capture_output=True, text=True,
        env={**os.environ, **environment})
    if run.returncode != 0:
        return {"error": run.stderr.strip()}, None
    with open(os.path.join(out, "report.json")) as f:
        report = json.load(f)
    frames = [{key: frame[key] for key in ("image_sha256", "fragments", "k", "r", "exact")}
              for frame in report["frames"]]
    return {"frames": frames}, report


def main():
    rows = configurations()
    assert len(set(rows)) == len(rows), "a configuration stands twice"
    with tempfile.TemporaryDirectory() as folder, \
            concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda row: draw(folder, row[0], *row[1], PINNED),
                                enumerate(rows)))
    drivers = {f"{report['gl']['renderer']} {report['gl']['version']}"
               for _, report in results if report}
    if any("llvmpipe" not in d or "Mesa 22.3" not in d for d in drivers):
        print("skipped: the stored values are those of Mesa 22.3's llvmpipe, this is", *drivers)
        sys.exit(77)
    made = {f"{scene}: {options}": result
            for (scene, options), (result, _) in zip(rows, results)}
    if os.environ.get("MACULA_UPDATE") == "1":
        with open(STORED, "w") as f:
            json.dump(made, f, indent=1)
            f.write("\n")
        print("configurations: stored", len(made))
        return
    with open(STORED) as f:
        stored = json.load(f)
    differing = [name for name in sorted(stored.keys() | made.keys())
                 if stored.get(name) != made.get(name)]
    for name in differing:
        print(f"FAILED {name}\n  stored {stored.get(name)}\n  made   {made.get(name)}")
    print(f"configurations: {len(made)}, {len(differing)} differ")
    sys.exit(bool(differing))


if __name__ == "__main__":
    main()
