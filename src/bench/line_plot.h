// Line plots, e.g. over the number of workers, as SVG and PNG.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tessera::bench {

struct PlotCurve {
  std::string name;
  std::vector<std::pair<double, double>> points;  // x ascending
  bool ideal = false;                             // dashed and grey
};

/// One pair of axes. Logarithmic axes have steps of two, a long x axis steps of four.
struct Panel {
  std::string title;
  std::string x_label;
  std::string y_label;
  bool log_y = false;
  double greatest_y = 1;  // end of the axis, which begins at 0, with log_y at 1
  std::vector<PlotCurve> curves;
  bool log_x = true;  // begins at 1; false: linear, begins at 0, with steps of 10
};

/// An SVG with the panels side by side.
std::string plot_svg(const std::vector<Panel>& panels);

/// Throws EnvironmentError where write_plot could not write; to be called before the work.
void check_plot_can_be_written(const std::string& path);

/// Writes `path`.svg and `path`.png. Throws EnvironmentError.
void write_plot(const std::vector<Panel>& panels, const std::string& path);

}  // namespace tessera::bench
