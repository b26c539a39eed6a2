# What all sources of the project are compiled with: `prs_options`; kernels, which are unrolled
# arithmetic, with its first part alone, since sanitizers would compile them in minutes.
add_library(prs_warnings INTERFACE)
add_library(prs_options INTERFACE)
target_link_libraries(prs_options INTERFACE prs_warnings)
target_compile_options(prs_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False alarms of GCC 12: on "literal" + std::string (bug 105651), on types of anonymous namespaces in
  # batches of sources, and in its own headers for AVX-512 (bug 105593).
  target_compile_options(prs_warnings INTERFACE -Wno-restrict $<$<COMPILE_LANGUAGE:CXX>:-Wno-subobject-linkage>)
  # Where there is memory, GCC need not look for what it could use again: a sixth of its time.
  cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY)  # MiB
  cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
  math(EXPR memory "${memory} / ${processors}")
  if(memory GREATER 3000)
    add_compile_options(--param=ggc-min-heapsize=2000000)  # KiB
  endif()
else()
  # As GCC has them: conversions without signs, shadows without fields of enclosing classes, unused
  # functions without those that another branch of `if constexpr` uses.
  target_compile_options(prs_warnings INTERFACE
    -Wno-sign-conversion -Wno-shadow -Wno-unneeded-internal-declaration)
endif()

if(PRS_SANITIZE)
  set(sanitizers $<IF:$<STREQUAL:${PRS_SANITIZE},thread>,thread,address$<COMMA>undefined>)
  target_compile_options(prs_options INTERFACE -fsanitize=${sanitizers} -fno-sanitize-recover=undefined
    # The address sanitizer finds most of these too; they take a third of the compiler's time.
    -fno-sanitize=null,alignment,object-size,vptr
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>  # False alarms together with sanitizers.
    $<$<CXX_COMPILER_ID:Clang>:-fsanitize-ignorelist=${PROJECT_SOURCE_DIR}/cmake/sanitizers.ignore>)
  target_link_options(prs_options INTERFACE -fsanitize=${sanitizers})
  # As in libraries that were compiled without sanitizers and hand Eigen's matrices over: pagmo.
  target_compile_definitions(prs_options INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
  if(PRS_SANITIZE STREQUAL "fuzzer")
    target_compile_options(prs_options INTERFACE
      -fsanitize=fuzzer-no-link -fprofile-instr-generate -fcoverage-mapping)
    target_link_options(prs_options INTERFACE -fprofile-instr-generate)
  endif()
elseif(NOT EMSCRIPTEN AND CMAKE_BUILD_TYPE MATCHES "Rel")
  # Guards against hostile files: sizes of what library functions write, returns of functions, tables
  # of addresses that are written once.
  target_compile_options(prs_options INTERFACE -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3 -fstack-protector-strong
    $<$<STREQUAL:${CMAKE_SYSTEM_PROCESSOR},x86_64>:-fcf-protection>)
  target_link_options(prs_options INTERFACE -Wl,-z,relro,-z,now)
endif()
