#!/usr/bin/env bash
# The seven flakes of scenes/paper/sphereflake.isl, 1 to 597,871 components: reading, compiling, tracing, memory, and how
# the tracing time grows with the number of components.
#
#   bench/sizes.sh [-n RUNS] [-s PIXELS] [-l LEVELS] [-t THREADS]
#     -n  runs of each, of which the table has the medians (3)
#     -s  width and height of the picture (512)
#     -l  the largest flake (6: 597,871 components)
#     -t  threads (2)
set -u
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname -- "$0")/common.sh"

runs=3 size=512 levels=6
while getopts n:s:l:t: option; do
  case $option in
    n) runs=$OPTARG ;;
    s) size=$OPTARG ;;
    l) levels=$OPTARG ;;
    t) threads=$OPTARG ;;
    *) exit 2 ;;
  esac
done
whole_number -n "$runs" 1
whole_number -s "$size" 1
whole_number -l "$levels" 0
whole_number -t "$threads" 1
scene=$root/scenes/paper/sphereflake.isl

# resident COMMAND…: the most memory that it held at once, in bytes, as the system saw it; 0 where GNU time is missing.
resident() {
  [ -x /usr/bin/time ] || { echo 0; return; }
  /usr/bin/time -f '%M' -o "$work/resident" "$@" >"$work/out" 2>&1 || { cat "$work/out" >&2; fail "failed: $*"; }
  awk '{ print $1 * 1024 }' "$work/resident"
}

# render LEVEL COMMAND…: what goes before the program's name, if anything, follows the level.
render() {
  local level=$1
  shift
  "$@" "$isl" render "$scene" -D "Levels=$level" -s "${size}x$size" --samples 1 -t "$threads" -q \
    --stats "$work/stats.json" -o "$work/flake.png"
}

# measure LEVEL: one row of the table, and a line "components seconds" for the fit.
measure() {
  local level=$1 stats=$work/stats.json
  for ((i = 0; i < runs; ++i)); do
    render "$level" timed
    note "read_$level" "$(sum "$(stat_of parse "$stats")" "$(stat_of evaluate "$stats")")"
    note "compile_$level" "$(stat_of compile "$stats")"
    note "trace_$level" "$(stat_of trace "$stats")"
    note "process_$level" "$seconds"
  done
  local render_resident check_resident components
  render_resident=$(render "$level" resident) || exit 1
  check_resident=$(resident "$isl" check "$scene" -D "Levels=$level") || exit 1
  components=$(stat_of fields "$stats")
  printf '%s %s\n' "$components" "$(median "trace_$level")" >>"$work/fit"
  awk -v n="$components" -v read="$(median "read_$level")" -v compile="$(median "compile_$level")" \
    -v trace="$(median "trace_$level")" -v process="$(median "process_$level")" -v peak="$(stat_of peak_bytes "$stats")" \
    -v database="$(stat_of database_bytes "$stats")" -v grid="$(stat_of grid_bytes "$stats")" \
    -v rendering="$render_resident" -v checking="$check_resident" '
    function mb(bytes) { return bytes > 0 ? sprintf("%.1f", bytes / 1e6) : "-" }
    BEGIN { printf "%10d %9.4f %9.4f %9.4f %9.4f %9s %9s %9s %9s %9s\n", n, read, compile, trace, process, mb(database),
              mb(grid), mb(peak), mb(rendering), mb(checking) }'
}

# The slope of log(trace time) over log(components), by least squares. The lone ball is left out: its time is that of the
# pixels and not of the components.
exponent() {
  awk '$1 > 1 { x = log($1); y = log($2); ++n; sx += x; sy += y; sxx += x * x; sxy += x * y; last = $1 }
    END {
      if (n < 2) { print "no exponent from fewer than two sizes above 1"; exit }
      printf "trace time grows as components^%.3f from 10 to %d\n", (n * sxy - sx * sy) / (n * sxx - sx * sx), last
    }' "$work/fit"
}

machine
printf '%sx%s, one ray a pixel, %s threads; seconds, medians of %s; memory in MB (10^6 bytes)\n\n' "$size" "$size" "$threads" \
  "$runs"
printf '%10s %9s %9s %9s %9s %9s %9s %9s %9s %9s\n' "" parse+ "" "" whole "" "" stats resident resident \
  components evaluate compile trace process database grid peak render check
for ((level = 0; level <= levels; ++level)); do measure "$level"; done
echo
exponent
