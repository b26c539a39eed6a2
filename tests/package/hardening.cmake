# The PROGRAMS lie at an address of chance, their tables of addresses cannot be written, and functions
# of theirs check returns and the sizes of what they write.
string(REPLACE "," ";" PROGRAMS "${PROGRAMS}")
foreach(program IN LISTS PROGRAMS)
  execute_process(COMMAND ${READELF} --wide --file-header --program-headers --dynamic --dyn-syms ${program}
    OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  foreach(guard IN ITEMS "Type: +DYN" "GNU_RELRO" "BIND_NOW|FLAGS_1.*NOW" "__stack_chk_fail" "__[a-z]+_chk@")
    if(NOT text MATCHES "${guard}")
      message(SEND_ERROR "${program}: readelf shows nothing like ${guard}")
    endif()
  endforeach()
endforeach()
