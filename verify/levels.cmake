# simulate() for each level of x86-64, a shared library each, of which the dynamic linker takes the best one that the
# processor has (glibc-hwcaps). Everything else that they call is the program's, compiled for any x86-64.

# gpf_simulate_levels(name): the target `name`, which programs link, and its libraries in the folder `name`.
function(gpf_simulate_levels name)
  foreach(level IN ITEMS x86-64 x86-64-v3 x86-64-v4)
    # Linked last, so that -march follows GPF_NATIVE's.
    add_library(${name}_options_${level} INTERFACE)
    target_compile_options(${name}_options_${level} INTERFACE -march=${level} -mprefer-vector-width=256)
    add_library(${name}_object_${level} OBJECT ${PROJECT_SOURCE_DIR}/verify/simulate.cpp)
    target_compile_options(${name}_object_${level} PRIVATE -fno-semantic-interposition)
    set_target_properties(${name}_object_${level} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_include_directories(${name}_object_${level} PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name}_object_${level} PRIVATE gpf::io gpf::measure gpf::event ${name}_options_${level})
    # What it calls and does not define is found in the program. What headers define is its own, although the program
    # may have functions of those names: -Bsymbolic-functions.
    if(level STREQUAL x86-64)
      set(library ${name})
      set(folder ${name})
    else()
      set(library ${name}_${level})
      set(folder ${name}/glibc-hwcaps/${level})
      add_dependencies(${name} ${library})
    endif()
    add_library(${library} SHARED $<TARGET_OBJECTS:${name}_object_${level}>)
    target_link_options(${library} PRIVATE -Wl,-Bsymbolic-functions)
    set_target_properties(${library} PROPERTIES LINKER_LANGUAGE CXX OUTPUT_NAME gpf_simulate
                          LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${folder})
  endforeach()
  target_include_directories(${name} INTERFACE ${PROJECT_SOURCE_DIR})
endfunction()
