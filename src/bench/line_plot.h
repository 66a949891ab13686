// Curves over the number of workers and the like, as SVG and as PNG.
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

/// One pair of axes. Logarithmic ones have steps of powers of two, or, a long x axis, of four.
struct Panel {
  std::string title;
  std::string x_label;
  std::string y_label;
  bool log_y = false;
  double greatest_y = 1;  // of the axis; it begins at 0, with log_y at 1
  std::vector<PlotCurve> curves;
  bool log_x = true;  // begins at 1; else at 0, with steps of 10
};

/// The panels side by side.
std::string plot_svg(const std::vector<Panel>& panels);

/// Throws EnvironmentError where write_plot could not write: before the work whose plot it is.
void check_plot_can_be_written(const std::string& path);

/// `path`.svg and `path`.png. Throws EnvironmentError.
void write_plot(const std::vector<Panel>& panels, const std::string& path);

}  // namespace tessera::bench
