// A job file in a temporary folder, for tests of its accepted and refused content.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "job/job_file.h"
#include "support/input_error.h"
#include "support/scratch_folder.h"

namespace tessera {

class JobFile : public testing::Test {
 protected:
  Job load(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    return load_job(folder_.write("job.toml", text), overrides);
  }

  /// The message of the InputError without the test's folder; empty if there is none.
  std::string mistake(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    std::string message = test::message_of([&] { load(text, overrides); });
    const auto at = message.find(folder_.path(""));
    return at == std::string::npos ? message : message.erase(at, folder_.path("").size());
  }

  test::ScratchFolder folder_;
  const std::string minimal_ = "[library]\nfile = \"animals.h5\"\n";
};

}  // namespace tessera
