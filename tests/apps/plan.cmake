# What work will take, said before it and without it.
set(plan "$SWELLRAY trace island --period 8 --direction 270 --height 1")
swellray_cli_test(dry_run 0 "^plan     100 rays launched, about [0-9.e+]+ with those inserted; about [0-9.e+]+ points on [0-9]+ fronts\ncost     about [0-9.e-]+ GB of memory and [0-9.e-]+ s.*\n0\n$" ""
  "${plan} -o r.vtp --dry-run && ls -A | wc -l")
# The numbers of the trace itself: fifty rays tell those of some hundreds to a third.
swellray_cli_test(dry_run_comes_true 0 "^true true\n$" ""
  "${plan} --dry-run > plan; ${plan} -o r.vtp > done; cat plan done | sed 's/: 100 launched/ 100 launched/' | awk '/^plan/ { rays = $6; points = $11 } /^rays/ { r = rays / $2; for (i = 1; i < NF; ++i) if ($(i + 1) == \"points\") p = points / $i } END { print (r > 0.75 && r < 1.33 ? \"true\" : r), (p > 0.75 && p < 1.33 ? \"true\" : p) }'")
swellray_cli_test(dry_run_from_site 2 "" "--dry-run plans one trace" "$SWELLRAY trace island --period 8 --from-site 900,0 -o w.vtp --dry-run")
swellray_cli_test(dry_run_of_list 2 "" "--dry-run plans one trace" "$SWELLRAY trace island --period 8,9 --direction 270 --height 1 -o r.vtp --dry-run")
swellray_cli_test(dry_run_no_water 1 "" "no cell below the water level" "$SWELLRAY trace $IN/land.asc --period 8 --direction 270 --height 1 --dry-run")
set(sea_plan "$SWELLRAY spectrum vincent-briggs --hs 0.0254 --tp 1.3 --direction 270 --map-spacing 2 --map m.vti --frequencies 4 --directions 12 --dry-run")
swellray_cli_test(dry_run_spectrum 0 "plan     about 7.5e.03 rays from 156 nodes, some 1.6e.02 of them in water; 48 rays a place\ncost     about [0-9.e-]+ s.*\n0\n$" ""
  "${sea_plan} && ls -A | wc -l")
swellray_cli_test(dry_run_spectrum_list 2 "" "--dry-run plans one sea" "$SWELLRAY spectrum plane --hs 1 --tp 8,9 --direction 90 --map m.vti --dry-run")
