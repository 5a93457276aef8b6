# Runs at every build: writes OUTPUT, a header with the commit of SOURCE and whether the sources that are built differ
# from it. Written only when its content changes, so that nothing is recompiled otherwise. Without git, outside a
# repository or before the first commit both facts are "unknown".
cmake_minimum_required(VERSION 3.25)
set(commit unknown)
set(dirty unknown)
find_program(git git)

function(run_git result_variable)
  execute_process(COMMAND ${git} --no-optional-locks -C ${SOURCE} ${ARGN} RESULT_VARIABLE status
                  OUTPUT_VARIABLE output ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0)
    set(output failed)
  endif()
  set(${result_variable} "${output}" PARENT_SCOPE)
endfunction()

if(git)
  # A source tree unpacked inside somebody else's repository must not take that repository's commit for its own.
  run_git(top rev-parse --show-toplevel)
  run_git(head rev-parse --verify HEAD)
  file(REAL_PATH "${SOURCE}" source)
  if(top STREQUAL source AND head MATCHES "^[0-9a-f]+$")
    set(commit ${head})
    # Reports and references may change without changing what the program does.
    run_git(changes status --porcelain -- CMakeLists.txt lib verify)
    if(changes STREQUAL "")
      set(dirty no)
    elseif(NOT changes STREQUAL "failed")
      set(dirty yes)
    endif()
  endif()
endif()

file(CONFIGURE OUTPUT "${OUTPUT}" @ONLY CONTENT
"// Generated at build time.
#pragma once
namespace gpf::git_facts {
inline constexpr const char* commit = \"@commit@\";
inline constexpr const char* dirty = \"@dirty@\";
}  // namespace gpf::git_facts
")
