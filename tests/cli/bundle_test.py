#!/usr/bin/env python3
"""The bundle of tools/bundle.sh runs in an empty root: bash, libc and Mesa, no GL loader, the file
that names the driver in an unusual place, no other program, no network. Its report has every
section, none failed, and a browser shows it.

Exit status 77: this machine lets nobody change the root.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from chart_cases import BROWSER, SOURCE, opened

BUILD = os.environ["MACULA_BUILD"]
LIBRARIES = "/usr/lib/x86_64-linux-gnu"
MESA = ("libEGL_mesa.so.0", "dri/swrast_dri.so", "dri/kms_swrast_dri.so")
VENDOR = "/usr/share/glvnd/egl_vendor.d/50_mesa.json"
# Where it lies in the root: as in a container that is lent its host's driver.
LENT = "/usr/local/nvidia/share/glvnd/egl_vendor.d/50_mesa.json"
SECTIONS = ["devices", "gl-ordered", "stability-ordered", "gl-spinlock", "stability-spinlock",
            "chart", "hold-120", "hold-240", "walk"]
PLAIN = {"HOME": "/", "PATH": "/nowhere", "LIBGL_ALWAYS_SOFTWARE": "1",
         "GALLIUM_DRIVER": "llvmpipe"}


def copy_into(root, path, place=None):
    to = root / (place or path).lstrip("/")
    if not to.exists():
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(path, to)
        shutil.copymode(path, to)


def closure(path):
    """The libraries that a program or library loads, by the paths that the loader takes."""
    said = subprocess.run(["ldd", path], capture_output=True, text=True, check=True).stdout
    return re.findall(r"(/\S+) \(0x", said)


def make_root(root):
    copy_into(root, VENDOR, LENT)
    for path in ["/bin/bash"] + [f"{LIBRARIES}/{name}" for name in MESA]:
        for file in [path] + closure(path):
            copy_into(root, file)
    # What only a driver may bring; libraries that drivers share with the program came with Mesa.
    for name in ("libm.so.6", "libdl.so.2", "libpthread.so.0", "libc.so.6"):
        copy_into(root, f"/lib/x86_64-linux-gnu/{name}")
    for folder in ("proc", "dev", "tmp", "opt"):
        (root / folder).mkdir()
    # For a root without mounts: what the scripts and the program ask of /dev and /proc.
    (root / "dev" / "null").touch()
    (root / "proc" / "self").mkdir()
    for name in ("libEGL.so.1", "libOpenGL.so.0", "libGLdispatch.so.0", "libfmt.so.9", "libX11.so.6"):
        assert not list(root.rglob(name)), f"{name} is in the root: the test would not miss it"


def isolated(root):
    """The words before a command that runs it in the root, or None where that is not allowed."""
    bare = ["env", "-i", *(f"{key}={value}" for key, value in PLAIN.items()),
            shutil.which("chroot", path=os.environ["PATH"] + ":/usr/sbin:/sbin")]
    inside = f'mount --rbind /proc "$0/proc" && mount --rbind /dev "$0/dev" && ' \
             f'exec {" ".join(bare)} "$0" "$@"'
    for options in (["--mount", "--net"], ["--map-root-user", "--mount", "--net"]):
        words = ["unshare", *options, "bash", "-c", inside, str(root)]
        if subprocess.run([*words, "/bin/bash", "-c", "exit 0"], check=False,
                          stderr=subprocess.DEVNULL).returncode == 0:
            return words
    words = [*bare, str(root)]
    if subprocess.run([*words, "/bin/bash", "-c", "exit 0"], check=False,
                      stderr=subprocess.DEVNULL).returncode == 0:
        return words
    return None


def check_report(folder):
    with open(folder / "report.json", encoding="utf-8") as f:
        report = json.load(f)
    states = {s["id"]: s["status"] for s in report["sections"]}
    wanted = {name: "skipped" if name == "walk" else "passed" for name in SECTIONS}
    assert states == wanted, (states, [s["log"][-2000:] for s in report["sections"]
                                       if s["status"] == "failed"])
    assert report["verdict"] == "passed" and report["software"] is True, report["verdict"]
    results = {s["id"]: s["result"] for s in report["sections"]}
    assert "llvmpipe" in results["devices"]["renderer"], results["devices"]
    tests = 0
    for name in SECTIONS[1:5]:
        assert results[name]["failures"] == 0 < results[name]["tests"], name
        tests += results[name]["tests"]
    points = results["chart"]["points"]
    measured = [p for p in points if p["status"] == "measured"]
    refused = [p for p in points if p["status"] == "refused"]
    assert {p["sync"] for p in measured} >= {"ordered", "spinlock"}, refused
    assert refused and all("interlock" in p["variant"] for p in refused), refused
    assert results["hold-120"]["target_ms"] == 8.333, results["hold-120"]["target_ms"]
    return report, tests, len(measured)


def check_old_library(folder, made):
    """Where the machine's libstdc++ lacks what the programs need, the bundle's is taken."""
    old = made / "old"
    old.mkdir()
    (old / "versions").write_text("GLIBCXX_3.4 { global: nothing; local: *; };\n", encoding="utf-8")
    (old / "empty.c").write_text("int nothing(void) { return 0; }\n", encoding="utf-8")
    subprocess.run(["gcc", "-shared", "-fPIC", "-Wl,-soname,libstdc++.so.6",
                    f"-Wl,--version-script={old}/versions", "-o", old / "libstdc++.so.6",
                    old / "empty.c"], check=True)
    environment = {**os.environ, "LD_LIBRARY_PATH": str(old)}
    bare = subprocess.run([folder / "bin" / "macula", "--version"], capture_output=True,
                          check=False, env=environment)
    assert bare.returncode != 0, "the old library was not even found"
    said = subprocess.run([folder / "macula", "--version"], capture_output=True, text=True,
                          check=True, env=environment)
    assert said.stdout.startswith("macula "), said.stdout


def check_page(folder, report):
    page = (folder / "report.html").read_text(encoding="utf-8")
    assert "{{" not in page.split("<script")[0], "a place of the template was not filled"
    if BROWSER is None:
        print("the page was not opened: no browser")
        return
    shown = opened(str(folder), str(folder / "report.html"))
    for section in report["sections"]:
        assert f'<section id="{section["id"]}"' in shown, section["id"]
    assert re.search(r'id="script-errors" role="alert" hidden', shown), "a script failed"
    assert "bar-row" in shown, "no times are shown"


def main():
    with tempfile.TemporaryDirectory() as made:
        made = pathlib.Path(made)
        root = made / "root"
        make_root(root)
        words = isolated(root)
        if words is None:
            print("skipped: neither namespaces nor chroot are allowed here")
            sys.exit(77)
        said = subprocess.run([os.path.join(SOURCE, "tools", "bundle.sh"), "--build", BUILD,
                               "--out", str(made)], check=True, stdout=subprocess.PIPE, text=True)
        print(said.stdout.strip())
        archive, = made.glob("*.tar.gz")
        subprocess.run(["tar", "-xzf", archive, "-C", root / "opt"], check=True)
        folder, = (root / "opt").iterdir()
        inside = "/" + str(folder.relative_to(root))
        (root / "proc" / "self" / "exe").symlink_to(f"{inside}/bin/macula")
        done = subprocess.run([*words, "/bin/bash", f"{inside}/gpu-report.sh", "--length", "quick"],
                              check=False, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True)
        print(done.stdout)
        report, tests, points = check_report(folder / "report")
        assert done.returncode == 0, done.returncode
        check_page(folder / "report", report)
        check_old_library(folder, made)
        print(f"bundle: {len(report['sections'])} sections, {tests} GL tests, {points} points "
              f"in an empty root ({words[0]})")


main()
