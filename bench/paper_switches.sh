#!/usr/bin/env bash
# What each optimisation of the published solver saves: `--solver paper:2,plain` with every switch off, each switch alone, and all
# together, on the coral of 31 branches and 512 needles at 320x240, adaptively sampled, beside the figures of the paper's
# Table 4.4 (A. Sherstyuk, 1999). Below, for scale, what else the same scene can be solved with.
#
#   bench/paper_switches.sh [-n RUNS] [-s WIDTHxHEIGHT] [-f SCENE]
#
# The runs take turns, on one thread. Ratios are of medians of `time.trace`; a gain above zero is time saved.
set -u
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname -- "$0")/common.sh"

runs=5 size=320x240 scene=$root/scenes/gallery/coral_tree.isl
while getopts n:s:f: option; do
  case $option in
    n) runs=$OPTARG ;;
    s) size=$OPTARG ;;
    f) scene=$OPTARG ;;
    *) exit 2 ;;
  esac
done
whole_number -n "$runs" 1

# Solver, and the paper's gain in per cent where it has one (a dash: not measured there).
rows=(
  'paper:2,plain 0.0'
  'paper:2,plain,on-demand 4.2'
  'paper:2,plain,reject 9.8'
  'paper:2,plain,pools 8.9'
  'paper:2,plain,reuse 1.4'
  'paper:2,plain,on-demand,reject,pools,reuse 17.7'
  'paper:2,plain,on-demand,reject -'
  'paper:2,plain,monotone -'
  'paper:2,plain,permanent -'
  'paper:2 -'
  'paper:2,eq10 -'
  'paper:8 -'
  'iso -'
  'hermite -'
)

for ((run = 0; run < runs; ++run)); do
  for row in "${rows[@]}"; do
    solver=${row% *}
    timed "$isl" render "$scene" -s "$size" -t 1 -q --solver "$solver" -o "$work/picture.ppm" --stats "$work/stats.json"
    note "trace.$solver" "$(stat_of trace "$work/stats.json")"
    note "fields.$solver" "$(stat_of field_evaluations "$work/stats.json")"
    note "shading.$solver" "$(stat_of shading_evaluations "$work/stats.json")"
  done
done

machine
printf '%s at %s, %s runs\n' "$(basename -- "$scene")" "$size" "$runs"
printf '%-46s %8s %14s %8s %8s %12s %12s\n' solver 'trace, s' least..greatest 'gain, %' 'paper, %' 'fields' 'in shading'
plain=$(median "trace.${rows[0]% *}")
for row in "${rows[@]}"; do
  solver=${row% *}
  seconds=$(median "trace.$solver")
  printf '%-46s %8.3f %14s %8.1f %8s %12.0f %12.0f\n' "$solver" "$seconds" "$(spread "trace.$solver")" \
    "$(awk -v a="$plain" -v b="$seconds" 'BEGIN { print 100 * (a - b) / a }')" "${row##* }" \
    "$(median "fields.$solver")" "$(median "shading.$solver")"
done
