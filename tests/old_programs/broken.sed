s|irg/hidden/draw_plot.hpp|irg/hidden/plot_surface.hpp|
