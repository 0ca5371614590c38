# A small sea, refracted to places.
set(sea "--hs 2 --tp 10 --direction 90 --frequencies 4 --directions 16")
set(spectrum "$SWELLRAY spectrum plane ${sea}")
swellray_cli_test(spectrum_stations 0
  "^x,y,name,Depth,SignificantWaveHeight,PeakPeriod,MeanPeriod,ZeroCrossingPeriod,EnergyPeriod,MeanDirectionFrom,DirectionalSpread,Breaking\n50,100,buoy,1[0-9.]*,[0-9.]+,[0-9.]+,[0-9.]+,[0-9.]+,[0-9.]+,[89][0-9.]+,[0-9.]+,[01]\n.*900,100,far,18,[0-9.]+,.*\n$"
  "" "${spectrum} --quiet --stations $IN/points.csv --table t.csv 2>err; code=$?; cat t.csv; exit $code")
swellray_cli_test(spectrum_spectra 0 "offshore Hs 2 m.*wrote    t.csv and s.sp2" ""
  "${spectrum} --stations $IN/points.csv --table t.csv --spectra s.sp2 2>err && head -c 4 s.sp2 | grep -q SWAN && $SWELLRAY spectrum plane --boundary s.sp2 --frequencies 4 --directions 16 --map m.vti --map-spacing 400 --quiet")
swellray_cli_test(spectrum_map 0 "map .*wrote    m.nc" "" "${spectrum} --map m.nc --map-spacing 400 && test -s m.nc")
swellray_cli_test(spectrum_nothing_to_write 2 "" "nothing to write" "${spectrum}")
swellray_cli_test(spectrum_no_sea 2 "" "one of three ways" "$SWELLRAY spectrum plane --direction 90 --map m.vti")
swellray_cli_test(spectrum_two_seas 2 "" "one of three ways" "${spectrum} --wind 10 --map m.vti")
swellray_cli_test(spectrum_no_period 2 "" "--hs needs --tp" "$SWELLRAY spectrum plane --hs 1 --direction 90 --map m.vti")
swellray_cli_test(spectrum_tma 2 "" "--offshore-depth" "${spectrum} --shape tma --map m.vti")
swellray_cli_test(spectrum_spread 2 "" "--spread" "${spectrum} --spread 0 --map m.vti")
swellray_cli_test(spectrum_boundary_missing 1 "" "nowhere.bnd" "$SWELLRAY spectrum plane --boundary nowhere.bnd --map m.vti --quiet")
