#!/usr/bin/env bash
# Installs what is missing of tools/packages.txt. Usage: install_packages.sh build [test] [lint] [dev] [train]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)

missing=()
while read -r name kind _; do
  [[ -z $name || $name == \#* ]] && continue
  [[ " $* " == *" $kind "* ]] || continue
  dpkg-query -W -f='${Status}' "$name" 2>/dev/null | grep -q '^install ok installed$' || missing+=("$name")
done <"$here/packages.txt"
if ((${#missing[@]} == 0)); then exit 0; fi

echo "Installing: ${missing[*]}"
as_root=()
if [[ $(id -u) -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "These Debian packages are missing, and installing them needs root: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -q
"${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"
