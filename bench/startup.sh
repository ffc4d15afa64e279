#!/usr/bin/env bash
# How long `isl check` of a ten-line scene takes, the whole process, as an editor that checks on every change would see
# it. One run first, unmeasured, brings the files into memory.
#
#   bench/startup.sh [-n RUNS] [SCENE]
#     -n  how often it runs (20)
set -u
# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname -- "$0")/common.sh"

runs=20
while getopts n: option; do
  case $option in
    n) runs=$OPTARG ;;
    *) exit 2 ;;
  esac
done
shift $((OPTIND - 1))
whole_number -n "$runs" 1
scene=${1:-$bench/scenes/ten_lines.pov}

# row LABEL SERIES
row() {
  sort -g "$work/series.$2" | awk -v label="$1" -v median="$(median "$2")" '{ v[NR] = $1 * 1000 }
    END { printf "  %-28s %8.2f  %8.2f  %8.2f\n", label, median * 1000, v[1], v[NR] }'
}

timed "$isl" check "$scene"
for ((i = 0; i < runs; ++i)); do
  timed "$isl" check "$scene"
  note check "$seconds"
  timed "$isl" --version
  note version "$seconds"
  timed /bin/true
  note nothing "$seconds"
done

machine
printf '%s runs; milliseconds      %8s  %8s  %8s\n' "$runs" median least greatest
row "isl check $(basename -- "$scene")" check
row "isl --version" version
row "/bin/true (what bash adds)" nothing
