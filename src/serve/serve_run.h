// tessera serve: shows a result in a browser on this machine, and refines it from there.
#pragma once

#include <string>

namespace tessera {

struct ServeArguments {
  std::string folder;  // the result
  int port = 0;        // 0: a free one
  int picture_mb = 0;  // as in ReportArguments
};

/// Serves until a signal comes. Returns the exit code; throws InputError and EnvironmentError.
int run_serve(const ServeArguments& arguments);

}  // namespace tessera
