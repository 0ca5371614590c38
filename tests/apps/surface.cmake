# The breaking-wave surface as its users meet it.
set(surface "$SWELLRAY surface $IN/beach.asc ${wave} --quiet")

swellray_cli_test(surface 0 "" "warning: the seafloor grid|^$" "${surface} -o s.vtp && grep -q '<VTKFile type=\"PolyData\"' s.vtp")
swellray_cli_test(help_surface 0 "Examples:\n  swellray surface" "" "$SWELLRAY surface --help")
swellray_cli_test(surface_no_output 2 "" "surface has nothing to write" "${surface}")
swellray_cli_test(surface_profile 2 "" "did you mean 'vortex'" "${surface} --profile vortx -o s.vtp")
swellray_cli_test(surface_profile_key 2 "" "did you mean 'threshold'" "${surface} --profile vortex:treshold=1 -o s.vtp")
swellray_cli_test(surface_two_times 2 "" "exclude each other" "${surface} --time 1 --times 0:1:1 -o s.pvd")
swellray_cli_test(surface_series_as_file 2 "" "-o FILE.pvd" "${surface} --times 0:1:1 -o s.vtp")
swellray_cli_test(surface_file_as_series 2 "" "needs --times" "${surface} --time 1 -o s.pvd")
swellray_cli_test(surface_times 2 "" "--times needs T0:T1:DT" "${surface} --times 1:0:1 -o s.pvd")
swellray_cli_test(surface_points 2 "" "--points-per-wave" "${surface} --points-per-wave 4 -o s.vtp")
swellray_cli_test(list_sections 0 "gerstner.*gonzato-lesaec.*vortex" "" "$SWELLRAY list")
swellray_cli_test(surface_series 0 "^3\n3\n$" "warning: the seafloor grid|^$"
  "${surface} --times 0:1:0.5 -o s.pvd && grep -c DataSet s.pvd && ls s | wc -l")
# A series goes on where it was: whole frames stay, a damaged one is made again, and so is one of another call.
swellray_cli_test(surface_resumes 0 "2 kept.*0 kept" "warning: the seafloor grid|^$"
  "run() { $SWELLRAY surface $IN/beach.asc ${wave} --times 0:1:0.5 -o s.pvd \"$@\" | grep frames; } && run >/dev/null && head -c 500 s/s_000001.vtp > t && mv t s/s_000001.vtp && run && run --seed 2")
swellray_cli_test(surface_straight 0 "" "warning: the seafloor grid|^$" "${surface} --profile peachey --phase straight -o s.vtp")
