# Sourced where isl is put beside Embree: the solids of a scene as plain numbers, and Embree's program for them, built when
# first asked for.
# shellcheck shell=bash disable=SC2154  # tables.sh sets what is used here

# embree_ready: builds embree_solids; false, with a line that says why, where that cannot be.
embree_ready() {
  [ -x "$work/embree_solids" ] && return
  local compiler=${CXX:-c++}
  if ! "$compiler" -std=c++20 -O2 -march=native "$paper/embree_solids.cpp" -o "$work/embree_solids" -lembree3 \
    >"$work/embree_build" 2>&1; then
    echo "no Embree (Debian's package libembree-dev): left out" >&2
    return 1
  fi
}

# plain_solids SCENE OPTION…: the camera and the points and cones of a scene's blobs, as embree_solids reads them. An object of the
# dump ends where the next begins, so that blanks and line ends do not count.
plain_solids() {
  "$isl" dump --stage database "$@" | tr -d ' \n' | awk -v RS='{' '
    function vector(name) {
      if (!match($0, "\"" name "\":\\[[^]]*")) return ""
      found = substr($0, RSTART, RLENGTH)
      sub(/.*\[/, "", found)
      gsub(/,/, " ", found)
      return found
    }
    function number(name) {
      if (!match($0, "\"" name "\":[-0-9.e+]+")) return 0
      found = substr($0, RSTART, RLENGTH)
      sub(/.*:/, "", found)
      return found
    }
    /"location":.*"direction":/ { print "camera", vector("location"), vector("direction"), vector("right"), vector("up") }
    /"skeleton":"point"/ { print "sphere", vector("a"), number("radius") }
    /"skeleton":"segment"/ { print "cone", vector("a"), number("radius"), vector("b"), number("radius") }
    /"skeleton":"cone"/ { print "cone", vector("a"), number("radius"), vector("b"), number("radius_b") }'
}

# embree SOLIDS WIDTH HEIGHT REPEATS: "solids build single packets share", see embree_solids.cpp.
embree() { "$work/embree_solids" "$2" "$3" "$4" <"$1" || fail "embree_solids failed"; }
