# `swellray validate`: what it prints and writes, and that it can fail.
swellray_cli_test(help_validate 0 "--perturb E.*check the.*checker.*Examples:\n  swellray validate" "" "$SWELLRAY validate --help")
swellray_cli_test(validate_list 0
  "c1_dispersion.*c2_deep_to_depth.*c3_design_luneburg.*c3_shallow_x2_circle.*c4_shoal_gauss_caustic.*c7c_berkhoff_rays.*c6_breaking" ""
  "$SWELLRAY validate --list")
# Everything but what takes long, without any display; the page and each picture are well-formed, the names complete.
swellray_cli_test(validate_quick 0 "case  *quantity .*tolerance  verdict\nc1_dispersion .* 0 cases failed.*wrote report/index.html.*\nwell-formed\n"
  "" "env -u DISPLAY PATH=/usr/bin:/bin $SWELLRAY validate --quick --report report && \
  cases=$($SWELLRAY validate --list | cut -d ' ' -f 1) && \
  for name in $cases; do test -s report/$name.svg && test -s report/$name.csv && grep -q \"id='$name'\" report/index.html || exit 5; done && \
  grep -qc 'c2_plane_A,.position' report/checks.csv && \
  python3 -c 'import glob, xml.dom.minidom as m; [m.parse(f) for f in glob.glob(\"report/*.svg\")]; print(\"well-formed\")'")
# A wrong gravity: every single one of these cases must see it.
swellray_cli_test(validate_perturbed 1 "all failed" "cases failed: c1_dispersion"
  "cases='--case c1 --case c2 --case c3 --case c4 --case c5 --case c6 --case c7c_berkhoff_rays --case c7c_berkhoff_caustic --case c8'; \
  $SWELLRAY validate --quick $cases --perturb 1e-3 >out 2>err; code=$?; grep failed err >&2; \
  n=$($SWELLRAY validate --list $cases | wc -l); grep -q \"^swellray: $n of $n cases failed\" err && echo all failed; exit $code")
# One formula wrong: a curvature of the bed that only the equation of the tube knows. Rays stay where they are, and their
# tubes, heights and caustics are seen to be wrong; a plane has none to be wrong about.
swellray_cli_test(validate_perturbed_tube 1 "ray right, tube wrong, plane right"
  "2 of 3 cases failed: c4_island_parabolic, c7c_berkhoff_rays"
  "$SWELLRAY validate --quick --case c2_plane_B,c4_island_parabolic,c7c_berkhoff_rays --perturb 1e-3 --perturb-in curvature >out; code=$?; \
  ! grep -E '(position|heading|phase|travel time) .*FAIL' out && ! grep -q 'c2_plane_B .*FAIL' out && \
  grep -q 'c4_island_parabolic  *tube width .*FAIL' out && grep -q 'c7c_berkhoff_rays  *height .*FAIL' out && \
  echo ray right, tube wrong, plane right; exit $code")
# The other way about: rays bend too little.
swellray_cli_test(validate_perturbed_slope 1 "c5_dean_A  *position .*FAIL" "2 of 2 cases failed: c5_dean_A, c5_bar_A"
  "$SWELLRAY validate --case c5_dean_A,c5_bar_A --perturb -1e-4 --perturb-in slope")
swellray_cli_test(validate_perturb_in 2 "" "--perturb-in must be gravity, slope or curvature, not 'k'"
  "$SWELLRAY validate --perturb 1e-3 --perturb-in k")
# A millionth is enough where the exact side is.
swellray_cli_test(validate_perturbed_little 1 "position .*FAIL" "3 of 3 cases failed: c2_plane_A, c2_plane_B"
  "$SWELLRAY validate --case c2_plane_A,c2_plane_B --perturb 1e-6")
swellray_cli_test(validate_case 0 "^case .*\nc3_design_circle .*1 cases, .* 0 cases failed" "" "$SWELLRAY validate --case c3_design_ci")
swellray_cli_test(validate_quiet 0 "^$" "" "$SWELLRAY validate --quiet --case c1")
swellray_cli_test(validate_unknown_case 2 "" "no case begins with 'c3_design_circel'; did you mean 'c3_design_circle'"
  "$SWELLRAY validate --case c3_design_circel")
swellray_cli_test(validate_empty_case 2 "" "--case needs the name of a case" "$SWELLRAY validate --case c1,,c2")
swellray_cli_test(validate_perturb_range 2 "" "--perturb must be within -0.5 to 0.5, not 2" "$SWELLRAY validate --perturb 2")
swellray_cli_test(validate_report_is_file 1 "" "cannot make the folder 'report'" "touch report; $SWELLRAY validate --case c1 --report report")
swellray_cli_test(validate_full_disk 1 "^0\n$" "cannot write 'report/"
  "( ulimit -f 1; $SWELLRAY validate --quiet --case c1 --report report 2>err ); code=$?; grep cannot err >&2; ls -A report | wc -l; exit $code")
set_tests_properties(apps.validate_quick apps.validate_perturbed PROPERTIES TIMEOUT 300)

target_link_libraries(swellray_apps_tests PRIVATE swellrayValidation swellrayReferences)
