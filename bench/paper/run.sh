#!/usr/bin/env bash
# The paper's tables and figures, measured again and written into the documentation: what a script of this folder prints stands in a page
# of docs/ between `<!-- table: NAME -->` and `<!-- end -->`, and pictures stand in docs/pictures/. Prose around them is
# written by hand.
#
#   bench/paper/run.sh [--quick] [NAME…]
#     --quick  small and short, to see that all runs: prints the tables and leaves the pages as they are
#     NAME     these tables only
set -u
# shellcheck source-path=SCRIPTDIR source=tables.sh
. "$(dirname -- "$0")/tables.sh"

if [ "${1:-}" = --quick ]; then quick=1; shift; fi
names=("$@")
((${#names[@]} > 0)) || names=(accuracy flakes scaling time_maps cross normals switches skeleton urchin crab clusters)

# page_of NAME: the page that has its place.
page_of() { grep -l -x -F -- "<!-- table: $1 -->" "$root"/docs/*.md || fail "no page has a place for $1"; }

# put NAME FILE: the file's lines in place of those between the markers.
put() {
  local page
  page=$(page_of "$1")
  awk -v begin="<!-- table: $1 -->" -v text="$2" '
    $0 == begin { print; while ((getline line < text) > 0) print line; skipping = 1; next }
    $0 == "<!-- end -->" { skipping = 0 }
    !skipping { print }' "$page" >"$work/page" && cp -- "$work/page" "$page"
}

machine | sed 's/^ *//' >"$work/machine.md"
for name in "${names[@]}"; do
  [ -x "$paper/$name.sh" ] || fail "no table $name"
  echo "$name…" >&2
  if ((quick)); then
    printf '\n## %s\n\n' "$name"
    "$paper/$name.sh" --quick -p "$work/pictures" || fail "$name failed"
  else
    "$paper/$name.sh" -p "$root/docs/pictures" >"$work/$name.md" || fail "$name failed"
    put "$name" "$work/$name.md"
  fi
done
((quick)) || put machine "$work/machine.md"
