#!/bin/sh
# Launcher of a source checkout: installs what is missing (Debian 12), builds, then runs the program with the same
# arguments. `./isl test` builds and runs the tests instead; `./isl style` checks how the code is written. The launcher prints to
# standard error only.
# The installed program (cmake --install) is the one that this script starts at its end; it needs no launcher.
# shellcheck disable=SC1091,SC2086  # lists of packages are split into words on purpose
set -u

# ---- The packages that are needed: their only list ---------------------------------------------------------------------
# openimageio-tools: OpenImageIO's CMake files refuse to load without them.
build_packages="g++ cmake ninja-build flex bison libfmt-dev libimath-dev libhwy-dev libtbb-dev libcli11-dev
fonts-povray nlohmann-json3-dev libpng-dev zlib1g-dev libopenexr-dev libfreetype-dev libopenimageio-dev openimageio-tools"
test_packages="libgtest-dev libgmock-dev librapidcheck-dev libboost-dev libmpfr-dev python3 valgrind"

style_packages="clang-format clang-tidy git"

self=$0
[ ! -h "$self" ] || self=$(readlink -f -- "$self")
root=$(CDPATH='' cd -- "$(dirname -- "$self")" && pwd -P) || exit 3
build=$root/build/release
program=$build/bin/isl
stamp=$build/launcher.stamp  # holds the checkout's path and the machine; its time is when the last good build began
rivals=$build/launcher.rivals  # the same for the module of the rival solvers
rival_solvers=$(sed -n 's/^ISL_RIVAL(\([a-z]*\),.*/\1/p' "$root/renderer/rays/solvers.def")
log=$root/build/launcher.log

say() { printf 'isl: %s\n' "$*" >&2; }

# run TITLE COMMAND…: prints the title, keeps the output in the log and shows the log's end only on failure.
run() {
  title=$1
  shift
  say "$title …"
  printf '\n==> %s: %s\n' "$title" "$*" >>"$log"
  begin=$(($(wc -l <"$log") + 1))
  "$@" >>"$log" 2>&1 </dev/null && return
  say "$title failed; the end of $log:"
  tail -n "+$begin" "$log" | tail -n 30 >&2
  exit 3
}

# show_progress TITLE: copies what ninja prints to the log, and shows its count: always on a terminal, else at every tenth.
show_progress() {
  shown=0
  while IFS= read -r line; do
    printf '%s\n' "$line" >>"$log"
    case $line in "["[0-9]*/[0-9]*"] "*) ;; *) continue ;; esac
    count=${line%%]*}
    count=${count#[}
    if [ -t 2 ]; then
      printf '\risl: %s [%s] ' "$1" "$count" >&2
      continue
    fi
    tenth=$((10 * ${count%/*} / ${count#*/}))
    [ "$tenth" -le "$shown" ] || say "$1 [$count]"
    [ "$tenth" -le "$shown" ] || shown=$tenth
  done
  [ ! -t 2 ] || printf '\r\033[K' >&2
}

# run_build TITLE COMMAND…: as `run`, with ninja's progress.
run_build() {
  title=$1
  shift
  say "$title …"
  printf '\n==> %s: %s\n' "$title" "$*" >>"$log"
  begin=$(($(wc -l <"$log") + 1))
  status=$({ { "$@" 2>&1 </dev/null; echo $? >&3; } | show_progress "$title"; } 3>&1)
  [ "$status" = 0 ] && return
  say "$title failed; the end of $log:"
  tail -n "+$begin" "$log" | tail -n 30 >&2
  exit 3
}

# The inner loops are compiled for this machine's vectors, so another machine that shares the folder builds anew.
built_here() { printf '%s on %s' "$root" "$(sed -n '/^flags/{p;q}' /proc/cpuinfo 2>/dev/null | cksum)"; }

# is_fresh STAMP FILE: true if FILE was built here and no input of the build is newer. `find` sees a removed file by its folder's
# time.
is_fresh() {
  [ -e "$2" ] && [ -r "$1" ] && read -r built <"$1" && [ "$built" = "$(built_here)" ] || return 1
  [ -z "$(cd "$root" && find isl CMakeLists.txt CMakePresets.json cmake base grammar interpreter renderer cli \
    -newer "$1" -print 2>/dev/null | head -n 1)" ]
}

# needs_rivals ARGUMENT…: true if the command compares solvers or names a rival.
needs_rivals() {
  [ "${1:-}" != accuracy ] || return 0
  for argument in "$@"; do
    for rival in $rival_solvers; do
      case ${argument#*=} in "$rival" | "$rival":* | "$rival "*) return 0 ;; esac
    done
  done
  return 1
}

is_ready() {
  is_fresh "$stamp" "$program" && { ! needs_rivals "$@" || is_fresh "$rivals" "$build/lib/isl/isl_rivals.so"; }
}

is_debian_12() {
  [ -r /etc/os-release ] && (. /etc/os-release && [ "${ID:-}" = debian ] && [ "${VERSION_ID:-}" = 12 ])
}

# require PACKAGE…: installs the missing ones, or names them if it cannot.
require() {
  if ! is_debian_12; then
    say "this is not Debian 12, so packages are not installed; install the equivalents of these Debian 12 packages: $*"
    return
  fi
  # "ii" and "hi" are installed; dpkg-query prints nothing for a package that it does not know.
  present=" $(dpkg-query -W -f '${db:Status-Abbrev}:${Package}\n' "$@" 2>/dev/null | sed -n 's/^.i *://p' | tr '\n' ' ')"
  missing=
  for package in "$@"; do
    case $present in *" $package "*) ;; *) missing="$missing $package" ;; esac
  done
  [ -n "$missing" ] || return 0

  as_root=
  if [ "$(id -u)" -ne 0 ]; then
    as_root=sudo
    if ! command -v sudo >/dev/null 2>&1; then
      say "packages are missing and there is no sudo; as root run: apt-get install --no-install-recommends$missing"
      exit 3
    fi
    sudo -v || exit 3  # asks for the password here, where it can be seen
  fi
  set -- apt-get -q -o DPkg::Lock::Timeout=300
  say "installing packages:$missing"
  # A stale or partly broken list of another archive is no reason to stop: the installation shows if it matters.
  $as_root "$@" update >>"$log" 2>&1 </dev/null || say "apt-get update had errors; the installation continues with the present package lists"
  run "apt-get install" $as_root env DEBIAN_FRONTEND=noninteractive "$@" install -y --no-install-recommends $missing
}

# One set-up at a time: others wait. The system releases the lock when the process ends.
lock() {
  mkdir -p "$root/build" || { say "cannot write to $root/build; make it writable or copy the checkout"; exit 3; }
  command -v flock >/dev/null 2>&1 || return 0
  exec 9>"$root/build/launcher.lock" || exit 3
  flock -n 9 || { say "waiting for another build of this checkout"; flock 9; }
}

unlock() { exec 9>&-; }

cores() { nproc 2>/dev/null || getconf _NPROCESSORS_ONLN 2>/dev/null || echo 2; }

# A build folder that was copied along with the checkout points to the old place; one for another machine's vectors is of no use.
drop_foreign() {
  [ -f "$1/CMakeCache.txt" ] || return 0
  grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$1/CMakeCache.txt" || rm -rf "$1"
  ! grep -q '^ISL_VECTOR_WIDTHS:STRING=machine$' "$1/CMakeCache.txt" 2>/dev/null || [ ! -r "$1/launcher.stamp" ] ||
    [ "$(head -n 1 "$1/launcher.stamp")" = "$(built_here)" ] || rm -rf "$1"
}

# is_configured FOLDER -DNAME=VALUE…: true if CMake need not run again; ninja detects changes of CMakeLists.txt.
is_configured() {
  [ -f "$1/build.ninja" ] && [ -z "$(find "$root/CMakePresets.json" -newer "$1/build.ninja")" ] || return 1
  cache=$1/CMakeCache.txt
  shift
  for setting in "$@"; do
    name=${setting#-D}
    grep -q "^${name%%=*}:[A-Z]*=${name#*=}\$" "$cache" || return 1
  done
}

# build_with PRESET TARGET STAMP -DNAME=VALUE…: configures if necessary and builds.
build_with() {
  preset=$1 target=$2 next=$3.next last=$3
  shift 3
  folder=$root/build/$preset
  drop_foreign "$folder"
  [ -f "$folder/build.ninja" ] || say "the first build takes some minutes"
  mkdir -p "$folder" && printf '%s\n' "$(built_here)" >"$next" || exit 3
  is_configured "$folder" "$@" || run "configuring ($preset)" cmake -S "$root" --preset "$preset" "$@"
  run_build "building ($preset)" cmake --build "$folder" --target "$target" -j "$(cores)"
  mv "$next" "$last"
}

# build_program TARGET STAMP: with the settings of an earlier build, which may have had the tests, or else for this machine alone.
build_program() {
  drop_foreign "$build"
  if [ -f "$build/build.ninja" ]; then
    (cd "$root" && build_with release "$1" "$2") || exit $?
  else
    (cd "$root" && build_with release "$1" "$2" -DISL_TESTS=OFF -DISL_VECTOR_WIDTHS=machine) || exit $?
  fi
}

set_up() {
  lock
  if ! is_ready "$@"; then  # another run may have built it while this one waited
    : >"$log"
    began=$(date +%s)
    require $build_packages
    is_fresh "$stamp" "$program" || build_program isl_program "$stamp"
    ! needs_rivals "$@" || build_program isl_rivals "$rivals"
    say "ready after $(($(date +%s) - began)) s"
  fi
  unlock
}

# run_tests [--asan|--asan=reading] [CTEST-OPTION…]: builds all and runs ctest; with the sanitizers, the quick tests or those of reading.
run_tests() {
  asan=
  case ${1:-} in
    --asan) asan=quick target=all loops=ON; shift;;
    # These look at what files can do to the program. With sanitizers the loops of the tracer take the compiler as long as all the rest.
    --asan=reading) asan=reading target=isl_reading_tests loops=OFF; shift;;
  esac
  lock
  : >"$log"
  require $build_packages $test_packages
  cd "$root" || exit 3
  # Another compiler may warn of what this one does not, so warnings are errors in checks only.
  (build_with release all "$stamp" -DISL_TESTS=ON -DISL_VECTOR_WIDTHS=all ${asan:+-DISL_WERROR=ON}) || exit $?
  cp -p "$stamp" "$rivals"
  [ -z "$asan" ] || (build_with asan "$target" "$root/build/asan/launcher.stamp" -DISL_SANITIZED_LOOPS=$loops) || exit $?
  status=0
  if [ -n "$asan" ]; then
    say "$asan tests with the address and undefined-behaviour sanitizers"
    ctest --test-dir build/asan --output-on-failure -j "$(cores)" -L "$asan" || status=1
  fi
  ctest --test-dir build/release --output-on-failure -j "$(cores)" "$@" || status=1
  exit $status
}

# check_style [COMMIT]: the format of every file, and clang-tidy on what changed since the commit (the one before the last).
check_style() {
  lock
  : >"$log"
  require $build_packages $test_packages $style_packages
  cd "$root" || exit 3
  status=0
  say "format of every file"
  git ls-files '*.h' '*.cpp' | xargs clang-format --dry-run -Werror || status=1
  base=${1:-HEAD~1}
  changed=$(git diff --name-only --diff-filter=d "$base" -- '*.cpp' 2>/dev/null) || changed=
  [ -n "$changed" ] || { say "no source changed since $base"; exit $status; }
  # In a folder of its own, as clang cannot read the headers that GCC has precompiled. Sources that are made are included by
  # others, so they must be there. What only GCC compiles is left out.
  (build_with style isl_generated_sources "$root/build/style/launcher.stamp") || exit $?
  changed=$(printf '%s\n' "$changed" | while IFS= read -r file; do
    ! grep -qF "/$file\"" build/style/compile_commands.json || printf '%s\n' "$file"
  done)
  say "clang-tidy on $(printf '%s\n' "$changed" | wc -l) files that changed since $base"
  printf '%s\n' "$changed" | xargs -r -P "$(cores)" -n 1 clang-tidy -p build/style --quiet --warnings-as-errors='*' \
    --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-ignored-optimization-argument || status=1
  exit $status
}

if [ "${1:-}" = style ]; then
  shift
  check_style "$@"
fi
if [ "${1:-}" = test ]; then
  shift
  run_tests "$@"
fi
is_ready "$@" || set_up "$@"
exec "$program" "$@"
