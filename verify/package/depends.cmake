# Read by cpack: which packages hold the libraries that gpf is linked with. CPack's own search calls file(1) for each of
# the hundreds of installed files.
find_program(shlibdeps dpkg-shlibdeps REQUIRED)
set(folder ${CPACK_PACKAGE_DIRECTORY}/depends)
file(WRITE ${folder}/debian/control "Source: gpf\n\nPackage: gpf\nArchitecture: any\n")
execute_process(COMMAND ${shlibdeps} -O ${CPACK_GPF_PROGRAM} WORKING_DIRECTORY ${folder}
                OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
string(REPLACE "shlibs:Depends=" "" CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${found}")
