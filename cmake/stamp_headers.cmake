# cmake -DROOT=… -DOUTPUT=… -P stamp_headers.cmake: writes a header with one hash of all headers of renderer/ and base/.
cmake_minimum_required(VERSION 3.25)
file(GLOB_RECURSE headers ${ROOT}/base/*.h ${ROOT}/renderer/*.h ${ROOT}/renderer/*.def)
foreach(header IN LISTS headers)
  file(SHA256 ${header} hash)
  string(APPEND all ${hash})
endforeach()
string(SHA256 stamp "${all}")
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT "#pragma once

namespace isl::render {
inline constexpr char kHeaderStamp[] = \"@stamp@\";
}
")
