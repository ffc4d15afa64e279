#!/usr/bin/env bash
# What each optimisation of the published solver saves: `--solver paper:2,plain` with every switch off, each switch alone, and all
# together, on the coral of 31 branches and 512 needles at 320x240, adaptively sampled, beside the figures of the paper's
# Table 4.4 (A. Sherstyuk, 1999). Below, for scale, what else the same scene can be solved with.
#
#   bench/paper/switches.sh [--quick] [-n RUNS] [-s WIDTHxHEIGHT] [-f SCENE]
#
# The runs take turns, on one thread. Times are the processor's for the whole program, less those for a picture of one pixel; a gain is one
# less the median of the ratios to the first row in the same turn.
set -u
# shellcheck source-path=SCRIPTDIR source=tables.sh
. "$(dirname -- "$0")/tables.sh"

runs=5 size=320x240 scene=$root/scenes/gallery/coral_tree.isl
while (($# > 0)); do
  case $1 in
    --quick) runs=1 size=64x48 ;;
    -p) shift ;;  # no pictures
    -n) runs=${2:-} && shift ;;
    -s) size=${2:-} && shift ;;
    -f) scene=${2:-} && shift ;;
    *) fail "unknown option $1" ;;
  esac
  shift
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
  timed "$isl" render "$scene" -s 1x1 -t 1 -q -o "$work/picture.ppm"
  start=$cpu
  for row in "${rows[@]}"; do
    solver=${row% *}
    timed "$isl" render "$scene" -s "$size" -t 1 -q --solver "$solver" -o "$work/picture.ppm" --stats "$work/stats.json"
    cpu=$(awk -v a="$cpu" -v b="$start" 'BEGIN { print a - b }')
    if [ "$row" = "${rows[0]}" ]; then plain=$cpu; fi
    note "cpu.$solver" "$cpu"
    note "gain.$solver" "$(awk -v a="$plain" -v b="$cpu" 'BEGIN { printf "%.4f", 100 * (a - b) / a }')"
    note "fields.$solver" "$(stat_of field_evaluations "$work/stats.json")"
    note "shading.$solver" "$(stat_of shading_evaluations "$work/stats.json")"
  done
done

head_row solver seconds 'time saved' 'least..greatest' paper 'evaluations' 'in shading'
for row in "${rows[@]}"; do
  solver=${row% *} claim=${row##* }
  row "\`$solver\`" "$(printf %.3f "$(median "cpu.$solver")")" "$(printf '%.1f %%' "$(median "gain.$solver")")" \
    "$(sort -g "$work/series.gain.$solver" | awk '{ v[NR] = $1 } END { printf "%.1f..%.1f", v[1], v[NR] }')" \
    "$([ "$claim" = - ] && echo - || echo "$claim %")" \
    "$(printf %.0f "$(median "fields.$solver")")" "$(printf %.0f "$(median "shading.$solver")")"
done
caption "$(basename -- "$scene") at $size, adaptively sampled, one thread, medians of $runs turns. Evaluations are those of single fields by" \
  'the solver; those for normals and textures are told apart.'
