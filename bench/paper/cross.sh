#!/usr/bin/env bash
# The paper's section 3: two crossed segments solved by K interpolants a field, from the front and from the side, and by
# how much every doubling of K lowers the error.
#
#   bench/paper/cross.sh [--quick] [-p FOLDER]
set -u
# shellcheck source-path=SCRIPTDIR source=tables.sh
. "$(dirname -- "$0")/tables.sh"
common_options "$@"
need oiiotool openimageio-tools

size=$(or_quick 320 64) counts=(2 4 8 16 32 64 128)
scene=$root/scenes/paper/cross.isl

# Kernel, convolved or not, balls an arm; and what is told of it.
fields=('quartic 0 9' 'gaussian 0 9' 'cauchy 1 0' 'quartic 1 0' 'cauchy 0 0' 'gaussian 0 0')
shown='cauchy 1 0'
declare -A label=(['quartic 0 9']='arms of balls, quartic' ['gaussian 0 9']='arms of balls, Gaussian'
  ['cauchy 1 0']='convolved Cauchy' ['quartic 1 0']='convolved quartic'
  ['cauchy 0 0']='Cauchy of the distance' ['gaussian 0 0']='Gaussian of the distance')

# errors K SIDE KERNEL CONVOLVED BALLS: "worst rms wrong" in scene units; the layer stays in $work/errors.
errors() {
  timed "$isl" render "$scene" -s "${size}x$size" --samples 1 --quality 0 -t 2 -q -D "Side=$2" -D "Kernel=$3" \
    -D "Convolve=$4" -D "Balls=$5" --solver "paper:$1" --aov error -o "$work/cross.exr"
  layer "$work/cross.exr" error.units >"$work/errors"
  awk '$1 == "inf" { ++wrong; next } $1 > 0 { ++n; sum += $1 * $1; if ($1 > worst) worst = $1 }
    END { print worst + 0, n ? sqrt(sum / n) : 0, wrong + 0 }' "$work/errors"
}

for field in "${fields[@]}"; do
  for side in 0 1; do
    for k in "${counts[@]}"; do
      # shellcheck disable=SC2086  # three words
      read -r worst rms wrong < <(errors "$k" "$side" $field)
      printf '%s %s %s %s %s %s\n' "${field// /,}" "$side" "$k" "$worst" "$rms" "$wrong" >>"$work/all"
      if [ "$field" = "$shown" ] && ((k <= 4)); then
        every "$size" 2 <"$work/errors" | false_colours $((size / 2)) 1e-5 1 "$work/error_${side}_$k.ppm"
      fi
    done
  done
done

# of FIELD SIDE K COLUMN
of() { awk -v f="${1// /,}" -v s="$2" -v k="$3" -v c="$4" '$1 == f && $2 == s && $3 == k { print $c }' "$work/all"; }

head_row "${label[$shown]}, K" "${counts[@]}"
for side in 0 1; do
  view=front
  ((side)) && view=side
  for what in 4:worst 5:rms 6:wrong; do
    cells=()
    for k in "${counts[@]}"; do cells+=("$(digits "$(of "$shown" "$side" "$k" "${what%:*}")")"); done
    row "$view, ${what#*:}" "${cells[@]}"
  done
done
caption "Errors along the ray in scene units (the segments have radius 0.3), against \`exact\`, ${size}x$size rays; wrong: surfaces missed or invented."

head_row 'field' view '2→4' '4→8' '8→16' '16→32' '32→64' '64→128' 'slope of rms' 'slope of worst'
for field in "${fields[@]}"; do
  for side in 0 1; do
    view=front
    ((side)) && view=side
    cells=()
    for ((i = 1; i < ${#counts[@]}; ++i)); do
      cells+=("$(awk -v a="$(of "$field" "$side" "${counts[i - 1]}" 5)" -v b="$(of "$field" "$side" "${counts[i]}" 5)" \
        'BEGIN { printf "%.1f", a / b }')")
    done
    for column in 5 4; do
      cells+=("$(for k in 16 32 64 128; do printf '%s %s\n' "$k" "$(of "$field" "$side" "$k" "$column")"; done | slope)")
    done
    row "${label[$field]}" "$view" "${cells[@]}"
  done
done
row '**paper**' both 16 16 16 16 16 16 -4 -4
caption "By what each doubling of K divides the rms error; slopes are of log error over log K, fitted from K = 16 to 128."

if [ -n "$pictures" ]; then
  oiiotool "$work/error_0_2.ppm" "$work/error_0_4.ppm" "$work/error_1_2.ppm" "$work/error_1_4.ppm" --mosaic:pad=4 4x1 \
    -o "$work/cross_errors.ppm"
  keep "$work/cross_errors.ppm" cross_errors
fi
