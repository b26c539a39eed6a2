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

# add_room(NAME FOLDER [USES ROOM..] [PUBLIC LIBRARY..] [PRIVATE LIBRARY..] SOURCES ..): the library
# prs_NAME of sources below prs/FOLDER.
function(add_room name folder)
  cmake_parse_arguments(PARSE_ARGV 2 room "" "" "USES;PUBLIC;PRIVATE;SOURCES")
  list(TRANSFORM room_USES PREPEND prs_)
  set(path prs/${folder})
  if(folder STREQUAL ".")
    set(path prs)
  else()
    list(TRANSFORM room_SOURCES PREPEND ${folder}/)
  endif()
  add_library(prs_${name} STATIC ${room_SOURCES})
  target_link_libraries(prs_${name}
    PUBLIC $<BUILD_INTERFACE:prs_options> ${room_USES} ${room_PUBLIC}
    PRIVATE ${room_PRIVATE})
  share_headers(prs_${name} ${path})
  batch_sources(prs_${name})
endfunction()
