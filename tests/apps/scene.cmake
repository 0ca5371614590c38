# Pictures of the water itself, as their users meet them; what is seen on them is tested in tests/scene.
set(scene "$SWELLRAY render bay --style scene --period 3 --direction 90 --height 0.4 --quiet")

swellray_cli_test(scene_without_wave 2 "" "--style scene needs waves" "$SWELLRAY render bay --style scene -o p.png")
swellray_cli_test(scene_of_rays 2 "" "traces its own rays" "${scene} --rays r.vtp -o p.png")
swellray_cli_test(scene_ellipsoid 2 "" "--style scene works on a plane" "${scene} --earth ellipsoid -o p.png")
swellray_cli_test(scene_camera_name 2 "" "--camera must be shore, aerial or chart, not 'boat'" "${scene} --camera boat -o p.png")
swellray_cli_test(scene_camera_numbers 2 "" "--camera needs shore, aerial, chart or" "${scene} --camera 1,2,3 -o p.png")
swellray_cli_test(scene_camera_nowhere 2 "" "of two places" "${scene} --camera 1,2,3,1,2,3 -o p.png")
swellray_cli_test(scene_sun_set 2 "" "elevation of 2 to 90 degrees" "${scene} --sun 180,-3 -o p.png")
swellray_cli_test(scene_movie_without_times 2 "" "a movie needs --times" "${scene} -o m.ogv")
swellray_cli_test(scene_times_without_movie 2 "" "--times needs a movie, numbered pictures" "${scene} --times 0:1:0.1 -o p.png")
swellray_cli_test(chart_camera 2 "" "need --style scene" "$SWELLRAY render bay --camera aerial -o p.png")
swellray_cli_test(chart_spray 2 "" "need --style scene" "$SWELLRAY render bay --spray-rate 5 -o p.png")
swellray_cli_test(chart_movie 2 "" "need --style scene" "$SWELLRAY render bay -o p.ogv")
swellray_cli_test(scene_no_display 1 "" "no display to draw on" "env -u DISPLAY PATH=/nowhere ${scene} -o p.png")
swellray_cli_test(chart_time 2 "" "need --style scene" "$SWELLRAY render bay --time 2 -o p.png")
swellray_cli_test(render_nothing 2 "" "render has nothing to write" "$SWELLRAY render bay")
swellray_cli_test(export_ending 2 "" "--export must end in .gltf or .html" "${scene} --export s.obj")
swellray_cli_test(export_without_wave 2 "" "--style scene needs waves" "$SWELLRAY render bay --export s.gltf")
swellray_cli_test(export_gltf 0 "^seafloor sea rays spray .*\n$" ""
  "env -u DISPLAY ${scene} --time 1 --export s.gltf && python3 -c 'import json; print(*[each[\"name\"] for each in json.load(open(\"s.gltf\"))[\"nodes\"]])'")
swellray_cli_test(export_gltf_without_spray 0 "^seafloor sea rays Camera Node Renderer Node\n$" ""
  "${scene} --spray-rate 0 --export s.gltf && python3 -c 'import json; print(*[each[\"name\"] for each in json.load(open(\"s.gltf\"))[\"nodes\"]])'")
swellray_cli_test(export_gltf_times 0 "^waves 2\n$" ""
  "${scene} --times 0:2:1 --export s.gltf && python3 -c 'import json; g = json.load(open(\"s.gltf\")); print(g[\"animations\"][0][\"name\"], len(g[\"meshes\"][1][\"primitives\"][0][\"targets\"]))'")
swellray_cli_test(export_gltf_full_disk 1 "^0\n$" "cannot write 's.gltf'"
  "( ulimit -f 8; ${scene} --export s.gltf 2>err ); code=$? ; cat err >&2 ; ls -A | grep -vc err ; exit $code")

# Any text stands for vtk.js here: what a browser makes of the page is tested in tests/scene.
set(page "printf '/*! vtk */ var vtk;' > v.js; SWELLRAY_VTKJS=v.js ${scene}")
swellray_cli_test(export_page 0 "^24\n$" "" "${page} --export s.html && grep -q 'vtk $' s.html && grep -o '\"times\":[[][^]]*' s.html | grep -o , | wc -l | sed 's/23/24/'")
swellray_cli_test(export_page_times 0 "\"times\":.0[.]0,0[.]5,1[.]0" "" "${page} --times 0:1:0.5 --export s.html && grep -o '\"times\":.*]' s.html")
swellray_cli_test(export_page_without_library 1 "" "cannot read 'none.js', the library of pages" "SWELLRAY_VTKJS=none.js ${scene} --export s.html")
swellray_cli_test(export_page_without_vtkjs 1 "" "pages need vtk.js, .*SWELLRAY_VTKJS" "cp \"$SWELLRAY\" own; ./own render bay --period 3 --direction 90 --height 0.4 --quiet --export s.html")
swellray_cli_test(export_page_too_large 1 "" "too many for a page; take a part of the seafloor with --crop, or fewer frames" "${page} --times 0:1000:0.1 --export s.html")

# Numbered pictures, those of the same call kept; without any display to draw on where there is nothing to draw.
swellray_cli_test(series_without_times 2 "" "a series of pictures needs --times" "${scene} -o %04d.png")
swellray_cli_test(series_chart 2 "" "need --style scene" "$SWELLRAY render bay -o %04d.png")
swellray_cli_test(series_jpeg 2 "" "a series of pictures is .png" "${scene} --times 0:1:1 -o %d.jpg")
swellray_cli_test(series_no_folder 1 "" "cannot make the folder 'a/b'" "touch a; ${scene} --times 0:1:1 -o a/b/%d.png")
swellray_cli_test(movie_mp4 2 "" "VTK writes no .mp4 here: write -o FILE.ogv, or -o FOLDER/%04d.png" "${scene} --times 0:1:0.1 -o m.mp4")
if(NOT SWELLRAY_SANITIZE)
  swellray_cli_test(series 0 "3 made and 0 kept[^\n]*\nf/a-000.png f/a-001.png f/a-002.png\n[^\n]*f/a-000.png to f/a-002.png, 1 made and 2 kept[^\n]*\nf/a-001.png\n$" ""
    "set -e; draw='render bay --style scene --period 3 --direction 90 --height 0.4 --size 400x400 --times 0:1:0.5 -o f/a-%03d.png'; $SWELLRAY $draw; echo f/*; rm f/a-001.png; touch -d '1 hour ago' f/*; $SWELLRAY $draw | grep wrote; find f -name '*.png' -mmin -30")
endif()
swellray_cli_test(chart_detail 2 "" "need --style scene" "$SWELLRAY render bay --detail screen -o p.png")
swellray_cli_test(scene_detail_word 2 "" "--detail must be auto, waves or screen" "${scene} --detail fine -o p.png")
