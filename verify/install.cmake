# Installs the program, its references, and the manual pages and completion that it writes of itself.
find_program(GPF_GZIP gzip REQUIRED)
set(pages ${CMAKE_CURRENT_BINARY_DIR}/pages)
string(TIMESTAMP today "%Y-%m-%d" UTC)  # or of SOURCE_DATE_EPOCH
file(GLOB claims CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/reference/claims/*.toml)
add_custom_command(OUTPUT ${pages}/bash/gpf
  COMMAND ${CMAKE_COMMAND} -E rm -rf ${pages}
  COMMAND gpf pages ${pages} --date ${today} --reference ${PROJECT_SOURCE_DIR}/reference
  COMMAND sh -c "${GPF_GZIP} -9n pages/man/*"
  COMMAND ${CMAKE_COMMAND} -E touch ${pages}/bash/gpf
  DEPENDS gpf ${claims} WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} VERBATIM)
add_custom_target(gpf_pages ALL DEPENDS ${pages}/bash/gpf)

if(TARGET gpf_simulate_x86-64-v3)
  file(RELATIVE_PATH levels_from_program ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR}/gpf)
  set_target_properties(gpf PROPERTIES INSTALL_RPATH "$ORIGIN/${levels_from_program}")
  install(TARGETS gpf_simulate LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/gpf COMPONENT program)
  foreach(level IN ITEMS x86-64-v3 x86-64-v4)
    install(TARGETS gpf_simulate_${level} COMPONENT program
            LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/gpf/glibc-hwcaps/${level})
  endforeach()
endif()
install(TARGETS gpf RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/reference/ DESTINATION ${CMAKE_INSTALL_DATADIR}/gpf/reference COMPONENT program)
install(DIRECTORY ${pages}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${pages}/bash/gpf DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
install(FILES ${pages}/fish/gpf.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)
install(FILES ${pages}/zsh/_gpf DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
