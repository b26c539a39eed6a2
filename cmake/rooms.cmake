# A room is a folder of sources and the library that they make. Its headers are seen by the rooms that
# name it in USES, and by those that name these: each room has an include folder of its own, with links
# to its headers, so that an include against the order of the rooms does not compile. Installed,
# the headers stand in one folder.
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
    $<BUILD_INTERFACE:${include}> $<INSTALL_INTERFACE:include/prs>)
  install(FILES ${headers} DESTINATION include/prs/${folder} COMPONENT development)
  string(REGEX REPLACE "^prs_" "" name ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  install(TARGETS ${target} EXPORT prs ARCHIVE DESTINATION lib/prs COMPONENT development)
endfunction()

# add_room(NAME FOLDER [USES ROOM..] [PUBLIC LIBRARY..] [PRIVATE LIBRARY..] [SOURCES ..]): the library
# prs_NAME of sources in prs/FOLDER, all that lie there unless they are named.
function(add_room name folder)
  cmake_parse_arguments(PARSE_ARGV 2 room "" "" "USES;PUBLIC;PRIVATE;SOURCES")
  list(TRANSFORM room_USES PREPEND prs_)
  list(TRANSFORM room_SOURCES PREPEND ${folder}/)
  if(NOT room_SOURCES)
    file(GLOB room_SOURCES RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} CONFIGURE_DEPENDS ${folder}/*.cpp)
  endif()
  string(REGEX REPLACE "/\\.$" "" path prs/${folder})
  add_library(prs_${name} STATIC ${room_SOURCES})
  target_link_libraries(prs_${name}
    PUBLIC $<BUILD_INTERFACE:prs_options> ${room_USES} ${room_PUBLIC}
    PRIVATE ${room_PRIVATE})
  share_headers(prs_${name} ${path})
  batch_sources(prs_${name})
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
    if(NOT type STREQUAL "STATIC_LIBRARY")
      list(REMOVE_ITEM found ${library})
    endif()
  endforeach()
  set(${result} ${found} PARENT_SCOPE)
endfunction()
