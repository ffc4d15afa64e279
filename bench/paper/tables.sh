# Sourced by the scripts of this folder: their two options, `isl accuracy` as numbers, layers as numbers, Markdown, and
# pictures in false colours. Knows nothing of what is measured. oiiotool (openimageio-tools) reads the layers.
# shellcheck shell=bash disable=SC2034  # what is set here is used where this is sourced
# shellcheck source-path=SCRIPTDIR source=../common.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/../common.sh"

paper=$bench/paper

# Also ends the script where $(…) would only end itself and leave an empty cell in a table.
trap 'exit 1' USR1
fail() {
  printf '%s: %s\n' "$(basename -- "$0")" "$*" >&2
  if ((BASHPID != $$)); then kill -s USR1 $$; fi
  exit 1
}

quick=0 pictures=

# common_options ARGUMENT…: --quick is a check that all runs, small and with one repeat; -p FOLDER is where pictures go
# (none are kept without).
common_options() {
  while (($# > 0)); do
    case $1 in
      --quick) quick=1 ;;
      -p) [ $# -ge 2 ] || fail "-p needs a folder"; pictures=$2; shift ;;
      *) fail "unknown option $1: there are --quick and -p FOLDER" ;;
    esac
    shift
  done
}

# or_quick FULL QUICK: the one that was asked for.
or_quick() { if ((quick)); then echo "$2"; else echo "$1"; fi; }

need() { command -v "$1" >/dev/null || fail "$1 is not installed (Debian's package $2)"; }

# ---- Numbers ---------------------------------------------------------------------------------------------------------

# measure NAME SCENE SIZE ROUNDS SETTINGS OPTION…: `isl accuracy` of the camera rays of SCENE (below scenes/) with the
# settings, separated by commas, on one thread; `measured` reads what it found under NAME.
measure() {
  local name=$1 scene=$2 size=$3 rounds=$4 setting settings asked=()
  IFS=, read -r -a settings <<<"$5"
  shift 5
  for setting in "${settings[@]}"; do asked+=(--setting "$setting"); done
  timed "$isl" accuracy "$root/scenes/$scene" -s "$size" --repeats "$rounds" -t 1 "${asked[@]}" -o "$work/$name" "$@"
}

# measured NAME SETTING COLUMN: of the table that `measure NAME` made. The default is called by its solver's name alone.
measured() {
  awk -F, -v setting="$2" -v column="$3" '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i == column) at = i; next }
    $1 == setting || $1 == setting " 0.05px" { print $at; found = 1; exit }
    END { exit !(found && at) }' "$work/$1.csv" || fail "no $3 of $2 in $1.csv"
}

# has_solver NAME: whether this build knows it.
has_solver() {
  printf '#version 3.7;\n' >"$work/empty.isl"
  "$isl" render "$work/empty.isl" -s 1x1 -q --solver "$1" -o "$work/empty.ppm" >/dev/null 2>&1
}

# layer FILE.exr CHANNEL: its values, row by row, one a line. oiiotool prints nine decimals: too few for small errors and times, so it
# prints them a thousand million times as large.
layer() {
  oiiotool "$1" --ch "$2" --mulc 1e9 -d float -o "$work/layer.exr" >"$work/oiio" 2>&1 ||
    { cat "$work/oiio" >&2; fail "no layer $2"; }
  oiiotool --dumpdata "$work/layer.exr" | awk '$1 == "Pixel" { print $NF == "inf" ? "inf" : $NF / 1e9 }'
}

# digits NUMBER: three digits that mean something, for people.
digits() {
  awk -v x="$1" 'BEGIN {
    if (x == 0) print "0"
    else if (x >= 1000 || x <= -1000) printf "%.0f\n", x
    else if (x >= 0.01 || x <= -0.01) printf "%.3g\n", x
    else printf "%.1e\n", x
  }'
}

# slope: of the least-squares line through the points "x y" on standard input, after logarithms of both.
slope() {
  awk '{ x = log($1); y = log($2); ++n; sx += x; sy += y; sxx += x * x; sxy += x * y }
    END { if (n > 1) printf "%.3f\n", (n * sxy - sx * sy) / (n * sxx - sx * sx); else print "-" }'
}

# ---- Markdown --------------------------------------------------------------------------------------------------------

# row CELL…
row() { printf '|'; printf ' %s |' "$@"; printf '\n'; }

# head_row CELL…: the first row and the line below it.
head_row() {
  row "$@"
  printf '|'
  printf -- '---|%.0s' "$@"
  printf '\n'
}

# caption TEXT: below a table, in italics, since a line above it would be read as its heading.
caption() { printf '\n*%s*\n\n' "$*"; }

# ---- Pictures --------------------------------------------------------------------------------------------------------

# keep FILE NAME: as NAME.png among the pictures, if any are wanted.
keep() {
  [ -n "$pictures" ] || return 0
  mkdir -p -- "$pictures"
  oiiotool "$1" -d uint8 -o "$pictures/$2.png" || fail "cannot write $pictures/$2.png"
}

# every WIDTH N: of values row by row, every Nth of every Nth row.
every() { awk -v width="$1" -v n="$2" 'int((NR - 1) / width) % n == 0 && (NR - 1) % width % n == 0'; }

# false_colours WIDTH LEAST GREATEST OUT.ppm: values row by row on standard input, WIDTH a row, by their logarithms from dark
# blue (LEAST) to yellow (GREATEST) in 16 steps that the eye sees as equal (viridis); 0 is nearly black and what is infinite
# red. A bar of the steps is below the picture.
false_colours() {
  awk -v width="$1" -v least="$2" -v greatest="$3" '
    BEGIN {
      split("68 1 84 72 26 108 71 47 125 65 68 135 57 86 140 49 104 142 42 120 142 35 136 142 31 152 139 34 168 132 " \
            "53 183 121 84 197 104 122 209 81 165 219 54 210 226 27 253 231 37", c, " ")
      for (i = 0; i < 16; ++i) colour[i] = c[3 * i + 1] " " c[3 * i + 2] " " c[3 * i + 3]
    }
    function of(x) {
      if (x == "inf" || x == "Inf") return "230 30 30"
      if (!(x > 0)) return "24 24 24"
      i = int(16 * log(x / least) / log(greatest / least))
      return colour[i < 0 ? 0 : i > 15 ? 15 : i]
    }
    { pixel[NR] = of($1) }
    END {
      height = NR / width
      bar = int(height / 32) + 2
      printf "P3 %d %d 255\n", width, height + bar
      for (i = 1; i <= NR; ++i) print pixel[i]
      for (y = 0; y < bar; ++y) for (x = 0; x < width; ++x) print y < 2 ? "24 24 24" : colour[int(16 * x / width)]
    }' >"$4"
}
