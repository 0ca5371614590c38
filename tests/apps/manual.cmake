# The manual, and its pages that are kept in docs/commands.
find_program(SWELLRAY_MAN man)
find_program(SWELLRAY_GROFF groff)
find_program(SWELLRAY_MANDOC mandoc)
swellray_cli_test(manual_pages_kept 0 "^same\n$" ""
  "$SWELLRAY manual --format markdown pages --quiet && diff -r pages '${PROJECT_SOURCE_DIR}/docs/commands' || echo 'not as docs/commands: build the target commandPages'; echo same")
swellray_cli_test(manual_every_command 0 "^all\n$" ""
  "$SWELLRAY manual man1 --quiet && for c in $($SWELLRAY --help | sed -n '/^Subcommands/,/^$/s/^  \\([a-z]*\\) .*/\\1/p'); do test -s man1/swellray-$c.1 && grep -q \"^.BR swellray..$c (1)\" man1/swellray.1 || echo no $c; done; echo all")
swellray_cli_test(manual_nowhere 1 "" "cannot make the folder 'file/man1'" "touch file; $SWELLRAY manual file/man1")
swellray_cli_test(manual_without_folder 2 "" "manual needs a FOLDER" "$SWELLRAY manual")
if(SWELLRAY_MAN)
  swellray_cli_test(manual_read_by_man 0 "swellray-trace - trace wave rays.*--scheme ode.snell.*  swellray trace harbour.tif" ""
    "$SWELLRAY manual man1 --quiet && LC_ALL=C.UTF-8 MANWIDTH=200 MAN_KEEP_FORMATTING= man -l man1/swellray-trace.1 | col -b")
endif()
if(SWELLRAY_GROFF)
  swellray_cli_test(manual_groff 0 "^done\n$" ""
    "$SWELLRAY manual man1 --quiet && for p in man1/*.1; do groff -ww -man -Tutf8 -z $p; done && echo done")
endif()
if(SWELLRAY_MANDOC)
  swellray_cli_test(manual_mandoc 0 "^done\n$" ""
    "$SWELLRAY manual man1 --quiet && mandoc -T lint -W error man1/*.1 && echo done")
endif()
