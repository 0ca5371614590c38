# An output made again by the command line that it carries: the same bytes.
set(record "$SWELLRAY trace plane:facing=270 ${wave} --spacing 50")
swellray_cli_test(again_rays 0 "again    swellray trace plane:facing=270 .*wrote    check/r.vtp and check/c.vtp.*\nsame\n$" ""
  "${record} -o r.vtp --crests c.vtp >/dev/null 2>&1 && $SWELLRAY again r.vtp --into check && cmp r.vtp check/r.vtp && cmp c.vtp check/c.vtp && echo same")
swellray_cli_test(again_in_place 0 "^same\n$" ""
  "${record} -o r.vtp --quiet 2>/dev/null && cp r.vtp old && rm r.vtp && cp old copy.vtp && $SWELLRAY again copy.vtp --quiet && cmp old r.vtp && echo same")
foreach(ending vti nc tif)
  swellray_cli_test(again_map_${ending} 0 "again    swellray trace .*wrote    check/m.${ending}" ""
    "${record} --map m.${ending} --map-spacing 50 >/dev/null 2>&1 && $SWELLRAY again m.${ending} --into check && test -s check/m.${ending}")
endforeach()
swellray_cli_test(again_gpkg 0 "^swellray trace plane:facing=270 --period 6 .*-o r.gpkg\n$" ""
  "${record} -o r.gpkg >/dev/null 2>&1 && $SWELLRAY again r.gpkg --show")
swellray_cli_test(again_series 0 "^swellray surface 'plane:facing=270,x1=400' .*-o s.pvd\n$" ""
  "$SWELLRAY surface 'plane:facing=270,x1=400' ${wave} --spacing 100 --times 0:1:1 -o s.pvd >/dev/null 2>&1; $SWELLRAY again s.pvd --show | sed \"s/ plane:facing=270,x1=400/ 'plane:facing=270,x1=400'/\"")
swellray_cli_test(again_quoted 0 "^swellray contour 'a b.asc' --interval 5 -o 'it'.''s.vtp'\n$" ""
  "cp $IN/beach.asc 'a b.asc' && $SWELLRAY contour 'a b.asc' --interval 5 -o \"it's.vtp\" >/dev/null && $SWELLRAY again \"it's.vtp\" --show && mkdir new && $SWELLRAY again \"it's.vtp\" --into new >/dev/null && cmp \"it's.vtp\" \"new/it's.vtp\"")
# A configuration file may change: its options are kept in its place.
swellray_cli_test(again_config 0 "^swellray trace plane:facing=270 -o r.vtp --quiet --period=6 --direction=270 --height=0.5\nsame\n$" ""
  "cp $IN/wave.toml w.toml && $SWELLRAY trace plane:facing=270 --config w.toml -o r.vtp --quiet 2>/dev/null && rm w.toml && $SWELLRAY again r.vtp --show && $SWELLRAY again r.vtp --into new --quiet && cmp r.vtp new/r.vtp && echo same")
swellray_cli_test(again_nothing 2 "" "again needs a FILE" "$SWELLRAY again")
swellray_cli_test(again_missing 1 "" "cannot read 'r.vtp': no such file" "$SWELLRAY again r.vtp")
swellray_cli_test(again_damaged 1 "" "damaged.vtp': it is no VTK file, or damaged" "$SWELLRAY again $IN/damaged.vtp")
swellray_cli_test(again_no_record 1 "" "beach.asc' does not say how it was made" "$SWELLRAY again $IN/beach.asc")
swellray_cli_test(again_gone 1 "" "seafloor 'b.asc': no such file"
  "cp $IN/beach.asc b.asc && $SWELLRAY contour b.asc --interval 5 -o c.vtp --quiet && rm b.asc && $SWELLRAY again c.vtp --quiet")
# Pictures, scenes and spectra say how they were made, too.
set(picture "bay --period 3 --direction 90 --height 0.4")
swellray_cli_test(again_chart 0 "^swellray render bay --size 500x400 -o p.png --quiet\nsame\n$" ""
  "$SWELLRAY render bay --size 500x400 -o p.png --quiet && $SWELLRAY again p.png --show && $SWELLRAY again p.png --into new --quiet && cmp p.png new/p.png && echo same")
swellray_cli_test(again_gltf 0 "^swellray render ${picture} --quiet --export s.gltf\nsame\n$" ""
  "$SWELLRAY render ${picture} --quiet --export s.gltf && $SWELLRAY again s.gltf --show && $SWELLRAY again s.gltf --into new --quiet && cmp s.gltf new/s.gltf && echo same")
swellray_cli_test(again_page 0 "^swellray render ${picture} --quiet --title '<a> & b' --export s.html\n$" ""
  "echo 'var vtk;' > v.js; SWELLRAY_VTKJS=v.js $SWELLRAY render ${picture} --quiet --title '<a> & b' --export s.html && $SWELLRAY again s.html --show")
swellray_cli_test(again_spectra 0 "^swellray spectrum bay .*--spectra s.sp2 --quiet\nsame\n$" ""
  "echo 'x,y\n20,0' > p.csv; $SWELLRAY spectrum bay --hs 0.4 --tp 3 --direction 90 --frequencies 2 --directions 8 --stations p.csv --spectra s.sp2 --quiet && $SWELLRAY again s.sp2 --show && $SWELLRAY again s.sp2 --into new --quiet && cmp s.sp2 new/s.sp2 && echo same")
swellray_cli_test(again_sea_image 0 "^swellray sea --hs 1 --tp 5 --direction 240 --pixels 32 --normal-map n.png --quiet\n$" ""
  "$SWELLRAY sea --hs 1 --tp 5 --direction 240 --pixels 32 --normal-map n.png --quiet && $SWELLRAY again n.png --show")
swellray_cli_test(again_geojson 0 "^swellray contour g.asc --crs EPSG:32631 --interval 5 -o c.geojson --quiet\n$" ""
  "sed 's/llcorner 0/llcorner 500000/' $IN/beach.asc > g.asc; $SWELLRAY contour g.asc --crs EPSG:32631 --interval 5 -o c.geojson --quiet && $SWELLRAY again c.geojson --show")
swellray_cli_test(again_every_output 0 "^o.vtp\nspray.vtp\n$" ""
  "$SWELLRAY surface ${picture} -o o.vtp --spray spray.vtp --quiet && mv spray.vtp old && $SWELLRAY again o.vtp --into new --quiet && test ! -e spray.vtp && ls new")
swellray_cli_test(again_table 1 "" "'t.csv' does not say how it was made, as .csv files cannot: take another output"
  "echo 'x,y' > t.csv; $SWELLRAY again t.csv")
swellray_cli_test(again_no_picture 1 "" "'p.png': it is no .png picture" "echo text > p.png; $SWELLRAY again p.png")
swellray_cli_test(again_no_scene 1 "" "'s.html' does not say how it was made" "echo text > s.html; $SWELLRAY again s.html")
