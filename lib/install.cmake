# Installs the layers and their headers so that find_package(gpf CONFIG) works from another project.
include(CMakePackageConfigHelpers)

get_property(layers GLOBAL PROPERTY GPF_LAYERS)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/gpf)

install(TARGETS ${layers} EXPORT gpf ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY gpf/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/gpf FILES_MATCHING PATTERN "*.hpp")
install(EXPORT gpf NAMESPACE gpf:: FILE gpf-targets.cmake DESTINATION ${package_folder})

configure_package_config_file(gpf-config.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/gpf-config.cmake
  INSTALL_DESTINATION ${package_folder} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/gpf-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/gpf-config.cmake ${CMAKE_CURRENT_BINARY_DIR}/gpf-config-version.cmake
  DESTINATION ${package_folder})
