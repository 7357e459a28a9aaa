set(visibility_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/visibility")
install(TARGETS visibility visibility_headers ${visibility_parts} EXPORT visibilityTargets)
install(EXPORT visibilityTargets NAMESPACE visibility:: DESTINATION "${visibility_package_dir}")
install(DIRECTORY include/visibility DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
configure_package_config_file(cmake/visibilityConfig.cmake.in "${PROJECT_BINARY_DIR}/visibilityConfig.cmake"
  INSTALL_DESTINATION "${visibility_package_dir}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/visibilityConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/visibilityConfig.cmake" "${PROJECT_BINARY_DIR}/visibilityConfigVersion.cmake"
  DESTINATION "${visibility_package_dir}")
if(VISIBILITY_BUILD_COMMAND)
  install(TARGETS visibility_command)
endif()
