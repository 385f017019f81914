#!/usr/bin/env bash
# Reads the sources: clang-format, clang-tidy, shellcheck and pyflakes. A warning is an error.
# clang-tidy reads what changed since the branch left MACULA_BASE (default: origin/main, else main;
# on that branch itself, in the newest commit), each file alone, so that an include that only others
# bring is an error too, and judges the lines that changed. Where more than kMost files changed it
# reads none, and says so.
# MACULA_TIDY=all: the whole tree; none: clang-tidy is left out.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
cd "$root"
kMost=8  # files that clang-tidy, half a minute each, reads in two minutes on two cores

# Also of an unpacked archive, which has no git.
files() { # files PATTERN...: sources and scripts of these names
  local pattern options=()
  for pattern in "$@"; do options+=(-o -name "$pattern"); done
  find .ci engine passes shaders/shared tools tests -type f \( "${options[@]:1}" \) | sort
}

status=0
files '*.cpp' '*.h' | xargs clang-format --dry-run -Werror || status=1
files '*.sh' run | xargs shellcheck -x || status=1
files '*.py' | xargs pyflakes3 || status=1

base_of_change() { # the merge base; on the base branch itself, the commit before the newest
  local base
  base=$(git merge-base HEAD "${MACULA_BASE:-origin/main}" 2>/dev/null ||
    git merge-base HEAD main 2>/dev/null) || return 1
  if [[ $base == "$(git rev-parse HEAD)" ]]; then
    base=$(git rev-parse --verify --quiet HEAD~1) || return 1
  fi
  echo "$base"
}
sources_of() { # sources that changed, and those of headers that did
  sed 's/\.h$/.cpp/' | sort -u | while read -r file; do
    if [[ -f $file ]]; then echo "$file"; fi
  done
}
lines_of() { # clang-tidy's filter of the lines that differ from a commit
  git diff -U0 --diff-filter=d "$1" -- engine passes tools tests | awk '
    /^\+\+\+ b\// { name = substr($2, 3) }
    /^@@/ {
      count = split(substr($3, 2), range, ",") == 2 ? range[2] : 1
      if (name !~ /\.(cpp|h)$/ || count == 0) next
      row = sprintf("{\"name\":\"%s\",\"lines\":[[%d,%d]]}", name, range[1], range[1] + count - 1)
      rows = rows (rows == "" ? "" : ",") row
    }
    END { print "[" rows "]" }'
}
tidy() { # tidy FOLDER OPTION FILE...: with the compile commands of a build folder
  local folder=$1 option=$2
  shift 2
  printf '%s\n' "$@" |
    xargs -r -P "$(nproc)" -n 1 clang-tidy -p "$folder" --quiet --warnings-as-errors='*' \
      --extra-arg=-Wno-unknown-warning-option "$option" 2>&1 |
    { grep -v -E '^[0-9]+ warnings? (generated|treated)' || true; }
}
case ${MACULA_TIDY:-changed} in
  none) ;;
  all) # as unity files, where every header is read once for many sources
    cmake --preset ci >/dev/null
    cmake --build --preset ci --target macula_version >/dev/null
    mapfile -t sources < <(sed -n 's/^ *"file": "\(.*\)".*/\1/p' build/ci/compile_commands.json | sort -u)
    tidy build/ci --checks=-bugprone-suspicious-include "${sources[@]}" || status=1
    ;;
  *)
    base=$(base_of_change) || exit $status
    mapfile -t sources < <(git diff --name-only --diff-filter=d "$base" -- engine passes tools tests |
      grep -E '\.(cpp|h)$' | sources_of)
    if ((${#sources[@]} > kMost)); then
      echo "lint: ${#sources[@]} files changed, clang-tidy reads none of them; MACULA_TIDY=all reads the whole tree"
      exit $status
    fi
    echo "lint: clang-tidy reads the changed lines of ${#sources[@]} files"
    if ((${#sources[@]})); then
      cmake --preset dev >/dev/null
      cmake --build --preset dev --target macula_version >/dev/null
      tidy build/dev "--line-filter=$(lines_of "$base")" "${sources[@]}" || status=1
    fi
    ;;
esac
exit $status
