#!/bin/bash
# Sourced by the scripts of a bundle, with $here set to its folder: lets its programs find their
# data, and their libraries.
#
# lib/ holds libraries that no driver loads. lib/absent/NAME/ holds those that a driver may load as
# well (libstdc++, X11, zlib, the vendor-neutral loader of GL): an older copy of ours in the place of
# the target's would break its driver, so each is used only where the target has none, or one that
# is too old for the programs. AppImage's excludelist keeps such libraries out of its images for the
# same reason (https://github.com/AppImageCommunity/pkg2appimage, excludelist). libc and the driver
# itself always come from the target.
#
# bash alone: a bare machine may have no other program.

here=${here:?the folder of the bundle}
export MACULA_DATA=$here/share/macula MACULA_MODULES=$here/lib/macula

# What the dynamic loader says of a program's libraries, without running it (as ldd does), with
# further ones preloaded.
trace() { # trace PATH-OF-LIBRARIES PROGRAM [LIBRARY...]
  local path=$1 program=$2
  shift 2
  LD_TRACE_LOADED_OBJECTS=1 LD_LIBRARY_PATH=$path LD_PRELOAD="$*" "$program" 2>&1
}

# The names of libraries that the loader did not find, or found too old, one a line.
unfound() { # unfound TRACE
  local line name
  local IFS=$'\n'
  for line in $1; do
    case $line in
      *' => not found'*) name=${line%% => not found*} ;;
      *"object '"*"' from LD_PRELOAD cannot be preloaded"*) name=${line#*object \'} name=${name%%\'*} ;;
      *': version '*' not found'*) name=${line%%: version *} name=${name##*: } ;;
      *) continue ;;
    esac
    name=${name##*[[:blank:]/]}
    printf '%s\n' "$name"
  done
}

# Sets LD_LIBRARY_PATH. Fails, and says why, where the programs cannot be loaded.
find_libraries() {
  local given=${LD_LIBRARY_PATH:-} path=$here/lib added=1 program said name
  set -f
  while ((added)); do
    added=0
    for program in "$here"/bin/macula "$here"/bin/gl_tests; do
      said=$(trace "$path${given:+:$given}" "$program" libEGL.so.1)
      if [[ $said != *'not found'* && $said == *libGLdispatch* ]]; then
        # The loader is there; it has the functions of GL in one of two libraries.
        said=$(trace "$path${given:+:$given}" "$program" libEGL.so.1 libOpenGL.so.0)
        [[ $(trace "$path${given:+:$given}" "$program" libGL.so.1) != *cannot* ]] && said=
      fi
      local IFS=$'\n'
      for name in $(unfound "$said"); do
        if [[ -d $here/lib/absent/$name && :$path: != *":$here/lib/absent/$name:"* ]]; then
          path+=:$here/lib/absent/$name
          added=1
        fi
      done
      unset IFS
    done
  done
  set +f
  said=$(trace "$path${given:+:$given}" "$here/bin/macula")
  if [[ $said == *'not found'* || $said != *libc.so.6* ]]; then
    printf '%s\n' "$said" >&2
    echo "macula: a library is missing here, or older than the programs need (glibc 2.36 is enough)" >&2
    return 1
  fi
  export LD_LIBRARY_PATH=$path${given:+:$given}
}

# The loader of EGL knows drivers by files in two folders. Where a container is lent the driver of its
# host, file and libraries may lie elsewhere, or the file may be missing.
find_driver() { # find_driver [FOLDER]: a place for such a file
  local folder file
  for folder in /usr/local/nvidia/lib64 /usr/local/nvidia/lib; do
    [[ -e $folder/libEGL_nvidia.so.0 ]] && export LD_LIBRARY_PATH=$LD_LIBRARY_PATH:$folder
  done
  [[ -n ${__EGL_VENDOR_LIBRARY_FILENAMES:-}${__EGL_VENDOR_LIBRARY_DIRS:-} ]] && return
  for folder in /etc/glvnd/egl_vendor.d /usr/share/glvnd/egl_vendor.d \
    /usr/local/nvidia/share/glvnd/egl_vendor.d /run/opengl-driver/share/glvnd/egl_vendor.d; do
    for file in "$folder"/*.json; do
      [[ -e $file ]] || continue
      [[ $folder == /etc/* || $folder == /usr/share/* ]] && return
      export __EGL_VENDOR_LIBRARY_DIRS=$folder
      return
    done
  done
  [[ -z ${1:-} ]] && return
  [[ $(trace "$LD_LIBRARY_PATH" "$here/bin/macula" libEGL_nvidia.so.0) == *cannot* ]] && return
  echo '{"file_format_version": "1.0.0", "ICD": {"library_path": "libEGL_nvidia.so.0"}}' \
    >"$1/egl_vendor.json"
  export __EGL_VENDOR_LIBRARY_FILENAMES=$1/egl_vendor.json
}
