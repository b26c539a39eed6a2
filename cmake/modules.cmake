# Components whose library few runs need become modules: shared objects that the program loads when
# a run asks for them (prs/modules/module.h). PRS_WITH_<NAME>: ON, OFF or AUTO, where it is found.
macro(find_component name)
  set(PRS_WITH_${name} AUTO CACHE STRING "Build what needs ${name}: ON, OFF, or AUTO, where it is found")
  set_property(CACHE PRS_WITH_${name} PROPERTY STRINGS AUTO ON OFF)
  set(search QUIET)
  if(PRS_WITH_${name} STREQUAL "AUTO" OR PRS_WITH_${name})
    if(NOT PRS_WITH_${name} STREQUAL "AUTO")
      set(search REQUIRED)
    endif()
    if("${name}" STREQUAL "NETCDF")
      pkg_check_modules(NETCDF ${search} IMPORTED_TARGET netcdf)
    else()
      find_package(${ARGN} ${search})
    endif()
  endif()
endmacro()

# add_module(NAME SOURCE LIBRARY): the module prs_NAME.so, where there is a target LIBRARY.
function(add_module name source library)
  if(NOT TARGET ${library})
    message(STATUS "Without ${library}: prs_${name}.so is not built")
    return()
  endif()
  set(module prs_module_${name})
  add_library(${module} MODULE ${source})
  set_target_properties(${module} PROPERTIES
    PREFIX "" OUTPUT_NAME prs_${name} LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib/prs
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  target_link_libraries(${module} PRIVATE prs_options ${library})
  target_include_directories(${module} PRIVATE
    $<TARGET_PROPERTY:prs_modules,INCLUDE_DIRECTORIES>)
  if(NOT PRS_SANITIZE)
    target_link_options(${module} PRIVATE -Wl,--no-undefined)
  endif()
  # Whatever may load it finds it built.
  add_dependencies(prs_modules ${module})
  set_property(GLOBAL APPEND PROPERTY PRS_MODULES ${module})
endfunction()
