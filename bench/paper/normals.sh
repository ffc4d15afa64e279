#!/usr/bin/env bash
# The paper's equation 10, which adds the fields' unit normals weighted by their values: how far these normals are from those of
# the field, at the same hits.
#
#   bench/paper/normals.sh [--quick]
set -u
# shellcheck source-path=SCRIPTDIR source=tables.sh
. "$(dirname -- "$0")/tables.sh"
common_options "$@"
need oiiotool openimageio-tools

size=$(or_quick 320x240 64x48)

# normals SCENE_AND_OPTIONS SWITCHES FILE: "x y z", a ray a line.
normals() {
  local axis
  # shellcheck disable=SC2086  # the options are words
  timed "$isl" render $1 -s "$size" --samples 1 --quality 0 -q --solver "paper:8$2" --aov normal -o "$work/normals.exr"
  for axis in X Y Z; do layer "$work/normals.exr" "normal.$axis" >"$work/normal.$axis"; done
  paste "$work/normal.X" "$work/normal.Y" "$work/normal.Z" >"$3"
}

head_row scene rays 'median, degrees' '99 %' worst 'more than 5°'
cd "$root/scenes" || exit 1
for scene in paper/cross.isl paper/sphereflake.isl 'gallery/coral_tree.isl -D Ground=0' 'paper/hermite_crab.isl -D Ground=0'; do
  normals "$scene" "" "$work/true"
  normals "$scene" ",eq10" "$work/eq10"
  name=${scene%.isl*} name=${name##*/}
  # The angle by half of it, whose sine is half the distance of unit vectors: right for small angles too.
  paste "$work/true" "$work/eq10" | awk '
    function asin(x) { return atan2(x, sqrt(x < 1 ? 1 - x * x : 0)) }
    $1 != 0 || $2 != 0 || $3 != 0 {
      d = sqrt(($1 - $4) ^ 2 + ($2 - $5) ^ 2 + ($3 - $6) ^ 2) / 2
      print 2 * asin(d > 1 ? 1 : d) * 45 / atan2(1, 1)
    }' | sort -g | awk -v name="$name" '
    { v[NR] = $1; far += $1 > 5 }
    END { printf "| %s | %d | %.2f | %.1f | %.0f | %.1f %% |\n", name, NR, v[int((NR + 1) / 2)], v[int(0.99 * NR)], v[NR], 100 * far / NR }'
done
caption "Angles between the normals of \`paper:8,eq10\` and of \`paper:8\`, ${size}"
