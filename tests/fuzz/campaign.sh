#!/usr/bin/env bash
# Builds the fuzz targets with clang under address and undefined-behaviour sanitizers and runs each
# for a number of executions, starting from its corpus. Prints the executions of each target; stops
# at the first finding, whose input is left in the build folder.
# Usage: campaign.sh [RUNS [TARGET ...]]     RUNS: 1000000; TARGET: all fuzz_*.cpp
# MACULA_FUZZ_LONGEST: bytes of the longest input (4096)
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
build=$root/build/fuzz
runs=${1:-1000000}
# 4 KB hold every row and table that matters; larger inputs only slow the search.
longest=${MACULA_FUZZ_LONGEST:-4096}
shift || true
targets=("$@")
if ((${#targets[@]} == 0)); then
  for source in "$here"/fuzz_*.cpp; do targets+=("$(basename "$source" .cpp)"); done
fi

mkdir -p "$root/build"
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1" \
  -DMACULA_FUZZ=ON -DMACULA_SANITIZE=ON >"$build.log" 2>&1 || { tail -20 "$build.log"; exit 1; }
cmake --build "$build" --target "${targets[@]}"

cd "$build"
for target in "${targets[@]}"; do
  # fuzz_gaze_eyelink begins with corpus/gaze/eyelink, or with its whole family where it has none.
  seeds=()
  family=${target#fuzz_}
  rest=${family#*_}
  family=${family%%_*}
  for folder in "$here/corpus/$family/$rest" "$here/corpus/$family"; do
    if [[ -d $folder ]]; then seeds=("$folder"); break; fi
  done
  mkdir -p "found/$target"
  start=$SECONDS
  if ! "./$target" -runs="$runs" -max_len="$longest" -timeout=20 -rss_limit_mb=2048 \
    -print_final_stats=1 -artifact_prefix="found/$target-" \
    "found/$target" "${seeds[@]}" >"$target.log" 2>&1; then
    tail -40 "$target.log"
    echo "FAILED $target: see $build/$target.log and $build/found" >&2
    exit 1
  fi
  executed=$(sed -n 's/^stat::number_of_executed_units: *//p' "$target.log")
  printf '%-28s %10s executions, %5d s, no finding\n' "$target" "$executed" $((SECONDS - start))
done
