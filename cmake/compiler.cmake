# The oldest compilers that were tried.
foreach(compiler IN ITEMS GNU=12 Clang=14)
  string(REPLACE "=" ";" compiler ${compiler})
  list(POP_FRONT compiler name oldest)
  if(CMAKE_CXX_COMPILER_ID STREQUAL name AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS oldest)
    message(FATAL_ERROR "${CMAKE_CXX_COMPILER} is ${name} ${CMAKE_CXX_COMPILER_VERSION}; prs needs GCC 12, "
                        "Clang 14 or later. Name one by -DCMAKE_CXX_COMPILER=.., in a new build folder.")
  endif()
endforeach()

# Where there is memory, GCC need not look for what it could use again: a sixth of its time.
cmake_host_system_information(RESULT memory QUERY TOTAL_PHYSICAL_MEMORY)  # MiB
cmake_host_system_information(RESULT processors QUERY NUMBER_OF_LOGICAL_CORES)
math(EXPR memory "${memory} / ${processors}")
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND memory GREATER 3000)
  add_compile_options(--param=ggc-min-heapsize=2000000)  # KiB
endif()

# Options of what reads and writes: it is compiled in half the time, and takes little of a run's. In live
# pages it is small.
set(PRS_HASTY -O1)
if(EMSCRIPTEN)
  set(PRS_HASTY -Os)
elseif(PRS_SANITIZE AND NOT PRS_FUZZ)
  set(PRS_HASTY -O0)
endif()

# Guards for what reads files and for the programs, where it is optimised: sizes of what library
# functions write, returns of functions, tables of addresses that are written once. What computes
# only has none, and keeps its speed.
set(PRS_HARDENING "")
if(NOT PRS_SANITIZE AND NOT EMSCRIPTEN AND CMAKE_BUILD_TYPE MATCHES "Rel")
  set(PRS_HARDENING -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=3 -fstack-protector-strong)
  if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    list(APPEND PRS_HARDENING -fcf-protection)
  endif()
endif()

# harden(TARGET..): those guards.
function(harden)
  if(NOT PRS_HARDENING)
    return()
  endif()
  foreach(target IN LISTS ARGN)
    target_compile_options(${target} PRIVATE ${PRS_HARDENING})
    get_target_property(type ${target} TYPE)
    if(NOT type STREQUAL "STATIC_LIBRARY")
      target_link_options(${target} PRIVATE -Wl,-z,relro,-z,now)
    endif()
    if(type STREQUAL "EXECUTABLE")
      target_link_options(${target} PRIVATE -pie)
    endif()
  endforeach()
endfunction()
