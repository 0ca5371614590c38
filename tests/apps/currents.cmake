# Waves on currents.
file(WRITE "${inputs}/v.asc" "ncols 5\nnrows 5\nxllcorner -60\nyllcorner -60\ncellsize 80\nNODATA_value -9999\n"
  "0.5 0.5 0.5 0.5 0.5\n0.5 0.5 0.5 0.5 0.5\n0.5 0.5 -9999 0.5 0.5\n0.5 0.5 0.5 0.5 0.5\n0.5 0.5 0.5 0.5 0.5\n")
function(write_bands name size)
  set(bands "")
  foreach(band 1 2)
    string(APPEND bands "<VRTRasterBand dataType=\"Float32\" band=\"${band}\"><NoDataValue>-9999</NoDataValue>"
      "<SimpleSource><SourceFilename relativeToVRT=\"1\">v.asc</SourceFilename><SourceBand>1</SourceBand>"
      "<SrcRect xOff=\"0\" yOff=\"0\" xSize=\"5\" ySize=\"5\"/><DstRect xOff=\"0\" yOff=\"0\" xSize=\"5\" ySize=\"5\"/>"
      "</SimpleSource></VRTRasterBand>")
  endforeach()
  file(WRITE "${inputs}/${name}" "<VRTDataset rasterXSize=\"5\" rasterYSize=\"5\">"
    "<GeoTransform>-60, ${size}, 0, 340, 0, -${size}</GeoTransform>${bands}</VRTDataset>")
endfunction()
write_bands(current.vrt 80)
write_bands(small.vrt 20)
string(REPEAT "0.3 -0.2 0 " 25 vectors)
file(WRITE "${inputs}/current.vti" "<VTKFile type=\"ImageData\" version=\"0.1\"><ImageData WholeExtent=\"0 4 0 4 0 0\""
  " Origin=\"-5 -5 0\" Spacing=\"60 60 60\"><Piece Extent=\"0 4 0 4 0 0\"><PointData><DataArray type=\"Float64\""
  " Name=\"Current\" NumberOfComponents=\"3\" format=\"ascii\">${vectors}</DataArray></PointData></Piece></ImageData></VTKFile>")
file(WRITE "${inputs}/scalar.vti" "<VTKFile type=\"ImageData\" version=\"0.1\"><ImageData WholeExtent=\"0 1 0 1 0 0\""
  " Origin=\"0 0 0\" Spacing=\"60 60 60\"><Piece Extent=\"0 1 0 1 0 0\"><PointData><DataArray type=\"Float64\""
  " Name=\"Current\" format=\"ascii\">1 2 3 4</DataArray></PointData></Piece></ImageData></VTKFile>")

set(shoal "$SWELLRAY trace shoal:depth=60 --direction 270 --height 1 --spacing 60")
swellray_cli_test(list_currents 0 "Built-in currents.*jet.*V0.*shear.*rate.*eddy.*radius" "" "$SWELLRAY list")
foreach(current jet:V0=2,w=200 shear:S=0.0005,heading=45 eddy:U0=1.5,R=400,yc=200)
  string(REGEX REPLACE ":.*" "" name "${current}")
  swellray_cli_test(current_${name} 0 "left the scene" "" "${shoal} --period 10 --current ${current} -o r.vtp && grep -qa 'Name=.Current.' r.vtp")
endforeach()
swellray_cli_test(current_blocks 0 "blocked by a current" "" "${shoal} --period 5 --current eddy:U0=2.5,R=300 -o r.vtp")
swellray_cli_test(current_raster 0 "rays " "1 of 25 nodes of the current have no data" "${trace} --current $IN/current.vrt -o r.vtp")
swellray_cli_test(current_image 0 "rays " "coarse" "${trace} --current $IN/current.vti -o r.vtp")
swellray_cli_test(current_too_small 1 "" "must cover all of the scene" "${trace} --quiet --current $IN/small.vrt -o r.vtp")
swellray_cli_test(current_unknown 2 "" "unknown built-in current 'jett'; did you mean 'jet'" "${trace} --current jett:V0=1 -o r.vtp")
swellray_cli_test(current_snell 2 "" "--scheme snell knows no current" "${trace} --scheme snell --current jet -o r.vtp")
swellray_cli_test(current_misspelt 2 "" "unknown built-in current 'jett'; did you mean 'jet'" "${trace} --current jett -o r.vtp")
swellray_cli_test(current_missing 1 "" "current 'none.nc': no such file" "${trace} --current none.nc -o r.vtp")
swellray_cli_test(current_text 1 "" "current '.*text.tif': not a raster" "${trace} --current $IN/text.tif -o r.vtp")
swellray_cli_test(current_one_band 1 "" "current '.*beach.asc': .*two variables or bands" "${trace} --current $IN/beach.asc -o r.vtp")
swellray_cli_test(current_scalar 1 "" "current '.*scalar.vti': it has no point array Current" "${trace} --current $IN/scalar.vti -o r.vtp")
swellray_cli_test(current_is_input 1 "" "is an input of this call" "cp $IN/current.vti r.vtp && ${trace} --current r.vtp -o r.vtp")
