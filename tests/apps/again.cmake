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
