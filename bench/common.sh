# Sourced by the scripts of this folder: where the program is, clocks, medians, and reading what programs print.
# Knows nothing of what is measured. Bash 5 and awk only.
# shellcheck shell=bash disable=SC2034  # what is set here is used where this is sourced

export LC_ALL=C  # a decimal point in every number

bench=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)
root=$(dirname -- "$bench")
isl=${ISL:-$root/build/release/bin/isl}
threads=2

fail() {
  printf '%s: %s\n' "$(basename -- "$0")" "$*" >&2
  exit 1
}

[ -x "$isl" ] || fail "no program at $isl: build it with './isl --version', or set ISL"

work=$(mktemp -d) || exit 1
trap 'rm -rf -- "$work"' EXIT

# whole_number WHAT VALUE LEAST: complains about an option's value that is none.
whole_number() {
  if ! [[ $2 =~ ^[0-9]+$ ]] || ((10#$2 < $3)); then fail "$1 is a whole number of at least $3, not '$2'"; fi
}

# timed COMMAND…: runs it, leaving what it prints in $work/out, and sets `seconds` to its wall-clock time from start to
# exit and `cpu` to the processor's seconds it took on all cores. A command that fails ends the script with its words.
timed() {
  local TIMEFORMAT='%3U %3S' status begin end
  begin=$EPOCHREALTIME
  { time "$@" >"$work/out" 2>&1; } 2>"$work/cpu"
  status=$?
  end=$EPOCHREALTIME
  ((status == 0)) || { tail -n 20 "$work/out" >&2; fail "exit code $status of: $*"; }
  seconds=$(awk -v a="$begin" -v b="$end" 'BEGIN { printf "%.6f", b - a }')
  cpu=$(awk '{ print $1 + $2 }' "$work/cpu")
}

# stat_of KEY FILE: the number that a --stats file has for a key; the file holds one key a line.
stat_of() {
  awk -v key="\"$1\":" '$1 == key { sub(/,$/, "", $2); print $2; found = 1; exit } END { exit !found }' "$2" ||
    fail "no $1 in the statistics"
}

# sum NUMBER…
sum() { awk 'BEGIN { for (i = 1; i < ARGC; ++i) s += ARGV[i]; printf "%.6f", s }' "$@"; }

# note SERIES VALUE: one more measurement of a series, a name without blanks. An empty value is a measurement that went
# wrong inside $(…), where `fail` could say so but not end the script.
note() {
  [ -n "$2" ] || exit 1
  printf '%s\n' "$2" >>"$work/series.$1"
}

# median SERIES; of an even count, the mean of the middle two.
median() {
  sort -g "$work/series.$1" | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int(NR / 2) + 1]) / 2 }'
}

# spread SERIES: "least..greatest", to judge how quiet the machine was.
spread() { sort -g "$work/series.$1" | awk '{ v[NR] = $1 } END { printf "%.3f..%.3f", v[1], v[NR] }'; }

machine() {
  printf '%s, %s cores, load %s; %s\n' \
    "$(awk -F': *' '/^model name/ { print $2; exit }' /proc/cpuinfo 2>/dev/null)" "$(nproc)" \
    "$(cut -d' ' -f1 /proc/loadavg 2>/dev/null)" "$("$isl" --version | head -n 1)"
}
