# Libraries of at least those versions that were tried, Debian 12's. What few runs need becomes a module,
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
  set(name ${CMAKE_MATCH_1})
  set(oldest ${CMAKE_MATCH_2})
  find_package(${name} REQUIRED)  # Some refuse to be asked for a version older than their own.
  if(${name}_VERSION AND ${name}_VERSION VERSION_LESS oldest)
    message(FATAL_ERROR "${name}: found version ${${name}_VERSION}; install ${oldest} or later")
  endif()
endforeach()
find_package(PkgConfig REQUIRED)
pkg_check_modules(NETTLE REQUIRED IMPORTED_TARGET nettle>=3.8)

# find_plain(TARGET HEADER LIBRARY PACKAGE [REQUIRED]): the imported TARGET of a library that brings no
# package for CMake; PACKAGE is Debian's.
function(find_plain target header library package)
  find_path(${library}_INCLUDE_DIR ${header} PATH_SUFFIXES suitesparse)
  find_library(${library}_LIBRARY ${library})
  if(${library}_INCLUDE_DIR AND ${library}_LIBRARY)
    add_library(${target} INTERFACE IMPORTED GLOBAL)
    target_include_directories(${target} SYSTEM INTERFACE ${${library}_INCLUDE_DIR})
    target_link_libraries(${target} INTERFACE ${${library}_LIBRARY})
  elseif("REQUIRED" IN_LIST ARGN)
    message(FATAL_ERROR "${library}: no ${header} or no library; install ${package}")
  endif()
endfunction()
find_plain(csv::csv csv.h csv libcsv-dev REQUIRED)
if(PRS_CHOLMOD)
  find_plain(cholmod::cholmod cholmod.h cholmod libsuitesparse-dev REQUIRED)
endif()

if(PRS_FULL)
  find_package(MPI QUIET COMPONENTS C)
  find_package(Pagmo QUIET)
  find_package(TBB QUIET)
  find_package(Ceres QUIET)
  pkg_check_modules(NETCDF QUIET IMPORTED_TARGET netcdf>=4.9)
  pkg_check_modules(RSVG QUIET IMPORTED_TARGET librsvg-2.0>=2.54)
  find_plain(SUNDIALS::cvode cvode/cvode.h sundials_cvode libsundials-dev)  # With its vectors and solvers.
  find_library(SUNDIALS_CORE sundials_core)  # Since version 7, which Debian builds with MPI.
  if(TARGET SUNDIALS::cvode AND SUNDIALS_CORE)
    target_link_libraries(SUNDIALS::cvode INTERFACE ${SUNDIALS_CORE} $<TARGET_NAME_IF_EXISTS:MPI::MPI_C>)
  endif()
endif()

# add_module(NAME LIBRARY PACKAGE SOURCE..): the module prs_NAME.so, where there is a target LIBRARY.
function(add_module name library package)
  if(NOT TARGET ${library})
    set_property(GLOBAL APPEND PROPERTY PRS_MODULES_TABLE "prs_${name}.so   not built: install ${package}")
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY PRS_MODULES_TABLE "prs_${name}.so   built with ${library}")
  set(module prs_module_${name})
  add_library(${module} MODULE ${ARGN})
  set_target_properties(${module} PROPERTIES
    PREFIX "" OUTPUT_NAME prs_${name} LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib/prs
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_link_libraries(${module} PRIVATE prs_options ${library} fmt::fmt Eigen3::Eigen)
  target_compile_definitions(${module} PRIVATE PRS_VERSION="${PROJECT_VERSION}")
  add_dependencies(prs_modules ${module})  # Whatever may load it finds it built.
  set_property(GLOBAL APPEND PROPERTY PRS_MODULES ${module})
endfunction()
