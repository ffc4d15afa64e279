#!/usr/bin/env bash
# The paper's claim that time grows slowly with the number of elements: flakes of 10 to 597,871 components, isl beside
# POV-Ray's blob and Embree's plain spheres, and the exponent of time over components of each.
#
#   bench/paper/scaling.sh [--quick]
set -u
# shellcheck source-path=SCRIPTDIR source=tables.sh
. "$(dirname -- "$0")/tables.sh"
# shellcheck source-path=SCRIPTDIR source=embree.sh
. "$(dirname -- "$0")/embree.sh"
common_options "$@"

size=$(or_quick 512 96) rounds=$(or_quick 5 1) runs=$(or_quick 3 1) levels=$(or_quick 6 2)
scene=$root/scenes/paper/sphereflake.isl

# keep_time SERIES COMPONENTS SECONDS: a point of the fit, except of the lone ball, whose time is that of the pixels.
keep_time() { printf '%s %s\n' "$2" "$3" >>"$work/time.$1"; }

# Whole pictures, with the shadows of three lights: bench/sizes.sh, whose fifth column after the components is `trace`.
"$bench/sizes.sh" -n "$runs" -s "$size" -l "$levels" -t 1 >"$work/sizes" || fail "sizes.sh failed"
awk '$1 ~ /^[0-9]+$/ && NF == 10 { print $1, $4 }' "$work/sizes" >"$work/time.pictures"

counts=()
mapfile -t counts < <(awk '{ print $1 }' "$work/time.pictures")
((${#counts[@]} == levels + 1)) || fail "sizes.sh printed something else than expected"

has_povray=0 has_embree=0
command -v povray >/dev/null && has_povray=1
embree_ready && has_embree=1

# povray_trace LEVEL: the processor's seconds that it tells of its tracing.
povray_trace() {
  timed povray "+I$bench/scenes/flake.pov" "Declare=Levels=$1" "+W$size" "+H$size" -A +WT1 -D -V -P +FN "+O$work/povray.png"
  awk '/Trace Time:/ { tracing = 1 }
    tracing && match($0, /[0-9.]+ CPU-seconds/) { print substr($0, RSTART, RLENGTH - 12); found = 1; exit }
    END { exit !found }' "$work/out" || fail "POV-Ray told no CPU-seconds of its tracing"
}

for ((level = 0; level <= levels; ++level)); do
  measure "rays$level" paper/sphereflake.isl "${size}x$size" "$rounds" hermite,hermite:single -D "Levels=$level"
  keep_time rays "${counts[level]}" "$(measured "rays$level" hermite processor_seconds)"
  keep_time single "${counts[level]}" "$(measured "rays$level" hermite:single processor_seconds)"
  if ((has_povray)); then
    for ((i = 0; i < runs; ++i)); do note "povray.$level" "$(povray_trace "$level")"; done
    keep_time povray "${counts[level]}" "$(median "povray.$level")"
  fi
  if ((has_embree)); then
    plain_solids "$scene" -D "Levels=$level" -s "${size}x$size" >"$work/solids"
    read -r _ _ single _ < <(embree "$work/solids" "$size" "$size" "$rounds")
    keep_time embree "${counts[level]}" "$single"
  fi
done

# times SERIES LABEL CLAIM: a row.
times() {
  local cells
  mapfile -t cells < <(awk '{ printf "%.4f\n", $2 }' "$work/time.$1")
  row "$2" "${cells[@]}" "$(awk '$1 > 1' "$work/time.$1" | slope)" "$3"
}

head_row 'components' "${counts[@]}" exponent 'told elsewhere'
times rays 'camera rays, eight at once' -
times single 'camera rays, one by one' 'target 0.07'
times pictures 'whole pictures, with shadows' 'paper 0.34'
if ((has_povray)); then times povray "POV-Ray's blob, whole pictures" 0.11; fi
if ((has_embree)); then times embree "Embree's plain spheres, camera rays" 0.06; fi
caption "Seconds on one thread, ${size}x$size, one ray a pixel, medians of $rounds (camera rays) and $runs (pictures); exponents are" \
  "least-squares fits from 10 components up. Making the search structure is in none of them. All is processor time but isl's whole" \
  'pictures, which are by the wall clock.'
