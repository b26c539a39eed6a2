# For cpack. Libraries of modules are recommended, so that who wants a small installation can leave them
# out; MPI, which is of use with several machines only, is suggested.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
file(GLOB modules ${CPACK_PRS_MODULES}/*.so)
set(mpi ${modules})
list(FILTER mpi INCLUDE REGEX "prs_mpi")
list(FILTER modules EXCLUDE REGEX "prs_mpi")
# dpkg-shlibdeps names a library in the strongest of the fields that need it.
set(control ${CPACK_TOPLEVEL_DIRECTORY}/control)
file(WRITE ${control}/debian/control "Source: prs\n\nPackage: prs\nArchitecture: any\n")
execute_process(
  COMMAND dpkg-shlibdeps -O -dDepends ${CPACK_PRS_PROGRAMS} -dRecommends ${modules} -dSuggests ${mpi}
  WORKING_DIRECTORY ${control} OUTPUT_VARIABLE fields COMMAND_ERROR_IS_FATAL ANY)
foreach(field IN ITEMS Depends Recommends Suggests)
  string(REGEX MATCH "shlibs:${field}=([^\n]*)" _ "${fields}")
  string(TOUPPER ${field} name)
  set(CPACK_DEBIAN_PACKAGE_${name} ${CMAKE_MATCH_1})
endforeach()
string(APPEND CPACK_DEBIAN_PACKAGE_SUGGESTS ", openmpi-bin")
