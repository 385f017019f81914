#!/bin/bash
# Runs the program of this folder.
here=$(CDPATH='' cd "$([[ $0 == */* ]] && echo "${0%/*}" || echo .)" && pwd)
# shellcheck source=tools/bundle/libraries.sh
. "$here/lib/libraries.sh"
find_libraries || exit 3
find_driver ''
exec "$here/bin/macula" "$@"
