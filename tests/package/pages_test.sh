#!/bin/bash
# Manual pages and completions say what the help says.
# usage: pages_test.sh GPF PAGES SOURCE
set -eu
gpf=$1 pages=$2 source=$3
fail() { echo "FAILED: $1" >&2; exit 1; }
offers() { # offers WORD...: $offered is what TAB offers after these words, the last of which is unfinished
  COMP_WORDS=(gpf "$@") COMP_CWORD=$# COMPREPLY=()
  _gpf || true # 1 when there is nothing
  offered=" ${COMPREPLY[*]} "
}
expect() { # expect OFFER WORD...
  local want=$1
  shift
  offers "$@"
  [ "$offered" = " $want " ] || fail "after 'gpf $*' it offers '$offered', not '$want'"
}
. "$pages/bash/gpf"

count=0
check_command() { # check_command PAGE WORD...: all that its help lists is completed, and in the page
  local page=$1 text help commands option command
  shift
  help=$("$gpf" "$@" --help)
  commands=$(sed -n '/^Subcommands:/,/^$/s/^  \([a-z]\+\) .*/\1/p' <<< "$help")
  text=$(zcat "$pages/man/$page.1.gz" | sed 's/\\-/-/g')
  for option in $(sed -n 's/^  \(-[a-z-]*\)\(,\(--[a-z-]*\)\)\{0,1\}.*/\1 \3/p' <<< "$help"); do
    offers "$@" "$option"
    [[ $offered = *" $option "* ]] || fail "'gpf $* $option' is not completed"
    [[ $text = *"fB$option\\fR"* ]] || fail "$page(1) lacks $option"
    count=$((count + 1))
  done
  for command in $commands; do
    offers "$@" ""
    [[ $offered = *" $command "* ]] || fail "'gpf $* $command' is not completed"
    if [ $# -eq 0 ]; then
      [[ $text = *"gpf-$command (1)"* ]] || fail "$page(1) lacks $command"
      check_command "gpf-$command" "$command"
    else
      [[ $text = *".SS $command"* ]] || fail "$page(1) lacks $command"
      check_command "$page" "$@" "$command"
    fi
  done
}
check_command gpf
[ "$count" -gt 80 ] || fail "the help lists only $count options: it is not read rightly"
echo "ok - $count options, in pages and completion"

expect "validate" vali
expect "quick standard full" validate --tier ""
expect "standard" validate eos.virial --tier s
expect "standard" validate --tier = s
expect "quick standard full" validate --tier =
expect "--store" validate --st
expect "missing" campaign mi
expect "--adaptive" campaign run fig-5-8 --a
expect "slip_velocity" advise scene.toml --observable sl
expect "" run scene.toml -o ""   # a file: the shell's own affair
claims=$(cd "$source/reference/claims" && echo *.toml | sed 's/\.toml//g')
for command in validate explain report; do expect "$claims" "$command" ""; done
expect "eos.global eos.virial" explain eos.
expect "algo.walls" faults "walls exchanged" --claim algo.wa
echo "ok - choices and claims"

missing=""
if command -v fish > /dev/null; then
  expect_fish() { # expect_fish OFFER LINE
    local offered
    offered=$(fish -N -c "source $pages/fish/gpf.fish; complete -C '$2'" | cut -f 1 | tr '\n' ' ')
    [ "$offered" = "$1 " ] || fail "after '$2' fish offers '$offered', not '$1'"
  }
  expect_fish "validate" "gpf vali"
  expect_fish "full quick standard" "gpf validate --tier "
  expect_fish "--store" "gpf validate --st"
  expect_fish "missing" "gpf campaign mi"
  expect_fish "--adaptive" "gpf campaign run fig-5-8 --ad"
  expect_fish "eos.global eos.virial" "gpf explain eos."
  echo "ok - fish"
else
  missing="$missing fish"
fi
if command -v zsh > /dev/null; then
  "$source/tests/package/completion_test.zsh" "$pages/zsh"
  echo "ok - zsh"
else
  missing="$missing zsh"
fi
if command -v mandoc > /dev/null; then
  for page in "$pages"/man/*.1.gz; do
    zcat "$page" > "$PWD/page.1"
    mandoc -T lint -W warning "$PWD/page.1" || fail "$page"
  done
  mandoc -T ascii page.1 > /dev/null
  rm page.1
  echo "ok - the language of the pages"
else
  missing="$missing mandoc"
fi
[ -z "$missing" ] || { echo "not tried without:$missing"; exit 77; }
