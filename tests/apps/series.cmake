# Water levels in a series.
file(WRITE "${inputs}/tide.csv" "time,level\n2024-05-01T00:00Z,0\n2024-05-01T06:00Z,1.5\n2024-05-01T12:30:15+02:00,0\n")
file(WRITE "${inputs}/hours.csv" "0,0.5\n1.5,-0.5\n")
set(series "${trace} --stations $IN/no_heading.csv --table t.csv --water-levels")
# Depth follows the level; equal levels have equal rows.
swellray_cli_test(levels 0 "level    2 of 2: 1.5 m.*wrote    t.csv: 3 times, 1 points, 2 different levels\nTime,WaterLevel,x,y,Elevation,Depth[^\n]*\n2024-05-01T00:00Z,0,50,100,(-[0-9.]+),([0-9.]+),([^\n]*)\n2024-05-01T06:00Z,1.5,50,100,-[0-9.]+,[0-9.]+,[^\n]*\n2024-05-01T12:30:15.02:00,0,50,100,[^\n]*\n$" "coarse"
  "${series} $IN/tide.csv && cat t.csv")
swellray_cli_test(levels_numbers 0 "\n0,0.5,50,100[^\n]*\n1.5,-0.5,50,100[^\n]*\n$" "coarse" "${series} $IN/hours.csv --quiet && cat t.csv")
swellray_cli_test(levels_equal_single 0 "^same\n$" ""
  "${series} $IN/hours.csv --quiet 2>err && ${trace} --quiet --water-level -0.5 --stations $IN/no_heading.csv --table u.csv 2>err && [ \"$(tail -1 t.csv | cut -d, -f3-)\" = \"$(tail -1 u.csv)\" ] && echo same")
swellray_cli_test(levels_alone 2 "" "--water-levels makes a table" "${trace} -o r.vtp --water-levels $IN/tide.csv")
swellray_cli_test(levels_twice 2 "" "in place of --water-level" "${series} $IN/tide.csv --water-level 1")
swellray_cli_test(levels_missing 1 "" "cannot read 'none.csv'" "${series} none.csv")
foreach(bad "no_level|a,b\n0,x\n|is no water level" "no_time|noon,1\n|'noon' is no time" "no_day|2023-02-29T00:00,1\n|is no time" "mixed|0,1\n2024-05-01T00:00,1\n|either all numbers" "back|1,1\n0,1\n|does not come after 1" "empty|time,level\n|has no water levels")
  string(REPLACE "|" ";" parts "${bad}")
  list(GET parts 0 name)
  list(GET parts 1 words)
  list(GET parts 2 says)
  file(WRITE "${inputs}/levels_${name}.csv" "${words}")
  swellray_cli_test(levels_${name} 1 "" "${says}" "${series} $IN/levels_${name}.csv")
endforeach()
swellray_cli_test(levels_dry 1 "^0\n$" "at the water level -30 m: " "printf '0,0\\n1,-30\\n' > l.csv; ${series} l.csv --quiet 2>err; code=$?; grep -v warning err >&2; ls -A | grep -c '^[.]\\|t.csv' ; exit $code")
