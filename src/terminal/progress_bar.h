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
  /// `total`: what `done` reaches at the end; any unit.
  ProgressBar(std::string label, std::size_t total);
  ~ProgressBar();  // finish()
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// Cheap: prints only when it is time to. `note` stands behind the bar, e.g. "120 shapes". The time left follows from
  /// what is done.
  void update(std::size_t done, const std::string& note = {});
  /// With the time left as somebody knows better; nothing: nobody knows.
  void update(std::size_t done, const std::string& note, std::optional<double> left_s);
  /// Leaves the last state of the bar standing; what is printed next begins on a line of its own.
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

/// "label  [####....]  42 %  note  0:31 left" in `width` columns: the bar takes what the words leave, and goes where
/// that is little; what is too long even then is cut. Without a bar ("label: 42 %, note, 0:31 left")
/// where width is 0.
std::string progress_text(const std::string& label, std::size_t done, std::size_t total, const std::string& note,
                          std::optional<double> left_s, int width);

/// At the pace so far. Nothing before anything is done, and when all is.
std::optional<double> time_left_s(std::size_t done, std::size_t total, double elapsed_s);

}  // namespace tessera
