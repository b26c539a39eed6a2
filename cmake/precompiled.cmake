# precompile_headers(KIND [OPTIONS ..] HEADERS ..): headers of libraries that most sources include,
# compiled once for all targets that have these options beyond those of every target. Other builds
# than those in batches are without: there a missing #include shows.
function(precompile_headers kind)
  cmake_parse_arguments(PARSE_ARGV 1 precompiled "" "" "OPTIONS;HEADERS")
  if(NOT PRS_UNITY_BUILD OR EMSCRIPTEN)
    return()
  endif()
  set(source ${PROJECT_BINARY_DIR}/precompiled/${kind}.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "")
  add_library(prs_precompiled_${kind} OBJECT EXCLUDE_FROM_ALL ${source})
  target_link_libraries(prs_precompiled_${kind} PRIVATE
    prs_options Eigen3::Eigen fmt::fmt nlohmann_json::nlohmann_json)
  target_compile_options(prs_precompiled_${kind} PRIVATE ${precompiled_OPTIONS})
  target_precompile_headers(prs_precompiled_${kind} PRIVATE ${precompiled_HEADERS})
endfunction()

# use_precompiled(KIND TARGET..): these include them first.
function(use_precompiled kind)
  if(NOT TARGET prs_precompiled_${kind})
    return()
  endif()
  foreach(target IN LISTS ARGN)
    target_link_libraries(${target} PRIVATE fmt::fmt)  # Whose macros belong to what was compiled.
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "EXECUTABLE")  # Compiled as libraries are.
      set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
      target_compile_options(${target} PRIVATE -fPIC)
    endif()
    target_precompile_headers(${target} REUSE_FROM prs_precompiled_${kind})
  endforeach()
endfunction()
