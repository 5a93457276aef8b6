# Installs the layers and their headers so that find_package(gpf CONFIG) and pkg-config work from another project.
include(CMakePackageConfigHelpers)

get_property(layers GLOBAL PROPERTY GPF_LAYERS)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/gpf)

install(TARGETS ${layers} EXPORT gpf ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(DIRECTORY gpf/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gpf COMPONENT development FILES_MATCHING PATTERN "*.hpp")
install(EXPORT gpf NAMESPACE gpf:: FILE gpf-targets.cmake DESTINATION ${package_folder} COMPONENT development)

configure_package_config_file(gpf-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/gpf-config.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/gpf-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/gpf-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/gpf-config-version.cmake
  DESTINATION ${package_folder} COMPONENT development)

# For pkg-config: what is compiled, an archive before those that it needs, as the linker wants it.
set(archives "")
foreach(layer IN LISTS layers)
  get_target_property(type ${layer} TYPE)
  if(type STREQUAL STATIC_LIBRARY)
    string(PREPEND archives " -l${layer}")
  endif()
endforeach()
file(RELATIVE_PATH prefix_from_pc ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(gpf.pc.in gpf.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/gpf.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
