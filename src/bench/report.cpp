#include "bench/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "io/atomic_file.h"
#include "io/number_text.h"

namespace tessera::bench {

std::string short_number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

double rounded(double value) { return io::rounded(value, 3); }

void write_report(const Report& report, const std::string& path) {
  io::write_file_atomically(path, report.json.dump(2) + "\n");
}

}  // namespace tessera::bench
