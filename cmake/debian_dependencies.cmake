# For cpack: libraries of modules are recommended, so that who wants a small installation can leave them out.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
file(GLOB modules ${CPACK_PRS_MODULES}/*.so)
file(WRITE ${CPACK_TOPLEVEL_DIRECTORY}/control/debian/control "Source: prs\n\nPackage: prs\nArchitecture: any\n")
execute_process(WORKING_DIRECTORY ${CPACK_TOPLEVEL_DIRECTORY}/control OUTPUT_VARIABLE fields COMMAND_ERROR_IS_FATAL ANY
  COMMAND dpkg-shlibdeps -O -dDepends ${CPACK_PRS_PROGRAMS} -dRecommends ${modules})
foreach(field IN ITEMS Depends Recommends)
  string(REGEX MATCH "shlibs:${field}=([^\n]*)" _ "${fields}")
  string(TOUPPER ${field} name)
  set(CPACK_DEBIAN_PACKAGE_${name} ${CMAKE_MATCH_1})
endforeach()
