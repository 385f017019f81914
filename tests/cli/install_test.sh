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
if [[ -f $MACULA_BUILD/macula-image-io.so ]]; then  # a build with OpenImageIO
  test -f "$prefix/lib/macula/macula-image-io.so"
  images=exr
else
  images=png
fi
unset MACULA_MODULES
"$prefix/bin/macula" replay layers-2 --frames 1 --size 32x32 --images $images --out "$prefix/out"
test -f "$prefix/out/report.json"
image=$prefix/out/frame_00000.$images
test -s "$image"
# Its module is its own: without it the program says so, and works where it needs no image.
rm -rf "${prefix:?}/lib"
if [[ $images == exr ]]; then
  status=0
  "$prefix/bin/macula" compare "$image" "$image" 2>"$prefix/err.txt" || status=$?
  test $status -eq 2
  test "$(wc -l <"$prefix/err.txt")" -eq 1
  grep -F "$prefix/lib/macula/macula-image-io.so: this part of Macula is missing" "$prefix/err.txt"
fi
"$prefix/bin/macula" gaze info "$prefix/share/macula/assets/gallery_gaze.csv" >/dev/null
echo "install: OK"
