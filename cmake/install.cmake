# bin/prs, its modules in lib/prs, and for `find_package(prs)` headers, libraries and
# lib/cmake/prs. Of the Python package see python/CMakeLists.txt.
include(CMakePackageConfigHelpers)
get_property(modules GLOBAL PROPERTY PRS_MODULES)
install(TARGETS prs RUNTIME DESTINATION bin COMPONENT program)
install(TARGETS prs-validate RUNTIME DESTINATION libexec/prs COMPONENT program)
install(TARGETS ${modules} LIBRARY DESTINATION lib/prs COMPONENT program)

configure_package_config_file(cmake/prsConfig.cmake.in prsConfig.cmake
  INSTALL_DESTINATION lib/cmake/prs)
write_basic_package_version_file(prsConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/prsConfig.cmake ${PROJECT_BINARY_DIR}/prsConfigVersion.cmake
  DESTINATION lib/cmake/prs COMPONENT development)
install(EXPORT prs NAMESPACE prs:: FILE prsTargets.cmake
  DESTINATION lib/cmake/prs COMPONENT development)
