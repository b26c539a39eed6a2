# What all sources are compiled with: `prs_options`; kernels with `prs_warnings` alone, since sanitizers would compile
# unrolled arithmetic in minutes.
add_library(prs_warnings INTERFACE)
target_include_directories(prs_warnings INTERFACE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include)
add_library(prs_options INTERFACE)
target_link_libraries(prs_options INTERFACE prs_warnings)
target_compile_options(prs_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # False alarms of GCC 12: on "literal" + std::string (bug 105651), on types of anonymous namespaces in batches; of
  # GCC 13: on references into another argument than the temporary one (bug 107532).
  target_compile_options(prs_warnings INTERFACE
    -Wno-restrict $<$<COMPILE_LANGUAGE:CXX>:-Wno-subobject-linkage;-Wno-dangling-reference>)
  # Where there is memory, GCC need not look for memory to reuse: a sixth of its time.
  cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY)  # MiB
  cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
  math(EXPR memory "${memory} / ${processors}")
  if(memory GREATER 3000)
    add_compile_options(--param=ggc-min-heapsize=2000000)  # KiB
  endif()
else()  # What GCC means by these warnings.
  target_compile_options(prs_warnings INTERFACE -Wno-sign-conversion -Wno-shadow -Wno-unneeded-internal-declaration)
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
    target_compile_options(prs_options INTERFACE -fsanitize=fuzzer-no-link)
  endif()
endif()

# Guards of what reads files, against hostile ones: sizes that library functions write, returns, tables of addresses.
# What computes has none, and keeps its speed.
add_library(prs_guards INTERFACE)
if(NOT PRS_SANITIZE AND NOT EMSCRIPTEN AND CMAKE_BUILD_TYPE MATCHES "Rel")
  target_compile_options(prs_guards INTERFACE -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3 -fstack-protector-strong
    $<$<STREQUAL:${CMAKE_SYSTEM_PROCESSOR},x86_64>:-fcf-protection>)
  target_link_options(prs_guards INTERFACE -Wl,-z,relro,-z,now)
endif()

# batch_by_folder(TARGET..): unity builds in batches of at most 12 sources of one folder, in which names of anonymous
# namespaces differ (scripts/check_rooms.py).
function(batch_by_folder)
  foreach(target IN LISTS ARGN)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
      cmake_path(GET source PARENT_PATH folder)
      math(EXPR batch "0${count_${folder}} / 12")
      math(EXPR count_${folder} "0${count_${folder}} + 1")
      string(MAKE_C_IDENTIFIER "${folder}_${batch}" batch)
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${batch})
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  endforeach()
endfunction()
