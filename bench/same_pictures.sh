#!/usr/bin/env bash
# Does isl draw what POV-Ray 3.7 draws? POV-Ray's plain blob scenes, as Debian's povray-examples has them, and the twenty of
# scenes/blobs.pov, both at 320x240 with one ray a pixel, compared in linear light: at most 0.5 % of the pixels of a picture may
# differ by more than 2/255 in a channel. Those are the ones on silhouettes and shadow edges.
#
#   bench/same_pictures.sh [-k FOLDER]
#     -k  keep the pictures there
#
# Needs povray, povray-includes, povray-examples and openimageio-tools.
set -u
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname -- "$0")/common.sh"

keep=
while getopts k: option; do
  case $option in
    k) keep=$OPTARG ;;
    *) exit 2 ;;
  esac
done
for tool in povray oiiotool idiff; do
  command -v "$tool" >/dev/null || fail "$tool is not installed"
done
examples=/usr/share/doc/povray/examples
includes=/usr/share/povray-3.7/include
[ -r "$examples/objects/blob.pov" ] || fail "no scenes in $examples (Debian's package povray-examples)"

worst=0
printf '%-28s %10s %10s\n' scene 'differ, %' 'mean error'

# compare NAME SCENE [CASE]
compare() {
  local name=$1 scene=$2 ours=() theirs=() share mean
  if [ $# -gt 2 ]; then
    ours=(-D "Case=$3")
    theirs=("Declare=Case=$3")
  fi
  timed povray "+I$scene" "+L$includes" "${theirs[@]}" +W320 +H240 -A -D -V -P +FN16 "+O$work/povray.png"
  timed "$isl" render "$scene" -I "$includes" "${ours[@]}" -s 320x240 --samples 1 -q -o "$work/unclipped.exr"
  # What is brighter than white is white in POV-Ray's file.
  timed oiiotool "$work/unclipped.exr" --ch R,G,B --clamp:min=0:max=1 -o "$work/isl.exr"
  oiiotool "$work/povray.png" --ch R,G,B -d float --colorconvert sRGB linear -o "$work/povray.exr" >/dev/null ||
    fail "oiiotool cannot read POV-Ray's picture of $name"
  # The share of pixels beyond the limit, and the mean error, from idiff's report.
  idiff -fail 0.00784314 -abs "$work/povray.exr" "$work/isl.exr" -o "$work/difference.exr" \
    >"$work/report" 2>&1
  share=$(awk '/pixels \(.*%\) over 0.0078/ { sub(/^.*\(/, ""); sub(/%.*$/, ""); print; exit }' "$work/report")
  mean=$(awk '/Mean error/ { print $4; exit }' "$work/report")
  printf '%-28s %10s %10s\n' "$name" "${share:-0}" "${mean:-0}"
  worst=$(awk -v a="$worst" -v b="${share:-0}" 'BEGIN { print (a > b ? a : b) }')
  if [ -n "$keep" ]; then
    mkdir -p -- "$keep" || exit 1
    cp -- "$work/povray.png" "$keep/$name-povray.png"
    oiiotool "$work/isl.exr" --colorconvert linear sRGB -o "$keep/$name-isl.png"
  fi
}

for scene in objects/blob objects/blob1a objects/blob1b objects/blob1c language/bounding; do
  compare "$(basename "$scene")" "$examples/$scene.pov"
done
for case in {1..20}; do compare "blobs-$case" "$bench/scenes/blobs.pov" "$case"; done

printf 'worst: %s %% (at most 0.5 is wanted)\n' "$worst"
awk -v worst="$worst" 'BEGIN { exit !(worst <= 0.5) }'
