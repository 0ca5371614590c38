# Lists in place of numbers: a file a case, one table, and only what is missing is run again.
set(sweep "$SWELLRAY trace $IN/beach.asc --period 6,8 --direction 260:280:10 --height 0.5")
swellray_cli_test(sweep_files 0
  "case     1 of 6: period 6, direction 260\n.*sweep    6 cases: 6 run, 0 kept, 0 failed; r.cases.csv\nr.cases.csv\nr_period6_direction260.vtp\nr_period6_direction270.vtp\nr_period6_direction280.vtp\nr_period8_direction260.vtp\n.*\nperiod,direction,files,state,seconds,command\n6,260,\"r_period6_direction260.vtp\",done,[0-9.e-]+,\"swellray trace .* --period 6 --direction 260 --height 0.5 -o r_period6_direction260.vtp\"\n"
  "" "${sweep} -o r.vtp 2>err && ls r* && cat r.cases.csv")
swellray_cli_test(sweep_equals_single 0 "^same\n$" ""
  "${sweep} --stations $IN/points.csv --table t.csv --quiet 2>err; $SWELLRAY trace $IN/beach.asc --period 8 --direction 270 --height 0.5 --stations $IN/points.csv --table u.csv --quiet 2>err; cmp u.csv t_period8_direction270.csv && [ \"$(grep '^8,270,50,100' t.csv)\" = \"8,270,$(grep '^50,100' u.csv)\" ] && head -1 t.csv | grep -q '^period,direction,x,y,name,' && [ $(wc -l < t.csv) = 19 ] && echo same")
swellray_cli_test(sweep_resumes 0 "sweep    6 cases: 2 run, 4 kept, 0 failed.*sweep    6 cases: 6 run, 0 kept" ""
  "${sweep} -o r.vtp --quiet 2>err; rm r_period8_direction270.vtp; grep -v ^6,280 r.cases.csv > t && mv t r.cases.csv; ${sweep} -o r.vtp 2>err; ${sweep} -o r.vtp --spacing 7 2>err")
swellray_cli_test(sweep_water_levels 0 "waterlevel-1.*waterlevel0.5" "" "$SWELLRAY trace $IN/beach.asc ${wave} --water-level=-1,0.5 -o r.vtp --quiet 2>err; ls")
# A case that cannot be run does not keep the others from it.
swellray_cli_test(sweep_failure 1 "^r.cases.csv\nr_waterlevel0.vtp\n.*\n-40,.*,failed,0,.*\n0,.*done" "1 of 2 cases failed; water-level -40: "
  "$SWELLRAY trace $IN/beach.asc ${wave} --water-level=-40,0 -o r.vtp --quiet 2>err; code=$?; tail -1 err >&2; ls | grep -v err; cat r.cases.csv; exit $code")
swellray_cli_test(sweep_config 0 "sweep    2 cases: 2 run" "" "printf '[trace]\\nperiod = [6, 7]\\n' > c.toml; $SWELLRAY trace $IN/beach.asc --config c.toml --direction 270 --height 0.5 -o r.vtp 2>err")
swellray_cli_test(sweep_range 2 "" "--period needs FROM:TO:STEP" "$SWELLRAY trace plane --period 8:6:1 --direction 270 --height 1 -o r.vtp")
swellray_cli_test(sweep_value 2 "" "--period must be above 0 seconds, not 0" "$SWELLRAY trace plane --period 8,0 --direction 270 --height 1 -o r.vtp")
swellray_cli_test(sweep_twice 2 "" "--period has 8 twice" "$SWELLRAY trace plane --period 8,8 --direction 270 --height 1 -o r.vtp")
swellray_cli_test(sweep_many 2 "" "more than 10000" "$SWELLRAY trace plane --period 1:100:0.1 --direction 0:300:1 --height 1 -o r.vtp")
swellray_cli_test(sweep_no_list 2 "" "--spacing needs a number" "$SWELLRAY trace plane ${wave} --spacing 1,2 -o r.vtp")
swellray_cli_test(sweep_spectrum 0 "^hs,tp,x,y,name,Depth,.*\n1,8,50,100,buoy.*\n2,10,900,100,far" ""
  "$SWELLRAY spectrum plane --hs 1,2 --tp 8,10 --direction 90 --frequencies 4 --directions 16 --frequency-range 0.06,0.4 --stations $IN/points.csv --table t.csv --transfer k.nc --quiet 2>err; cat t.csv")
