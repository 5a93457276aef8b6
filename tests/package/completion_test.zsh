#!/bin/zsh -f
# What TAB offers in zsh, in an interactive shell on a terminal of its own.
# usage: completion_test.zsh FOLDER_OF__gpf
zmodload zsh/zpty
hits=$PWD/zsh-hits
zpty shell "TERM=dumb ${(q)commands[zsh]} -f -i"
setup=("PS1=" "fpath=(${(q)1} \$fpath)" "autoload -Uz compinit" "compinit -D -u" "gpf() { : }"
  "compadd() { if [[ \"\$*\" == *-[OAD]* ]]; then builtin compadd \"\$@\"; else local -a got; builtin compadd -A got \"\$@\"; print -l -- \$got >> ${(q)hits}; builtin compadd \"\$@\"; fi }")
await() { # until the shell has come so far
  zpty -w shell ": > ${(q)hits}.done"
  for ((k = 0; k < 100; ++k)); do [[ -e $hits.done ]] && break; sleep 0.1; done
}
rm -f $hits.done
for line in $setup; do zpty -w shell $line; done
await
failed=0
expect() { # expect OFFER LINE
  rm -f $hits $hits.done
  zpty -w -n shell "$2"$'\t'
  zpty -w -n shell $'\x15' # ^U clears the line
  await
  offered=$(grep . $hits 2> /dev/null | tr '\n' ' ')
  [[ $offered == "$1 " ]] || { print -u2 "FAILED: after '$2' zsh offers '$offered', not '$1'"; failed=1 }
}
expect "validate" "gpf vali"
expect "quick standard full" "gpf validate --tier "
expect "--store" "gpf validate --st"
expect "missing" "gpf campaign mi"
expect "--adaptive" "gpf campaign run fig-5-8 --ad"
expect "slip_velocity" "gpf advise scene.toml --observable sl"
expect "eos.global eos.virial" "gpf explain eos."
zpty -d shell
rm -f $hits $hits.done
exit $failed
