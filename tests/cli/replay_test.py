#!/usr/bin/env python3
"""macula replay from outside: schema, determinism, budget, gaze that follows the log."""
import base64
import hashlib
import json
import math
import os
import struct
import subprocess
import sys
import tempfile

MACULA = sys.argv[1]
SOURCE = os.environ["MACULA_SOURCE"]
DATA = os.path.join(SOURCE, "..", "shared", "data")


def replay(folder, scene, *options):
    out = os.path.join(folder, "run")
    subprocess.run([MACULA, "replay", scene, "--out", out, *options], check=True,
                   stdout=subprocess.DEVNULL)
    with open(os.path.join(out, "report.json")) as f:
        return json.load(f), out


def check_schema(report):
    assert list(report)[:8] == ["schema", "commit", "scene", "width", "height", "gl", "method",
                                "sync"], list(report)
    assert report["schema"] == 1
    assert set(report["bytes"]) == {"total", "oit", "budget", "overhead", "gbuffer", "buffers"}
    assert report["bytes"]["total"] == report["bytes"]["oit"] + report["bytes"]["overhead"]
    buffers = report["bytes"]["buffers"]
    # Buffers whose lives in a frame do not meet share memory.
    assert sum(buffers.values()) >= report["bytes"]["oit"] + report["bytes"]["overhead"], buffers
    for i, frame in enumerate(report["frames"]):
        assert frame["index"] == i
        # The contract; docs/report.schema.json has all, and cli.report holds reports against it.
        assert set(frame) >= {"index", "time_s", "gaze", "fovea", "r", "shading", "ms",
                              "fragments", "k", "error", "flicker", "hazards", "exact",
                              "lock_failures", "image_sha256"}, set(frame)
        assert set(frame["shading"]) == {"pixels", "shaded", "holes"}
        assert set(frame["gaze"]) == {"x", "y", "raw_x", "raw_y", "state", "age_s"}
        assert set(frame["fovea"]) == {"radius", "saccade", "error_deg"}
        assert set(frame["error"]) == {"rmse", "psnr_db", "max", "flip", "flip_gaze"}
        assert (frame["hazards"] is not None) == (report["method"] == "kb-racy"), frame["hazards"]
        compared = frame["error"]["rmse"] is not None
        assert (frame["error"]["flip_gaze"] is not None) == compared
        assert (frame["flicker"] is not None) == (compared and i > 0), frame["flicker"]
        assert set(frame["fragments"]) == {"generated", "stored", "merged", "lost"}
        assert 0 <= frame["gaze"]["x"] <= 1 and 0 <= frame["gaze"]["y"] <= 1
        assert frame["ms"]["total"] > 0
        assert len(frame["image_sha256"]) == 64
    assert set(report["summary"]) >= {"ms", "error", "fragments"}


def check_exact_layers(folder):
    report, _ = replay(folder, "layers-64", "--method", "ab-sbuffer", "--frames", "2", "--size",
                       "64x48", "--tonemap", "none")
    check_schema(report)
    for frame in report["frames"]:
        assert frame["exact"] is True
        assert frame["fragments"] == {"generated": 64 * 64 * 48, "stored": 64 * 64 * 48,
                                      "merged": 0, "lost": 0}
    assert report["bytes"]["budget"] is None


def check_budget(folder):
    report, _ = replay(folder, "layers-64", "--method", "kb-variable", "--k-ave", "8", "--frames",
                       "2", "--size", "64x48", "--reference")
    check_schema(report)
    assert report["bytes"]["budget"] == 8 * 64 * 48 * 16
    assert report["bytes"]["oit"] <= report["bytes"]["budget"]
    for frame in report["frames"]:
        f = frame["fragments"]
        assert f["stored"] + f["merged"] + f["lost"] == f["generated"]
        assert f["stored"] * 16 <= report["bytes"]["budget"]
        assert frame["error"]["rmse"] > 0.001, "56 of 64 equal layers are missing on average"


def check_hazards(folder):
    options = ("--frames", "2", "--size", "64x48", "--k-ave", "4")
    racy, _ = replay(folder, "layers-64", "--method", "kb-racy", *options)
    fixed, _ = replay(folder, "layers-64", "--method", "kb-fixed", *options)
    check_schema(racy)
    check_schema(fixed)
    for a, b in zip(racy["frames"], fixed["frames"]):
        assert 0 <= a["hazards"] <= 64 * 48, a["hazards"]
        # No hazard shows as no other image.
        assert (a["hazards"] == 0) == (a["image_sha256"] == b["image_sha256"]), a["hazards"]
        assert a["exact"] is False


def check_identical_is_null(folder):
    report, _ = replay(folder, "layers-4", "--method", "ab-sbuffer", "--frames", "1", "--size",
                       "32x32", "--reference")
    error = report["frames"][0]["error"]
    assert error["rmse"] == 0 and error["psnr_db"] is None and error["max"] == 0, error


def check_opacity(folder):
    # An opaque scene has fragments once it is looked at as transparent.
    options = ("marble", "--method", "ab-sbuffer", "--frames", "1", "--size", "32x24")
    solid, _ = replay(folder, *options)
    assert solid["frames"][0]["fragments"]["generated"] in (0, None), solid["frames"][0]
    clear, _ = replay(folder, *options, "--scene.opacity", "0.5")
    check_schema(clear)
    generated = clear["frames"][0]["fragments"]["generated"]
    assert generated > 32 * 24 / 4, f"{generated} fragments: more than a quarter of the frame"
    assert clear["frames"][0]["image_sha256"] != solid["frames"][0]["image_sha256"]


def check_images(folder):
    report, out = replay(folder, "layers-4", "--frames", "2", "--size", "32x24", "--reference",
                         "--images", "png", "--k-ave", "2")
    for stem in ("frame", "reference"):
        for i in range(2):
            assert os.path.exists(os.path.join(out, f"{stem}_{i:05}.png"))
    # compare sees what the report says, up to the rounding to 8 bits
    printed = subprocess.run([MACULA, "compare", os.path.join(out, "reference_00000.png"),
                              os.path.join(out, "frame_00000.png"), "--json", "-"], check=True,
                             capture_output=True, text=True).stdout
    plain = json.loads(printed)
    assert set(plain) == {"rmse", "psnr_db", "max", "flip"}, plain
    assert abs(plain["rmse"] - report["frames"][0]["error"]["rmse"]) < 2 / 255
    prefix = os.path.join(out, "error")
    printed = subprocess.run([MACULA, "compare", os.path.join(out, "reference_00000.png"),
                              os.path.join(out, "frame_00000.png"), "--gaze", "0.5,0.5", "--maps",
                              prefix, "--json", "-"], check=True, capture_output=True,
                             text=True).stdout
    more = json.loads(printed)
    assert {k: more[k] for k in plain} == plain, "more is asked for, the rest stays"
    assert abs(more["flip_gaze"] - report["frames"][0]["error"]["flip_gaze"]) < 2 / 255
    assert more["maps"]["difference"] == prefix + "_difference.png"
    assert more["maps"]["difference_scale"] >= 1
    assert abs(more["maps"]["difference_scale"] * more["maps"]["difference_white"] - 1) < 1e-6
    assert os.path.exists(more["maps"]["colour_bars"])
    assert os.path.exists(prefix + "_difference.png") and os.path.exists(prefix + "_flip.png")


def check_heatmap(folder):
    """A heat map is on the picture, and nothing that is measured is of its colours."""
    options = ("layers-12", "--frames", "2", "--size", "96x72", "--reference", "--images", "png",
               "--k-ave", "4")
    plain, out = replay(folder, *options)
    os.replace(os.path.join(out, "frame_00001.png"), os.path.join(folder, "plain.png"))
    mapped, out = replay(folder, *options, "--heatmap", "depth-complexity")
    for a, b in zip(plain["frames"], mapped["frames"]):
        for key in ("image_sha256", "error", "flicker", "hazards"):
            assert a[key] == b[key], key
    printed = subprocess.run([MACULA, "compare", os.path.join(folder, "plain.png"),
                              os.path.join(out, "frame_00001.png"), "--json", "-"], check=True,
                             capture_output=True, text=True).stdout
    assert json.loads(printed)["rmse"] > 0.1, "the picture is the heat map"


def check_warnings(folder):
    """What is not drawn as given is said on one line of standard error, and by scene info."""
    lights = [{"type": "point", "intensity": 5.0, "color": [1, 1, 1]},
              {"type": "point", "intensity": 1.0, "color": [1, 1, 1]}]
    nodes = [{"translation": [0, 0, 3.0], "name": f"lamp {i}",
              "extensions": {"KHR_lights_punctual": {"light": 0 if i != 7 else 1}}}
             for i in range(33)]
    triangle = struct.pack("<9f", -1, -1, 0, 1, -1, 0, 0, 1, 0)
    scene = os.path.join(folder, "lamps.gltf")
    with open(scene, "w", encoding="utf-8") as f:
        json.dump({
            "asset": {"version": "2.0"}, "scene": 0, "extensionsUsed": ["KHR_lights_punctual"],
            "scenes": [{"nodes": list(range(34))}], "nodes": [*nodes, {"mesh": 0}],
            "extensions": {"KHR_lights_punctual": {"lights": lights}},
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                           "min": [-1, -1, 0], "max": [1, 1, 0]}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}],
            "buffers": [{"byteLength": 36, "uri": "data:application/octet-stream;base64,"
                         + base64.b64encode(triangle).decode()}]}, f)
    sky = os.path.join(folder, "sun.hdr")
    with open(sky, "wb") as f:
        f.write(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 8\n" + bytes(4 * 9)
                + bytes([128, 128, 128, 128 + 18]) + bytes(4 * 22))
    done = subprocess.run([MACULA, "replay", scene, "--environment", sky, "--frames", "1", "--size",
                           "32x24", "--out", os.path.join(folder, "run")], check=True,
                          capture_output=True, text=True)
    lines = done.stderr.splitlines()
    assert len(lines) == 2, lines
    assert lines[0].startswith(f"warning: {sky}: 1 of 32 texels is brighter than 65504"), lines
    assert "1.311e+05 in column 1, row 1" in lines[0], lines
    assert "33 lights" in lines[1] and "without lamp 7;" in lines[1], lines
    printed = subprocess.run([MACULA, "scene", "info", scene, "--json", "-"], check=True,
                             capture_output=True, text=True).stdout
    warnings = json.loads(printed[printed.index("{"):])["warnings"]
    assert len(warnings) == 1 and "33 lights" in warnings[0], warnings


def check_hdr(folder):
    options = ("layers-4", "--frames", "2", "--size", "32x24", "--reference", "--k-ave", "2",
               "--tonemap", "none")
    linear, _ = replay(folder, *options, "--hdr")
    check_schema(linear)
    display, _ = replay(folder, *options)
    for a, b in zip(linear["frames"], display["frames"]):
        assert a["error"]["flip"] > 0 and a["error"]["flip"] != b["error"]["flip"]
        assert a["flicker"] == b["flicker"], "flicker is on display values in both"


def check_deterministic(folder, scene, gaze):
    options = ["--gaze", gaze, "--camera", "auto", "--frames", "8", "--size", "128x128",
               "--method", "kb-variable", "--k-ave", "2", "--reference"]
    a, _ = replay(folder, scene, *options)
    b, _ = replay(folder, scene, *options)
    check_schema(a)
    for x, y in zip(a["frames"], b["frames"]):
        for timeless in (x, y):
            del timeless["ms"]
        assert x == y, "two runs differ"
    return a


def check_gaze_follows(report, path):
    """Every frame's raw gaze is the newest sample at or before its time."""
    rows = []
    with open(path, encoding="utf-8") as f:
        header = f.readline().rstrip("\r\n").split("\t")
        for line in f:
            cell = dict(zip(header, line.rstrip("\r\n").split("\t")))
            if cell.get("GazePointX"):
                rows.append((int(cell["MicroSecondTimestamp"]), int(cell["GazePointX"]),
                             int(cell["GazePointY"]), cell["ValidityLeft"], cell["ValidityRight"]))
    start = rows[0][0]
    for frame in report["frames"]:
        known = [r for r in rows if (r[0] - start) * 1e-6 <= frame["time_s"] + 1e-6]
        _, x, y, left, right = known[-1]
        if left == "4" and right == "4":
            continue
        assert math.isclose(frame["gaze"]["raw_x"], x / 1280, abs_tol=1e-6), frame["gaze"]
        assert math.isclose(frame["gaze"]["raw_y"], y / 1024, abs_tol=1e-6), frame["gaze"]


def sha256_of(path):
    with open(path, "rb") as f:
        return hashlib.sha256(f.read()).hexdigest()


def scene_with_files(folder):
    """layers-2 as a .gltf with its buffer beside it, and an image that is not there."""
    packed = os.path.join(folder, "packed.glb")
    subprocess.run([MACULA, "scene", "make", "layers-2", "--out", packed], check=True,
                   stdout=subprocess.DEVNULL)
    with open(packed, "rb") as f:
        data = f.read()
    length = struct.unpack_from("<I", data, 12)[0]
    document = json.loads(data[20:20 + length])
    with open(os.path.join(folder, "the data.bin"), "wb") as f:
        f.write(data[28 + length:])
    document["buffers"][0]["uri"] = "the%20data.bin"
    document["images"] = [{"uri": "nowhere.png"}, {"uri": "data:image/png;base64,AAAA"}]
    scene = os.path.join(folder, "two layers.gltf")
    with open(scene, "w", encoding="utf-8") as f:
        json.dump(document, f)
    return scene


def check_provenance(folder):
    """What a report says it was made from: command, program, and every file by its hash."""
    small = ("--frames", "1", "--size", "32x24", "--warmup", "0")
    version = subprocess.run([MACULA, "--version"], check=True, capture_output=True,
                             text=True).stdout
    made, out = replay(folder, "layers-2", *small)
    block = made["provenance"]
    assert block["command"].startswith("macula replay layers-2 --out "), block
    assert f"macula {block['version']} ({block['commit']})" in version, (block, version)
    assert block["commit"] == made["commit"]
    nothing = {"path": None, "sha256": None, "files": []}
    assert block["scene"] == {"name": "layers-2", **nothing}, block
    assert block["gaze"] == {"name": "center", **nothing}, block
    assert block["camera"] == {"name": "auto", **nothing}, block
    assert block["fps"] == 60 and block["seed"] == 1, block

    scene = scene_with_files(folder)
    log = os.path.join(SOURCE, "assets", "gallery_gaze.csv")
    path = os.path.join(SOURCE, "assets", "gallery_walk.csv")
    options = (*small, "--gaze", log, "--camera", path, "--fps", "50", "--seed", "7")
    made, _ = replay(folder, scene, *options)
    block = made["provenance"]
    assert f"replay '{scene}' --out {out} --frames 1" in block["command"], block["command"]
    assert block["scene"] == {
        "name": scene, "path": scene, "sha256": sha256_of(scene),
        "files": [{"path": "the data.bin",
                   "sha256": sha256_of(os.path.join(folder, "the data.bin"))},
                  {"path": "nowhere.png", "sha256": None}]}, block["scene"]
    for role, file in (("gaze", log), ("camera", path)):
        assert block[role] == {"name": file, "path": file, "sha256": sha256_of(file),
                               "files": []}, block[role]
    assert block["fps"] == 50 and block["seed"] == 7, block
    again, _ = replay(folder, scene, *options)
    assert again["provenance"] == block, "two runs differ"

    # The command may hold any bytes, and is still JSON.
    odd = os.fsencode(os.path.join(folder, "caf")) + b"\xe9"
    subprocess.run([MACULA, "replay", "layers-2", "--out", odd, *small], check=True,
                   stdout=subprocess.DEVNULL)
    with open(os.path.join(odd, b"report.json"), encoding="utf-8") as f:
        assert "caf\ufffd" in json.load(f)["provenance"]["command"]


def check_booleans_of_files(folder):
    """A TOML file takes the command line's words."""
    for word, on in (('"on"', True), ("1", True), ("true", True), ('"off"', False), ("0", False)):
        file = os.path.join(folder, "settings.toml")
        with open(file, "w", encoding="utf-8") as f:
            f.write(f"oit.fill = {word}\n")
        report, _ = replay(folder, "layers-2", "--frames", "1", "--size", "32x24", "--warmup", "0",
                           "--config", file)
        assert report["settings"]["oit.fill"] is on, word


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_exact_layers(folder)
        check_budget(folder)
        check_hazards(folder)
        check_identical_is_null(folder)
        check_opacity(folder)
        check_images(folder)
        check_hdr(folder)
        check_heatmap(folder)
        check_warnings(folder)
        check_provenance(folder)
        check_booleans_of_files(folder)
        demo = os.path.join(SOURCE, "assets", "gallery_gaze.csv")
        check_deterministic(folder, "layers-12", demo)
        log = os.path.join(DATA, "gaze", "tobii_studio_50hz_decimal_comma.tsv")
        dish = os.path.join(DATA, "gltf", "IridescentDishWithOlives.glb")
        if os.path.exists(log) and os.path.exists(dish):
            check_gaze_follows(check_deterministic(folder, dish, log), log)
        else:
            print("skipped: no shared data for the real scene and log")
    print("replay: all checks passed")


main()
