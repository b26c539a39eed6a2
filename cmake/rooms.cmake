# A room is a folder of sources and the library that they make. Its headers are seen by the rooms that
# name it in USES, and by those that name these: each room has an include folder of its own, with links
# to its headers, so that an include against the order of the rooms does not compile. Which headers are
# installed: install_headers.cmake.
function(share_headers target folder)
  get_target_property(type ${target} TYPE)
  set(scope PUBLIC)
  if(type STREQUAL "INTERFACE_LIBRARY")
    set(scope INTERFACE)
  endif()
  file(GLOB headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/*.h)
  set(include ${PROJECT_BINARY_DIR}/rooms/${target})
  file(MAKE_DIRECTORY ${include}/${folder})
  foreach(header IN LISTS headers)
    cmake_path(GET header FILENAME name)
    file(CREATE_LINK ${header} ${include}/${folder}/${name} SYMBOLIC)
  endforeach()
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${include}> "$<INSTALL_INTERFACE:include;include/prs/detail>")
  install_room(${target})
endfunction()

function(install_room target)
  string(REGEX REPLACE "^prs_" "" name ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT prs ARCHIVE DESTINATION lib/prs COMPONENT development)
endfunction()

# Sources that show a result: its record, tables, files and pictures, and the object of the analysis.
set(PRS_SHOWN "_(record|json|table|csv|netcdf|columns|files|figures|pictures|parts|case|analysis)\\.cpp$")

# add_room(NAME FOLDER [USES ROOM..] [PUBLIC LIBRARY..] [PRIVATE LIBRARY..] [SHOWN ROOM..]
# [SOURCES ..]): the library prs_NAME of sources in prs/FOLDER, all that lie there unless they are
# named. With SHOWN, what shows the results is a library of its own, prs_NAME_shown, which sees the
# rooms of SHOWN as well.
function(add_room name folder)
  cmake_parse_arguments(PARSE_ARGV 2 room "" "" "USES;PUBLIC;PRIVATE;SHOWN;SOURCES")
  list(TRANSFORM room_USES PREPEND prs_)
  list(TRANSFORM room_SHOWN PREPEND prs_)
  list(TRANSFORM room_SOURCES PREPEND ${folder}/)
  cmake_path(SET path NORMALIZE prs/${folder}/)
  string(REGEX REPLACE "/$" "" path ${path})
  if(name IN_LIST PRS_ROOMS_OF_HEADERS)
    add_library(prs_${name} INTERFACE)
    target_link_libraries(prs_${name} INTERFACE ${room_USES} ${room_PUBLIC})
    share_headers(prs_${name} ${path})
    if(room_SHOWN)
      add_library(prs_${name}_shown INTERFACE)
      target_link_libraries(prs_${name}_shown INTERFACE prs_${name} ${room_SHOWN})
    endif()
    return()
  endif()
  if(NOT room_SOURCES)
    file(GLOB room_SOURCES RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS ${folder}/*.cpp)
  endif()
  if(room_SHOWN)
    set(shown ${room_SOURCES})
    list(FILTER shown INCLUDE REGEX ${PRS_SHOWN})
    list(FILTER room_SOURCES EXCLUDE REGEX ${PRS_SHOWN})
    add_library(prs_${name}_shown STATIC ${shown})
    target_link_libraries(prs_${name}_shown
      PUBLIC $<BUILD_INTERFACE:prs_options> prs_${name} ${room_SHOWN}
      PRIVATE ${room_PRIVATE})
    install_room(prs_${name}_shown)
    batch_sources(prs_${name}_shown)
  endif()
  add_library(prs_${name} STATIC ${room_SOURCES})
  target_link_libraries(prs_${name}
    PUBLIC $<BUILD_INTERFACE:prs_options> ${room_USES} ${room_PUBLIC}
    PRIVATE ${room_PRIVATE})
  share_headers(prs_${name} ${path})
  batch_sources(prs_${name})
endfunction()

# compile_only(ROOM..): of the program's libraries, compiles these alone in this build, and links the
# archives of PRS_COMPILED_FROM for the others, which stay as targets without sources. To be called after
# all sources are known.
function(compile_only)
  list(TRANSFORM ARGN PREPEND prs_ OUTPUT_VARIABLE here)
  project_libraries(libraries prs::prs)
  foreach(library IN LISTS here)
    if(NOT library IN_LIST libraries)
      string(REPLACE "prs_" "" room ${library})
      message(FATAL_ERROR "PRS_COMPILE_ONLY: got \"${room}\"; expected rooms of prs/CMakeLists.txt, such as model;input")
    endif()
  endforeach()
  list(REMOVE_ITEM libraries ${here})
  set(nothing ${PROJECT_BINARY_DIR}/nothing.cpp)
  file(CONFIGURE OUTPUT ${nothing} CONTENT "")
  set(archives "")
  foreach(library IN LISTS libraries)
    get_target_property(folder ${library} BINARY_DIR)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_BINARY_DIR})
    set(archive ${PRS_COMPILED_FROM}/${folder}/lib${library}.a)
    list(APPEND archives ${archive})
    get_target_property(uses ${library} INTERFACE_LINK_LIBRARIES)
    add_library(${library}_archive STATIC IMPORTED GLOBAL)
    set_target_properties(${library}_archive PROPERTIES
      IMPORTED_LOCATION ${archive} INTERFACE_LINK_LIBRARIES "${uses}")
    set_target_properties(${library} PROPERTIES
      SOURCES ${nothing} UNITY_BUILD OFF DISABLE_PRECOMPILE_HEADERS ON)
    target_link_libraries(${library} PUBLIC ${library}_archive)
    add_dependencies(${library} compiled_archives)
  endforeach()
  # Up to date before they are linked, and the modules before they are copied.
  add_custom_target(compiled_archives BYPRODUCTS ${archives} USES_TERMINAL
    COMMAND ${CMAKE_COMMAND} --build ${PRS_COMPILED_FROM} --target prs prs-validate)
endfunction()

# project_libraries(RESULT TARGET..): the targets and what they link, as far as this project builds
# it and it has objects.
function(project_libraries result)
  set(waiting ${ARGN})
  set(found "")
  while(waiting)
    list(POP_FRONT waiting library)
    string(REGEX REPLACE "^\\$<LINK_ONLY:(.*)>$" "\\1" library "${library}")
    string(REPLACE "::" "_" library "${library}")
    if(NOT library MATCHES "^prs_" OR NOT TARGET ${library} OR library IN_LIST found)
      continue()
    endif()
    list(APPEND found ${library})
    get_target_property(more ${library} INTERFACE_LINK_LIBRARIES)
    if(more)
      list(APPEND waiting ${more})
    endif()
  endwhile()
  foreach(library IN LISTS found)
    get_target_property(type ${library} TYPE)
    get_target_property(imported ${library} IMPORTED)
    if(imported OR NOT type STREQUAL "STATIC_LIBRARY")
      list(REMOVE_ITEM found ${library})
    endif()
  endforeach()
  set(${result} ${found} PARENT_SCOPE)
endfunction()
