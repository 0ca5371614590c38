# trace --method mild-slope.
set(shoal_waves "$SWELLRAY trace berkhoff:x0=-8,x1=8,y0=-6,y1=6 --period 1 --direction 270 --height 0.0464 --offshore-depth 0.45 --node-spacing 0.14")
set(mild_slope "${shoal_waves} --method mild-slope --breaking none")
file(WRITE "${inputs}/tank.csv" "x,y\n4,0\n50,0\n")
foreach(ending vti nc tif)
  swellray_cli_test(mild_slope_${ending} 0 "mesh .*cost .*heights  up to 0[.]1.*for 1 solutions.*wrote    m.${ending}; open" ""
    "${mild_slope} --side-walls --map m.${ending} --map-spacing 0.5 && test -s m.${ending} && [ $(ls -A | wc -l) = 1 ]")
endforeach()
swellray_cli_test(mild_slope_stations 0
  "^x,y,Elevation,Depth,WaveHeight,DirectionFrom,Wavelength,Breaking,WavePhase\n4,0,-0[.]2[0-9]*,0[.]2[0-9]*,0[.]1[0-9]*,2[67][0-9.]*,1[.][0-9]*,0,[-0-9.]+\n50,0,,,,,,,\n$"
  "no wave came to 1 of 2 points of '.*tank.csv'"
  "${mild_slope} --quiet --stations $IN/tank.csv --table t.csv 2>err; code=$?; grep 'no wave' err >&2; cat t.csv; exit $code")
swellray_cli_test(mild_slope_nonlinear 0 "for [2-9][0-9]* solutions" ""
  "${shoal_waves} --method mild-slope --dispersion nonlinear --friction 0.01 --coast-reflection 0.2 --map m.vti --map-spacing 0.5")
swellray_cli_test(mild_slope_dry_run 0 "mesh .*nodes .*in the shortest wavelength.*cost .*GB of memory and about" ""
  "${mild_slope} --dry-run && [ $(ls -A | wc -l) = 0 ]")
swellray_cli_test(mild_slope_too_large 1 "" "needs .* GB of memory, more than .*a spacing of the nodes of .* would fit .*or a crop to"
  "$SWELLRAY trace island --period 10 --direction 270 --height 1 --method mild-slope --map m.vti --max-memory 2")
swellray_cli_test(mild_slope_no_rays 2 "" "--method mild-slope has no rays to write" "${mild_slope} -o r.vtp")
swellray_cli_test(mild_slope_no_current 2 "" "--method mild-slope knows no current" "${mild_slope} --map m.vti --current jet")
swellray_cli_test(mild_slope_options_alone 2 "" "belong to --method mild-slope" "${shoal_waves} --map m.vti")
swellray_cli_test(mild_slope_reflection 2 "" "--coast-reflection must be" "${mild_slope} --map m.vti --coast-reflection 1.2")
swellray_cli_test(mild_slope_too_coarse 1 "" "at least 4 are needed" "$SWELLRAY trace berkhoff --period 1 --direction 270 --height 0.04 --method mild-slope --map m.vti --node-spacing 0.5")
swellray_cli_test(mild_slope_obstacles 0 "heights  up to" "scene's file"
  "$SWELLRAY trace $IN/beach.asc --obstacles $IN/wall.geojson --reflection 0.5 ${wave} --method mild-slope --node-spacing 3 --min-depth 1 --map m.vti && grep -qa ObstaclePoints m.vti")
