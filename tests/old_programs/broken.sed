s|irg/hidden/draw_plot.hpp|irg/hidden/plot_surface.hpp|
s/\.kind \(==\|!=\) irg::solvability::/.status \1 irg::solvability::/
s/irg::print_\(integer\|decimal\)(\(text\)/*irg::print_\1(\2/g
