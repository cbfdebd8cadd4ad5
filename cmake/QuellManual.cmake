# The manual page and the completions of shells, printed by the tool itself, beside which they are installed.
if(CMAKE_CROSSCOMPILING)
  return()
endif()
set(QUELL_MANUAL_FILES "")

# quell_manual_file(name folder arguments...): what the tool prints when called so.
# Names that end in .gz are compressed.
function(quell_manual_file name folder)
  set(file ${PROJECT_BINARY_DIR}/manual/${name})
  set(compressed "")
  if(name MATCHES "\\.gz$")
    set(compressed | gzip -9n)
  endif()
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/manual)
  add_custom_command(OUTPUT ${file} COMMAND quell_tool ${ARGN} ${compressed} > ${file} DEPENDS quell_tool)
  install(FILES ${file} DESTINATION ${folder} COMPONENT tool)
  set(QUELL_MANUAL_FILES ${QUELL_MANUAL_FILES} ${file} PARENT_SCOPE)
endfunction()

set(manual quell.1)
if(QUELL_PACKAGE)
  set(manual quell.1.gz)
endif()
quell_manual_file(${manual} ${CMAKE_INSTALL_MANDIR}/man1 man)
quell_manual_file(quell ${CMAKE_INSTALL_DATADIR}/bash-completion/completions completion bash)
quell_manual_file(_quell ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions completion zsh)
quell_manual_file(quell.fish ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d completion fish)
add_custom_target(quell_manual ALL DEPENDS ${QUELL_MANUAL_FILES})
