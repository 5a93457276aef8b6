# The parts of the page of `gpf view`, built into the program: our own, and the plotting library uPlot by npm.
set(GPF_VIEW AUTO CACHE STRING
  "Build in what the pages of gpf view are drawn with, fetched by npm: ON, OFF, or AUTO (if npm is there and can)")
set_property(CACHE GPF_VIEW PROPERTY STRINGS AUTO ON OFF)
find_program(GPF_NPM npm)
if(GPF_VIEW AND NOT GPF_VIEW STREQUAL AUTO AND NOT GPF_NPM)
  message(FATAL_ERROR "GPF_VIEW is ON and there is no npm: install it (Debian: apt-get install npm), "
    "or set GPF_VIEW=OFF")
endif()

set(view ${CMAKE_CURRENT_SOURCE_DIR}/view)
set(fetched ${CMAKE_CURRENT_BINARY_DIR}/view)
set(plot "")
if(GPF_VIEW AND GPF_NPM)
  if(GPF_VIEW STREQUAL AUTO)
    set(required OFF)
  else()
    set(required ON)
  endif()
  # Named after the setting, so that another one tries again.
  set(plot ${fetched}/${GPF_VIEW}/plot)
  add_custom_command(OUTPUT ${plot}
    COMMAND ${CMAKE_COMMAND} -DNPM=${GPF_NPM} -DSOURCE=${view} -DFOLDER=${fetched}/${GPF_VIEW} -DREQUIRED=${required}
            -P ${view}/fetch.cmake
    DEPENDS ${view}/package.json ${view}/package-lock.json ${view}/fetch.cmake VERBATIM)
endif()
file(GLOB page CONFIGURE_DEPENDS ${view}/page/*)
add_custom_command(OUTPUT ${generated}/gpf_view_parts.hpp
  COMMAND ${CMAKE_COMMAND} -DPAGE=${view}/page -DPLOT=${plot} -DOUTPUT=${generated}/gpf_view_parts.hpp
          -P ${view}/parts.cmake
  DEPENDS ${page} ${view}/parts.cmake ${plot} VERBATIM)
target_sources(gpf_verify PRIVATE ${generated}/gpf_view_parts.hpp)
