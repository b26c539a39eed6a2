# The files of the live page as bytes of the program: templates, style, scripts, and the engine where
# it is shipped. Without it pages are for reading alone.
set(folder ${PROJECT_SOURCE_DIR}/prs/page/live)
set(loader ${PROJECT_SOURCE_DIR}/prs/engine/engine.js)
set(engine ${PROJECT_SOURCE_DIR}/prs/engine/engine.wasm.lzma)
if(NOT EXISTS ${engine} OR NOT EXISTS ${loader})
  set(loader ${PROJECT_BINARY_DIR}/prs/no_engine)
  set(engine ${loader})
  file(WRITE ${engine} "")
endif()
file(GLOB resources CONFIGURE_DEPENDS ${folder}/*)
set_source_files_properties(page/page.cpp PROPERTIES
  SKIP_UNITY_BUILD_INCLUSION ON
  OBJECT_DEPENDS "${resources};${loader};${engine}"
  COMPILE_DEFINITIONS "PRS_PAGE_FOLDER=\"${folder}\";PRS_PAGE_LOADER=\"${loader}\";PRS_PAGE_ENGINE=\"${engine}\"")
