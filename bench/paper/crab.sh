#!/usr/bin/env bash
# Figure 7 of the paper: the crab of 641 elements of five kinds of field, the largest a hundred times the smallest. What every
# setting gets wrong on it, and how far apart sizes may be.
#
#   bench/paper/crab.sh [--quick] [-p FOLDER]
set -u
# shellcheck source-path=SCRIPTDIR source=tables.sh
. "$(dirname -- "$0")/tables.sh"
common_options "$@"
need oiiotool openimageio-tools

size=$(or_quick 450x300 90x60) rounds=$(or_quick 3 1)
settings=(hermite hermite:single exact iso paper:2 paper:3 paper:4 paper:8 paper:16 lg interval inclusion sphere segment march:1px march:0.25px
  march:0.0625px climb:1px climb:0.25px climb:0.0625px)
measure crab paper/hermite_crab.isl "$size" "$rounds" "$(IFS=,; echo "${settings[*]}")" -D Ground=0

head_row 'the crab' 'time over ours' 'evaluations a ray' 'median px' '99 % px' 'worst px' '> 1 px' missed false holes
for setting in "${settings[@]}"; do
  cells=("$(printf %.2f "$(measured crab "$setting" relative_time)")")
  for column in field_evaluations_per_ray error_median_px error_p99_px error_worst_px; do
    cells+=("$(digits "$(measured crab "$setting" "$column")")")
  done
  for column in beyond_pixel missed false_surfaces holes; do cells+=("$(measured crab "$setting" "$column")"); done
  row "\`$setting\`" "${cells[@]}"
done
caption "$size camera rays, one thread, medians of $rounds rounds. Without the ground, on which a ray that misses would end. The paper: every element is found."

few=(hermite lg paper:2 march:1px climb:1px)
ratios=(10 100 1e4 1e6)
head_row 'sizes 1 to' 10 100 '10⁴' '10⁶'
for ratio in "${ratios[@]}"; do
  measure "ratio$ratio" ../bench/paper/ratio.isl "$(or_quick 48x48 24x24)" 1 "$(IFS=,; echo "${few[*]}")" -D "Ratio=$ratio"
done
for setting in "${few[@]}"; do
  cells=()
  for ratio in "${ratios[@]}"; do
    cells+=("$(digits "$(measured "ratio$ratio" "$setting" error_worst_px)"), $(measured "ratio$ratio" "$setting" missed) missed")
  done
  row "\`$setting\`" "${cells[@]}"
done
cells=()
for ratio in "${ratios[@]}"; do
  cells+=("$(awk -F'[:,]' '/"(rays|proven)":/ { gsub(/[ "]/, "", $1); n[$1] = $2 } END { printf "%d of %d", n["proven"], n["rays"] }' \
    "$work/ratio$ratio.json")")
done
row 'reference proven on' "${cells[@]}"
caption "Worst error in pixels and surfaces missed, of two balls that touch, the small one filling the picture."

if [ -n "$pictures" ]; then
  width=${size%x*}
  for solver in paper:2 paper:8; do
    timed "$isl" render "$root/scenes/paper/hermite_crab.isl" -D Ground=0 -s "$size" --samples 1 --quality 0 -q --solver "$solver" --aov error \
      -o "$work/crab.exr"
    layer "$work/crab.exr" error.pixels | every "$width" 2 | false_colours $((width / 2)) 1e-4 100 "$work/crab_$solver.ppm"
  done
  oiiotool "$work/crab_paper:2.ppm" "$work/crab_paper:8.ppm" --mosaic:pad=4 2x1 -o "$work/crab.ppm"
  keep "$work/crab.ppm" crab_errors
fi
