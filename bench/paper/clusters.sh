#!/usr/bin/env bash
# The paper's section 4.3: clusters of overlapping fields kept for good or gathered for each ray, on simple and on complex scenes.
#
#   bench/paper/clusters.sh [--quick]
# shellcheck disable=SC2016  # backticks in single quotes are Markdown
set -u
# shellcheck source-path=SCRIPTDIR source=tables.sh
. "$(dirname -- "$0")/tables.sh"
common_options "$@"

size=$(or_quick 320x240 64x48) turns=$(or_quick 7 1)

# Scene, options, label.
scenes=(
  'paper/icicle.isl||the icicle'
  'paper/sphereflake.isl|-D Levels=1|a flake of 10'
  'paper/sphereflake.isl|-D Levels=4|a flake of 7,381'
  'gallery/coral_tree.isl|-D Ground=0|the coral'
  'paper/sea_urchin.isl||the sea urchin'
)

head_row scene fields '`permanent`, s' '`volatile`, s' 'volatile over permanent' 'the paper found best'
for i in "${!scenes[@]}"; do
  IFS='|' read -r scene options label <<<"${scenes[i]}"
  for ((turn = 0; turn < turns; ++turn)); do
    for clusters in permanent volatile; do
      # shellcheck disable=SC2086  # the options are words
      timed "$isl" render "$root/scenes/$scene" $options -s "$size" --samples 4 --quality 1 -t 1 -q \
        --solver "paper:2,plain,on-demand,reject,monotone,pools,$clusters" -o "$work/picture.ppm" --stats "$work/stats.json"
      note "$clusters.$i" "$(stat_of trace "$work/stats.json")"
    done
    note "ratio.$i" "$(awk -v a="$(tail -n 1 "$work/series.volatile.$i")" -v b="$(tail -n 1 "$work/series.permanent.$i")" \
      'BEGIN { print a / b }')"
  done
  fields=$(stat_of fields "$work/stats.json")
  row "$label" "$fields" "$(printf %.4f "$(median "permanent.$i")")" "$(printf %.4f "$(median "volatile.$i")")" \
    "$(printf %.2f "$(median "ratio.$i")")" "$( ((fields < 50)) && echo permanent || echo volatile)"
done
caption "$size, 4 samples a pixel, quick colours without shadows, one thread, medians of $turns turns, all other switches but \`reuse\` on."
