#!/bin/bash
# Usage: gpu-report.sh [--out FOLDER] [--length full|short|quick]
# Runs on a machine with an OpenGL 4.5 driver and nothing else: devices, the GL tests and the
# stability tests with every way of per-pixel ordering that the device offers, a timed experiment
# over all methods, and frame times held at 120 and 240 Hz. Writes report.html and report.json.
# Needs no network, no packages, no root and no program but bash. Exit status 1: a section failed.
#
# --length: full, with 1080p and 4K; short, the same at small sizes, the default on a software
#   rasteriser; quick, a sample of the tests and tiny pictures.
# --out: an existing folder, empty by preference (default: report, beside this script).
set -u
export LC_ALL=C
shopt -u patsub_replacement 2>/dev/null # bash 5.2: & in a replacement is only that
here=$(CDPATH='' cd "$([[ $0 == */* ]] && echo "${0%/*}" || echo .)" && pwd)
# shellcheck source=tools/bundle/libraries.sh
. "$here/lib/libraries.sh"

out=$here/report length=
while (($#)); do
  case $1 in
    --out) out=${2:-none} ;;
    --length) length=${2:-none} ;;
    *)
      echo "gpu-report: unknown option '$1'; there are --out FOLDER and --length full|short|quick" >&2
      exit 2
      ;;
  esac
  shift $(($# < 2 ? 1 : 2))
done
if [[ ! $length =~ ^(full|short|quick)?$ ]]; then
  echo "gpu-report: --length is full, short or quick" >&2
  exit 2
fi
[[ -d $out ]] || mkdir -p "$out" 2>/dev/null
if ! { : >"$out/devices.log"; } 2>/dev/null; then
  echo "gpu-report: '$out' cannot be written; make a folder and name it by --out" >&2
  exit 2
fi
out=$(cd "$out" && pwd)
[[ -w ${TMPDIR:-/tmp} ]] || export TMPDIR=$out

# shellcheck source=tools/bundle/report.sh
. "$here/lib/report.sh"
find_libraries || exit 3
find_driver "$out"
macula=$here/bin/macula tests=$here/bin/gl_tests

section devices "The device" "$out/devices.json" "$macula" devices --json "$out/devices.json"
devices=
[[ -r $out/devices.json ]] && devices=$(<"$out/devices.json")
software=false
[[ $devices =~ \"renderer\":\ *\"[^\"]*(llvmpipe|softpipe|swrast|SwiftShader) ]] && software=true
if [[ -z $length ]]; then
  length=full
  [[ $software == true ]] && length=short
fi
modes=()
[[ $devices =~ \"interlock\":\ *true ]] && modes+=(interlock)
[[ $devices =~ \"ordered\":\ *true ]] && modes+=(ordered)
modes+=(spinlock)

# The suites of tests/gl/stability_*_test.cpp.
stability='CompleteMethods.*:Depths.*:Edges.*:FillMirror.*:Memory.*:Order.*:Ordering.*:Promise.*:Tails.*'
case $length in
  quick)
    frames=30 hold=64x36 sizes=(64x48 64x48) rounds=1
    gl='GlTest.TimerAndRasteriser*:GlTest.BudgetInBytes*:GlTest.TwoRuns*:Networks/Probes.*/macula'
    stable='Ordering.WithoutIt*:Order.OfT*Tails*:Promise.Fill*' scene=layers-6
    ;;
  short)
    frames=120 hold=320x180 sizes=(320x180 640x360) rounds=5
    gl=-$stability stable=$stability scene=gallery
    ;;
  full)
    frames=600 hold=1920x1080 sizes=(1920x1080 3840x2160) rounds=9
    gl=-$stability stable=$stability scene=gallery
    ;;
esac
for mode in "${modes[@]}"; do
  export MACULA_TEST_SYNC=$mode
  section "gl-$mode" "GL tests, $mode" "$out/gl-$mode.json" "$tests" --gtest_color=no \
    --gtest_brief=1 "--gtest_filter=$gl" "--gtest_output=json:$out/gl-$mode.json"
  section "stability-$mode" "Stability tests, $mode" "$out/stability-$mode.json" "$tests" \
    --gtest_color=no --gtest_brief=1 "--gtest_filter=$stable" \
    "--gtest_output=json:$out/stability-$mode.json"
done
unset MACULA_TEST_SYNC

experiment=$(<"$MACULA_DATA/assets/experiments/gpu.toml")
experiment=${experiment//1920x1080/"${sizes[0]}"}
experiment=${experiment//3840x2160/"${sizes[1]}"}
experiment=${experiment//frames = 9/"frames = $rounds"}
if [[ $length == quick ]]; then # the first study alone, of a small scene
  experiment=${experiment%'[[study]]'*}
  experiment=${experiment/'"bottles", "gallery"'/'"layers-6"'}
fi
printf '%s\n' "$experiment" >"$out/gpu.toml"
wanted='"status": "measured"'
section chart "Frame times of all methods" "$out/chart/results.json" "$macula" chart "$out/gpu.toml" \
  --out "$out/chart"
wanted=
for hertz in 120 240; do
  target=8.333
  ((hertz == 240)) && target=4.167
  section "hold-$hertz" "A frame time held at $hertz Hz" "$out/hold-$hertz/results.json" "$macula" \
    hold "$scene" --target-ms "$target" --load none --frames "$frames" --size "$hold" \
    --out "$out/hold-$hertz"
done
if [[ $length == quick ]]; then
  skip walk "The walkthrough's pace" "left out of a quick report"
elif [[ -z ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]]; then
  skip walk "The walkthrough's pace" "no display: DISPLAY and WAYLAND_DISPLAY are not set"
else
  section walk "The walkthrough's pace" "$out/walk.json" "$macula" walk "$scene" --camera auto \
    --frames "$frames" --size "$hold" --no-panels --json "$out/walk.json"
fi

write_report "$out" "$length" "$software"
