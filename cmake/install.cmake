# find_package(quarter) gives quarter::robot and quarter::learn.
include(CMakePackageConfigHelpers)

set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/quarter)
install(TARGETS quarter_robot quarter_learn EXPORT quarter-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/quarter DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h")
install(EXPORT quarter-targets NAMESPACE quarter:: DESTINATION ${package_folder})
write_basic_package_version_file(quarter-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_SOURCE_DIR}/cmake/quarter-config.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/quarter-config-version.cmake DESTINATION ${package_folder})
if(TARGET quarter)
  install(TARGETS quarter RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
