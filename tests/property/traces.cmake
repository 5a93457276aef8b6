# cmake -D expected=traces.toml (-D program=TRACE | -D compiler=CXX -D flags="..." -D source=ROOT -D fmt=LIBRARY
# -D scratch=FOLDER) -P traces.cmake: are the program's trace hashes the expected ones, to the last line? With a compiler
# the program is built first, from the sources alone, so that everything on the way to a hash is built that way.
cmake_minimum_required(VERSION 3.25)

if(compiler)
  set(unity "")
  foreach(file IN ITEMS tests/property/trace lib/gpf/scene/start lib/gpf/scene/lattice lib/gpf/scene/scene
                        lib/gpf/scene/canonical_text lib/gpf/base/random lib/gpf/base/error)
    string(APPEND unity "#include \"${source}/${file}.cpp\"\n")
  endforeach()
  file(WRITE ${scratch}/trace.cpp "${unity}")
  set(program ${scratch}/trace)
  separate_arguments(flags)
  execute_process(
    COMMAND ${compiler} -std=c++20 -DNDEBUG -ffp-contract=off -w ${flags} -I${source}/lib -I${source}/tests
            ${scratch}/trace.cpp ${fmt} -o ${program}
    COMMAND_ERROR_IS_FATAL ANY)
endif()

file(READ ${expected} toml)
string(REGEX MATCHALL "name = \"[^\"]*\"\ncontacts = [0-9]*\nhash = \"[0-9a-f]*\"" traces "${toml}")
string(REGEX REPLACE "name = \"([^\"]*)\"\ncontacts = ([0-9]*)\nhash = \"([0-9a-f]*)\"" "\\1 \\2 \\3" traces "${traces}")
list(LENGTH traces count)
if(count LESS 1)
  message(FATAL_ERROR "${expected} holds no trace")
endif()
list(JOIN traces "\n" wanted)

execute_process(COMMAND ${program} OUTPUT_VARIABLE found OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
if(NOT found STREQUAL wanted)
  message(FATAL_ERROR "found:\n${found}\nexpected (${expected}):\n${wanted}")
endif()
message(STATUS "${count} traces agree")
