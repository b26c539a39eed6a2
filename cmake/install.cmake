# What `cmake --install` writes, in components:
#   program      bin/prs, its modules in lib/prs, lessons and validation data in share/prs, which
#                the programs find from where they stand; manual pages and completions
#   documents    share/doc/prs, and there LICENSE of the component licence
#   development  for `find_package(prs)`: headers (install_headers.cmake), libraries, lib/cmake/prs
# Of the Debian package see package.cmake, of the Python package python/CMakeLists.txt.
include(CMakePackageConfigHelpers)
get_property(modules GLOBAL PROPERTY PRS_MODULES)

# install_compressed(FILE DESTINATION COMPONENT ..): FILE, an absolute path, as DESTINATION.gz.
function(install_compressed file destination component)
  install(CODE "
    set(path \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${destination}.gz\")
    message(STATUS \"Installing: \${path}\")
    cmake_path(GET path PARENT_PATH folder)
    file(MAKE_DIRECTORY \${folder})
    execute_process(COMMAND gzip -9nc \"${file}\" OUTPUT_FILE \${path} COMMAND_ERROR_IS_FATAL ANY)"
    COMPONENT ${component} ${ARGN})
endfunction()

install(TARGETS prs RUNTIME DESTINATION bin COMPONENT program)
install(TARGETS prs-validate RUNTIME DESTINATION libexec/prs COMPONENT program)
install(TARGETS ${modules} LIBRARY DESTINATION lib/prs COMPONENT program)
install(DIRECTORY configs/ DESTINATION share/prs/lessons COMPONENT program
  FILES_MATCHING PATTERN *.yaml PATTERN *.csv)
install(DIRECTORY validation/ DESTINATION share/prs/validation COMPONENT program
  FILES_MATCHING PATTERN *.yaml PATTERN *.csv PATTERN *.json PATTERN SOURCE.md)
# Engine and scripts of live pages, where scripts/web.sh built them.
install(DIRECTORY build/web/ DESTINATION share/prs/web COMPONENT program OPTIONAL)
install(CODE "set(prs \"$<TARGET_FILE:prs>\")" COMPONENT program)
install(SCRIPT cmake/install_texts.cmake COMPONENT program)

install(FILES LICENSE DESTINATION share/doc/prs COMPONENT licence)
install(FILES web/licences.txt DESTINATION share/doc/prs RENAME LICENCES.pages COMPONENT licence)
install(FILES README.md CHANGELOG.md DESTINATION share/doc/prs COMPONENT documents)
install(DIRECTORY docs DESTINATION share/doc/prs COMPONENT documents)

install(CODE "set(source \"${PROJECT_SOURCE_DIR}\")" COMPONENT development)
install(SCRIPT cmake/install_headers.cmake COMPONENT development)
configure_package_config_file(cmake/prsConfig.cmake.in prsConfig.cmake
  INSTALL_DESTINATION lib/cmake/prs)
write_basic_package_version_file(prsConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/prsConfig.cmake ${PROJECT_BINARY_DIR}/prsConfigVersion.cmake
  DESTINATION lib/cmake/prs COMPONENT development)
install(EXPORT prs NAMESPACE prs:: FILE prsTargets.cmake
  DESTINATION lib/cmake/prs COMPONENT development)
