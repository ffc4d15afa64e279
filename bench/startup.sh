#!/usr/bin/env bash
# What it costs to start: processor time, wall-clock time and peak memory of whole processes that do next to nothing. A scene of
# ten lines is rendered at 4x3 pixels by isl as PNG and as EXR and by POV-Ray as PNG, and checked, as an editor would on every
# change. Besides, how long isl takes to write a large picture. The programs run in turn; one run of each, unmeasured, brings the
# files into memory.
#
#   bench/startup.sh [-n RUNS] [SCENE]
#     -n  how often each runs (20)
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

programs=(png exr povray check version nothing)
declare -A label=(
  [png]="isl render, 4x3 as PNG" [exr]="isl render, 4x3 as EXR" [povray]="POV-Ray, 4x3 as PNG"
  [check]="isl check" [version]="isl --version" [nothing]="/bin/true (what bash adds)"
)
if ! command -v povray >/dev/null; then
  programs=(png exr check version nothing)
  echo "without POV-Ray: it is not installed"
fi

# start PROGRAM WRAPPER…: runs one of them through the wrapper.
start() {
  local program=$1
  shift
  case $program in
    png | exr) "$@" "$isl" render "$scene" -s 4x3 -q -o "$work/picture.$program" ;;
    povray) "$@" povray "+I$scene" +W4 +H3 -A -D -GA "+O$work/povray.png" ;;
    check) "$@" "$isl" check "$scene" ;;
    version) "$@" "$isl" --version ;;
    nothing) "$@" /bin/true ;;
  esac
}

# Kilobytes, by a run of its own: the tool that tells takes time itself.
note_memory() {
  [ -x /usr/bin/time ] || return 0
  start "$1" /usr/bin/time -f %M -o "$work/memory" >/dev/null 2>&1 || fail "${label[$1]} failed"
  note "memory.$1" "$(tail -n 1 "$work/memory")"
}

# row PROGRAM
row() {
  local ratio=- memory=-
  [ ! -f "$work/series.cpu.povray" ] || ratio=$(awk -v a="$(median "cpu.$1")" -v b="$(median cpu.povray)" 'BEGIN { printf "%.2f", a / b }')
  [ ! -f "$work/series.memory.$1" ] || memory=$(awk -v kb="$(median "memory.$1")" 'BEGIN { printf "%.1f", kb * 1.024e-3 }')
  awk -v label="${label[$1]}" -v cpu="$(median "cpu.$1")" -v spread="$(spread "cpu.$1")" -v wall="$(median "wall.$1")" \
    -v ratio="$ratio" -v memory="$memory" \
    'BEGIN { printf "  %-27s %6.1f  %13s %9s %9.1f %9s\n", label, cpu * 1e3, spread, ratio, wall * 1e3, memory }'
}

# note_write SERIES FORMAT OPTION…: how long the large picture takes to be written, from the run's own statistics, and its size.
note_write() {
  local series=$1 file=$work/flake.$2
  timed "$isl" render "$bench/scenes/flake.pov" -D Levels=4 -s 1024x1024 --samples 1 -t "$threads" -q "${@:3}" \
    -o "$file" --stats "$work/stats.json"
  note "write.$series" "$(stat_of write "$work/stats.json")"
  note "size.$series" "$(stat -c %s "$file")"
}

# write_row SERIES LABEL
write_row() {
  awk -v label="$2" -v write="$(median "write.$1")" -v spread="$(spread "write.$1")" -v size="$(median "size.$1")" \
    'BEGIN { printf "  %-27s %6.1f  %13s %9.2f\n", label, write * 1e3, spread, size * 1e-6 }'
}

for program in "${programs[@]}"; do start "$program" timed; done
for ((i = 0; i < runs; ++i)); do
  for program in "${programs[@]}"; do
    start "$program" timed
    note "cpu.$program" "$cpu"
    note "wall.$program" "$seconds"
    note_memory "$program"
  done
done

machine
printf 'medians of %-3s                processor ms, spread in s   ratio   wall ms   peak MB\n' "$runs"
for program in "${programs[@]}"; do row "$program"; done

for ((i = 0; i < (runs + 3) / 4; ++i)); do
  note_write png16 png
  note_write png8 png --bits 8
  note_write exr exr
done
printf 'the flake at 1024x1024, written   ms, spread in s        MB\n'
write_row png16 "PNG, 16 bits a channel"
write_row png8 "PNG, 8 bits a channel"
write_row exr "EXR"
