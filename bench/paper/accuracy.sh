#!/usr/bin/env bash
# The table of docs/accuracy.md: what `isl accuracy` says of the flake of 820 balls.
#
#   bench/paper/accuracy.sh [--quick]
set -u
# shellcheck source-path=SCRIPTDIR source=tables.sh
. "$(dirname -- "$0")/tables.sh"
common_options "$@"

size=$(or_quick 400x300 80x60)
timed "$isl" accuracy "$root/scenes/paper/sphereflake.isl" -s "$size" -o "$work/flake"

head_row setting time 'fields/ray' 'median px' '99 % px' 'worst px' '> 1 px' missed false holes
# Tolerances that change nothing share a row.
awk -F, '
  function count(n) { return n > 0 ? n : "-" }
  function px(x) { return x == 0 ? "0" : x >= 100 ? sprintf("%.0f", x) : x < 0.001 ? sprintf("%.1e", x) : sprintf("%.2g", x) }
  function finish() {
    if (name != "") printf "| `%s`%s | %.2f%s", name, first == last ? (first == "" ? "" : ", " first) : ", " first " to " last, time, rest
  }
  NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
  {
    split($1, word, " ")
    line = sprintf(" | %.2f | %s | %s | %s | %s | %s | %s | %s |\n", $at["field_evaluations_per_ray"],
                   px($at["error_median_px"]), px($at["error_p99_px"]), px($at["error_worst_px"]), count($at["beyond_pixel"]),
                   count($at["missed"]), count($at["false_surfaces"]), count($at["holes"]))
    if (word[1] == name && word[2] != "" && line == rest) {
      last = word[2]
      if ($at["options"] ~ /0.05px/) time = $at["relative_time"]
      next
    }
    finish()
    name = word[1]
    first = last = word[2]
    time = $at["relative_time"]
    rest = line
  }
  END { finish() }' "$work/flake.csv"
printf '\n*%s*\n' "$(grep '^The truth' "$work/out")"
