#!/usr/bin/env bash
# Figure 4 of the paper: what every pixel of the flake of 820 balls costs, with our solver and with LG-surfaces; how even
# the costs are, in numbers and in false colours.
#
#   bench/paper/time_maps.sh [--quick] [-p FOLDER]
set -u
# shellcheck source-path=SCRIPTDIR source=tables.sh
. "$(dirname -- "$0")/tables.sh"
common_options "$@"
need oiiotool openimageio-tools

size=$(or_quick 512 64) repeats=$(or_quick 7 1)
solvers=(hermite lg)

# Of each pixel the least of the repeats' times: what interrupts a ray only ever makes it longer.
for solver in "${solvers[@]}"; do
  for ((i = 0; i < repeats; ++i)); do
    timed "$isl" render "$root/scenes/paper/sphereflake.isl" -s "${size}x$size" --samples 1 --quality 0 -t 1 -q --solver "$solver" \
      --aov cost,depth -o "$work/cost.exr"
    layer "$work/cost.exr" cost.seconds >"$work/seconds.$i"
  done
  paste "$work"/seconds.* | awk '{ m = $1; for (i = 2; i <= NF; ++i) if ($i < m) m = $i; print 1e9 * m }' >"$work/time.$solver"
  layer "$work/cost.exr" cost.evaluations >"$work/evaluations.$solver"
  layer "$work/cost.exr" depth.Z >"$work/depth"
done

# evenness FILE HIT: of the values whose ray evaluated a field and met a surface (1) or none (0): how many, median, p99 / median,
# CV (standard deviation over mean).
evenness() {
  paste "$1" "$work/depth" "$work/evaluations.hermite" |
    awk -v hit="$2" '$3 > 0 && ($2 != "inf" && $2 < 1e9) == hit { print $1 }' | sort -g | awk '
      { v[NR] = $1; sum += $1; squares += $1 * $1 }
      END {
        if (NR == 0) { print "0 0 0 0"; exit }
        mean = sum / NR
        median = v[int((NR + 1) / 2)]
        last = int(0.99 * NR)
        print NR, median, v[last < 1 ? 1 : last] / median, sqrt(squares / NR - mean * mean) / mean
      }'
}

head_row '' 'of rays that' rays 'median' '99 % over median' 'CV'
for what in time evaluations; do
  for hit in 1 0; do
    for solver in "${solvers[@]}"; do
      read -r rays median p99 cv < <(evenness "$work/$what.$solver" "$hit")
      row "\`$solver\`, $([ $what = time ] && echo 'ns' || echo 'evaluations')" "$( ((hit)) && echo meet || echo 'pass close by')" \
        "$rays" "$(digits "$median")" "$(printf %.1f "$p99")" "$(printf %.2f "$cv")"
    done
  done
done
caption "820 balls, ${size}x$size, one ray a pixel, traced one by one; times are the least of $repeats. Close by: through a cell in" \
  'which a field has to be evaluated. CV is the standard deviation over the mean. The paper tells no numbers; its maps show' \
  'its own time as nearly flat and that of LG-surfaces rising at silhouettes.'

if [ -n "$pictures" ]; then
  for what in evaluations time; do
    for solver in "${solvers[@]}"; do
      if [ $what = time ]; then range=(100 25600); else range=(1 256); fi
      every "$size" 2 <"$work/$what.$solver" | false_colours $((size / 2)) "${range[@]}" "$work/map_${what}_$solver.ppm"
    done
    oiiotool "$work/map_${what}_hermite.ppm" "$work/map_${what}_lg.ppm" --mosaic:pad=4 2x1 -o "$work/map.ppm"
    keep "$work/map.ppm" "flake_$what"
  done
fi
