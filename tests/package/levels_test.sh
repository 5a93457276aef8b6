#!/bin/sh
# The dynamic linker takes the best simulate() for the processor, and each gives the same bits. An older processor is
# played by hiding features of this one from the dynamic linker.
# usage: levels_test.sh PROGRAM FOLDER LINKER    (FOLDER has the libraries, LINKER is the dynamic linker's path)
set -eu
program=$1 folder=$2 linker=$3
for tool in objdump "$linker"; do
  command -v "$tool" > /dev/null || { echo "no $tool: skipped"; exit 77; }
done
fail() { echo "FAILED: $1" >&2; exit 1; }

# Which registers the code of each level may use.
uses() { objdump -d "$folder/$1libgpf_simulate.so" | grep -qE "$2"; }
! uses '' '%[yz]mm' || fail "that for any x86-64 uses AVX"
uses glibc-hwcaps/x86-64-v3/ '%ymm' || fail "that for x86-64-v3 does not use AVX"
! uses glibc-hwcaps/x86-64-v3/ '%zmm|%[xy]mm(1[6-9]|[23][0-9])' || fail "that for x86-64-v3 uses AVX-512"

# The levels that the dynamic linker says it may take, with these features hidden, and the one that it takes.
for hidden in '' -AVX512F -AVX2; do
  export GLIBC_TUNABLES=glibc.cpu.hwcaps=$hidden
  best=$("$linker" --help | sed -n 's,^ *\(x86-64-v[34]\) (supported.*,glibc-hwcaps/\1/,p' | head -n 1)
  taken=$(LD_TRACE_LOADED_OBJECTS=1 "$program" | sed -n 's/.*libgpf_simulate.so => \([^ ]*\).*/\1/p')
  [ "$taken" = "$folder/${best}libgpf_simulate.so" ] || fail "hidden: ${hidden:-nothing}: $taken was taken, not ${best:-the plain one}"
  [ "$hidden" != -AVX2 ] || [ -z "$best" ] || fail "without AVX2 $best was taken"
  hash=$("$program")
  [ "${first:=$hash}" = "$hash" ] || fail "$taken: $hash, not $first"
  echo "ok - hidden: ${hidden:-nothing}: ${best:-plain}, $hash"
done
