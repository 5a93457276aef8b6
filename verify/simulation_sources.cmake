# cmake -DSOURCES=file;file... -DROOT=folder -DNAME=constant -DOUTPUT=header -P simulation_sources.cmake
# Writes a header with a hash of the files' names and contents; an unchanged one is left alone.
set(all "")
foreach(file IN LISTS SOURCES)
  file(SHA256 ${file} hash)
  cmake_path(RELATIVE_PATH file BASE_DIRECTORY ${ROOT})
  string(APPEND all "${file} ${hash}\n")
endforeach()
string(SHA256 hash "${all}")
string(SUBSTRING ${hash} 0 16 hash)
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT "#pragma once
#include <cstdint>
inline constexpr std::uint64_t ${NAME} = 0x${hash}u;
" @ONLY)
