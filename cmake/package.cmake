# `cpack -G DEB`: program and documents as a package for the release of Debian that it is made on.
set(PRS_PACKAGE_CONTACT "the prs authors <prs-authors@prs.invalid>" CACHE STRING
    "Who answers for the packages: a name and an address")
set(CPACK_PACKAGE_NAME prs)
set(CPACK_PACKAGE_CONTACT ${PRS_PACKAGE_CONTACT})
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
an equation of a published source.")
# Read by cpack, with the two names below.
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

 -- @PRS_PACKAGE_CONTACT@  @date@
")
install_compressed(${PROJECT_BINARY_DIR}/debian/changelog.Debian
  share/doc/prs/changelog.Debian debian EXCLUDE_FROM_ALL)
install_compressed(${PROJECT_SOURCE_DIR}/CHANGELOG.md
  share/doc/prs/changelog debian EXCLUDE_FROM_ALL)
