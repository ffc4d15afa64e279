# Headers that nearly every file includes, compiled once for all production code and once for all tests. Included last: the other
# CMakeLists.txt know nothing of it, and every file includes what it uses; ISL_PCH=OFF shows that it does.
#
# A compiled header fits where the options that choose the machine's code agree, so modules (-fPIC) go without. GCC's -O levels need
# not agree. -fpch-preprocess is for ccache, which looks at preprocessed text; it needs CCACHE_SLOPPINESS=pch_defines,time_macros.
option(ISL_PCH "Use precompiled headers" ON)

set(isl_pch_standard
  <algorithm> <array> <bit> <chrono> <cmath> <cstddef> <cstdint> <cstring> <deque> <filesystem> <functional> <iterator> <limits> <map>
  <memory> <numbers> <numeric> <optional> <span> <string> <string_view> <system_error> <tuple> <type_traits> <unordered_map>
  <utility> <variant> <vector>)

# isl_compiled_header(NAME LIBRARIES … HEADERS …): a library that holds nothing but the compiled header.
function(isl_compiled_header name)
  cmake_parse_arguments(arg "" "" "LIBRARIES;HEADERS" ${ARGN})
  set(source ${PROJECT_BINARY_DIR}/${name}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "// A target needs a source.\n")
  add_library(${name} STATIC ${source})
  target_link_libraries(${name} PRIVATE isl::options ${arg_LIBRARIES})
  target_compile_options(${name} PRIVATE -fpch-preprocess)
  target_precompile_headers(${name} PRIVATE ${arg_HEADERS})
endfunction()

# isl_share_compiled_header(FOLDER HEADER LIBRARIES …): for all programs and libraries of the folder and those below.
function(isl_share_compiled_header folder header)
  cmake_parse_arguments(arg "" "" "LIBRARIES" ${ARGN})
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    get_target_property(type ${target} TYPE)
    if(type MATCHES "^(STATIC_LIBRARY|OBJECT_LIBRARY|EXECUTABLE)$")
      target_compile_options(${target} PRIVATE -fpch-preprocess)
      target_link_libraries(${target} PRIVATE ${arg_LIBRARIES})  # their definitions must agree with the compiled header's
      target_precompile_headers(${target} REUSE_FROM ${header})
    endif()
  endforeach()
  get_property(subfolders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(subfolder IN LISTS subfolders)
    isl_share_compiled_header(${subfolder} ${header} LIBRARIES ${arg_LIBRARIES})
  endforeach()
endfunction()

if(ISL_PCH AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(libraries fmt::fmt Imath::Imath nlohmann_json::nlohmann_json)
  isl_compiled_header(isl_production_header
    LIBRARIES ${libraries}
    HEADERS ${isl_pch_standard} <fmt/format.h> <ImathBox.h> <ImathMatrix.h> <ImathVec.h> <nlohmann/json.hpp>)
  foreach(part base grammar interpreter renderer cli)
    isl_share_compiled_header(${PROJECT_SOURCE_DIR}/${part} isl_production_header LIBRARIES ${libraries})
  endforeach()
  if(ISL_TESTS)
    find_package(GTest REQUIRED)  # found before in the scope of tests/ only
    isl_compiled_header(isl_tests_header
      LIBRARIES ${libraries} GTest::gmock
      HEADERS ${isl_pch_standard} <fstream> <random> <sstream> <fmt/format.h> <ImathBox.h> <ImathMatrix.h> <ImathVec.h>
        <nlohmann/json.hpp> <gmock/gmock.h> <gtest/gtest.h>)
    target_compile_definitions(isl_tests_header PRIVATE _GLIBCXX_ASSERTIONS)  # as tests/CMakeLists.txt has it
    isl_share_compiled_header(${PROJECT_SOURCE_DIR}/tests isl_tests_header LIBRARIES ${libraries} GTest::gmock)
  endif()
endif()
