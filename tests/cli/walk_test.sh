#!/bin/sh
# The walkthrough in a real window: k rises where the pointer is.
#
# usage: walk_test.sh PROGRAM [FOLDER]
#
# Starts an X server without a screen, puts the pointer at one place of the picture and then at
# another, and compares the mean k around both places between the two runs. Places, not times,
# decide. The screenshots and numbers stay in FOLDER where one is given. Exit status 77: not run.
set -eu

program=$1
keep=${2:-}

for tool in Xvfb xdotool; do
  if ! command -v "$tool" >/dev/null 2>&1; then
    echo "skipped: $tool is not installed (apt-get install xvfb xdotool)"
    exit 77
  fi
done

folder=$(mktemp -d)
server=
cleanup() {
  if [ -n "$server" ]; then kill "$server" 2>/dev/null || true; fi
  if [ -n "$keep" ]; then
    mkdir -p "$keep"
    cp -f "$folder"/*.png "$folder"/*.json "$keep" 2>/dev/null || true
  fi
  rm -rf "$folder"
}
trap cleanup EXIT
trap 'exit 1' INT TERM

# The server itself chooses a free display and says which once it takes connections. -noreset: it
# would put the pointer back when xdotool leaves.
mkfifo "$folder/display"
Xvfb -displayfd 3 -screen 0 800x600x24 -nolisten tcp -noreset \
  3>"$folder/display" 2>"$folder/server.log" &
server=$!
read -r number <"$folder/display" || { cat "$folder/server.log"; exit 1; }
DISPLAY=:$number
export DISPLAY
unset WAYLAND_DISPLAY

# Mesa then prints what a program does wrong with OpenGL.
MESA_DEBUG=1
export MESA_DEBUG

faults=0
check() {
  if [ "$1" = 1 ]; then
    echo "ok     $2"
  else
    echo "FAULT  $2"
    faults=$((faults + 1))
  fi
}

# holds EXPRESSION: 1 where it is true for awk, else 0.
holds() { awk "BEGIN { print (($1) ? 1 : 0) }"; }

# walk NAME SCENE OPTION...: draws into NAME.png and NAME.json.
walk() {
  name=$1
  shift
  if ! "$program" walk "$@" --screenshot "$folder/$name.png" --json "$folder/$name.json" \
    2>"$folder/$name.log"; then
    cat "$folder/$name.log"
    exit 1
  fi
  if grep -i "user error" "$folder/$name.log"; then check 0 "$name: OpenGL is used rightly"; fi
}

# number_of NAME KEY: the first number with that key. means_of NAME: k_mean of all probes.
number_of() { sed -n "s/.*\"$2\": *\([-0-9.e+]*\).*/\1/p" "$folder/$1.json" | head -n 1; }
means_of() { sed -n 's/.*"k_mean": *\([-0-9.e+]*\).*/\1/p' "$folder/$1.json" | tr '\n' ' '; }

# png_size NAME: "width height" from the header of the file.
png_size() {
  od -An -tu1 -j16 -N8 "$folder/$1.png" |
    awk '{ print (($1*256+$2)*256+$3)*256+$4, (($5*256+$6)*256+$7)*256+$8 }'
}

# rises NAME PLACE_A PLACE_B FACTOR SCENE OPTION...: two runs with the pointer at two places, both
# "X Y" in pixels. k around a place must be larger than FACTOR times what it is when the other place
# is looked at. Without a window manager the window lies in the corner of the screen. More than one
# frame, because the first has no history.
rises() {
  title=$1 a=$2 b=$3 factor=$4
  shift 4
  probe_a=$(echo "$a" | awk '{ printf "%.6f,%.6f", $1 / 480, $2 / 320 }')
  probe_b=$(echo "$b" | awk '{ printf "%.6f,%.6f", $1 / 480, $2 / 320 }')
  for place in a b; do
    if [ $place = a ]; then at=$a; else at=$b; fi
    xdotool mousemove "${at% *}" "${at#* }"
    run="$title-$place"
    walk "$run" "$@" --size 480x320 --method kb-variable --heatmap k --no-panels --frames 3 \
      --probe "$probe_a" --probe "$probe_b"
    x=$(number_of "$run" x)
    y=$(number_of "$run" y)
    echo "       $run: pointer at $x, $y; mean k $(means_of "$run")"
    check "$(holds "($x - ${at% *} / 480)^2 < 0.003^2 && ($y - ${at#* } / 320)^2 < 0.003^2")" \
      "$run: the gaze is where the pointer was put"
    check "$([ "$(png_size "$run")" = "480 320" ] && echo 1)" "$run: the picture is the window"
  done
  # shellcheck disable=SC2046  # two numbers each, and so four words
  set -- $(means_of "$title-a") $(means_of "$title-b")
  check "$(holds "${1:-0} > $factor * ${3:-1} && ${3:-0} > 0")" "$title: k rises at the first place"
  check "$(holds "${4:-0} > $factor * ${2:-1} && ${2:-0} > 0")" "$title: k rises at the second place"
  check "$(cmp -s "$folder/$title-a.png" "$folder/$title-b.png" || echo 1)" "$title: the pictures differ"
}

# Sixteen layers over the whole picture: only the distance to the gaze tells pixels apart. At the
# far place its factor is 0 (1 - (2 * 384 / (1.1 * 577))^3 < 0), at the near one 1.
rises layers "48 160" "432 160" 2 layers-16 --k-ave 4
# Smoke, 200 pixels from its head to its foot; a budget that binds, and a steeper fall-off.
rises smoke "256 50" "236 190" 1.1 smoke --k-ave 0.5 --set importance.periphery=1

# The window with its panels, at a size where they have to fold.
walk panels smoke --size 640x480 --frames 2 --heatmap k
check "$([ "$(png_size panels)" = "640 480" ] && echo 1)" "panels: the picture is the window"

# Frames of a walk wait for the GPU only where that is the clock, and times are wanted.
walk quiet smoke --size 320x240 --frames 12 --no-panels --method kb-variable --set frame.timing=off
check "$([ "$(number_of quiet blocking_calls)" = 0 ] && echo 1)" "quiet: no frame waits for the GPU"
walk timed smoke --size 320x240 --frames 12 --no-panels --method kb-variable
calls=$(number_of timed blocking_calls)
if "$program" devices | grep -q "glFinish and the steady clock are used"; then
  check "$(holds "$calls > 5")" "timed: $calls times, once a pass"
else
  check "$(holds "$calls == 0")" "timed: $calls times, as a timer query waits for nothing"
fi

if [ $faults -gt 0 ]; then
  echo "$faults faults"
  exit 1
fi
