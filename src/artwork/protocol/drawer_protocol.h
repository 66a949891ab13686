// The messages between the program and its drawers (drawers.h): a greeting, then requests and answers in turn. Both
// sides are the same build on the same machine, so headers are sent as their bytes in memory. The program trusts no
// answer: it checks every length before it allocates.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <opencv2/core.hpp>
#include <span>
#include <string>
#include <vector>

#include "artwork/artwork_shape.h"
#include "artwork/protocol/drawer_layers.h"

namespace tessera {

/// The descriptor of a drawer's socket.
inline constexpr int kDrawerSocket = 3;

/// The first bytes that a drawer sends after it has limited itself. Another layout of the greeting needs another mark.
using DrawerMark = std::array<char, 8>;
inline constexpr DrawerMark kDrawerMark = {'d', 'r', 'a', 'w', 'e', 'r', '0', '5'};

/// Identifies a build. Two builds of one commit may differ in uncommitted changes, so it includes the headers' sizes.
struct DrawerBuild {
  std::array<char, 56> name = {};                  // version and commit, filled up with zeros
  std::array<std::uint32_t, 2> header_bytes = {};  // of RequestHeader and AnswerHeader

  friend bool operator==(const DrawerBuild&, const DrawerBuild&) = default;
};

/// Follows the mark.
struct DrawerGreeting {
  DrawerBuild build;
  DrawerLayers layers;
};

DrawerBuild this_build();

enum class DrawingKind : std::uint32_t {
  page,
  natural_size,
  svg_import,
  png,
  shape,
  pdf,
  plain_pdf,
  photo,
  labels,
  whole,
  warped_svg,
  uncut_page,
  outlines
};

struct DrawingRequest {
  DrawingKind kind = DrawingKind::page;
  int longest_side_px = 0;                   // for page, uncut_page, png and whole
  double width_pt = 0;                       // for the PDFs
  double px_per_inch = 0;                    // for outlines
  TracingSettings tracing = {};              // for shape
  std::string path = {};                     // for messages; also gives a shape's name
  std::string scope_id = {};                 // for svg_import and warped_svg
  std::vector<std::uint8_t> warp = {};       // for warped_svg: see warp_codec.h
  std::span<const std::uint8_t> bytes = {};  // the file
};

/// Sent before the request's path, scope_id, warp and bytes.
struct RequestHeader {
  DrawingKind kind;
  std::int32_t longest_side_px;
  double width_pt;
  double px_per_inch;
  std::int32_t pad_levels;
  float pad_delta_tau;
  float edge_opacity;
  std::uint32_t keep_rectangles;
  std::uint32_t fill_holes;
  std::uint32_t opaque;
  std::uint64_t path_bytes;
  std::uint64_t scope_id_bytes;
  std::uint64_t warp_bytes;
  std::uint64_t bytes;
};

enum class DrawingStatus : std::uint32_t {
  done,
  refused  // the payload is the reason
};

/// Sent before the payload.
struct AnswerHeader {
  DrawingStatus status = DrawingStatus::done;
  std::int32_t columns = 0;  // of an image payload, CV_8UC4
  std::int32_t rows = 0;
  std::uint32_t unused = 0;
  std::uint64_t bytes = 0;
};

struct DrawingAnswer {
  AnswerHeader header;
  cv::Mat payload;  // one row of bytes

  std::span<const std::uint8_t> bytes() const { return {payload.data, payload.total()}; }
};

inline constexpr std::size_t kMostReasonBytes = 4096;

/// Exit codes of a drawer.
inline constexpr int kDrawerGaveUp = 70;
inline constexpr int kDrawerOutOfMemory = 71;

/// The longest payload that a drawer may send.
std::size_t most_answer_bytes(const DrawingRequest& request);

RequestHeader header_of(const DrawingRequest& request);

}  // namespace tessera
