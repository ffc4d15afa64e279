# `cmake --install`: bin/isl and what scenes include in share/isl; what the program loads goes to lib/isl by its own rule
# (renderer/image). They find one another by their places, so that the whole may be moved.
include(GNUInstallDirs)
install(TARGETS isl_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/stdlib/ DESTINATION share/isl OPTIONAL)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
