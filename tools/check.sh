#!/usr/bin/env bash
# Installs packages, reads the sources (tools/lint.sh), builds with warnings as errors, and runs
# every test. Those without GL, and the fuzz programs of all parsers, are built and run under the
# address and undefined-behaviour sanitizers, the others without them.
# MACULA_PRESET: build preset of the others (default ci). MACULA_SKIP_SANITIZERS=1: all in that one.
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
unit_tests=ON
status=0
closing=() # what ctest said at the end
details=() # what the tests themselves said
run_tests() { # run_tests FOLDER OPTION...
  closing+=("$1/check.log")
  details+=("$1/Testing/Temporary/LastTest.log")
  ctest --test-dir "$1" --output-on-failure -j "$(nproc)" "${@:2}" | tee "$1/check.log" || status=1
}
if [[ -z ${MACULA_SKIP_SANITIZERS:-} ]]; then
  unit_tests=OFF
  cmake --preset asan
  cmake --build --preset asan --target sanitized_tests
  run_tests build/asan -L sanitized
fi
cmake --preset "$preset" -DMACULA_UNIT_TESTS=$unit_tests
cmake --build --preset "$preset"
run_tests "build/$preset"
echo "What was compared: shaders and tables, barriers and memory of random frames, orders of insertion,"
echo "two drivers, the bundle (these tests ran in any case, so their counts must be there):"
compared='(NOTE +\] (Bindings\.|[0-9]+ lists|InsertionModel|Contention))'
compared+='|^second driver: |^bundle: [0-9]+ sections'
grep -h -E "$compared" "${details[@]}" | sort -u || status=1
for log in "${closing[@]}"; do sed -n '/tests passed/,$p' "$log"; done
((status == 0))
