# What CHANGELOG.md says does not compile any more, as the examples of 0.2 have it.
s|irg/hidden/draw_plot.hpp|irg/hidden/plot_surface.hpp|
s/\([?:] \)irg::print_\(integer\|decimal\)(/\1*irg::print_\2(/g
s/irg::clamp(/irg::clamped(/g
s/\.kind == irg::solvability/.status == irg::solvability/
