#!/usr/bin/env bash
# Bad input ends with one clear line and exit status 2, and leaves nothing half-written.
set -uo pipefail
macula=$1
data=$MACULA_SOURCE/../shared/data
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
cd "$work" || exit 1
failures=0

# refuses NAME WORD COMMAND...: status 2, one line on standard error, which holds WORD.
refuses() {
  local name=$1 word=$2
  shift 2
  "$@" >out.txt 2>err.txt
  local status=$? lines
  lines=$(wc -l <err.txt)
  if [[ $status -ne 2 || $lines -ne 1 ]] || ! grep -qF -- "$word" err.txt; then
    echo "FAILED $name: status $status, $lines lines, wanted '$word':"
    head -5 err.txt
    failures=$((failures + 1))
  else
    echo "ok $name: $(cat err.txt)"
  fi
}

replay() { "$macula" replay "$@" --frames 1 --size 32x32 --out out; }

: >empty.glb
: >empty.csv
head -c 100 /bin/ls >garbage.csv
mkdir folder.glb
"$macula" scene make layers-2 --out good.glb >/dev/null || exit 1
head -c 200 good.glb >cut.glb
mkdir locked
chmod a-w locked

refuses "wrong path" nowhere.glb replay nowhere.glb
refuses "no such scene" smoke replay smokee
refuses "scenes are listed" "of gallery, smoke, bottles" replay smokee
refuses "wrong path without a scene's ending" "no such file; check the path" replay nowhere/smoke
refuses "empty file" empty.glb replay empty.glb
refuses "folder" folder.glb replay folder.glb
refuses "truncated" cut.glb replay cut.glb
refuses "unknown setting" --k-ave replay layers-2 --k-avee 3
refuses "unknown setting by --set" oit.kAve replay layers-2 --set oit.kAvee=3
refuses "unknown method" kb-variable replay layers-2 --method kb-variabel
refuses "size 0x0" --size "$macula" replay layers-2 --size 0x0 --out out
refuses "size without cross" --size "$macula" replay layers-2 --size 100 --out out
refuses "negative k_ave" k-ave replay layers-2 --k-ave -1
refuses "k_ave not a number" k-ave replay layers-2 --k-ave nan
refuses "unreadable log" nowhere.csv replay layers-2 --gaze nowhere.csv
refuses "empty log" empty.csv replay layers-2 --gaze empty.csv
refuses "no gaze log" garbage.csv replay layers-2 --gaze garbage.csv
refuses "scene as gaze" "a glTF scene, not a gaze log" replay layers-2 --gaze good.glb
printf 'time_s,x,y,valid\n0,0.5,0.5,1\n' >log.csv
refuses "format that is not the file's" "but the file is macula-csv" replay layers-2 --gaze log.csv --gaze.format eyelink
refuses "gaze off the window" 1.5 replay layers-2 --gaze 1.5,0.5
refuses "no camera path" nowhere.csv replay layers-2 --camera nowhere.csv
refuses "no word for a camera" "give auto, scene" replay layers-2 --camera orbit
refuses "percent for a share" "write 0.5 for 50 %" replay layers-2 --scene.opacity 50
refuses "percent sign for a share" "write 0.5 for 50 %" replay layers-2 --set scene.opacity=50%
refuses "percent of the pixels" "write 0.13 for 13 %" "$macula" features --training layers-2 --out out --sample 13%
refuses "percent among shares" "write 0.2 for 20 %" "$macula" features --training layers-2 --out out --shares 0.1 20

# A budget is stated once, in whatever place and form.
two="cannot hold together; drop"
printf 'oit.kAve = 2\n' >average.toml
printf '[oit]\nkAve = 2\nmemoryMiB = 8\n' >both.toml
refuses "two budgets" "--k-ave and --oit-memory $two --k-ave to keep 8 MiB, or --oit-memory to keep 4" replay layers-2 --k-ave 4 --oit-memory 8
refuses "two budgets by --set" "--set oit.kAve and --oit-memory $two" replay layers-2 --oit-memory 8 --set oit.kAve=2
refuses "two budgets, one in a file" "average.toml:1: oit.kAve and --oit-memory $two oit.kAve" replay layers-2 --config average.toml --oit-memory 8
refuses "two budgets in a file" "both.toml:2: oit.kAve and both.toml:3: oit.memoryMiB $two" replay layers-2 --config both.toml
replay layers-2 --config average.toml --oit-memory 0 >/dev/null || { echo "FAILED: 0 is no budget"; failures=$((failures + 1)); }
printf 'oit.fill = on\n' >word.toml
refuses "a word without quotes" "word.toml:1:12: Error while parsing value: could not determine value type; write true" replay layers-2 --config word.toml

refuses "no environment" nowhere.hdr replay layers-2 --environment nowhere.hdr
refuses "budget of nothing" oit-memory replay layers-2 --oit-memory 0.000001
refuses "zero frames" frames "$macula" replay layers-2 --frames 0 --out out
refuses "unknown subcommand" replay "$macula" replai
refuses "no subcommand" subcommand "$macula"
refuses "compare without a file" nowhere.png "$macula" compare nowhere.png nowhere.png
refuses "compare with a gaze off the image" --gaze "$macula" compare a.png b.png --gaze 1.5,0
refuses "compare of no pixels per degree" pixels-per-degree "$macula" compare a.png b.png --pixels-per-degree 0
refuses "gaze info of garbage" garbage.csv "$macula" gaze info garbage.csv
refuses "scene info of a cut file" cut.glb "$macula" scene info cut.glb
if [[ $(id -u) -ne 0 ]]; then
  refuses "output folder locked" locked/out "$macula" replay layers-2 --frames 1 --out locked/out
else
  refuses "output folder under /proc" /proc/macula "$macula" replay layers-2 --frames 1 --out /proc/macula
fi
refuses "output is a file" good.glb "$macula" replay layers-2 --frames 1 --out good.glb
GALLIUM_DRIVER=softpipe LIBGL_ALWAYS_SOFTWARE=1 \
  refuses "context below 4.5" "4.5" "$macula" replay layers-2 --frames 1 --size 32x32 --out out --platform surfaceless
if [[ -f $MACULA_BUILD/macula-image-io.so ]]; then  # a build with OpenImageIO
  image=$MACULA_SOURCE/docs/images/gallery.png
  mkdir modules
  refuses "image module missing" "modules/macula-image-io.so: this part of Macula is missing" \
    env MACULA_MODULES=modules "$macula" compare "$image" "$image"
  echo "no library" >modules/macula-image-io.so
  refuses "image module is none" "modules/macula-image-io.so: cannot be loaded" \
    env MACULA_MODULES=modules "$macula" compare "$image" "$image"
fi
if [[ -d $data/gltf-bad ]]; then
  for file in "$data"/gltf-bad/*.gl*; do
    timeout 60 "$macula" scene info "$file" >out.txt 2>err.txt
    status=$?
    if [[ $status -ne 0 && ($status -ne 2 || $(wc -l <err.txt) -ne 1) ]]; then
      echo "FAILED $file: status $status"
      failures=$((failures + 1))
    fi
  done
else
  echo "skipped: no shared data for malformed files"
fi
if compgen -G "out/*.part*" >/dev/null; then
  echo "FAILED: something half-written is left"
  failures=$((failures + 1))
fi
echo "$failures failures"
exit $((failures > 0))
