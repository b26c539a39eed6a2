# Libraries with the oldest versions that were tried, those of Debian 12. What few runs need becomes a module,
# prs_NAME.so, which the program loads when it is asked for it (modules/module.h).
if(EMSCRIPTEN)
  include(${CMAKE_CURRENT_LIST_DIR}/webassembly.cmake)
  return()
endif()
set(PRS_LIBRARIES Eigen3=3.4.0 yaml-cpp=0.7.0 nlohmann_json=3.11.2 fmt=9.1.0 CLI11=2.1.2 Boost=1.74.0 xsimd=8.1.0
  ZLIB=1.2.13)
if(PRS_FULL)
  list(APPEND PRS_LIBRARIES spectra=1.0.1)
endif()
foreach(library IN LISTS PRS_LIBRARIES)
  string(REGEX MATCH "(.*)=(.*)" _ ${library})
  find_package(${CMAKE_MATCH_1} REQUIRED)  # Some refuse to be asked for a version older than their own.
  string(REGEX MATCH "(.*)=(.*)" _ ${library})
  if(${CMAKE_MATCH_1}_VERSION AND ${CMAKE_MATCH_1}_VERSION VERSION_LESS CMAKE_MATCH_2)
    message(FATAL_ERROR "${CMAKE_MATCH_1}: found version ${${CMAKE_MATCH_1}_VERSION}; install ${CMAKE_MATCH_2} or later")
  endif()
endforeach()
find_package(PkgConfig REQUIRED)
pkg_check_modules(NETTLE REQUIRED IMPORTED_TARGET nettle>=3.8)
find_library(CSV_LIBRARY csv REQUIRED)
if(PRS_CHOLMOD)
  find_path(CHOLMOD_INCLUDE_DIR cholmod.h PATH_SUFFIXES suitesparse REQUIRED)
  find_library(CHOLMOD_LIBRARY cholmod REQUIRED)
endif()
if(NOT PRS_FULL)
  return()
endif()

find_package(Pagmo QUIET)
find_package(TBB QUIET)
find_package(Ceres QUIET)
pkg_check_modules(RSVG QUIET IMPORTED_TARGET librsvg-2.0>=2.54)
find_library(SUNDIALS_LIBRARY sundials_cvode)  # With its vectors and solvers.
find_library(SUNDIALS_CORE sundials_core)      # Since version 7, which Debian builds with MPI.
if(SUNDIALS_LIBRARY)
  if(SUNDIALS_CORE)
    find_package(MPI QUIET COMPONENTS C)
  endif()
  add_library(SUNDIALS::cvode INTERFACE IMPORTED)
  target_link_libraries(SUNDIALS::cvode INTERFACE ${SUNDIALS_LIBRARY} $<$<BOOL:${SUNDIALS_CORE}>:${SUNDIALS_CORE}>
    $<$<BOOL:${SUNDIALS_CORE}>:$<TARGET_NAME_IF_EXISTS:MPI::MPI_C>>)
endif()

# add_module(NAME LIBRARY PACKAGE SOURCE..): the module prs_NAME.so, where there is a target LIBRARY.
function(add_module name library package)
  if(NOT TARGET ${library})
    message(STATUS "prs_${name}.so: not built; install ${package}")
    return()
  endif()
  message(STATUS "prs_${name}.so: with ${library}")
  add_library(prs_module_${name} MODULE ${ARGN})
  set_target_properties(prs_module_${name} PROPERTIES
    PREFIX "" OUTPUT_NAME prs_${name} LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib/prs
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_link_libraries(prs_module_${name} PRIVATE prs_options prs_guards ${library} fmt::fmt Eigen3::Eigen)
  target_compile_definitions(prs_module_${name} PRIVATE PRS_VERSION="${PROJECT_VERSION}")
  add_dependencies(prs_modules prs_module_${name})  # Whatever may load it finds it built.
  set_property(GLOBAL APPEND PROPERTY PRS_MODULES prs_module_${name})
endfunction()
