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

# A sea that enters from the west, 810 km away, comes from 7.6 degrees further south along its geodesic.
file(WRITE "${inputs}/degrees.csv" "lon,lat\n184.5,-46\n")
set(ocean_sea "$SWELLRAY spectrum $IN/ocean.asc --crs EPSG:4326 --hs 2 --tp 14 --direction 270 --spread 5 --edge none --frequencies 3 --directions 72")
swellray_cli_test(ellipsoid_spectrum 0 "\n184.5,-46,5000,(2|1.99[0-9]*|2.00[0-9]*),[^\n]*,262[.][0-9]+,5[0-9.]*,0\n" ""
  "${ocean_sea} --earth ellipsoid --quiet --stations $IN/degrees.csv --table t.csv && cat t.csv")
swellray_cli_test(ellipsoid_spectrum_plane 0 "\n184.5,-46,5000,[^\n]*,270[0-9.]*,5[0-9.]*,0\n" ""
  "${ocean_sea} --quiet --stations $IN/degrees.csv --table t.csv && cat t.csv")
swellray_cli_test(ellipsoid_spectrum_map 0 "Mercator .variant B" ""
  "${ocean_sea} --earth ellipsoid --map m.tif --map-spacing 400000 && gdalinfo m.tif")

# Waves from a storm or a point.
set(storm "$SWELLRAY trace $IN/ocean.asc --crs EPSG:4326 --earth ellipsoid --period 16 --height 3 --spacing 50000 --steps-per-wave 0.1")
swellray_cli_test(storm_trace 0 "source +[0-9.e+]+ m away; the waves first arrive from 1[0-9.]+ degrees, over the edges from" ""
  "${storm} --from-storm 170,-60 -o r.vtp && grep -qa SourceDistance r.vtp")
swellray_cli_test(storm_plane 1 "" "says where on Earth it lies: give its CRS"
  "$SWELLRAY trace plane --period 6 --height 1 --from-storm 170,-60 -o r.vtp")
swellray_cli_test(storm_inside 1 "" "must lie outside of the scene" "${storm} --from-storm 178,-45 -o r.vtp")
swellray_cli_test(storm_opposite 1 "" "nearly opposite the scene" "${storm} --from-storm 0,46 -o r.vtp")
swellray_cli_test(storm_latitude 2 "" "--from-storm needs a longitude within -360 to 360 and a latitude within -90 to 90 degrees, not '170,-95'"
  "${storm} --from-storm 170,-95 -o r.vtp")
swellray_cli_test(storm_one_number 2 "" "--from-storm needs LON,LAT, not '170'" "${storm} --from-storm 170 -o r.vtp")
swellray_cli_test(storm_and_direction 2 "" "--direction is that of a plane wave"
  "${storm} --from-storm 170,-60 --direction 200 -o r.vtp")
swellray_cli_test(storm_and_point 2 "" "--from-storm and --from-point exclude each other"
  "${storm} --from-storm 170,-60 --from-point 1,2 -o r.vtp")
swellray_cli_test(point_trace 0 "source +100 m away; the waves first arrive from (90|89.9[0-9]*|90.0[0-9]*) degrees" ""
  "$SWELLRAY trace plane --period 6 --height 0.5 --from-point 2500,0 -o r.vtp --map m.nc")
swellray_cli_test(point_degrees 1 "" "waves from a point need a plane" "${storm} --from-point 170,-60 -o r.vtp")
swellray_cli_test(point_mild_slope 2 "" "mild-slope takes a plane wave"
  "$SWELLRAY trace $IN/beach.asc --period 6 --height 0.5 --from-point -50,100 --method mild-slope --map m.nc")
swellray_cli_test(no_direction 2 "" "trace needs --direction DEG" "$SWELLRAY trace plane --period 6 --height 1 -o r.vtp")
