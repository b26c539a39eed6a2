# ccache, where it is installed. Objects of other build folders of this source tree count as well:
# neither names below the build folder nor debug information say where that folder lies. Sources
# with precompiled headers are kept only with this sloppiness.
find_program(PRS_CCACHE ccache)
if(PRS_CCACHE AND PROJECT_IS_TOP_LEVEL AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
    ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_BINARY_DIR}
    CCACHE_SLOPPINESS=pch_defines,time_macros ${PRS_CCACHE})
  target_compile_options(prs_options INTERFACE -fdebug-prefix-map=${PROJECT_BINARY_DIR}=.)
endif()
