# Lines for maps: GeoPackage and GeoJSON.
set(placed "${trace} --quiet --crs EPSG:32605")
swellray_cli_test(lines_gpkg 0 "wrote    r.gpkg and c.gpkg and m.vti; open with: paraview m.vti, qgis r.gpkg c.gpkg\nSQLite format 3\n3\n$" "coarse"
  "${trace} -o r.gpkg --crests c.gpkg --points --map m.vti && head -c 15 r.gpkg && echo && grep -qa rays_points r.gpkg && ls -A | wc -l")
swellray_cli_test(lines_geojson 0 "urn:ogc|\"FeatureCollection\"" "coarse" "${placed} -o r.geojson && head -c 60 r.geojson")
swellray_cli_test(lines_geojson_local 1 "" "cannot write 'r.geojson': GeoJSON holds longitude and latitude, and the seafloor has no place"
  "${trace} --quiet -o r.geojson 2>err; code=$?; grep cannot err >&2; exit $code")
swellray_cli_test(lines_contours 0 "wrote c.gpkg; open with: qgis c.gpkg" "" "$SWELLRAY contour $IN/beach.asc --levels 2,5 -o c.gpkg && grep -qa contours c.gpkg")
swellray_cli_test(lines_breakers 0 "wrote    b.geojson; open with: qgis b.geojson" "coarse"
  "${trace} --crs EPSG:32605 --breaker-line b.geojson && grep -q BreakerHeightMean b.geojson")
foreach(ending gpkg geojson)
  swellray_cli_test(lines_${ending}_full_disk 1 "^0\n$" "cannot write 'r.${ending}'"
    "( ulimit -f 8; ${placed} -o r.${ending} 2>err ); code=$? ; grep cannot err >&2 ; ls -A | grep -vc err ; exit $code")
endforeach()
swellray_cli_test(lines_ending 2 "" "--output must end in .vtp, .gpkg or .geojson, not 'r.shp'" "${trace} -o r.shp")
swellray_cli_test(lines_points 2 "" "--points needs a file of lines that ends in .gpkg" "${trace} -o r.vtp --points")
# CGAL orders points of equal cost by their addresses, which no two runs have alike.
set(simplified "$SWELLRAY contour shoal --interval 0.1 --simplify 1 --quiet -o c.vtp")
swellray_cli_test(contour_same_twice 0 "^same\n$" "" "${simplified} && mv c.vtp d.vtp && ${simplified} && cmp c.vtp d.vtp && echo same")
