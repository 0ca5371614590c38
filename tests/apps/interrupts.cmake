# Stopped at any time, a command leaves what it was asked for whole or not at all.
set(interrupt "bash ${CMAKE_CURRENT_SOURCE_DIR}/interrupt")
set(slow "--period 6 --direction 270 --height 0.5 --spacing 2")
file(WRITE "${inputs}/moments.csv" "0,0\n1,0.2\n2,0.4\n3,0.6\n")
foreach(signal INT TERM KILL)
  foreach(output rays.vtp rays.gpkg rays.geojson)
    swellray_cli_test(${signal}_trace_${output} 0 "^stopped [0-9]" "" "${interrupt} ${signal} ${output} $SWELLRAY trace $IN/beach.asc --crs EPSG:32605 ${slow} -o ${output}")
  endforeach()
  swellray_cli_test(${signal}_map 0 "^stopped [0-9]" "" "${interrupt} ${signal} m.nc $SWELLRAY trace $IN/beach.asc ${slow} --map m.nc --map-spacing 0.5")
  swellray_cli_test(${signal}_levels 0 "^stopped [0-9]" ""
    "${interrupt} ${signal} t.csv $SWELLRAY trace $IN/beach.asc ${slow} --stations $IN/no_heading.csv --table t.csv --water-levels $IN/moments.csv")
  swellray_cli_test(${signal}_contour 0 "^stopped [0-9]" "" "${interrupt} ${signal} c.vtp $SWELLRAY contour shoal --interval 0.1 --simplify 1 -o c.vtp")
  swellray_cli_test(${signal}_render 0 "^stopped [0-9]" "" "${interrupt} ${signal} p.png $SWELLRAY render $IN/beach.asc -o p.png")
endforeach()
