#!/usr/bin/env bash
# isl against POV-Ray 3.7 on the same file, scenes/flake.pov: tracing it, and reading it. Both programs run in turn, as
# often as asked; the table shows medians with the least and the greatest, and POV-Ray's median over isl's.
#
#   bench/povray.sh [-n RUNS] [-s PIXELS] [-l LEVELS] [-r LEVELS]
#     -n  how often each program runs (5)
#     -s  width and height of the traced picture (1024)
#     -l  levels of the flake that is traced (4: 7,381 components)
#     -r  levels of the flake that is read (5: 66,430 components)
set -u
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname -- "$0")/common.sh"

runs=5 size=1024 trace_levels=4 read_levels=5
while getopts n:s:l:r: option; do
  case $option in
    n) runs=$OPTARG ;;
    s) size=$OPTARG ;;
    l) trace_levels=$OPTARG ;;
    r) read_levels=$OPTARG ;;
    *) exit 2 ;;
  esac
done
whole_number -n "$runs" 1
whole_number -s "$size" 1
whole_number -l "$trace_levels" 0
whole_number -r "$read_levels" 0
command -v povray >/dev/null || fail "povray is not installed (Debian's package povray)"
scene=$bench/scenes/flake.pov

# ---- The two programs, told the same -----------------------------------------------------------------------------------

# Both write a PNG: neither can be told to do all the work and keep the picture to itself.
# povray_run LEVELS PIXELS: no antialiasing, no display, no progress lines; leaves its report in $work/out.
povray_run() {
  timed povray "+I$scene" "Declare=Levels=$1" "+W$2" "+H$2" -A "+WT$threads" -D -V -P +FN "+O$work/povray.png"
}

# isl_run LEVELS PIXELS: the same; leaves its statistics in $work/stats.json.
isl_run() {
  timed "$isl" render "$scene" -D "Levels=$1" -s "$2x$2" --samples 1 -t "$threads" -q \
    --stats "$work/stats.json" -o "$work/isl.png"
}

# printed_time WHAT: of a line like "Trace Time: 0 hours 0 minutes 1 seconds (1.234 seconds)", the number in brackets.
printed_time() {
  awk -v what="$1 Time:" 'index($0, what) && match($0, /\([0-9.]+ seconds\)/) {
      print substr($0, RSTART + 1, RLENGTH - 10); found = 1; exit
    } END { exit !found }' "$work/out" || fail "POV-Ray printed no $1 Time"
}

isl_read_time() { sum "$(stat_of parse "$work/stats.json")" "$(stat_of evaluate "$work/stats.json")"; }

# ---- The table -----------------------------------------------------------------------------------------------------------

# row LABEL POVRAY_SERIES ISL_SERIES
row() {
  awk -v label="$1" -v a="$(median "$2")" -v b="$(median "$3")" -v sa="$(spread "$2")" -v sb="$(spread "$3")" '
    BEGIN { printf "  %-42s %8.3f  %-13s %8.3f  %-13s %7.2f\n", label, a, sa, b, sb, a / b }'
}

# heading TITLE RIVAL
heading() { printf '\n%s\n  %-42s %8s  %-13s %8s  %-13s %7s\n' "$1" "seconds" "$2" "" isl "" ratio; }

# A comparison is worth something only if both programs drew the same thing.
compare_pictures() {
  command -v idiff >/dev/null || { echo "pictures not compared: no idiff (Debian's package openimageio-tools)"; return; }
  povray_run "$trace_levels" 256
  isl_run "$trace_levels" 256
  idiff -fail 0.00784314 "$work/povray.png" "$work/isl.png" | awk '
    / over / && match($0, /\([0-9.e-]+%\)/) { share = substr($0, RSTART + 1, RLENGTH - 2) }
    /^PASS/ { share = "0%" }
    END { print "256x256 pictures: " (share == "" ? "could not be compared" : share " of the pixels differ by more than 2/255") }'
}

trace_both() {
  for ((i = 0; i < runs; ++i)); do
    povray_run "$trace_levels" "$size"
    note povray_trace "$(printed_time Trace)"
    note povray_trace_process "$seconds"
    note povray_trace_cpu "$cpu"
    isl_run "$trace_levels" "$size"
    note isl_trace "$(stat_of trace "$work/stats.json")"
    note isl_trace_process "$seconds"
    note isl_trace_cpu "$cpu"
  done
  heading "tracing: $(stat_of fields "$work/stats.json") components, ${size}x$size, one ray a pixel, $threads threads" POV-Ray
  row "Trace Time | time.trace" povray_trace isl_trace
  row "whole process" povray_trace_process isl_trace_process
  row "whole process, processor's seconds" povray_trace_cpu isl_trace_cpu
}

read_both() {
  for ((i = 0; i < runs; ++i)); do
    povray_run "$read_levels" 2
    note povray_parse "$(printed_time Parse)"
    note povray_read_process "$seconds"
    isl_run "$read_levels" 2
    note isl_read "$(isl_read_time)"
    note isl_read_compile "$(sum "$(isl_read_time)" "$(stat_of compile "$work/stats.json")")"
    note isl_read_process "$seconds"
    timed "$isl" check "$scene" -D "Levels=$read_levels"
    note isl_check_process "$seconds"
    command -v lua5.4 >/dev/null || continue
    for style in vectors numbers; do
      timed lua5.4 "$bench/lua_flake.lua" "$read_levels" "$style"
      note "lua_$style" "$(awk '{ print $3 }' "$work/out")"
      note "lua_${style}_process" "$seconds"
    done
  done
  heading "reading: $(stat_of fields "$work/stats.json") components made by a macro" POV-Ray
  row "Parse Time | time.parse + time.evaluate" povray_parse isl_read
  row "Parse Time | the same + time.compile" povray_parse isl_read_compile
  row "whole process, 2x2 pixels" povray_read_process isl_read_process
  row "whole process, 2x2 pixels | isl check" povray_read_process isl_check_process
  [ -e "$work/series.lua_vectors" ] || { echo "  no lua5.4: left out"; return; }
  heading "the same loop in Lua 5.4, making tables" Lua
  row "vectors as tables | parse + evaluate" lua_vectors isl_read
  row "coordinates as numbers | parse + evaluate" lua_numbers isl_read
  row "whole process, vectors | isl check" lua_vectors_process isl_check_process
  row "whole process, numbers | isl check" lua_numbers_process isl_check_process
}

# Scripts that make nothing: what loops and calls cost.
scripts_both() {
  heading "reading: Parse Time | time.parse + time.evaluate" POV-Ray
  local name
  for name in while fibonacci; do
    local scene=$bench/scenes/$name.pov
    for ((i = 0; i < runs; ++i)); do
      povray_run 0 2
      note "povray_$name" "$(printed_time Parse)"
      note "povray_${name}_process" "$seconds"
      isl_run 0 2
      note "isl_$name" "$(isl_read_time)"
      note "isl_${name}_process" "$seconds"
    done
    row "$name.pov" "povray_$name" "isl_$name"
    row "$name.pov, whole process" "povray_${name}_process" "isl_${name}_process"
  done
}

machine
povray --version 2>&1 | sed -n '/^POV-Ray/p'
echo "medians of $runs, least..greatest; ratio above 1: isl is faster"
compare_pictures
trace_both
read_both
scripts_both
