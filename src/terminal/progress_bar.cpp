#include "terminal/progress_bar.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace tessera {
namespace {

constexpr std::chrono::milliseconds kRedraw{100};
constexpr std::chrono::seconds kPlainLine{10};
constexpr int kMostCells = 30;
constexpr int kLeastCells = 8;  // a shorter bar is not shown

int terminal_width() {
  winsize size{};
  const bool known = ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

std::string minutes(double seconds) {
  char text[32];
  const long whole = long(std::min(seconds, 1e6) + 0.5);
  std::snprintf(text, sizeof text, "%ld:%02ld", whole / 60, whole % 60);
  return text;
}

/// The bar with its brackets in at most `columns` columns; empty where these are too few.
std::string bar(double fraction, int columns) {
  const int cells = std::min(columns - int(std::string("  []").size()), kMostCells);
  if (cells < kLeastCells) return "";
  const int full = int(fraction * cells + 0.5);
  return "  [" + std::string(std::size_t(full), '#') + std::string(std::size_t(cells - full), '.') + "]";
}

double fraction_of(std::size_t done, std::size_t total) {
  return total == 0 ? 1.0 : std::min(1.0, double(done) / double(total));
}

}  // namespace

std::optional<double> time_left_s(std::size_t done, std::size_t total, double elapsed_s) {
  const double fraction = fraction_of(done, total);
  if (done == 0 || fraction >= 1) return std::nullopt;
  return elapsed_s * (1 / fraction - 1);
}

std::string progress_text(const std::string& label, std::size_t done, std::size_t total, const std::string& note,
                          std::optional<double> left_s, int width) {
  const double fraction = fraction_of(done, total);
  const std::string percent = std::to_string(int(100 * fraction)) + " %";
  const std::string separator = width == 0 ? ", " : "  ";
  std::string text = (width == 0 ? ": " : "  ") + percent;
  if (!note.empty()) text += separator + note;
  if (left_s) text += separator + minutes(*left_s) + " left";
  if (width == 0) return label + text;
  const int left = width - int(label.size() + text.size());
  return (label + bar(fraction, left) + text).substr(0, std::size_t(width));
}

ProgressBar::ProgressBar(std::string label, std::size_t total)
    : label_(std::move(label)),
      total_(total),
      terminal_(::isatty(STDERR_FILENO) == 1),
      start_(Clock::now()),
      last_(start_) {}

ProgressBar::~ProgressBar() { finish(); }

void ProgressBar::update(std::size_t done, const std::string& note) {
  update(done, note, time_left_s(done, total_, std::chrono::duration<double>(Clock::now() - start_).count()));
}

void ProgressBar::update(std::size_t done, const std::string& note, std::optional<double> left_s) {
  done_ = done;
  note_ = note;
  left_s_ = left_s;
  const auto now = Clock::now();
  if (now - last_ < (terminal_ ? Clock::duration(kRedraw) : Clock::duration(kPlainLine))) return;
  last_ = now;
  draw();
}

void ProgressBar::draw() {
  drawn_ = true;
  if (terminal_) {
    // One column is left free: a full line would wrap. \033[K clears what a longer text left behind.
    const std::string text = progress_text(label_, done_, total_, note_, left_s_, terminal_width() - 1);
    std::fprintf(stderr, "\r%s\033[K", text.c_str());
  } else {
    std::fprintf(stderr, "%s\n", progress_text(label_, done_, total_, note_, left_s_, 0).c_str());
  }
  std::fflush(stderr);
}

void ProgressBar::finish() {
  if (std::exchange(finished_, true) || !terminal_ || !drawn_) return;
  draw();
  std::fputc('\n', stderr);
}

}  // namespace tessera
