# What `cmake --install` writes, in components:
#   program      bin/prs, its modules in lib/prs, lessons, validation data and the engine of pages in
#                share/prs, which the programs find from where they stand; manual and completions
#   documents    share/doc/prs, and there LICENSE of the component licence
#   development  for `find_package(prs)`: headers, libraries, lib/cmake/prs
# `cpack -G DEB` makes program and documents a package for the release of Debian that it runs on.
include(CMakePackageConfigHelpers)
get_property(modules GLOBAL PROPERTY PRS_MODULES)
install(TARGETS prs RUNTIME DESTINATION bin COMPONENT program)
install(TARGETS prs-validate RUNTIME DESTINATION libexec/prs COMPONENT program)
install(TARGETS ${modules} LIBRARY DESTINATION lib/prs COMPONENT program)
install(DIRECTORY configs/ DESTINATION share/prs/lessons COMPONENT program
  FILES_MATCHING PATTERN *.yaml PATTERN *.csv)
install(DIRECTORY validation/ DESTINATION share/prs/validation COMPONENT program
  FILES_MATCHING PATTERN *.yaml PATTERN *.csv PATTERN *.json PATTERN SOURCE.md)
install(DIRECTORY build/web/ DESTINATION share/prs/web COMPONENT program OPTIONAL)
install(CODE "set(prs \"$<TARGET_FILE:prs>\")" COMPONENT program)
install(SCRIPT cmake/install_texts.cmake COMPONENT program)

install(FILES LICENSE DESTINATION share/doc/prs COMPONENT licence)
install(FILES web/licences.txt DESTINATION share/doc/prs RENAME LICENCES.pages COMPONENT licence)
install(FILES README.md CHANGELOG.md DESTINATION share/doc/prs COMPONENT documents)
install(DIRECTORY docs DESTINATION share/doc/prs COMPONENT documents)

# The public headers, and those that they include, below include/prs/detail.
install(DIRECTORY include/ DESTINATION include COMPONENT development)
install(DIRECTORY contact fe modules prs simd DESTINATION include/prs/detail COMPONENT development
  FILES_MATCHING PATTERN *.h)
install(TARGETS prs_libraries prs_simd prs_modules prs_contact prs_fe prs_prs EXPORT prs
  ARCHIVE DESTINATION lib/prs COMPONENT development)
configure_package_config_file(cmake/prsConfig.cmake.in prsConfig.cmake INSTALL_DESTINATION lib/cmake/prs)
write_basic_package_version_file(prsConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/prsConfig.cmake ${PROJECT_BINARY_DIR}/prsConfigVersion.cmake
  DESTINATION lib/cmake/prs COMPONENT development)
install(EXPORT prs NAMESPACE prs:: FILE prsTargets.cmake DESTINATION lib/cmake/prs COMPONENT development)

if(NOT PROJECT_IS_TOP_LEVEL)
  return()
endif()
set(CPACK_PACKAGE_CONTACT "the prs authors <prs-authors@prs.invalid>" CACHE STRING "Who answers for the packages")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program documents debian)
set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION
"Reads the description of a planetary roller screw from a YAML file. It
computes the load on every thread, the axial stiffness, the contact
pressures, the slip of the rollers and the power losses, the life and the
weight, and it searches for a better design. Every number can be traced to
an equation of a published source. Since it links CHOLMOD with its supernodal
part, the package as a whole is under the GPL, version 2 or later.")
set(CPACK_PROJECT_CONFIG_FILE ${PROJECT_SOURCE_DIR}/cmake/debian_dependencies.cmake)
set(CPACK_PRS_PROGRAMS ${PROJECT_BINARY_DIR}/prs/cli/prs ${PROJECT_BINARY_DIR}/prs/cli/prs-validate)
set(CPACK_PRS_MODULES ${PROJECT_BINARY_DIR}/lib/prs)
include(CPack)

# What Debian wants in share/doc, of this package alone.
install(FILES LICENSE DESTINATION share/doc/prs RENAME copyright COMPONENT debian EXCLUDE_FROM_ALL)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(CONFIGURE OUTPUT debian/changelog.Debian @ONLY CONTENT
"prs (@PROJECT_VERSION@-@CPACK_DEBIAN_PACKAGE_RELEASE@) unstable; urgency=medium

  * Release @PROJECT_VERSION@; changelog.gz says what has changed.

 -- @CPACK_PACKAGE_CONTACT@  @date@
")
foreach(file IN ITEMS debian/changelog.Debian changelog)
  set(source ${PROJECT_SOURCE_DIR}/CHANGELOG.md)
  if(file MATCHES Debian)
    set(source ${PROJECT_BINARY_DIR}/${file})
  endif()
  cmake_path(GET file FILENAME name)
  install(CODE "execute_process(COMMAND gzip -9nc \"${source}\" COMMAND_ERROR_IS_FATAL ANY
    OUTPUT_FILE \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/share/doc/prs/${name}.gz\")"
    COMPONENT debian EXCLUDE_FROM_ALL)
endforeach()
