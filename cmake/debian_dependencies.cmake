# For cpack. CHOLMOD, which factorizes what `prs solve` solves, is required. Other modules' libraries
# are recommended, so that who wants a small installation can leave them out; MPI, which is of use
# with several machines only, is suggested.
if(NOT CPACK_GENERATOR STREQUAL "DEB")
  return()
endif()
file(GLOB modules ${CPACK_PRS_MODULES}/*.so)
set(mpi ${modules})
list(FILTER mpi INCLUDE REGEX "prs_mpi")
set(cholmod ${modules})
list(FILTER cholmod INCLUDE REGEX "prs_cholmod")
list(FILTER modules EXCLUDE REGEX "prs_(cholmod|mpi)")
# dpkg-shlibdeps names a library in the strongest of the fields that need it.
set(control ${CPACK_TOPLEVEL_DIRECTORY}/control)
file(WRITE ${control}/debian/control "Source: prs\n\nPackage: prs\nArchitecture: any\n")
execute_process(
  COMMAND dpkg-shlibdeps -O -dDepends ${CPACK_PRS_PROGRAMS} ${cholmod} -dRecommends ${modules} -dSuggests ${mpi}
  WORKING_DIRECTORY ${control} OUTPUT_VARIABLE fields COMMAND_ERROR_IS_FATAL ANY)
function(set_field field more)
  string(REGEX MATCH "shlibs:${field}=([^\n]*)" _ "${fields}")
  string(JOIN ", " all ${CMAKE_MATCH_1} ${more})
  string(TOUPPER ${field} name)
  set(CPACK_DEBIAN_PACKAGE_${name} ${all} PARENT_SCOPE)
endfunction()
set_field(Depends "")
set_field(Recommends "")
set_field(Suggests "openmpi-bin")
