# Completion as it is called with the words typed so far: of bash always, of fish where there is one.
find_program(SWELLRAY_FISH fish)
find_program(SWELLRAY_ZSH zsh)
foreach(typed IN ITEMS "swellray tra=trace" "swellray trace --sche=--scheme" "swellray trace --scheme =ode snell"
    "swellray spectrum --shape p=pierson-moskowitz" "swellray info --thr=--threads" "swellray info --conf=--config"
    "swellray completion f=fish" "swellray info har=")
  string(REGEX MATCH "^([^=]*)=(.*)$" matched "${typed}")
  set(words "${CMAKE_MATCH_1}")
  set(expected "${CMAKE_MATCH_2}")
  string(MAKE_C_IDENTIFIER "${words}" name)
  swellray_cli_test(completion_${name} 0 "^${expected}\n$" ""
    "source <($SWELLRAY completion) && typed='${words}' && COMP_WORDS=($typed) && [ \"\${typed: -1}\" != ' ' ] || COMP_WORDS+=('') && COMP_CWORD=$((\${#COMP_WORDS[@]} - 1)) && _swellray; echo \"\${COMPREPLY[*]}\"")
  if(SWELLRAY_FISH)
    swellray_cli_test(completion_fish_${name} 0 "^${expected}\n$" ""
      "export HOME=$PWD/home && $SWELLRAY completion fish > s.fish && '${SWELLRAY_FISH}' -c 'source s.fish; complete -C \"${words}\"' | cut -f1 | paste -sd' '; rm -rf home")
  endif()
endforeach()

# The same options, words and helps in all three.
swellray_cli_test(completion_bash_named 0 "^same\n$" ""
  "$SWELLRAY completion bash > a && $SWELLRAY completion > b && cmp a b && echo same")
swellray_cli_test(completion_zsh 0
  "'--scheme=.integrate the ray equations, or Snell'.''s law step by step [(]1997[)].:word:[(]ode snell[)]'.*'1:seafloor:_files'"
  "" "$SWELLRAY completion zsh")
swellray_cli_test(completion_fish 0
  "-l scheme -x -a 'ode snell' -d 'integrate the ray equations, or Snell.'s law step by step [(]1997[)]'" ""
  "$SWELLRAY completion fish")
swellray_cli_test(completion_every_option 0 "^all\n$" ""
  "for s in bash zsh fish; do $SWELLRAY completion $s > $s; done; for c in trace spectrum render; do for o in $($SWELLRAY $c --help | grep -oE '^  (-[a-z],)?--[a-z-]+' | grep -oE '[a-z][a-z-]+$'); do grep -qe \"--$o\" bash && grep -qe \"--$o\" zsh && grep -qe \"-l $o \" fish || echo no $o; done; done; echo all")
swellray_cli_test(completion_of_none 2 "" "completion must be bash, zsh or fish, not 'tcsh'" "$SWELLRAY completion tcsh")
if(SWELLRAY_ZSH)
  # As typed on a terminal: what stands there after the tabulator.
  swellray_cli_test(completion_zsh_typed 0 "swellray trace --scheme snell" ""
    "$SWELLRAY completion zsh > _swellray && '${SWELLRAY_ZSH}' -f '${CMAKE_CURRENT_SOURCE_DIR}/type-in-zsh' 'swellray trace --scheme s'; rm -f .zcompdump")
endif()
