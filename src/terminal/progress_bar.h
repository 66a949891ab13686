// Progress of a long command on stderr: a bar that redraws itself on a terminal, a plain line every 10 s otherwise (a
// batch job's log file).
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>

namespace tessera {

class ProgressBar {
 public:
  /// `total` is the value of `done` at the end, in any unit.
  ProgressBar(std::string label, std::size_t total);
  ~ProgressBar();  // finish()
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Shows the progress; cheap, as it prints only from time to time. `note` is shown behind the bar, e.g. "120 shapes".
  /// The time left is computed from `done`.
  void update(std::size_t done, const std::string& note = {});
  /// Shows the progress with a time left that the caller knows; nullopt: unknown.
  void update(std::size_t done, const std::string& note, std::optional<double> left_s);
  /// Leaves the last state of the bar on the terminal; the next output begins on a new line.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;

  void draw();

  std::string label_;
  std::size_t total_;
  bool terminal_;
  bool drawn_ = false;
  bool finished_ = false;
  std::size_t done_ = 0;
  std::string note_;
  std::optional<double> left_s_;
  Clock::time_point start_;
  Clock::time_point last_;
};

/// "label  [####....]  42 %  note  0:31 left" in `width` columns. The bar gets the columns that the words leave, and is
/// left out where these are few; a text that is still too long is cut. Where `width` is 0: a line without a bar,
/// "label: 42 %, note, 0:31 left".
std::string progress_text(const std::string& label, std::size_t done, std::size_t total, const std::string& note,
                          std::optional<double> left_s, int width);

/// The time left at the pace so far. Nullopt before anything is done and when all is done.
std::optional<double> time_left_s(std::size_t done, std::size_t total, double elapsed_s);

}  // namespace tessera
