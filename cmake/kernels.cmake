# add_simd_kernel(TARGET SOURCE): compiles SOURCE once for each instruction set of simd/architectures.h,
# with PRS_SIMD_ARCHITECTURE naming it, and adds the objects to TARGET.
set(PRS_ARCHITECTURES Baseline)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
  list(APPEND PRS_ARCHITECTURES Avx2 Avx512)
endif()
set(PRS_FLAGS_Avx2 -mavx2 -mfma)
set(PRS_FLAGS_Avx512
  -mavx512f -mavx512cd -mavx512dq -mavx512bw -mavx2 -mfma -mprefer-vector-width=512)

function(add_simd_kernel target source)
  cmake_path(GET source STEM name)
  foreach(architecture IN LISTS PRS_ARCHITECTURES)
    set(library ${target}_${name}_${architecture})
    add_library(${library} OBJECT ${source})
    target_link_libraries(${library} PRIVATE prs_warnings Eigen3::Eigen Boost::headers)
    target_compile_definitions(${library} PRIVATE PRS_SIMD_ARCHITECTURE=simd::${architecture})
    target_compile_options(${library} PRIVATE ${PRS_FLAGS_${architecture}}
      $<$<CONFIG:Debug>:-O3> $<$<CXX_COMPILER_ID:GNU>:-Wno-uninitialized;-Wno-maybe-uninitialized>)
    target_sources(${target} PRIVATE $<TARGET_OBJECTS:${library}>)
  endforeach()
endfunction()
