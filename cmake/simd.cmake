# Compiles a kernel's source once for each instruction set of simd/architectures.h, with
# PRS_SIMD_ARCHITECTURE naming it, and adds the objects to TARGET. UNROLLED: the source consists of
# unrolled arithmetic, which compilers instrument, or optimise a little, in minutes only: it is
# compiled alike in all builds, without sanitizers.
function(add_simd_kernel target source)
  cmake_parse_arguments(PARSE_ARGV 2 kernel "UNROLLED" "" "")
  set(architectures Baseline)
  set(flags_Baseline "")
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND architectures Avx2 Avx512)
    set(flags_Avx2 -mavx2 -mfma)
    set(flags_Avx512 -mavx512f -mavx512cd -mavx512dq -mavx512bw -mavx2 -mfma -mprefer-vector-width=512)
  endif()
  get_filename_component(name ${source} NAME_WE)
  if(kernel_UNROLLED)
    # Options of a source come after those of its target, and win.
    set_source_files_properties(${source} PROPERTIES COMPILE_OPTIONS "-O3;-g0;-fno-sanitize=all")
  endif()
  foreach(architecture IN LISTS architectures)
    set(library ${target}_${name}_${architecture})
    add_library(${library} OBJECT ${source})
    target_link_libraries(${library} PRIVATE prs_options)
    target_compile_definitions(${library} PRIVATE PRS_SIMD_ARCHITECTURE=simd::${architecture})
    target_compile_options(${library} PRIVATE ${flags_${architecture}})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
      # False alarms in GCC's own AVX-512 headers (GCC bug 105593).
      target_compile_options(${library} PRIVATE -Wno-uninitialized -Wno-maybe-uninitialized)
    endif()
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${library}>)
  endforeach()
endfunction()
