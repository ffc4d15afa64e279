# `cmake --install`: bin/isl and what scenes include in share/isl; what the program loads goes to lib/isl by its own
# rule (renderer/image). They find one another by their places, so that the whole may be moved.
#
# The components `libraries` and `docs` need no build: `cmake --install build/release --component docs`.
include(GNUInstallDirs)
install(TARGETS isl_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
# The page about the libraries shows pictures of docs/, and is installed with those.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/stdlib/ DESTINATION share/isl COMPONENT libraries
  PATTERN README.md EXCLUDE
  PATTERN CMakeLists.txt EXCLUDE)

# The pages link to one another, to scenes and to pictures by relative paths, so they lie as they do in the sources.
# docs/effects.md shows scenes of bench/. tests/install checks that no link leads nowhere.
set(isl_docs ${CMAKE_INSTALL_DOCDIR})
foreach(page README.md CHANGELOG.md CONTRIBUTING.md LICENSE)
  install(FILES ${PROJECT_SOURCE_DIR}/${page} DESTINATION ${isl_docs} COMPONENT docs)
endforeach()
foreach(folder docs scenes bench/pairs bench/soft)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/ DESTINATION ${isl_docs}/${folder} COMPONENT docs
    PATTERN CMakeLists.txt EXCLUDE
    PATTERN *.py EXCLUDE)
endforeach()
foreach(folder stdlib bench)
  install(FILES ${PROJECT_SOURCE_DIR}/${folder}/README.md DESTINATION ${isl_docs}/${folder} COMPONENT docs)
endforeach()
