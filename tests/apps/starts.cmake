# Rays from lines, points and a site.
file(WRITE "${inputs}/launch.geojson" [=[{"type":"FeatureCollection","features":[{"type":"Feature","properties":{},
"geometry":{"type":"LineString","coordinates":[[900,-300],[900,300]]}}]}]=])
file(WRITE "${inputs}/dots.geojson" [=[{"type":"FeatureCollection","features":[{"type":"Feature","properties":{},
"geometry":{"type":"Point","coordinates":[900,-300]}}]}]=])
file(WRITE "${inputs}/launch.csv" "x,y,direction\n900,0,90\n800,100,70\n")
file(WRITE "${inputs}/places.csv" "x,y\n900,0\n800,100\n")
set(beach "$SWELLRAY trace plane --period 8 --height 1")
swellray_cli_test(launch_lines 0 "spacing .* over 600 m of crest" "" "${beach} --direction 90 --launch $IN/launch.geojson -o r.vtp --map m.nc")
swellray_cli_test(launch_points 0 "launch +2 points.*rays +2: 2 launched" "" "${beach} --launch $IN/launch.csv -o r.vtp")
swellray_cli_test(launch_points_direction 0 "rays +2: 2 launched" "" "${beach} --direction 80 --launch $IN/places.csv -o r.vtp")
swellray_cli_test(launch_no_direction 2 "" "trace needs --direction DEG: .*has no direction for every point"
  "${beach} --launch $IN/places.csv -o r.vtp")
swellray_cli_test(launch_lines_no_direction 2 "" "has no direction for its lines" "${beach} --launch $IN/launch.geojson -o r.vtp")
swellray_cli_test(launch_outside 1 "" "a launch line leaves the scene"
  "$SWELLRAY trace plane:x1=500 --period 8 --height 1 --direction 90 --launch $IN/launch.geojson -o r.vtp")
swellray_cli_test(launch_kind 1 "" "launch lines .*dots.geojson': it has a geometry of the kind 'POINT': only lines"
  "${beach} --direction 90 --launch $IN/dots.geojson -o r.vtp")
swellray_cli_test(launch_missing 1 "" "launch lines 'none.geojson': no such file" "${beach} --direction 90 --launch none.geojson -o r.vtp")
swellray_cli_test(launch_surface 0 "" "" "$SWELLRAY surface plane --period 8 --height 1 --direction 90 --spacing 50 --launch $IN/launch.geojson -o s.vtp")
set(site "$SWELLRAY trace plane --period 8 --from-site 300,0")
swellray_cli_test(site 0 "site +6 m deep; waves come there from offshore in [1-9][0-9]* of 36 directions.*followed back" ""
  "${site} --directions 36 -o w.vtp && grep -qa OffshoreDirectionFrom w.vtp")
swellray_cli_test(site_gpkg 0 "" "" "${site} -o w.gpkg && ogrinfo -q w.gpkg")
swellray_cli_test(site_dry 1 "" "it must lie within the scene and in water" "$SWELLRAY trace plane --period 8 --from-site -20,0 -o w.vtp")
swellray_cli_test(site_height 2 "" "trace needs --height" "$SWELLRAY trace plane --period 8 --direction 90 -o w.vtp")
swellray_cli_test(site_direction 2 "" "--from-site follows rays back from all directions" "${site} --direction 90 -o w.vtp")
swellray_cli_test(site_map 2 "" "--from-site writes rays only" "${site} -o w.vtp --map m.nc")
swellray_cli_test(site_numbers 2 "" "--from-site needs X,Y, not '300'" "$SWELLRAY trace plane --period 8 --from-site 300 -o w.vtp")
swellray_cli_test(directions_alone 2 "" "--directions needs --from-site" "${beach} --direction 90 --directions 10 -o r.vtp")
