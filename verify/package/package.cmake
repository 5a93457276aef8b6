# Debian packages: `gpf`, the program, and `libgpf-dev`, the library. For this machine only when GPF_NATIVE is ON.
set(GPF_PACKAGE_CONTACT "gpf maintainers <maintainers@gpf.invalid>" CACHE STRING
  "Who answers for the packages: name <address>")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "${GPF_PACKAGE_CONTACT}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulation of granular Poiseuille flow, and a judge of claims about it")
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
if(GPF_NATIVE)
  string(APPEND CPACK_PACKAGE_VERSION "+native")
endif()
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME gpf)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "Inelastic hard disks that gravity drives through a two-dimensional channel,
simulated event by event, and published claims about that flow, and the
simulation itself, judged against independent references.")
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_SOURCE_DIR}/verify/package/depends.cmake)
set(CPACK_GPF_PROGRAM ${PROJECT_BINARY_DIR}/verify/gpf)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS gnuplot-nox)  # the pictures of reports
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS ffmpeg)         # movies

# What gpf-config.cmake and gpf.pc look for.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libgpf-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libfftw3-dev, libfmt-dev, libgsl-dev, libhdf5-dev, nlohmann-json3-dev, pkg-config")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "Static libraries and headers of gpf: scenes, the event-driven engine,
measurements, other methods, theory, statistics and records; for development.")

string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)
set(package ${PROJECT_BINARY_DIR}/package)
file(CONFIGURE OUTPUT ${package}/changelog @ONLY CONTENT "gpf (@CPACK_PACKAGE_VERSION@) stable; urgency=medium

  * Built from source; what changed stands in CHANGELOG.md there.

 -- @GPF_PACKAGE_CONTACT@  @date@
")
file(COPY ${CMAKE_CURRENT_SOURCE_DIR}/verify/package/copyright DESTINATION ${package})
execute_process(COMMAND ${GPF_GZIP} -9nf changelog WORKING_DIRECTORY ${package} COMMAND_ERROR_IS_FATAL ANY)
install(FILES ${package}/copyright ${package}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/gpf COMPONENT program)
install(FILES ${package}/copyright ${package}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/libgpf-dev
  COMPONENT development)
include(CPack)
