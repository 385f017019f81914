#!/usr/bin/env bash
# An installed program finds its shaders and assets, away from the source tree.
set -euo pipefail
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
cmake --install "$MACULA_BUILD" --prefix "$prefix" >/dev/null
test -f "$prefix/share/macula/shaders/lighting.comp"
test -f "$prefix/share/macula/assets/gallery_gaze.csv"
test -f "$prefix/share/macula/assets/experiments/quick.toml"
test -f "$prefix/share/macula/assets/report/report.html"
test -f "$prefix/share/macula/assets/udev/70-macula-eye-tracker.rules"
test -f "$prefix/share/macula/assets/trackers/example.toml"
cd "$prefix"
"$prefix/bin/macula" replay layers-2 --frames 1 --size 32x32 --out "$prefix/out"
test -f "$prefix/out/report.json"
echo "install: OK"
