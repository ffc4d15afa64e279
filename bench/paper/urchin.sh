#!/usr/bin/env bash
# Figure 5 of the paper: spikes thinner than a pixel. How much of a picture they cover, by samples, against their area; and
# how many rays to the sea urchin each method gets wrong.
#
#   bench/paper/urchin.sh [--quick]
set -u
# shellcheck source-path=SCRIPTDIR source=tables.sh
. "$(dirname -- "$0")/tables.sh"
common_options "$@"
need oiiotool openimageio-tools

pixels=$(or_quick 64 16) size=$(or_quick 400x400 64x64) rounds=$(or_quick 3 1)
samples=(1 16 256 1024)
radii=(0.2 0.02 0.001) solvers=(hermite march:1px climb:1px sphere paper:2)
if ((quick)); then samples=(1 16) radii=(0.02); fi

# coverage SOLVER RADIUS SAMPLES: mean of alpha.
coverage() {
  timed "$isl" render "$paper/spikes.isl" -D "Radius=$2" -D "Pixels=$pixels" -s "${pixels}x$pixels" --samples "$3" --alpha \
    --quality 0 -q --solver "$1" -o "$work/spikes.exr"
  layer "$work/spikes.exr" A | awk '{ sum += $1 } END { printf "%.3g\n", sum / NR }'
}

head_row 'radius, pixels' solver 'area' "${samples[@]}" 'of the area'
for radius in "${radii[@]}"; do
  area=$(awk -v r="$radius" -v n="$pixels" 'BEGIN { printf "%.6g", 2 * r * sqrt(1 + 1 / (n * n)) }')
  for solver in "${solvers[@]}"; do
    cells=()
    for n in "${samples[@]}"; do cells+=("$(coverage "$solver" "$radius" "$n")"); done
    row "$radius" "\`$solver\`" "$(digits "$area")" "${cells[@]}" \
      "$(awk -v c="${cells[-1]}" -v a="$area" 'BEGIN { printf "%.1f %%", 100 * c / a }')"
  done
done
caption "Share of the picture that spikes cover, ${pixels}x$pixels pixels, by samples a pixel. A right method differs from the area by" \
  "chance only, by less with more samples: with ${samples[-1]} a share of 0.002 is told to within $(awk -v n="$((pixels * pixels * samples[-1]))" 'BEGIN { printf "%.1f %%", 100 * sqrt(0.998 / 0.002 / n) }') (one standard deviation, had the samples no order)."

settings=(hermite hermite:single lg interval inclusion sphere segment march:1px march:0.25px march:0.0625px climb:1px climb:0.25px climb:0.0625px paper:2 paper:8)
for thickness in 1 0.1; do
  measure "urchin$thickness" paper/sea_urchin.isl "$size" "$rounds" "$(IFS=,; echo "${settings[*]}")" -D "Thickness=$thickness"
done
head_row 'the sea urchin' 'time over ours' missed false 'worst, px' 'spikes a tenth: time' missed false 'worst, px'
for setting in "${settings[@]}"; do
  cells=()
  for thickness in 1 0.1; do
    for column in relative_time missed false_surfaces error_worst_px; do
      value=$(measured "urchin$thickness" "$setting" "$column")
      case $column in
        relative_time) value=$(printf %.2f "$value") ;;
        error_worst_px) value=$(digits "$value") ;;
      esac
      cells+=("$value")
    done
  done
  row "\`$setting\`" "${cells[@]}"
done
caption "$size camera rays, one thread, medians of $rounds rounds; a spike's tip is 0.008 thick, or 0.0008, and a pixel about" \
  "$(awk -v n="${size%x*}" 'BEGIN { printf "%.3f", 2 * 7.5 * 0.3443 / n }'). The paper: none missed."
