# Compiles a kernel's source once for each instruction set of simd/architectures.h, with
# PRS_SIMD_ARCHITECTURE naming it, and adds the objects to TARGET. UNROLLED: the source consists of
# unrolled arithmetic, which compilers instrument, or optimise a little, in minutes only: it is
# compiled without sanitizers, and taken from PRS_COMPILED_FROM where that is given. `unroll_kernels`
# makes the rest of its options those of a release. WIDE_FROM_THERE: wider batches than the baseline's
# are taken from there too; tests run the baseline's.
function(add_simd_kernel target source)
  cmake_parse_arguments(PARSE_ARGV 2 kernel "UNROLLED;WIDE_FROM_THERE" "" "")
  set(architectures Baseline)
  set(flags_Baseline "")
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND architectures Avx2 Avx512)
    set(flags_Avx2 -mavx2 -mfma)
    set(flags_Avx512 -mavx512f -mavx512cd -mavx512dq -mavx512bw -mavx2 -mfma -mprefer-vector-width=512)
  endif()
  get_filename_component(name ${source} NAME_WE)
  set(options prs_options)
  if(kernel_UNROLLED)
    set(options prs_warnings)
  endif()
  foreach(architecture IN LISTS architectures)
    set(library ${target}_${name}_${architecture})
    set(from_there ${kernel_UNROLLED})
    if(kernel_WIDE_FROM_THERE AND NOT architecture STREQUAL "Baseline")
      set(from_there TRUE)
    endif()
    if(from_there AND PRS_COMPILED_FROM)
      set_property(GLOBAL APPEND PROPERTY PRS_KERNELS_FROM_THERE ${library})
      file(RELATIVE_PATH folder ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR})
      target_sources(${target} PRIVATE
        ${PRS_COMPILED_FROM}/${folder}/CMakeFiles/${library}.dir/${source}${CMAKE_CXX_OUTPUT_EXTENSION})
      continue()
    endif()
    add_library(${library} OBJECT ${source})
    target_link_libraries(${library} PRIVATE ${options})
    target_include_directories(${library} PRIVATE
      $<TARGET_PROPERTY:${target},INCLUDE_DIRECTORIES>)
    target_compile_definitions(${library} PRIVATE PRS_SIMD_ARCHITECTURE=simd::${architecture})
    target_compile_options(${library} PRIVATE ${flags_${architecture}})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      # False alarms in GCC's own AVX-512 headers (GCC bug 105593).
      target_compile_options(${library} PRIVATE -Wno-uninitialized -Wno-maybe-uninitialized)
    endif()
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${library}>)
  endforeach()
endfunction()

# In a folder of kernels: its sources are compiled alike in all builds.
macro(unroll_kernels)
  foreach(config DEBUG RELWITHDEBINFO MINSIZEREL)
    set(CMAKE_CXX_FLAGS_${config} "${CMAKE_CXX_FLAGS_RELEASE}")
  endforeach()
endmacro()
