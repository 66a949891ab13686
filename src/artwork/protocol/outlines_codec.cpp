#include "artwork/protocol/outlines_codec.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string_view>

namespace tessera {
namespace {

/// Sent before the names and the outlines.
struct OutlinesHeader {
  double page_width_mm = 0, page_height_mm = 0;
  double program_px_per_inch = 0;
  std::int32_t unread_elements = 0;
  std::uint32_t undrawn_elements = 0;
  std::uint32_t says_unit = 0;
  std::uint32_t far_elements = 0;
  std::uint64_t masked_elements = 0;
  std::uint64_t outlines = 0;
};

/// Sent before an outline's name and steps.
struct OutlineHeader {
  std::uint32_t filled = 0;
  std::uint32_t even_odd = 0;
  std::uint64_t steps = 0;
};

class Writer {
 public:
  template <class T>
  void add(const T& value) {
    add_bytes(&value, sizeof value);
  }
  void add(const std::string& text) {
    add(std::uint64_t(text.size()));
    add_bytes(text.data(), text.size());
  }
  void add(const PathStep& step) {
    add(step.command);
    add_bytes(step.points.data(), std::size_t(points_of(step)) * sizeof step.points[0]);
  }
  std::vector<std::uint8_t> take() { return std::move(bytes_); }

 private:
  void add_bytes(const void* from, std::size_t count) {
    const auto* const first = static_cast<const std::uint8_t*>(from);
    bytes_.insert(bytes_.end(), first, first + count);
  }
  std::vector<std::uint8_t> bytes_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

  template <class T>
  T next() {
    T value;
    std::memcpy(static_cast<void*>(&value), take(sizeof value).data(), sizeof value);
    return value;
  }
  std::string next_text() {
    const std::span<const std::uint8_t> text = take(next<std::uint64_t>());
    return {text.begin(), text.end()};
  }
  std::vector<std::string> next_names(std::uint64_t count) {
    std::vector<std::string> names(checked_count(count, kMostOutlineElements));
    for (std::string& name : names) name = next_text();
    return names;
  }
  PathStep next_step() {
    PathStep step{.command = next<char>()};
    if (std::string_view("MLCZ").find(step.command) == std::string_view::npos) throw_garbled();
    for (int k = 0; k < points_of(step); ++k) {
      const cv::Point2d p = next<cv::Point2d>();
      if (!(std::abs(p.x) <= kMost && std::abs(p.y) <= kMost)) throw_garbled();
      step.points[std::size_t(k)] = p;
    }
    return step;
  }
  /// The checked count of items that follow: each has at least one byte, and there are at most `most` of them.
  std::size_t checked_count(std::uint64_t count, std::size_t most) const {
    if (count > rest_.size() || count > most) throw_garbled();
    return std::size_t(count);
  }
  void end() const {
    if (!rest_.empty()) throw_garbled();
  }

 private:
  /// Largest coordinate: a control point may lie beyond the reach of an outline.
  static constexpr double kMost = 10 * kFarthestOutline_mm;

  [[noreturn]] static void throw_garbled() { throw std::runtime_error("outlines that are cut off or garbled"); }

  std::span<const std::uint8_t> take(std::uint64_t count) {
    if (count > rest_.size()) throw_garbled();
    const std::span<const std::uint8_t> taken = rest_.first(std::size_t(count));
    rest_ = rest_.subspan(std::size_t(count));
    return taken;
  }

  std::span<const std::uint8_t> rest_;
};

}  // namespace

std::vector<std::uint8_t> encode_outlines(const SvgOutlines& found) {
  Writer writer;
  writer.add(OutlinesHeader{.page_width_mm = found.page_mm.width,
                            .page_height_mm = found.page_mm.height,
                            .program_px_per_inch = found.program_px_per_inch,
                            .unread_elements = found.unread_elements,
                            .undrawn_elements = std::uint32_t(found.undrawn_elements.size()),
                            .says_unit = found.says_unit,
                            .far_elements = std::uint32_t(found.far_elements.size()),
                            .masked_elements = found.masked_elements.size(),
                            .outlines = found.outlines.size()});
  writer.add(found.program);
  for (const auto* names : {&found.undrawn_elements, &found.masked_elements, &found.far_elements}) {
    for (const std::string& name : *names) writer.add(name);
  }
  for (const SvgOutline& outline : found.outlines) {
    writer.add(OutlineHeader{outline.filled, outline.even_odd, outline.steps.size()});
    writer.add(outline.name);
    for (const PathStep& step : outline.steps) writer.add(step);
  }
  return writer.take();
}

SvgOutlines decode_outlines(std::span<const std::uint8_t> bytes) {
  Reader reader(bytes);
  const auto header = reader.next<OutlinesHeader>();
  SvgOutlines found{.unread_elements = header.unread_elements,
                    .undrawn_elements = {},
                    .says_unit = header.says_unit != 0,
                    .page_mm = {header.page_width_mm, header.page_height_mm},
                    .program_px_per_inch = header.program_px_per_inch};
  found.program = reader.next_text();
  found.undrawn_elements = reader.next_names(header.undrawn_elements);
  found.masked_elements = reader.next_names(header.masked_elements);
  found.far_elements = reader.next_names(header.far_elements);
  std::size_t steps_left = kMostOutlineSteps;
  for (std::size_t i = reader.checked_count(header.outlines, kMostOutlineSteps); i > 0; --i) {
    const auto of = reader.next<OutlineHeader>();
    SvgOutline& outline = found.outlines.emplace_back();
    outline.name = reader.next_text();
    outline.filled = of.filled != 0;
    outline.even_odd = of.even_odd != 0;
    const std::size_t count = reader.checked_count(of.steps, steps_left);
    steps_left -= count;
    outline.steps.reserve(count);
    for (std::size_t k = 0; k < count; ++k) outline.steps.push_back(reader.next_step());
    if (!outline.steps.empty() && outline.steps.front().command != 'M')
      throw std::runtime_error("an outline that does not begin with M");
  }
  reader.end();
  return found;
}

}  // namespace tessera
