#!/usr/bin/env bash
# Installs packages, builds with warnings as errors, and runs every test; the parsers and loaders
# run again under the address and undefined-behaviour sanitizers.
# MACULA_PRESET: build preset (default ci). MACULA_SKIP_SANITIZERS=1: leave those out.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"

finish() {
  local status=$?
  if ((status == 0)); then echo "check: OK"; else echo "check: FAILED (status $status)"; fi
}
trap finish EXIT

tools/install_packages.sh build test
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
ctest --test-dir "build/$preset" --output-on-failure -j "$(nproc)"
