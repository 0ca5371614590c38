# A small sea, refracted to places.
set(sea "--hs 2 --tp 10 --direction 90 --frequencies 4 --directions 16")
set(spectrum "$SWELLRAY spectrum plane ${sea}")
swellray_cli_test(spectrum_stations 0
  "^x,y,name,Depth,SignificantWaveHeight,PeakPeriod,MeanPeriod,ZeroCrossingPeriod,EnergyPeriod,MeanDirectionFrom,DirectionalSpread,Breaking\n50,100,buoy,1[0-9.]*,[0-9.]+,[0-9.]+,[0-9.]+,[0-9.]+,[0-9.]+,[89][0-9.]+,[0-9.]+,[01]\n.*900,100,far,18,[0-9.]+,.*\n$"
  "" "${spectrum} --quiet --stations $IN/points.csv --table t.csv 2>err; code=$?; cat t.csv; exit $code")
swellray_cli_test(spectrum_spectra 0 "offshore Hs 2 m.*wrote    t.csv and s.sp2" ""
  "${spectrum} --stations $IN/points.csv --table t.csv --spectra s.sp2 2>err && head -c 4 s.sp2 | grep -q SWAN && $SWELLRAY spectrum plane --boundary s.sp2 --frequencies 4 --directions 16 --map m.vti --map-spacing 400 --quiet")
swellray_cli_test(spectrum_map 0 "map .*wrote    m.nc" "" "${spectrum} --map m.nc --map-spacing 400 && test -s m.nc")
swellray_cli_test(spectrum_random_breaking 0 "^x,y,name,.*\n50,100,buoy,1,0\\.[3-9][0-9]*,.*,1\n.*" ""
  "${spectrum} --breaking battjes-janssen --quiet --stations $IN/points.csv --table t.csv 2>err; code=$?; cat t.csv; exit $code")
swellray_cli_test(spectrum_baldock 0 "^x,y,name,.*\n50,100,buoy,1,0\\.[2-9][0-9]*,.*,1\n.*" ""
  "${spectrum} --breaking baldock --quiet --stations $IN/points.csv --table t.csv 2>err; code=$?; cat t.csv; exit $code")
swellray_cli_test(spectrum_baldock_kept 2 "" "--breaking baldock traces rays for each sea alone"
  "${spectrum} --breaking baldock --stations $IN/points.csv --table t.csv --transfer k.nc")
swellray_cli_test(spectrum_random_breaking_kept 2 "" "leave out --series and --transfer"
  "${spectrum} --breaking battjes-janssen --stations $IN/points.csv --table t.csv --transfer k.nc")
swellray_cli_test(spectrum_rule 2 "" "--breaking" "${spectrum} --breaking dally --map m.vti")
swellray_cli_test(spectrum_nothing_to_write 2 "" "nothing to write" "${spectrum}")
swellray_cli_test(spectrum_no_sea 2 "" "one of four ways" "$SWELLRAY spectrum plane --direction 90 --map m.vti")
swellray_cli_test(spectrum_two_seas 2 "" "one of four ways" "${spectrum} --wind 10 --map m.vti")
swellray_cli_test(spectrum_no_period 2 "" "--hs needs --tp" "$SWELLRAY spectrum plane --hs 1 --direction 90 --map m.vti")
swellray_cli_test(spectrum_tma 2 "" "--offshore-depth" "${spectrum} --shape tma --map m.vti")
swellray_cli_test(spectrum_spread 2 "" "--spread" "${spectrum} --spread 0 --map m.vti")
swellray_cli_test(spectrum_boundary_missing 1 "" "nowhere.bnd" "$SWELLRAY spectrum plane --boundary nowhere.bnd --map m.vti --quiet")

# Rays that are kept: traced once, told to be of another scene, damaged.
set(kept "${spectrum} --quiet --stations $IN/points.csv --transfer k.nc")
swellray_cli_test(spectrum_transfer 0 "^same\n$" ""
  "${kept} --table a.csv 2>err && cp k.nc first.nc && ${kept} --table b.csv 2>err && cmp k.nc first.nc && ${spectrum} --quiet --stations $IN/points.csv --table c.csv 2>err && cut -d, -f1-9 a.csv > d && cut -d, -f1-9 b.csv | cmp - d && cut -d, -f1-9 c.csv | cmp - d && echo same")
swellray_cli_test(spectrum_transfer_grows 0 "^same\n$" ""
  "head -2 $IN/points.csv > one.csv && ${spectrum} --quiet --stations one.csv --transfer k.nc --table a.csv 2>err && ${kept} --table b.csv 2>err && ${spectrum} --quiet --stations $IN/points.csv --table c.csv 2>err && cut -d, -f1-9 b.csv > d && cut -d, -f1-9 c.csv | cmp - d && echo same")
swellray_cli_test(spectrum_transfer_scene 1 "" "k.nc' belongs to another scene: it has water level 0, not water level 0.5"
  "${kept} --table a.csv 2>err && ${kept} --table b.csv --water-level 0.5")
swellray_cli_test(spectrum_transfer_rays 1 "" "it has directions 16, not directions 24"
  "${kept} --table a.csv 2>err && $SWELLRAY spectrum plane --hs 2 --tp 10 --direction 90 --frequencies 4 --directions 24 --quiet --stations $IN/points.csv --transfer k.nc --table b.csv")
swellray_cli_test(spectrum_transfer_damaged 1 "" "cannot read the transfer table 'k.nc'" "echo no > k.nc; ${kept} --table a.csv")
swellray_cli_test(spectrum_transfer_band 1 "" "hold only .* of the energy"
  "${kept} --table a.csv 2>err && $SWELLRAY spectrum plane --hs 2 --tp 2 --direction 90 --frequencies 4 --directions 16 --quiet --stations $IN/points.csv --transfer k.nc --table b.csv")

# Seas in time: a row of the series is what the sea gives alone.
file(WRITE "${inputs}/seas.csv" "Time,Hs,Tp,Dir,Spread\n2026-01-01T00:00,2,10,90,25\n2026-01-01T01:00,,,,\n2026-01-01T02:00,1,8,100,15\n2026-01-01T03:00,0,8,100,15\n")
set(series "$SWELLRAY spectrum plane --frequencies 4 --directions 16 --frequency-range 0.06,0.4 --stations $IN/points.csv --table t.csv --series")
swellray_cli_test(spectrum_series 0
  "^Time,x,y,name,Depth,SignificantWaveHeight,.*\n2026-01-01T00:00,50,100,buoy,1,[0-9.]+,.*\n2026-01-01T01:00,50,100,buoy,1,,,,,,,,\n.*\n2026-01-01T03:00,50,100,buoy,1,0,,,,,,,0\n.*"
  "1 of 4 times have no sea" "${series} $IN/seas.csv --quiet 2>err; code=$?; grep times err >&2; cat t.csv; exit $code")
swellray_cli_test(spectrum_series_equals_single 0 "^same\n$" ""
  "${series} $IN/seas.csv --quiet 2>err && $SWELLRAY spectrum plane --hs 1 --tp 8 --direction 100 --spread 15 --frequencies 4 --directions 16 --frequency-range 0.06,0.4 --stations $IN/points.csv --table u.csv --quiet 2>err && [ \"$(grep T02 t.csv | tail -1 | cut -d, -f2-6 | cut -c1-20)\" = \"$(tail -1 u.csv | cut -d, -f1-5 | cut -c1-20)\" ] && echo same")
swellray_cli_test(spectrum_series_of_spectra 0 "series   2 times at 3 stations" ""
  "printf 'SWAN 1\\nTIME\\n 1\\nAFREQ\\n 3\\n 0.08\\n 0.12\\n 0.2\\nNDIR\\n 4\\n 0\\n 90\\n 180\\n 270\\nQUANT\\n 1\\nVaDens\\nm2/Hz/degr\\n -99\\n20260101.000000\\nFACTOR\\n 1\\n 0 1 0 0\\n 0 2 0 0\\n 0 1 0 0\\n20260101.010000\\nZERO\\n' > s.sp2; ${series} s.sp2 2>err")
swellray_cli_test(spectrum_series_columns 1 "" "seas.csv' line 1: the columns time, hs, tp and direction are needed"
  "printf 'time,hs\\n0,1\\n' > seas.csv; ${series} seas.csv")
swellray_cli_test(spectrum_series_value 1 "" "seas.csv' line 3: '-1' is no peak period"
  "printf 'time,hs,tp,dir\\n0,1,9,0\\n1,1,-1,0\\n' > seas.csv; ${series} seas.csv")
swellray_cli_test(spectrum_series_and_map 2 "" "--series makes a table in time" "${series} $IN/seas.csv --map m.nc")
swellray_cli_test(spectrum_series_missing 1 "" "cannot read 'none.csv'" "${series} none.csv")
swellray_cli_test(spectrum_range 2 "" "--frequency-range needs F0,F1" "${spectrum} --frequency-range 0.3,0.1 --map m.vti")

# Elevation in time at stations.
set(elevation "${spectrum} --quiet --stations $IN/points.csv --elevation-series e.csv --duration 300 --interval 0.5")
swellray_cli_test(spectrum_elevation 0 "^Time,Elevation1,Elevation2,Elevation3\n0,[-0-9.]+,[-0-9.]+,[-0-9.]+\n601\n$" ""
  "${elevation} 2>err; code=$?; head -2 e.csv; wc -l < e.csv; exit $code")
swellray_cli_test(spectrum_elevation_seed 0 "^same\nother\n$" ""
  "${elevation} 2>err; cp e.csv f.csv; ${elevation} 2>err; cmp e.csv f.csv && echo same; ${elevation} --seed 2 2>err; cmp -s e.csv f.csv || echo other")
swellray_cli_test(spectrum_elevation_short 1 "" "elevation at station 1: a record of .* too short" "${spectrum} --quiet --stations $IN/points.csv --elevation-series e.csv --duration 10")
swellray_cli_test(spectrum_elevation_samples 2 "" "it must be 2 to a million" "${spectrum} --stations $IN/points.csv --elevation-series e.csv --interval 1e-9" )

# Spectra in other formats.
swellray_cli_test(spectrum_netcdf 0 "wrote    s.nc.*Hs [0-9.]+ to [0-9.]+ m" ""
  "${spectrum} --stations $IN/points.csv --spectra s.nc 2>err && $SWELLRAY spectrum plane --boundary s.nc --frequencies 4 --directions 16 --map m.vti --map-spacing 400 2>err")
swellray_cli_test(spectrum_buoy 0 "offshore Hs 1.26 m, .* from 300 degrees" ""
  "h='#YY MM DD hh mm .06 .10 .14'; t='2020 01 02 03 00'; for k in 'w 0 2.5 0' 'd 999 300 999' 'j 999 85 999' 'i 999 300 999' 'k 999 60 999'; do set -- $k; printf '%s\n%s %s %s %s\n' \"$h\" \"$t\" $2 $3 $4 > 1\${1}2020.txt; done; $SWELLRAY spectrum plane --boundary 1w2020.txt --frequencies 4 --directions 16 --map m.vti --map-spacing 400 2>err")
swellray_cli_test(spectrum_buoy_alone 1 "" "has no directions" "printf '#YY MM DD hh mm .06 .10\n2020 01 02 03 00 1 1\n' > b.txt; $SWELLRAY spectrum plane --boundary b.txt --map m.vti --quiet")
