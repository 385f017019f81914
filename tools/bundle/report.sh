#!/bin/bash
# Sourced by gpu-report.sh: runs its sections and writes report.json and report.html of them.
# bash alone. report.json is put together from the JSON that the programs wrote.

out=${out:?the folder of the report}
sections=() # each a JSON object
failed=0

# Text as a JSON string. Bytes beyond ASCII, which a log of a driver may hold, become question marks.
json_string() {
  local text=$1
  text=${text//\\/\\\\}
  text=${text//\"/\\\"}
  text=${text//$'\n'/\\n}
  text=${text//$'\t'/\\t}
  text=${text//[^[:print:]]/?}
  printf '"%s"' "$text"
}

# The end of a file, which says how a run ended.
tail_of() {
  local text
  text=$(<"$1")
  if ((${#text} > 20000)); then text="... ${text: -20000}"; fi
  printf '%s' "$text"
}

# The JSON of a file, or null where it is not there or was not finished.
json_of() {
  local text=
  [[ -r $1 ]] && text=$(<"$1")
  if [[ $text == "{"*"}" ]]; then printf '%s' "$text"; else printf 'null'; fi
}

add_section() { # add_section ID TITLE STATUS EXIT SECONDS COMMAND LOG-TEXT RESULT-JSON
  sections+=("{\"id\": \"$1\", \"title\": $(json_string "$2"), \"status\": \"$3\", \"exit\": $4,
\"seconds\": $5, \"command\": $(json_string "$6"), \"log\": $(json_string "$7"), \"result\": $8}")
}

# Runs a command. What it prints goes to ID.log; it is to write RESULT, a JSON file, with $wanted in
# it.
wanted=
section() { # section ID TITLE RESULT COMMAND...
  local id=$1 title=$2 result=$3 began=$SECONDS status=passed code found told
  shift 3
  printf '%-22s ' "$id"
  rm_file "$result"
  ${patience[@]+"${patience[@]}"} "$@" >"$out/$id.log" 2>&1
  code=$?
  found=$(json_of "$result")
  # No test is no success: the filter fits none.
  if ((code != 0)) || [[ $found == null || $found == *'"tests": 0,'* || $found != *"$wanted"* ]]; then
    status=failed
    ((++failed))
  fi
  echo "$status, $((SECONDS - began)) s"
  told=${*//"$here/bin/"/}
  add_section "$id" "$title" "$status" "$code" "$((SECONDS - began))" \
    "${told//"$out/"/}" "$(tail_of "$out/$id.log")" "$found"
}

skip() { # skip ID TITLE REASON
  printf '%-22s skipped: %s\n' "$1" "$3"
  add_section "$1" "$2" skipped null 0 "" "$3" null
}

# A result of an earlier run must not be taken for this one's. There may be no rm: it is emptied.
rm_file() {
  if [[ -e $1 ]]; then : >"$1"; fi
}

# A hanging driver must not keep the other sections away, where there is a program to end it.
patience=()
command -v timeout >/dev/null && patience=(timeout -k 10 3600)

first_line() { # first_line FILE PATTERN: of the lines that match
  local line
  [[ -r $1 ]] || return
  while IFS= read -r line; do
    if [[ $line =~ $2 ]]; then
      printf '%s' "${line#*: }"
      return
    fi
  done <"$1"
}

write_report() { # write_report FOLDER LENGTH SOFTWARE
  local verdict=passed joined page assets=$MACULA_DATA/assets/report when
  ((failed)) && verdict=failed
  joined=$(printf '%s,\n' "${sections[@]}")
  printf -v when '%(%Y-%m-%d)T' -1
  local json
  json="{\"schema\": 1, \"verdict\": \"$verdict\", \"length\": \"$2\", \"software\": $3,
\"date\": \"$when\", \"version\": $(json_string "$("$here/bin/macula" --version 2>&1)"),
\"kernel\": $(json_string "$(first_line /proc/version .)"),
\"processor\": $(json_string "$(first_line /proc/cpuinfo '^model name')"),
\"kernel_driver\": $(json_string "$(first_line /proc/driver/nvidia/version .)"),
\"sections\": [
${joined%,}
]}"
  printf '%s\n' "$json" >"$1/report.json"
  page=$(<"$assets/gpu.html")
  {
    printf '%s' "${page%%'{{style}}'*}"
    printf '%s\n' "$(<"$assets/report.css")"
    page=${page#*'{{style}}'}
    printf '%s' "${page%%'{{data}}'*}"
    printf '%s' "${json//</\\u003c}" # as scriptSafe() of engine/core/page.h
    page=${page#*'{{data}}'}
    printf '%s' "${page%%'{{script}}'*}"
    printf '%s\n' "$(<"$assets/charts.js")" "$(<"$assets/gpu.js")"
    printf '%s\n' "${page#*'{{script}}'}"
  } >"$1/report.html"
  echo "report: $1/report.html"
  ((failed == 0)) || echo "$failed of ${#sections[@]} sections failed"
  ((failed == 0))
}
