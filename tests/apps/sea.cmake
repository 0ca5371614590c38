# The surface of a sea.
set(patch "--hs 1 --tp 5 --direction 240 --size 100 --spacing 4 --components 40")
set(surface_of_sea "$SWELLRAY sea ${patch}")
swellray_cli_test(help_sea 0 "Examples:\n  swellray sea" "" "$SWELLRAY sea --help")
swellray_cli_test(sea_mesh 0 "sea      Hs 1 m, Tp 5 s; trochoids up to [0-9.]+ Hz, then turbulence.*wrote    s.vtp" ""
  "${surface_of_sea} -o s.vtp && grep -q SurfaceHeight s.vtp")
swellray_cli_test(sea_images 0 "heights  -1.25 to 1.25 m.*wrote    h.png and n.png" ""
  "$SWELLRAY sea --hs 1 --tp 5 --direction 240 --size 150 --tile --pixels 64 --height-map h.png --normal-map n.png && file h.png | grep -q '64 x 64, 16-bit' && file n.png | grep -q '64 x 64, 8-bit/color RGB'")
swellray_cli_test(sea_tif 0 "wrote    h.tif and n.tif" ""
  "${surface_of_sea} --pixels 64 --height-map h.tif --normal-map n.tif && $SWELLRAY info h.tif --crs local | grep -q '64 x 64'")
swellray_cli_test(sea_picture 0 "wrote    p.png" ""
  "env -u DISPLAY ${surface_of_sea} --picture p.png --picture-size 400x400 && file p.png | grep -q '400 x 400, 8-bit/color RGB'")
swellray_cli_test(sea_series 0 "^3\n3\nframes   3: 0 made in [0-9.]+ s, 3 kept\n$" ""
  "${surface_of_sea} --times 0:1:0.5 -o s.pvd > first && grep -c DataSet s.pvd && ls s | wc -l && ${surface_of_sea} --times 0:1:0.5 -o s.pvd | grep frames")
swellray_cli_test(sea_wind 0 "Tp 5.23 s" "" "$SWELLRAY sea --wind 6.67 --direction 0 --spread 30 --spreading normal --turbulence off --spacing 20 -o s.vtp")
swellray_cli_test(sea_no_sea 2 "" "one of two ways" "$SWELLRAY sea --direction 0 -o s.vtp")
swellray_cli_test(sea_no_direction 2 "" "sea needs --direction" "$SWELLRAY sea --hs 1 --tp 5 -o s.vtp")
swellray_cli_test(sea_no_output 2 "" "sea has nothing to write" "${surface_of_sea}")
swellray_cli_test(sea_series_and_image 2 "" "images and pictures are of one --time"
  "${surface_of_sea} --times 0:1:1 -o s.pvd --height-map h.png")
swellray_cli_test(sea_two_spreads 2 "" "--spread is that of --spreading cosine or normal" "${surface_of_sea} --spread 20 --spreading thon -o s.vtp")
swellray_cli_test(sea_spacing 2 "" "--spacing must be at most --size" "$SWELLRAY sea --hs 1 --tp 5 --direction 0 --size 10 --spacing 20 -o s.vtp")
swellray_cli_test(sea_small_tile 1 "" "a tile of 50[.0-9]* m is too small for waves of 100 m; choose a size of at least 300 m" "$SWELLRAY sea --hs 1 --tp 8 --direction 0 --size 50 --tile -o s.vtp")
swellray_cli_test(sea_same_file 2 "" "--height-map and --normal-map name the same file" "${surface_of_sea} --height-map a.png --normal-map ./a.png")
swellray_cli_test(sea_image_full_disk 1 "^0\n$" "cannot write 'h.tif'"
  "( ulimit -f 8; ${surface_of_sea} --quiet --height-map h.tif --pixels 512 2>err ); code=$? ; grep cannot err >&2 ; ls -A | grep -vc err ; exit $code")
swellray_cli_test(sea_large_tile 1 "" "a tile of 9000 m is too large for waves of 96 m; choose a size of at most 4800 m"
  "$SWELLRAY sea --wind 10 --direction 270 --size 9000 --spacing 100 --tile -o s.vtp")
