// A test base for states that the loop must refuse with a reason.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/base/error.h"
#include "core/collage/checkpoint_state.h"

namespace tessera::test {

/// A run that continues from `state_`.
class ForeignStateTest : public testing::Test {
 protected:
  virtual void go_on() const = 0;

  std::string complaint() const {
    try {
      go_on();
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  }

  void expect_complaint(const std::string& what) const {
    EXPECT_EQ(complaint(), "checkpoint.h5: not a checkpoint of this canvas and library: " + what +
                               "; --restart removes it and starts again");
  }

  CheckpointState state_;
};

}  // namespace tessera::test
