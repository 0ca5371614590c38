# Stopped at any time, a command leaves what it was asked for whole or not at all.
set(interrupt "bash ${CMAKE_CURRENT_SOURCE_DIR}/interrupt")
set(slow "--period 6 --direction 270 --height 0.5 --spacing 2")
file(WRITE "${inputs}/moments.csv" "0,0\n1,0.2\n2,0.4\n3,0.6\n")

# interrupt_test(<name> <call>): the call, by each signal.
function(interrupt_test name call)
  foreach(signal INT TERM KILL)
    swellray_cli_test(${signal}_${name} 0 "^stopped [0-9]" "" "${interrupt} ${signal} ${call}")
    set_tests_properties(apps.${signal}_${name} PROPERTIES TIMEOUT 300)
  endforeach()
endfunction()

foreach(output rays.vtp rays.gpkg rays.geojson)
  interrupt_test(trace_${output} "$SWELLRAY trace $IN/beach.asc --crs EPSG:32605 ${slow} -o ${output}")
endforeach()
interrupt_test(map "$SWELLRAY trace $IN/beach.asc ${slow} --map m.nc --map-spacing 0.5")
interrupt_test(grid "$SWELLRAY grid $IN/survey.csv --spacing 0.1 -o g.tif")
interrupt_test(all_of_trace "$SWELLRAY trace bar --period 9 --direction 95 --height 1.5 --spacing 20 -o r.vtp --crests c.vtp --breaker-line b.vtp --map m.vti --stations $IN/no_heading.csv --table t.csv")
interrupt_test(mild_slope "$SWELLRAY trace $IN/beach.asc ${wave} --method mild-slope --crop 0,40,160,160 --map m.nc")
interrupt_test(levels "$SWELLRAY trace $IN/beach.asc ${slow} --stations $IN/no_heading.csv --table t.csv --water-levels $IN/moments.csv")
interrupt_test(contour "$SWELLRAY contour shoal --interval 0.3 --simplify 1 -o c.vtp")
interrupt_test(render "$SWELLRAY render $IN/beach.asc -o p.png")
interrupt_test(surface_series "$SWELLRAY surface $IN/beach.asc ${wave} --times 0:1:0.25 -o s.pvd")
interrupt_test(surface_spray "$SWELLRAY surface $IN/beach.asc ${wave} --time 4 -o s.vtp --spray p.vtp")
interrupt_test(surface_spray_series "$SWELLRAY surface $IN/beach.asc ${wave} --times 0:1:0.25 -o s.pvd --spray p.pvd")
interrupt_test(spectrum "$SWELLRAY spectrum plane --hs 2 --tp 10 --direction 90 --frequencies 4 --directions 16 --stations $IN/no_heading.csv --table t.csv --spectra s.sp2")
interrupt_test(validate "$SWELLRAY validate --case c1,c2 --report report")
set(interrupt_sea "$SWELLRAY sea --hs 1 --tp 5 --direction 240 --components 40")
interrupt_test(sea "${interrupt_sea} --tile --size 150 --spacing 1 -o s.vtp --pixels 256 --height-map h.png --normal-map n.tif --picture p.png --picture-size 400x400")
interrupt_test(sea_series "${interrupt_sea} --size 100 --spacing 4 --times 0:2:0.25 -o s.pvd")
interrupt_test(elevations "$SWELLRAY spectrum plane --hs 2 --tp 10 --direction 90 --frequencies 4 --directions 16 --stations $IN/no_heading.csv --elevation-series e.csv --transfer k.nc")

# What is made again is as whole: the record lies beside the folder in which the calls are broken off.
foreach(signal INT TERM KILL)
  swellray_cli_test(${signal}_again 0 "^stopped [0-9]" ""
    "$SWELLRAY trace plane:facing=270 ${slow} --quiet -o r.vtp --crests c.vtp --map m.nc && mkdir again && cd again && ${interrupt} ${signal} $SWELLRAY again ../r.vtp --into .")
  set_tests_properties(apps.${signal}_again PROPERTIES TIMEOUT 300)
endforeach()
