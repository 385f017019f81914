#!/usr/bin/env bash
# The commit that a build names: that of a clean tree, of a changed one, of an archive, of none.
set -uo pipefail
if ! command -v git >/dev/null || ! command -v cmake >/dev/null; then
  echo "skipped: git or cmake is not installed"
  exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
failures=0

# names WANTED NAME TREE: what cmake/Version.cmake of TREE writes.
names() {
  local wanted=$1 name=$2 tree=$3 found
  rm -f "$work/version.h"
  cmake -DSOURCE="$tree" -DOUTPUT="$work/version.h" -DVERSION=1.2.3 -P "$tree/cmake/Version.cmake" || failures=$((failures + 1))
  found=$(sed -n 's/#define MACULA_COMMIT "\(.*\)"/\1/p' "$work/version.h")
  if [[ $found == "$wanted" ]]; then
    echo "ok $name: $found"
  else
    echo "FAILED $name: '$found', wanted '$wanted'"
    failures=$((failures + 1))
  fi
}

# A repository of its own: the state of the tree that is tested must decide nothing.
tree=$work/tree
mkdir -p "$tree/cmake"
cp "$MACULA_SOURCE/.gitattributes" "$tree"
cp "$MACULA_SOURCE/cmake/Version.cmake" "$MACULA_SOURCE/cmake/archive_commit.txt" "$tree/cmake"
# In a source tree that is itself an archive, the file is filled in already.
# shellcheck disable=SC2016  # git replaces it, not the shell
echo '$Format:%H$' >"$tree/cmake/archive_commit.txt"
export GIT_CONFIG_GLOBAL=/dev/null GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a@b \
  GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a@b
unset GIT_DIR GIT_WORK_TREE
git -C "$tree" init -q && git -C "$tree" add -A && git -C "$tree" commit -qm first || exit 1
commit=$(git -C "$tree" rev-parse HEAD)
commit=${commit:0:12}
names "$commit" "clean tree" "$tree"

mkdir "$work/archive"
git -C "$tree" archive HEAD | tar -x -C "$work/archive"
names "$commit" "archive" "$work/archive"

echo changed >>"$tree/.gitattributes"
names "$commit-dirty" "changed tree" "$tree"
git -C "$tree" checkout -q .gitattributes
echo new >"$tree/new.txt"
names "$commit" "tree with a file that is not tracked" "$tree"

# An archive inside another repository is not of that one's commit.
mkdir "$work/outer"
git -C "$work/outer" init -q
cp -r "$work/archive" "$work/outer/inner"
git -C "$work/outer" add -A && git -C "$work/outer" commit -qm outer || exit 1
names "$commit" "archive in another repository" "$work/outer/inner"

rm -rf "$tree/.git"
names unknown "copy without .git" "$tree"
echo "$failures failures"
exit $((failures > 0))
