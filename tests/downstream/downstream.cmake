# Installs into a fresh prefix, then configures, builds and runs the consumer against nothing but that prefix.
cmake_minimum_required(VERSION 3.25)

function(step what)
  message(STATUS "${what}")
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${what}: exit status ${status}\n${output}\n${errors}")
  endif()
  set(output "${output}" PARENT_SCOPE)
endfunction()

file(REMOVE_RECURSE ${scratch}/prefix ${scratch}/consumer)
step("install" ${CMAKE_COMMAND} --install ${build} --prefix ${scratch}/prefix)
step("configure" ${CMAKE_COMMAND} -S ${source} -B ${scratch}/consumer -G ${generator}
  -D CMAKE_PREFIX_PATH=${scratch}/prefix -D CMAKE_FIND_USE_PACKAGE_REGISTRY=OFF -D CMAKE_EXPORT_COMPILE_COMMANDS=ON
  -D CMAKE_C_COMPILER=${c_compiler} -D CMAKE_CXX_COMPILER=${compiler} "-DCMAKE_CXX_FLAGS=${flags}" "-Dcomponents=${components}")
step("build" ${CMAKE_COMMAND} --build ${scratch}/consumer)

# The consumer's own flags: the bits of a run travel with the headers, our warnings and our CPU do not.
file(READ ${scratch}/consumer/compile_commands.json commands)
foreach(flag IN ITEMS -ffp-contract=off "-std=(c|gnu)\\+\\+20")
  if(NOT commands MATCHES "${flag}")
    message(FATAL_ERROR "the consumer is compiled without ${flag}:\n${commands}")
  endif()
endforeach()
foreach(flag IN ITEMS -Werror -Wall -march=native)
  if(commands MATCHES "${flag}")
    message(FATAL_ERROR "the consumer inherits ${flag}:\n${commands}")
  endif()
endforeach()

# The README's own scene, so that it stays a scene that can be run.
file(READ ${readme} text)
string(REGEX MATCH "```toml\n([^`]*)```" found "${text}")
file(WRITE ${scratch}/scene.toml "${CMAKE_MATCH_1}")
step("run in the build tree" ${in_tree} ${scratch}/scene.toml)
set(expected "${output}")
step("run the consumer" ${scratch}/consumer/consumer ${scratch}/scene.toml)
if(NOT output MATCHES "^area fraction 0.5600, trace [0-9a-f]+\n$" OR NOT output STREQUAL expected)
  message(FATAL_ERROR "the consumer printed '${output}', the same program in the build tree '${expected}'")
endif()
message(STATUS "${output}")

# The same by pkg-config alone, from a prefix that was moved.
file(REMOVE_RECURSE ${scratch}/moved)
file(RENAME ${scratch}/prefix ${scratch}/moved)
set(ENV{PKG_CONFIG_PATH} ${scratch}/moved/${pc_folder})
step("pkg-config" ${pkg_config} --static --cflags --libs gpf)
if(sanitize)
  string(PREPEND flags "-fsanitize=${sanitize} ")
endif()
separate_arguments(options UNIX_COMMAND "${flags} ${output}")
step("compile" ${compiler} -O1 ${source}/main.cpp ${options} -o ${scratch}/by_pkg_config)
step("run what pkg-config built" ${scratch}/by_pkg_config ${scratch}/scene.toml)
if(NOT output STREQUAL expected)
  message(FATAL_ERROR "built with pkg-config it prints '${output}', in the build tree '${expected}'")
endif()
