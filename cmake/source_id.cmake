# Writes OUTPUT: the hash of all sources that live pages are made of, of their names and contents. The program
# and the engine of pages that scripts/web.sh builds both have it: a page takes an engine of the same sources
# alone. `cmake -D OUTPUT=FILE -P cmake/source_id.cmake`; an unchanged file is not touched.
cmake_minimum_required(VERSION 3.25)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
foreach(folder IN ITEMS contact fe modules prs simd validation/standard_screws wasm web/src)
  foreach(kind IN ITEMS h c cpp css csv html in js jsx txt xml yaml)
    list(APPEND patterns ${root}/${folder}/*.${kind})
  endforeach()
endforeach()
file(GLOB_RECURSE sources RELATIVE ${root} ${patterns})
list(FILTER sources EXCLUDE REGEX "^prs/cli/")  # Words of the terminal, which no page has.
set(content "")
foreach(source IN LISTS sources ITEMS cmake/webassembly.cmake web/build.mjs web/package-lock.json)
  file(SHA256 ${root}/${source} hash)
  string(APPEND content "${hash} ${source}\n")
endforeach()
string(SHA256 id "${content}")
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "${id}")
