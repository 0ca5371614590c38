# What work will take, said before it and without it.
set(plan "$SWELLRAY trace island --period 8 --direction 270 --height 1")
swellray_cli_test(dry_run 0 "^plan     100 rays launched, about [0-9,]+ with those inserted, in about [0-9,]+ steps; about [0-9,]+ points on some [0-9]+ fronts\ncost     about [0-9.e-]+ GB of memory and about [0-9.e-]+ s, beside.*\n0\n$" ""
  "${plan} -o r.vtp --dry-run && ls -A | wc -l")

# swellray_plan_test(<name> <call>): the numbers of the work itself.
function(swellray_plan_test name call)
  swellray_cli_test(dry_run_comes_true_${name} 0 "^true\n$" ""
    "$SWELLRAY ${call} --dry-run > plan && $SWELLRAY ${call} > run && python3 '${CMAKE_CURRENT_SOURCE_DIR}/compare_plan.py' plan run && rm -f out.*")
endfunction()
set(lee "island:slope=0.2,shore-radius=12,toe-radius=20,xc=-15,x0=-50,y0=-50,x1=50,y1=50")
set(sea "spectrum vincent-briggs --hs 0.0254 --tp 1.3 --direction 270 --map out.vti --frequencies 3 --directions 12")
swellray_plan_test(traced "trace island --period 8 --direction 270 --height 1 -o out.vtp")
swellray_plan_test(lee "trace ${lee} --period 4 --direction 270 --height 0.5 --spacing 0.02 -o out.vtp")
swellray_plan_test(steps "trace ${lee} --period 4 --direction 270 --height 0.5 --step 0.4 --scheme snell -o out.vtp")
swellray_plan_test(sea "${sea} --map-spacing 2")
swellray_plan_test(breaking_sea "${sea} --map-spacing 4 --breaking battjes-janssen")

swellray_cli_test(dry_run_from_site 2 "" "--dry-run plans one trace" "$SWELLRAY trace island --period 8 --from-site 900,0 -o w.vtp --dry-run")
swellray_cli_test(dry_run_of_list 2 "" "--dry-run plans one trace" "$SWELLRAY trace island --period 8,9 --direction 270 --height 1 -o r.vtp --dry-run")
swellray_cli_test(dry_run_no_water 1 "" "no cell below the water level" "$SWELLRAY trace $IN/land.asc --period 8 --direction 270 --height 1 --dry-run")
swellray_cli_test(dry_run_spectrum 0 "plan     about 7,500 rays in about [0-9,]+ steps from 156 nodes, some 156 of them in water; 48 rays a place\ncost     about [0-9.e-]+ s; about [0-9.e-]+ GB.*\n0\n$" ""
  "$SWELLRAY spectrum vincent-briggs --hs 0.0254 --tp 1.3 --direction 270 --map-spacing 2 --map m.vti --frequencies 4 --directions 12 --dry-run && ls -A | wc -l")
swellray_cli_test(dry_run_spectrum_list 2 "" "--dry-run plans one sea" "$SWELLRAY spectrum plane --hs 1 --tp 8,9 --direction 90 --map m.vti --dry-run")

# On a terminal long work tells how much of it is done and, after a moment, the time that is left.
find_program(SWELLRAY_SCRIPT script)
if(SWELLRAY_SCRIPT)
  swellray_cli_test(progress 0 "tracing    .#+ +. +[0-9]+ %, about [0-9.]+ s left *[\r]" ""
    "'${SWELLRAY_SCRIPT}' -qec \"$SWELLRAY trace '${lee}' --period 4 --direction 270 --height 0.5 --spacing 0.004 --threads 1 -o r.vtp\" /dev/null")
endif()

# A surface in time, without its spray.
set(surface "$SWELLRAY surface babbage --period 6 --direction 15 --height 0.8")
swellray_cli_test(dry_run_surface 0 "surface  about [0-9,]+ points, about [0-9.e-]+ GB of memory, in each of 11 frames; about [0-9.e-]+ s for all.*\n0\n$" ""
  "${surface} --times 0:1:0.1 -o s.pvd --dry-run && ls -A | wc -l")
swellray_cli_test(dry_run_surface_comes_true 0 "^true\n$" ""
  "${surface} -o s.vtp --dry-run | tr -d , > plan; ${surface} -o s.vtp > run; awk '/^surface/ && FILENAME == \"plan\" { p = $3 } /^surface/ && FILENAME == \"run\" { q = $3 } END { print (p / q > 0.9 && p / q < 1.1 ? \"true\" : p \" planned, \" q) }' plan run")
swellray_cli_test(dry_run_surface_of_two 2 "" "--dry-run plans the surface of one wave" "${surface} --component 2,20,0.1 -o s.vtp --dry-run")
