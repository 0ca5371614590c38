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
# Its frames are made at the same time, and are the same whatever the threads: but for their number in the command line.
swellray_cli_test(surface_series_threads 0 "^15 1\n$" "warning: the seafloor grid|^$"
  "run() { $SWELLRAY surface $IN/beach.asc ${wave} --quiet --group-waves 4 --times 0:1:0.25 -o s.pvd --spray p.pvd --foam f.pvd --threads $1 && mkdir r$1 && mv s p f r$1; }; run 1 && run 2 && for f in r1/*/*; do cmp -l $f r2\${f#r1} | wc -l; done | sort | uniq -c | sed 's/^ *//'")
# A series goes on where it was: whole frames stay, a damaged one is made again, and so is one of another call.
swellray_cli_test(surface_resumes 0 "2 kept.*0 kept" "warning: the seafloor grid|^$"
  "run() { $SWELLRAY surface $IN/beach.asc ${wave} --times 0:1:0.5 -o s.pvd \"$@\" | grep frames; } && run >/dev/null && head -c 500 s/s_000001.vtp > t && mv t s/s_000001.vtp && run && run --seed 2")
swellray_cli_test(surface_straight 0 "" "warning: the seafloor grid|^$" "${surface} --profile peachey --phase straight -o s.vtp")
# Spray and the surface at points.
swellray_cli_test(surface_spray 0 "^1\n$" "warning: the seafloor grid|^$" "${surface} --time 4 --spray p.vtp && grep -c '<VTKFile type=\"PolyData\"' p.vtp")
swellray_cli_test(surface_spray_series 0 "^3 3\n4 kept" "warning: the seafloor grid|^$"
  "${surface} --times 0:1:0.5 -o s.pvd --spray p.pvd && echo $(ls s | wc -l) $(ls p | wc -l) && rm s/s_000001.vtp p/p_000002.vtp && $SWELLRAY surface $IN/beach.asc ${wave} --quiet --times 0:1:0.5 -o s.pvd --spray p.pvd && echo 4 kept")
swellray_cli_test(surface_spray_same 2 "" "name the same file" "${surface} -o s.vtp --spray s.vtp")
swellray_cli_test(surface_spray_alone 2 "" "need --spray" "${surface} -o s.vtp --spray-rate 5")
swellray_cli_test(surface_spray_straight 2 "" "leave out --phase straight" "${surface} --phase straight --spray p.vtp")
swellray_cli_test(surface_at_alone 2 "" "belong together" "${surface} --at p.csv")
swellray_cli_test(surface_at 0 "^x,y,name,Time,SurfaceElevation,NormalX,.*,Waves\n5\n$" "warning|^$"
  "printf 'x,y,name\\n100,100,a\\n1e7,0,dry\\n' > p.csv && ${surface} --at p.csv --times 0:0.5:0.5 --table o.csv && head -1 o.csv && wc -l < o.csv")
swellray_cli_test(surface_at_own_times 0 "^x,y,t,SurfaceElevation.*\n3\n$" "warning: the seafloor grid|^$"
  "printf 'x,y,t\\n100,100,0\\n100,100,2\\n' > p.csv && ${surface} --at p.csv --table o.csv && head -1 o.csv && wc -l < o.csv")
swellray_cli_test(surface_at_bad_time 1 "" "'soon' is no time" "printf 'x,y,t\\n100,100,soon\\n' > p.csv && ${surface} --at p.csv --table o.csv")
# Foam on still water.
foreach(ending vti nc tif)
  swellray_cli_test(surface_foam_${ending} 0 "foam     39 x 39 nodes, 5 x 5 m apart.*wrote    f.${ending}" "warning: the seafloor grid|^$"
    "$SWELLRAY surface $IN/beach.asc ${wave} --time 4 --foam f.${ending} --foam-spacing 5 && test -s f.${ending}")
endforeach()
swellray_cli_test(surface_foam_series 0 "^frames[^\n]* 0 kept\n3\nframes[^\n]* 6 kept\n$" "warning: the seafloor grid|^$"
  "run() { $SWELLRAY surface $IN/beach.asc ${wave} --times 0:1:0.5 --foam f.pvd -o s.pvd | grep frames; } && run && grep -c 'f_.*[.]vti' f.pvd && run")
swellray_cli_test(surface_foam_spacing_alone 2 "" "--foam-spacing needs --foam" "${surface} -o s.vtp --foam-spacing 5")
swellray_cli_test(surface_foam_straight 2 "" "leave out --phase straight" "${surface} --phase straight --foam f.vti")
# Waves in groups: 4 m of water at 50 m, where the lowest have a fifth of the height.
swellray_cli_test(surface_groups 0 "^yes\n$" "warning: the seafloor grid|^$"
  "printf 'x,y\\n60,100\\n' > p.csv && ${surface} --profile airy --at p.csv --table a.csv --times 0:30:0.1 --group-waves 5 --group-lull 0.2 && awk -F, 'NR > 1 { e = \$4 > 0 ? \$4 : -\$4; if (NR < 30 || NR > 270) next; i = int(NR / 60); if (e > m[i]) m[i] = e } END { h = l = m[1]; for (i in m) { h = m[i] > h ? m[i] : h; l = m[i] < l ? m[i] : l }; print (h > 2 * l ? \"yes\" : \"no\" h \" \" l) }' a.csv")
swellray_cli_test(surface_group_lull_alone 2 "" "--group-lull needs --group-waves" "${surface} -o s.vtp --group-lull 0.5")
swellray_cli_test(surface_group_waves 2 "" "--group-waves must be" "${surface} -o s.vtp --group-waves 1")
# As a camera samples it.
swellray_cli_test(surface_camera 0 "surface  gonzato-lesaec: [0-9]+ points.*wrote    s.vtp" "warning: the seafloor grid|^$"
  "$SWELLRAY surface $IN/beach.asc ${wave} --camera 165,100,8,60,100,0 --size 640x480 --pixel-step 4 -o s.vtp")
swellray_cli_test(surface_camera_series 0 "" "warning: the seafloor grid|^$" "${surface} --camera shore --times 0:1:0.5 -o s.pvd && test -s s/s_000002.vtp")
swellray_cli_test(surface_camera_below 1 "" "must be above the water" "${surface} --camera 165,100,-8,60,100,-9 -o s.vtp 2>err; code=$?; grep -v warning err >&2; exit $code")
swellray_cli_test(surface_camera_alone 2 "" "give -o" "${surface} --camera shore --spray p.vtp")
swellray_cli_test(surface_pixel_step_alone 2 "" "need --camera" "${surface} --pixel-step 4 -o s.vtp")
# A sea of several waves.
swellray_cli_test(surface_components 0 "1\n2\n$" "warning: the seafloor grid|^$"
  "printf 'x,y\\n100,100\\n' > p.csv && ${surface} --at p.csv --table a.csv && ${surface} --at p.csv --table b.csv --component 3,260,0.2 --component 2.5,280,0.1 && grep -c -v '^x' a.csv && cmp -s a.csv b.csv; echo $(( $? + 1 ))")
swellray_cli_test(surface_components_spray 0 "^more\n$" "warning: the seafloor grid|^$"
  "${surface} --time 4 --spray a.vtp --spray-rate 300 && ${surface} --time 4 --spray b.vtp --spray-rate 300 --component 5,280,0.6 && [ $(stat -c %s b.vtp) -gt $(( $(stat -c %s a.vtp) + 3000 )) ] && echo more")
swellray_cli_test(surface_component 2 "" "--component needs T,DIR,H" "${surface} -o s.vtp --component 3,260")
