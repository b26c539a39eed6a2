# What `cmake --install` writes, in components: program, with lessons, validation data and the engine of pages in
# share/prs; documents; licence; development, for `find_package(prs)`.
include(CMakePackageConfigHelpers)
get_property(modules GLOBAL PROPERTY PRS_MODULES)
install(TARGETS prs RUNTIME DESTINATION bin COMPONENT program)
install(TARGETS ${modules} LIBRARY DESTINATION lib/prs COMPONENT program)
install(DIRECTORY configs/ DESTINATION share/prs/lessons COMPONENT program FILES_MATCHING PATTERN *.yaml PATTERN *.csv)
install(DIRECTORY validation/ DESTINATION share/prs/validation COMPONENT program
  FILES_MATCHING PATTERN *.yaml PATTERN *.csv PATTERN *.json PATTERN SOURCE.md)
install(DIRECTORY build/web/ DESTINATION share/prs/web COMPONENT program OPTIONAL)  # Of scripts/web.sh.
# The program itself writes its manual and its completions.
set(share \$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/share)
install(CODE "file(MAKE_DIRECTORY ${share}/bash-completion/completions)
  foreach(command IN ITEMS \"manual --output '${share}/man/man1'\"
          \"completion bash >'${share}/bash-completion/completions/prs'\")
    execute_process(COMMAND sh -c \"'$<TARGET_FILE:prs>' \${command}\" COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  file(GLOB pages ${share}/man/man1/prs*.1)
  execute_process(COMMAND gzip -9nf \${pages} COMMAND_ERROR_IS_FATAL ANY)" COMPONENT program)

install(FILES LICENSE DESTINATION share/doc/prs COMPONENT licence)
install(FILES LICENSE DESTINATION share/doc/prs RENAME copyright COMPONENT licence)
install(FILES web/licences.txt DESTINATION share/doc/prs RENAME LICENCES.pages COMPONENT licence)
install(FILES README.md CHANGELOG.md DESTINATION share/doc/prs COMPONENT documents)
install(DIRECTORY docs DESTINATION share/doc/prs COMPONENT documents)

# The public headers, and those that they include.
install(DIRECTORY include/ DESTINATION include COMPONENT development)
install(DIRECTORY contact fe modules prs simd DESTINATION include/prs/detail COMPONENT development
  FILES_MATCHING PATTERN *.h)
install(TARGETS prs_libraries prs_simd prs_modules prs_contact prs_fe prs_prs EXPORT prs
  ARCHIVE DESTINATION lib/prs COMPONENT development)
install(EXPORT prs NAMESPACE prs:: FILE prsTargets.cmake DESTINATION lib/cmake/prs COMPONENT development)
configure_package_config_file(cmake/prsConfig.cmake.in prsConfig.cmake INSTALL_DESTINATION lib/cmake/prs)
write_basic_package_version_file(prsConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/prsConfig.cmake ${PROJECT_BINARY_DIR}/prsConfigVersion.cmake
  DESTINATION lib/cmake/prs COMPONENT development)

if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()
# `cpack -G DEB`: a package for the release of Debian that it is made on.
set(CPACK_PACKAGE_CONTACT "the prs authors <prs-authors@prs.invalid>" CACHE STRING "Who answers for the packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program documents licence)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Computes loads, stiffness, slip, losses, life and designs of planetary roller
screws, described by a YAML file. Every number can be traced to an equation of a published source. It links CHOLMOD
with its supernodal part: as a whole it is under the GPL, version 2 or later.")
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/debian_dependencies.cmake)
set(CPACK_PRS_PROGRAMS ${PROJECT_BINARY_DIR}/prs/cli/prs)
set(CPACK_PRS_MODULES ${PROJECT_BINARY_DIR}/lib/prs)
include(CPack)
