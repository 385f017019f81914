#!/usr/bin/env bash
# Usage: bundle.sh [--build FOLDER] [--out FOLDER]
# Makes macula-VERSION-linux-x86_64.tar.gz in FOLDER (default build): the program, the GL tests, the
# libraries that they need, shaders, assets, and gpu-report.sh, which runs them on a machine with a
# driver and nothing else. --build: a built folder to take them from; without it, the release preset
# is built with its tests. tools/bundle/libraries.sh says which libraries go where, and why.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
kMostBytes=60000000

build='' out=$root/build
while (($#)); do
  case $1 in
    --build) build=${2:?a folder} ;;
    --out) out=${2:?a folder} ;;
    *)
      echo "bundle: unknown option '$1'; there are --build FOLDER and --out FOLDER" >&2
      exit 2
      ;;
  esac
  shift 2
done
if [[ -z $build ]]; then
  cd "$root"
  cmake --preset release -DMACULA_TESTS=ON
  cmake --build --preset release --target macula gl_tests
  build=build/release
fi
build=$(cd "$build" && pwd)
mkdir -p "$out"
out=$(cd "$out" && pwd)

read -r _ version _ < <("$build/macula" --version)
name=macula-$version-linux-x86_64
staged=$(mktemp -d)
trap 'rm -rf "$staged"' EXIT
folder=$staged/$name
mkdir -p "$folder"/{bin,lib/absent,lib/macula,report,share/macula/tests/golden,share/doc}

strip -o "$folder/bin/macula" "$build/macula"
strip -o "$folder/bin/gl_tests" "$build/gl_tests"
if [[ -f $build/png/macula-image-io.so ]]; then  # else the program has its codec in itself
  strip -o "$folder/lib/macula/macula-image-io.so" "$build/png/macula-image-io.so"
fi
cp -r "$root/shaders" "$root/assets" "$folder/share/macula"
cp -r "$root/tests/golden/networks" "$folder/share/macula/tests/golden"
cp "$root/tools/bundle/"{libraries,report}.sh "$folder/lib"
cp "$root/tools/bundle/gpu-report.sh" "$folder/gpu-report.sh"
cp "$root/tools/bundle/macula.sh" "$folder/macula"
cp "$root/tools/bundle/README.txt" "$folder"
cp "$root/LICENSE" "$folder/share/doc"

# From the target: libc and its parts, and what belongs to a driver.
target='^(linux-vdso|ld-linux|lib(c|m|dl|rt|pthread|resolv|drm|gbm|glapi)\.so)'
# Loaded by drivers, too: used where the target has none.
shared='^lib(stdc\+\+|gcc_s|z|X11|xcb|Xau|Xdmcp|bsd|md|udev|EGL|GLdispatch|OpenGL|GLX|GL)\.so'
libraries() { # NAME PATH of each library of the programs
  ldd "$build/macula" "$build/gl_tests" | awk '$2 == "=>" && $3 ~ /^\// { print $1, $3 }' | sort -u
  # Opened at run time, so ldd does not see them: the vendor-neutral loader of GL.
  /sbin/ldconfig -p | awk '/x86-64/ && $1 ~ /^lib(EGL|GLdispatch|OpenGL|GLX|GL)\.so\.[0-9]+$/ {
    print $1, $NF }'
}
while read -r library path; do
  [[ $library =~ $target ]] && continue
  to=$folder/lib
  if [[ $library =~ $shared ]]; then
    to=$folder/lib/absent/$library
    mkdir -p "$to"
  fi
  cp -L "$path" "$to/$library"
  # Its licence, by the package that it came from, which may name it in /lib or /usr/lib.
  real=$(readlink -f "$path")
  package=$({ dpkg-query -S "$real" "${real#/usr}" 2>/dev/null || true; } | sed 's/:.*//; q')
  if [[ -n $package && -f /usr/share/doc/$package/copyright ]]; then
    cp -L "/usr/share/doc/$package/copyright" "$folder/share/doc/$package.txt"
  fi
done < <(libraries)

archive=$out/$name.tar.gz
tar --sort=name --owner=0 --group=0 --numeric-owner -C "$staged" -czf "$archive.part" "$name"
bytes=$(stat -c %s "$archive.part")
if ((bytes > kMostBytes)); then
  rm "$archive.part"
  echo "bundle: $bytes bytes, at most $kMostBytes; see what grew in $build" >&2
  exit 1
fi
mv "$archive.part" "$archive"
echo "bundle: $archive, $((bytes / 1000000)) MB"
