#!/usr/bin/env bash
# Every scene that POV-Ray is distributed with, read by `isl check`: accepted, refused because of something that isl does not
# have (what), or failed otherwise (why). Needs Debian's packages povray-examples and povray-includes; nothing of them is copied.
#
#   bench/distribution.sh [-e FOLDER] [-i FOLDER] [-t FILE] [-l] [-v]
#     -e  the scenes (/usr/share/doc/povray/examples)
#     -i  POV-Ray's include files (/usr/share/povray-3.7/include)
#     -t  a table of tabs, "path lines tier …" with a heading, by which the counts are split
#     -l  with --lenient: whether each evaluates to the end
#     -v  name the scenes that are refused
set -u
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname -- "$0")/common.sh"

examples=/usr/share/doc/povray/examples includes=/usr/share/povray-3.7/include tiers='' options=() verbose=false
while getopts e:i:t:lv option; do
  case $option in
    e) examples=$OPTARG ;;
    i) includes=$OPTARG ;;
    t) tiers=$(realpath -- "$OPTARG") ;;
    l) options=(--lenient) ;;
    v) verbose=true ;;
    *) exit 2 ;;
  esac
done
[ -d "$examples" ] || fail "no scenes in $examples (Debian's package povray-examples)"
[ -d "$includes" ] || fail "no include files in $includes (Debian's package povray-includes)"

# What scenes write (pages that list their pictures, meshes) goes here and nowhere else.
mkdir "$work/written"
cd "$work/written" || exit 1

# verdict SCENE: "accepted", "refused WORD" or "failed MESSAGE".
# A scene with a settings file of its name is an animation: its first frame.
verdict() {
  local frame=()
  [ -f "${1%.pov}.ini" ] && frame=(--frame 1)
  if timeout 120 "$isl" check "$1" -I "$includes" --allow-write . "${frame[@]}" "${options[@]}" >"$work/out" 2>"$work/err"; then
    echo accepted
    return
  fi
  awk '/ error: / {
         sub(/^.* error: /, "")
         if (/is not supported/) { if (!word) { word = $0; sub(/ is not supported.*/, "", word) } }
         else if (!message) message = $0
       }
       END { print message ? "failed " message : word ? "refused " word : "failed without a message" }' "$work/err"
}

# tier SCENE: from the table; "-" where there is none.
tier() { [ -n "$tiers" ] && awk -F '\t' -v path="$1" '$1 == path { print $3; found = 1 } END { if (!found) print "-" }' "$tiers" || echo -; }

while IFS= read -r scene; do
  printf '%s\t%s\t%s\n' "$(tier "$scene")" "$scene" "$(verdict "$examples/$scene")"
done < <(cd "$examples" && find . -name '*.pov' | sed 's|^\./||' | sort) >"$work/verdicts"

awk -F '\t' '
  { split($3, word, " "); count[$1, word[1]]++; total[word[1]]++; seen[$1]; n++ }
  END {
    printf "%-6s %9s %9s %9s\n", "tier", "accepted", "refused", "failed"
    for (t in seen) printf "%-6s %9d %9d %9d\n", t, count[t, "accepted"], count[t, "refused"], count[t, "failed"] | "sort"
    close("sort")
    printf "%-6s %9d %9d %9d   of %d\n", "all", total["accepted"], total["refused"], total["failed"], n
  }' "$work/verdicts"
echo
echo "refused because of"
awk -F '\t' '$3 ~ /^refused/ { sub(/^refused /, "", $3); count[$3]++ } END { for (w in count) printf "%5d  %s\n", count[w], w }' \
  "$work/verdicts" | sort -k1,1nr -k2
$verbose && awk -F '\t' '$3 ~ /^refused/ { print "  " $2 ": " $3 }' "$work/verdicts"
echo
echo "failed otherwise"
awk -F '\t' '$3 ~ /^failed/ { sub(/^failed /, "", $3); print "  " $1, $2 ": " $3 }' "$work/verdicts"
