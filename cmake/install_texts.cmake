# At installation: manual pages and completions, which the program itself writes (`prs`).
set(share "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share")
message(STATUS "Installing: ${share}/man/man1, completions of shells")
execute_process(COMMAND ${prs} manual --output ${share}/man/man1 COMMAND_ERROR_IS_FATAL ANY)
file(GLOB pages ${share}/man/man1/prs*.1)
execute_process(COMMAND gzip -9nf ${pages} COMMAND_ERROR_IS_FATAL ANY)
set(zsh zsh/site-functions)
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  set(zsh zsh/vendor-completions)  # Debian's, for packages.
endif()
foreach(shell IN ITEMS bash:bash-completion/completions/prs zsh:${zsh}/_prs
        fish:fish/vendor_completions.d/prs.fish)
  string(REGEX MATCH "^(.*):(.*)$" _ ${shell})
  cmake_path(GET CMAKE_MATCH_2 PARENT_PATH folder)
  file(MAKE_DIRECTORY ${share}/${folder})
  execute_process(COMMAND ${prs} completion ${CMAKE_MATCH_1}
    OUTPUT_FILE ${share}/${CMAKE_MATCH_2} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
