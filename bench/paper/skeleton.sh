#!/usr/bin/env bash
# What blending costs: the coral as an implicit surface against its own skeleton, in isl and in Embree.
#
#   bench/paper/skeleton.sh [--quick]
# shellcheck disable=SC2016  # backticks in single quotes are Markdown
set -u
# shellcheck source-path=SCRIPTDIR source=tables.sh
. "$(dirname -- "$0")/tables.sh"
# shellcheck source-path=SCRIPTDIR source=embree.sh
. "$(dirname -- "$0")/embree.sh"
common_options "$@"

size=$(or_quick 640x480 96x72) turns=$(or_quick 5 1) rounds=$(or_quick 3 1)
scene=gallery/coral_tree.isl
flags=(-D Ground=0)

# one SERIES OPTION…: processor seconds of the camera rays.
one() {
  local series=$1
  shift
  measure "$series" "$scene" "$size" "$rounds" hermite "${flags[@]}" "$@"
  note "$series" "$(measured "$series" hermite processor_seconds)"
}

has_embree=0
if embree_ready; then
  has_embree=1
  plain_solids "$root/scenes/$scene" "${flags[@]}" -s "$size" >"$work/solids"
fi
for ((i = 0; i < turns; ++i)); do
  one implicit
  one skeleton --skeleton
  one solids -D Skeleton=1
  if ((has_embree)); then
    read -r _ _ single packets share < <(embree "$work/solids" "${size%x*}" "${size#*x}" "$rounds")
    note embree "$single"
    note packets "$packets"
  fi
  for series in skeleton solids embree packets; do
    [ -e "$work/series.$series" ] || continue
    note "over_$series" "$(awk -v a="$(tail -n 1 "$work/series.implicit")" -v b="$(tail -n 1 "$work/series.$series")" \
      'BEGIN { print a / b }')"
  done
done

# line SERIES LABEL CLAIM
line() {
  row "$2" "$(printf %.4f "$(median "$1")")" "$(awk -v s="$(median "$1")" -v n="$((${size%x*} * ${size#*x}))" 'BEGIN { printf "%.0f", 1e9 * s / n }')" \
    "$([ "$1" = implicit ] && echo 1 || printf %.2f "$(median "over_$1")")" "$3"
}

head_row 'the coral' 'seconds' 'ns a ray' 'implicit over this' 'paper'
line implicit 'implicit, `hermite`' '28:30'
line skeleton '`--skeleton`: round cones' '9:36; 2.97 (target at most 2)'
line solids '`-D Skeleton=1`: a union of solid cones with flat ends' -
if ((has_embree)); then
  line embree 'Embree, round cones, single rays' -
  line packets 'Embree, round cones, packets of 16' -
fi
caption "Camera rays of $size, processor seconds on one thread, medians of $turns turns. The paper's are 320x240 with shading, adaptive."
if ((has_embree)); then
  "$isl" render "$root/scenes/$scene" "${flags[@]}" -s "$size" --skeleton --samples 1 --alpha -q -o "$work/skeleton.exr" || fail "no skeleton"
  printf 'Both drew the same: %s of the rays meet a solid in Embree, %s in isl.\n\n' "$share" \
    "$(layer "$work/skeleton.exr" A | awk '{ n += $1 > 0 } END { printf "%.6f", n / NR }')"
fi
