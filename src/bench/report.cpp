#include "bench/report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "files/atomic_file.h"
#include "text/number_text.h"

namespace tessera::bench {

std::string short_number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

double rounded(double value) { return tessera::rounded(value, 3); }

void write_report(const Report& report, const std::string& path) {
  write_file_atomically(path, report.json.dump(2) + "\n");
}

}  // namespace tessera::bench
