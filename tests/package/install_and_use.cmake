# Installs the build, moves it, uses its programs in a folder of their own, builds the project beside
# this file on it, and compares its answer with that of the installed program; builds the examples,
# which print what their last lines say.
set(folder ${BUILD}/tests/package)
set(case ${CMAKE_CURRENT_LIST_DIR}/../../configs/01_config_1_to_3.yaml)
function(run output)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY ${folder} OUTPUT_VARIABLE text ERROR_VARIABLE error RESULT_VARIABLE status)
  if(status)
    message(FATAL_ERROR "${ARGN}: ${status}\n${text}${error}")
  endif()
  set(${output} "${text}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${folder})
file(MAKE_DIRECTORY ${folder})
foreach(component program development)
  run(_ ${CMAKE_COMMAND} --install ${BUILD} --prefix ${folder}/prefix --component ${component})
endforeach()
# Found wherever it is moved.
file(RENAME ${folder}/prefix ${folder}/moved)
set(prs ${folder}/moved/bin/prs)

# Of the validation data that are found, a quick source is enough.
file(GLOB sources ${folder}/moved/share/prs/validation/*)
list(FILTER sources EXCLUDE REGEX sandu_2018)
file(REMOVE_RECURSE ${sources})
run(validated ${prs} validate --json)
string(JSON source GET "${validated}" sources 0 name)
if(NOT source STREQUAL sandu_2018)
  message(FATAL_ERROR "validated ${source}")
endif()

run(_ ${prs} new --lesson 14 lesson.yaml)
run(commands ${prs} list commands lesson.yaml)
if(NOT commands MATCHES "life")
  message(FATAL_ERROR "lesson 14 has all for ${commands}")
endif()

foreach(text man/man1/prs.1.gz man/man1/prs-solve.1.gz bash-completion/completions/prs
        zsh/site-functions/_prs fish/vendor_completions.d/prs.fish)
  file(SIZE ${folder}/moved/share/${text} size)
  if(size EQUAL 0)
    message(FATAL_ERROR "${text} is empty")
  endif()
endforeach()

run(_ ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR} -B ${folder}/build -G ${GENERATOR}
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=-O0 -D CMAKE_PREFIX_PATH=${folder}/moved)
run(_ ${CMAKE_COMMAND} --build ${folder}/build)
run(by_library ${folder}/build/package ${case})
run(by_program ${prs} solve ${case} --json)
string(JSON by_library GET "${by_library}" load_cases)
string(JSON by_program GET "${by_program}" load_cases)
if(NOT by_library STREQUAL by_program)
  message(FATAL_ERROR "the library solved ${by_library}\nthe program ${by_program}")
endif()

set(examples ${CMAKE_CURRENT_LIST_DIR}/../../examples)
run(_ ${CMAKE_COMMAND} -S ${examples} -B ${folder}/examples -G ${GENERATOR}
  -D CMAKE_CXX_COMPILER=${COMPILER} -D CMAKE_CXX_FLAGS=-O0 -D CMAKE_PREFIX_PATH=${folder}/moved)
run(_ ${CMAKE_COMMAND} --build ${folder}/examples)
file(GLOB sources ${examples}/*.cpp)
foreach(source IN LISTS sources)
  cmake_path(GET source STEM example)
  run(printed ${folder}/examples/${example} ${folder}/moved/share/prs/lessons/05_standard_screw.yaml)
  file(READ ${source} text)
  string(REGEX REPLACE "\n$" "" printed "//     ${printed}")
  string(REPLACE "\n" "\n//     " printed "${printed}")
  string(REPLACE "//     \n" "//\n" printed "${printed}")
  string(FIND "${text}" "\n// Prints:\n//\n${printed}" place)
  if(place EQUAL -1)
    message(FATAL_ERROR "${source} prints\n${printed}")
  endif()
endforeach()
