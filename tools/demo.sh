#!/usr/bin/env bash
# Usage: demo.sh [--training]
# Installs packages, builds, and runs the main job on the built-in gallery: a window where there is
# a display, else a headless replay of the demo gaze log. Says where the report is.
# The replay takes one frame every sixth of a second of the walk, 10 seconds in all.
# --training: installs what tools/train needs as well.
# MACULA_DEMO_FRAMES, MACULA_DEMO_SIZE: shorten the replay. MACULA_DEMO_HEADLESS=1: no window.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"

kinds=(build)
for option in "$@"; do
  case $option in
    --training) kinds+=(train) ;;
    *)
      echo "demo: unknown option '$option'; the only one is --training" >&2
      exit 2
      ;;
  esac
done

finish() {
  local status=$?
  if ((status == 0)); then echo "demo: OK"; else echo "demo: FAILED (status $status)"; fi
}
trap finish EXIT

tools/install_packages.sh "${kinds[@]}"
cmake --preset release -DMACULA_TESTS=OFF
cmake --build --preset release
macula=build/release/macula

"$macula" devices
if [[ -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} && -z ${MACULA_DEMO_HEADLESS:-} ]]; then
  echo "Opening the gallery. Close the window to end."
  "$macula" walk gallery
else
  "$macula" replay gallery --gaze assets/gallery_gaze.csv --camera assets/gallery_walk.csv \
    --frames "${MACULA_DEMO_FRAMES:-60}" --fps 6 --size "${MACULA_DEMO_SIZE:-960x540}" \
    --method kb-variable --k-ave 4 --reference --images png --out out/demo
  echo "Images and report: $root/out/demo (report.json, frame_00000.png, reference_00000.png, ...)"
fi
