#!/usr/bin/env bash
# Table 5 and Figure 3 of the paper: flakes of 1 to 7,381 components, one method after the other, as ratios to ours of
# processor time, with evaluations of fields and errors beside them.
#
#   bench/paper/flakes.sh [--quick]
# shellcheck disable=SC2016  # backticks in single quotes are Markdown
set -u
# shellcheck source-path=SCRIPTDIR source=tables.sh
. "$(dirname -- "$0")/tables.sh"
common_options "$@"

size=$(or_quick 512x512 96x96) rounds=$(or_quick 5 1) levels=$(or_quick 4 1) super_rounds=$(or_quick 5 1)
scene=paper/sphereflake.isl

# From the step that a first try would take to one that even the smallest balls are thicker than.
steps=(4px 1px 0.25px 0.0625px)
rivals=(lg)
if has_solver lg:octree; then rivals+=(lg:octree); fi
rivals+=(interval inclusion sphere segment)
for step in "${steps[@]}"; do rivals+=("march:$step"); done
for step in "${steps[@]}"; do rivals+=("climb:$step"); done
all=(hermite hermite:single "${rivals[@]}" paper:2 paper:8)

for ((level = 0; level <= levels; ++level)); do
  measure "flake$level" "$scene" "$size" "$rounds" "$(IFS=,; echo "${all[*]}")" -D "Levels=$level"
done

# wrong LEVEL SETTING: how many rays missed a surface or found a false one.
wrong() { awk -v a="$(measured "flake$1" "$2" missed)" -v b="$(measured "flake$1" "$2" false_surfaces)" 'BEGIN { print a + b }'; }

# errors LEVEL SETTING: "12" for the worst in pixels, "12, 3 wrong" where surfaces were missed or invented.
errors() {
  local count
  count=$(wrong "$1" "$2")
  printf '%s%s' "$(digits "$(measured "flake$1" "$2" error_worst_px)")" "$( ((count > 0)) && printf ', %s wrong' "$count")"
}
time_of() { printf '%.2f' "$(measured "flake$1" "$2" relative_time)"; }
evaluations() { digits "$(measured "flake$1" "$2" field_evaluations_per_ray)"; }

# table WHAT: a row a setting, a column a flake; WHAT LEVEL SETTING prints a cell.
table() {
  local setting cells level
  for setting in "${all[@]}"; do
    cells=("\`$setting\`")
    for ((level = 0; level <= levels; ++level)); do cells+=("$("$1" "$level" "$setting")"); done
    row "${cells[@]}"
  done
}

# longest_sound METHOD LEVEL: the longest of its steps at which no ray went wrong, or nothing.
longest_sound() {
  local step
  for step in "${steps[@]}"; do
    if (($(wrong "$2" "$1:$step") == 0)); then echo "$1:$step"; return; fi
  done
}

# sound_ratios METHOD: a row's cells, at the longest sound step of each flake.
sound_ratios() {
  local level found
  for ((level = 0; level <= levels; ++level)); do
    found=$(longest_sound "$1" "$level")
    if [ -n "$found" ]; then printf '%s (%s)\n' "$(time_of "$level" "$found")" "${found#*:}"; else echo 'none was'; fi
  done
}

counts=(1 10 91 820 7381)
columns=("${counts[@]:0:levels+1}")

head_row 'processor time over ours' "${columns[@]}"
table time_of
mapfile -t cells < <(sound_ratios march)
row '`march`, the longest step that gets no ray wrong' "${cells[@]}"
mapfile -t cells < <(sound_ratios climb)
row '`climb`, likewise' "${cells[@]}"
paper_lg=(1.24 - - - 3.04) paper_climb=(- - - - 1.75)
row '**paper:** LG over its own' "${paper_lg[@]:0:levels+1}"
row '**paper:** climbing over its own' "${paper_climb[@]:0:levels+1}"
caption "$size, one ray a pixel, camera rays only, one thread, medians of $rounds rounds. \`hermite\` is ours and the default."

head_row 'evaluations of fields a ray' "${columns[@]}"
table evaluations
echo
head_row 'worst error, pixels along the ray' "${columns[@]}"
table errors
caption "Wrong: rays that missed a surface or found one where there is none, of $((${size%x*} * ${size%x*}))."

# ---- 16 samples a pixel ----------------------------------------------------------------------------------------------
for ((level = 0; level <= levels; ++level)); do
  for ((i = 0; i < super_rounds; ++i)); do
    for solver in hermite lg; do
      timed "$isl" render "$root/scenes/$scene" -D "Levels=$level" -s "$size" --samples 16 --quality 1 -t 1 -q --solver "$solver" \
        --stats "$work/stats.json" -o "$work/flake.ppm"
      note "$solver.$level" "$(stat_of trace "$work/stats.json")"
    done
    note "ratio.$level" "$(awk -v a="$(tail -n 1 "$work/series.lg.$level")" -v b="$(tail -n 1 "$work/series.hermite.$level")" \
      'BEGIN { print a / b }')"
  done
done
head_row '16 samples a pixel' "${columns[@]}"
for what in hermite lg ratio; do
  cells=()
  for ((level = 0; level <= levels; ++level)); do
    if [ $what = ratio ]; then cells+=("$(printf %.2f "$(median "ratio.$level")")")
    else cells+=("$(printf '%.2f s' "$(median "$what.$level")")"); fi
  done
  if [ $what = ratio ]; then row '`lg` over ours' "${cells[@]}"; else row "\`$what\`" "${cells[@]}"; fi
done
paper_ours=('46 s' '3:23' '7:31' '13:53' '31:30') paper_lg=('57 s' - - - '95:52')
row '**paper:** its own, 90 MHz' "${paper_ours[@]:0:levels+1}"
row '**paper:** LG, 90 MHz' "${paper_lg[@]:0:levels+1}"
caption "$size, 16 samples in every pixel, quick colours without shadows, one thread, medians of $super_rounds turns. The paper's" \
  "are adaptive, at most 16."
