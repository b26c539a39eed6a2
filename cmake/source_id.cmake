# Writes OUTPUT: the hash of all sources that live pages are made of, of their names and contents. The program and
# the engine that scripts/web.sh builds both have it: a page takes an engine of the same sources alone.
cmake_minimum_required(VERSION 3.25)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
foreach(folder IN ITEMS contact fe modules prs simd validation/standard_screws wasm web/src)
  file(GLOB_RECURSE files RELATIVE ${root} ${root}/${folder}/*.*)
  list(APPEND sources ${files})
endforeach()
list(FILTER sources EXCLUDE REGEX "^prs/cli/|\\.md$|CMakeLists")  # Words of the terminal, which no page has.
foreach(source IN LISTS sources ITEMS docs/glossary.md cmake/webassembly.cmake web/build.mjs web/package-lock.json)
  file(SHA256 ${root}/${source} hash)
  string(APPEND content "${hash} ${source}\n")
endforeach()
string(SHA256 id "${content}")
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "${id}")
