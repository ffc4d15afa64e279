#!/usr/bin/env bash
# What grids cost where thin things lie among large ones that overlap: scenes/overlaps.isl, a random blob of 100
# components for each case, and scenes/hair.isl, 50,000 threads on a body.
#
#   bench/overlaps.sh [-n CASES] [-f FIRST] [-j THREADS_OF_HAIR] [-t THREADS]
#     -n  random blobs (1000); 0 for none
#     -f  the first of them (0)
#     -j  threads of hair (50000); 0 for none
#     -t  threads (2)
set -u
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname -- "$0")/common.sh"

cases=1000 first=0 hair=50000
while getopts n:f:j:t: option; do
  case $option in
    n) cases=$OPTARG ;;
    f) first=$OPTARG ;;
    j) hair=$OPTARG ;;
    t) threads=$OPTARG ;;
    *) exit 2 ;;
  esac
done
whole_number -n "$cases" 0
whole_number -f "$first" 0
whole_number -j "$hair" 0
whole_number -t "$threads" 1

# Only compiling counts, so the pictures are tiny.
for ((i = first; i < first + cases; ++i)); do
  timed "$isl" render "$bench/scenes/overlaps.isl" -D "Case=$i" -s 4x3 --samples 1 -t "$threads" -q --stats "$work/stats.json" \
    -o "$work/blob.png"
  compile=$(stat_of compile "$work/stats.json") && bytes=$(stat_of grid_bytes "$work/stats.json") || exit 1
  printf '%s %s %s %s\n' "$i" "$compile" "$bytes" "$cpu" >>"$work/cases"
done
if ((cases > 0)); then
  machine
  printf '%s random blobs of 100 components; wanted of each: at most 1 s to compile and 100 MB of grid\n\n' "$cases"
  awk -v file="$work/cases" '
    function median(column,   command, line, n, v) {
      command = "sort -g -k" column "," column " " file
      while ((command | getline line) > 0) { split(line, v, " "); all[++n] = v[column] }
      close(command)
      return all[int((n + 1) / 2)]
    }
    { if ($2 > slowest) { slowest = $2; slow_case = $1 } if ($3 > largest) { largest = $3; large_case = $1 }
      if ($4 > dearest) { dearest = $4; dear_case = $1 }
      over += $2 > 1 || $3 > 100e6 }
    END {
      printf "%-14s %10s %10s\n", "", "median", "most"
      printf "%-14s %10.4f %10.4f   case %d\n", "compile, s", median(2), slowest, slow_case
      printf "%-14s %10.4f %10.4f   case %d\n", "processor, s", median(4), dearest, dear_case
      printf "%-14s %10.1f %10.1f   case %d\n", "grid, MB", median(3) / 1e6, largest / 1e6, large_case
      printf "beyond the limits: %d\n\n", over
    }' "$work/cases"
fi

if ((hair > 0)); then
  timed "$isl" render "$bench/scenes/hair.isl" -D "Threads=$hair" -s 800x600 --samples 1 -t "$threads" -q --stats "$work/stats.json" \
    -o "$work/hair.png"
  stats=$work/stats.json
  printf '%s threads of hair on a body, 800x600, one ray a pixel, %s threads; wanted of 50,000: 60 s and 1 GB\n\n' "$hair" "$threads"
  awk -v compile="$(stat_of compile "$stats")" -v trace="$(stat_of trace "$stats")" -v process="$seconds" \
    -v grid="$(stat_of grid_bytes "$stats")" -v peak="$(stat_of peak_bytes "$stats")" 'BEGIN {
      printf "compile %.2f s, trace %.2f s, whole process %.2f s, grid %.1f MB, peak %.1f MB\n", compile, trace, process,
        grid / 1e6, peak / 1e6 }'
fi
