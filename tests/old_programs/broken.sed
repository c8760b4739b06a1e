# What CHANGELOG.md says does not compile any more, as the examples of 0.2 have it.
s|irg/hidden/draw_plot.hpp|irg/hidden/plot_surface.hpp|
s/irg::clamp(/irg::clamped(/g
s/\.kind \(==\|!=\) irg::solvability::/.status \1 irg::solvability::/
s/irg::print_\(integer\|decimal\)(\(text\)/*irg::print_\1(\2/g
s/plot\.\(azimuth\|elevation\) =/plot.\1_degrees =/
/bspline_interpolate/{N;s/if (\(.*\))\.status !=\n.*bspline_fit_status::done)/if (!\1))/}
