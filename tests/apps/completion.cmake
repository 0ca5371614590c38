# Completion by bash, as it is called with the words typed so far.
foreach(typed IN ITEMS "swellray tra=trace" "swellray trace --sche=--scheme" "swellray trace --scheme =ode snell"
    "swellray spectrum --shape p=pierson-moskowitz" "swellray info --thr=--threads" "swellray info har=")
  string(REGEX MATCH "^([^=]*)=(.*)$" matched "${typed}")
  set(words "${CMAKE_MATCH_1}")
  set(expected "${CMAKE_MATCH_2}")
  string(MAKE_C_IDENTIFIER "${words}" name)
  swellray_cli_test(completion_${name} 0 "^${expected}\n$" ""
    "source <($SWELLRAY completion) && typed='${words}' && COMP_WORDS=($typed) && [ \"\${typed: -1}\" != ' ' ] || COMP_WORDS+=('') && COMP_CWORD=$((\${#COMP_WORDS[@]} - 1)) && _swellray; echo \"\${COMPREPLY[*]}\"")
endforeach()
