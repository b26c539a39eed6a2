# The files of the live page as bytes of the program: style, scripts, and the engine where it is
# shipped. Without it pages are for reading alone.
set(PRS_PAGE_STYLE ${PROJECT_SOURCE_DIR}/prs/page/live/page.css)
set(PRS_PAGE_SCRIPT ${PROJECT_SOURCE_DIR}/prs/page/live/page.js)
set(PRS_PAGE_WORKER ${PROJECT_SOURCE_DIR}/prs/page/live/worker.js)
set(PRS_PAGE_LOADER ${PROJECT_SOURCE_DIR}/prs/engine/engine.js)
set(PRS_PAGE_ENGINE ${PROJECT_SOURCE_DIR}/prs/engine/engine.wasm.gz)
if(NOT EXISTS ${PRS_PAGE_ENGINE} OR NOT EXISTS ${PRS_PAGE_LOADER})
  set(PRS_PAGE_LOADER ${PROJECT_BINARY_DIR}/prs/no_engine)
  set(PRS_PAGE_ENGINE ${PRS_PAGE_LOADER})
  file(WRITE ${PRS_PAGE_ENGINE} "")
endif()
set(resources ${PROJECT_BINARY_DIR}/prs/page_resources.cpp)
configure_file(${PROJECT_SOURCE_DIR}/prs/page/resources.cpp.in ${resources} @ONLY)
set_source_files_properties(${resources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON
  OBJECT_DEPENDS "${PRS_PAGE_STYLE};${PRS_PAGE_SCRIPT};${PRS_PAGE_WORKER};${PRS_PAGE_LOADER};${PRS_PAGE_ENGINE}")
target_sources(prs_page PRIVATE ${resources})
