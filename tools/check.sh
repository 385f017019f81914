#!/usr/bin/env bash
# Installs packages, reads the sources (tools/lint.sh), builds with warnings as errors, and runs
# every test; the parsers and loaders run again under the address and undefined-behaviour sanitizers.
# MACULA_PRESET: build preset (default ci). MACULA_SKIP_SANITIZERS=1: leave those out.
# MACULA_TIDY, MACULA_BASE: what clang-tidy reads, see tools/lint.sh.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"

finish() {
  local status=$?
  if ((status == 0)); then echo "check: OK"; else echo "check: FAILED (status $status)"; fi
}
trap finish EXIT

tools/install_packages.sh build test lint
tools/lint.sh
preset=${MACULA_PRESET:-ci}
# Where ccache is used, a second checkout shares what the first has compiled.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1
cmake --preset "$preset"
cmake --build --preset "$preset"

if [[ -z ${MACULA_SKIP_SANITIZERS:-} ]]; then
  cmake --preset asan
  cmake --build --preset asan --target sanitized_tests
  ctest --test-dir build/asan --output-on-failure -L sanitized -j "$(nproc)"
fi
log=build/$preset/check.log
status=0
ctest --test-dir "build/$preset" --output-on-failure -j "$(nproc)" | tee "$log" || status=$?
echo "What was compared: shaders and tables, barriers and memory of random frames, orders of insertion,"
echo "two drivers, the bundle (these tests ran in any case, so their counts must be there):"
compared='(NOTE +\] (Bindings\.|[0-9]+ lists|InsertionModel|Contention))'
compared+='|^second driver: |^bundle: [0-9]+ sections'
grep -h -E "$compared" "build/$preset/Testing/Temporary/LastTest.log" | sort -u || status=1
sed -n '/tests passed/,$p' "$log"
((status == 0))
