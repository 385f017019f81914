#!/usr/bin/env python3
"""What the passes cost an item, beside a shader that only writes the same targets.

  tools/pass_costs.py build/release/macula [--rounds 5] [--size 1024x1024] [--out docs/benchmarks/pass_costs.csv]

An item is a fragment of the passes that draw transparent surfaces, and a pixel of the others. The bound of a
pass is the time of the same pass with a shader whose main function writes constants: what remains are
vertices, rasterisation, blending and the writes. Both are drawn by turns; ns are medians over all frames.
Bytes are those that an item reads and writes in targets, images and storage, counted by hand from the
shaders. The driver is what the environment chooses.
"""
import argparse
import datetime
import json
import os
import pathlib
import shutil
import statistics
import subprocess
import tempfile

import benchmark_files as files

COLUMNS = ["scene", "method", "pass", "items", "ms", "ns_item", "bound_ns_item", "over_bound", "bytes_item"]
ROOT = pathlib.Path(__file__).resolve().parent.parent
CASES = [("spheres", "blend"), ("spheres", "ab-sbuffer"), ("spheres", "ab-list"), ("spheres", "kb-fixed"),
         ("bottles", "blend"), ("bottles", "kb-variable"), ("gallery", "kb-variable")]
MAIN = "void main() {"
# Pass: shader, what its main function is replaced by, whether items are fragments, bytes an item.
PASSES = {
    "gbuffer": ("gbuffer.frag", """  outNormalOct = vec2(0.5);
  outBaseColor = outSurface = vec4(0.5);
  outEmissive = vec3(0.5);
""", False, 20),
    "lighting": ("lighting.comp", "  imageStore(target, ivec2(gl_GlobalInvocationID.xy), vec4(0.5));\n", False, 28),
    "oit.count": ("oit/count.frag", "  count = 1.0;\n", True, 12),
    "oit.blend": ("oit/blend.frag", "  color = vec4(0.25);\n", True, 20),
    "oit.capture": ("oit/capture.frag", """  PixelSlots slots = pixelSlots(ivec2(gl_FragCoord.xy));
  if (slots.capacity > 0u) storeFragment(slots.first, makeFragment(uvec2(0u), vec4(0.25)));
""", True, 36),
    "oit.resolve": ("oit/resolve.comp", "  imageStore(hdrColor, ivec2(gl_GlobalInvocationID.xy), vec4(0.5));\n", False,
                    28),
}


def without_work(folder):
    """A copy of shaders and assets in which the passes above write constants."""
    for name in ("shaders", "assets"):
        shutil.copytree(ROOT / name, folder / name)
    for shader, body, _, _ in PASSES.values():
        path = folder / "shaders" / shader
        text = path.read_text(encoding="utf-8")
        head, found, _ = text.rpartition(MAIN)
        if not found:
            raise SystemExit(f"{path}: no '{MAIN}'")
        if shader == "oit/count.frag":
            body += "#ifdef RANGE\n  range = vec2(0.5, -0.5);\n#endif\n"
        path.write_text(head + MAIN + "\n" + body + "}\n", encoding="utf-8")


def draw(options, case, data, out):
    scene, method = case
    environment = {**os.environ, "MACULA_DATA": str(data), "MACULA_SHADER_CACHE": "off"}
    subprocess.run([options.program, "replay", scene, "--method", method, "--camera", "scene", "--size",
                    options.size, "--frames", "3", "--warmup", "1", "--out", out, "--force"],
                   env=environment, check=True, stdout=subprocess.DEVNULL)
    return json.loads(pathlib.Path(out, "report.json").read_text(encoding="utf-8"))


def measure(options, case, bound, folder):
    times, bounds = {}, {}
    for _ in range(options.rounds):
        report = draw(options, case, ROOT, folder / "out")
        for data, into in ((report, times), (draw(options, case, bound, folder / "bound"), bounds)):
            for frame in data["frames"]:
                for name in PASSES:
                    into.setdefault(name, []).append(frame["ms"].get(name, 0.0))
    width, height = (int(n) for n in options.size.split("x"))
    # Blending does not count its fragments.
    counted = draw(options, (case[0], "ab-sbuffer"), ROOT, folder / "out")
    fragments = counted["frames"][-1]["fragments"]["generated"]
    for name, (_, _, each_fragment, size) in PASSES.items():
        ms = statistics.median(times[name])
        if ms == 0.0:
            continue
        items = fragments if each_fragment else width * height
        ns, least = 1e6 * ms / items, 1e6 * statistics.median(bounds[name]) / items
        row = {"scene": case[0], "method": case[1], "pass": name, "items": items, "ms": f"{ms:.2f}",
               "ns_item": f"{ns:.1f}", "bound_ns_item": f"{least:.1f}", "over_bound": f"{ns / least:.2f}",
               "bytes_item": size}
        print(", ".join(f"{key} {value}" for key, value in row.items()), flush=True)
        yield row, report


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--size", default="1024x1024")
    parser.add_argument("--out")
    options = parser.parse_args()
    options.program = os.path.abspath(options.program)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        bound = folder / "data"
        bound.mkdir()
        without_work(bound)
        results = [result for case in CASES for result in measure(options, case, bound, folder)]
    if options.out:
        report = results[-1][1]
        files.write(pathlib.Path(options.out), {
            "kind": "table", "title": "What an item of a pass costs", "commit": report["provenance"]["commit"],
            "command": "tools/pass_costs.py", "page": "docs/performance.md", "renderer": report["gl"]["renderer"],
            "date": datetime.date.today().isoformat(), "sizes": options.size, "rounds": options.rounds},
            COLUMNS, [row for row, _ in results])


if __name__ == "__main__":
    main()
