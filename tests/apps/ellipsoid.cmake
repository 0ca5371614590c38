# Rays on the ellipsoid.
set(row "")
string(REPEAT "-5000 " 12 row)
string(REPEAT "${row}\n" 10 rows)
file(WRITE "${inputs}/ocean.asc" "ncols 12\nnrows 10\nxllcenter 174\nyllcenter -50\ncellsize 1\nNODATA_value -9999\n${rows}")
file(WRITE "${inputs}/arctic.asc" "ncols 12\nnrows 10\nxllcenter 174\nyllcenter 79\ncellsize 1\nNODATA_value -9999\n${rows}")
set(ocean "$SWELLRAY trace $IN/ocean.asc --crs EPSG:4326 --earth ellipsoid --period 16 --direction 210 --height 3 --spacing 50000")
swellray_cli_test(ellipsoid_info 0 "Earth .*ellipsoid, on Mercator's map with scale 1 at latitude -45.5" ""
  "$SWELLRAY info $IN/ocean.asc --crs EPSG:4326 --earth ellipsoid")
swellray_cli_test(ellipsoid_trace 0 "left the scene" "" "${ocean} -o r.vtp --crests c.vtp --map m.nc && grep -qa 'Mercator of the scene' r.vtp && grep -qa MapScale r.vtp")
swellray_cli_test(ellipsoid_map 0 "Mercator .variant B" "" "${ocean} --map m.tif && gdalinfo m.tif")
swellray_cli_test(ellipsoid_stations 0 "\n179.5,-46,-5000,5000,[^\n]*,1\n[-]179.5,-46,-5000,5000,[^\n]*,1\n" ""
  "printf 'lon,lat\\n179.5,-46\\n-179.5,-46\\n' > s.csv && ${ocean} --stations s.csv --table t.csv && cat t.csv")
swellray_cli_test(ellipsoid_snell 2 "" "--scheme snell knows no ellipsoid" "${ocean} --scheme snell -o r.vtp")
swellray_cli_test(ellipsoid_smooth 2 "" "leave out smooth" "${ocean} --smooth 100 -o r.vtp")
swellray_cli_test(ellipsoid_form 2 "" "the ellipsoid needs a grid in longitude and latitude; 'plane' is a built-in form"
  "$SWELLRAY trace plane ${wave} --earth ellipsoid -o r.vtp")
swellray_cli_test(ellipsoid_plane_grid 1 "" "on the ellipsoid a grid must be in longitude and latitude"
  "${trace} --earth ellipsoid -o r.vtp")
swellray_cli_test(ellipsoid_pole 1 "" "reach beyond latitude 85"
  "$SWELLRAY trace $IN/arctic.asc --crs EPSG:4326 ${wave} --earth ellipsoid -o r.vtp")
swellray_cli_test(ellipsoid_word 2 "" "--earth must be plane or ellipsoid" "${trace} --earth sphere -o r.vtp")
swellray_cli_test(ellipsoid_current 0 "left the scene" "" "${ocean} --current shear:S=1e-6 -o r.vtp")
