# Obstacles.
set(wall "{\"type\":\"Feature\",\"properties\":{},\"geometry\":{\"type\":\"LineString\",\"coordinates\":[[60,-200],[60,400]]}}")
file(WRITE "${inputs}/wall.geojson" "${wall}")
file(WRITE "${inputs}/pile.geojson" "{\"type\":\"Point\",\"coordinates\":[60,100]}")
set(walled "${trace} --obstacles $IN/wall.geojson")
swellray_cli_test(obstacles 0 "0 in the lee, 0 reflected.*[0-9]+ stopped by an obstacle" "coordinates of the scene's file" "${walled} -o r.vtp")
swellray_cli_test(obstacles_reflect 0 "[1-9][0-9]* reflected" "scene's file" "${walled} --reflection 0.5 --max-reflections 3 -o r.vtp --map m.tif --combine phase")
swellray_cli_test(obstacles_drawn 0 "wrote p.png.*wrote q.png" "scene's file"
  "${walled} -o r.vtp --quiet && $SWELLRAY render $IN/beach.asc --rays r.vtp -o p.png && $SWELLRAY render $IN/beach.asc --obstacles $IN/wall.geojson -o q.png")
swellray_cli_test(obstacles_missing 1 "" "obstacles 'none.shp': no such file" "${trace} --obstacles none.shp -o r.vtp")
swellray_cli_test(obstacles_points 1 "" "pile.geojson': it has only points" "${trace} --obstacles $IN/pile.geojson -o r.vtp")
swellray_cli_test(reflection_alone 2 "" "--reflection needs --obstacles" "${trace} --reflection 0.5 -o r.vtp")
swellray_cli_test(reflection_range 2 "" "--reflection must be" "${walled} --reflection 1.5 -o r.vtp")
swellray_cli_test(obstacles_are_input 1 "" "is an input of this call" "cp $IN/wall.geojson r.vtp && ${trace} --obstacles r.vtp -o r.vtp")
