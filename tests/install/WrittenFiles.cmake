# require_written_files(<prefix>): man pages and completions, whole, where programs look for them.
function(require_written_files prefix)
  foreach(entry IN ITEMS
      "man/man1/swellray.1|BR swellray..trace"
      "man/man1/swellray-trace.1|SH EXAMPLES"
      "bash-completion/completions/swellray|complete -o default"
      "zsh/vendor-completions/_swellray|#compdef swellray"
      "fish/vendor_completions.d/swellray.fish|complete -c swellray")
    string(REGEX MATCH "^([^|]*)[|](.*)$" matched "${entry}")
    set(path "${prefix}/share/${CMAKE_MATCH_1}")
    set(expected "${CMAKE_MATCH_2}")
    if(NOT EXISTS "${path}")
      message(FATAL_ERROR "${path} is missing")
    endif()
    file(READ "${path}" text)
    if(NOT text MATCHES "${expected}")
      message(FATAL_ERROR "${path} should match '${expected}'")
    endif()
  endforeach()
endfunction()
