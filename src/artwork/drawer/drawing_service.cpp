#include "artwork/drawer/drawing_service.h"

#include <algorithm>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "artwork/artwork_render.h"
#include "artwork/artwork_shape.h"
#include "artwork/images/artwork_page.h"
#include "artwork/images/photo.h"
#include "artwork/images/png_picture.h"
#include "artwork/images/whole_picture.h"
#include "artwork/open_artwork_page.h"
#include "artwork/outlines/svg_outlines.h"
#include "artwork/protocol/outlines_codec.h"
#include "artwork/protocol/shape_answer.h"
#include "artwork/protocol/warp_codec.h"
#include "artwork/svg/svg_import.h"
#include "artwork/svg/svg_pdf.h"
#include "artwork/warping/warped_svg.h"

namespace tessera {
namespace {

DrawingAnswer bytes_answer(std::span<const std::uint8_t> bytes) {
  DrawingAnswer answer;
  answer.payload.create(1, int(bytes.size()), CV_8U);
  std::copy(bytes.begin(), bytes.end(), answer.payload.data);
  answer.header.bytes = bytes.size();
  return answer;
}

DrawingAnswer text_answer(std::string_view text) {
  return bytes_answer({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

DrawingAnswer size_answer(cv::Size2d size) {
  const double sides[2] = {size.width, size.height};
  return bytes_answer({reinterpret_cast<const std::uint8_t*>(sides), sizeof sides});
}

/// The picture as an answer, without a copy: it may be the largest object in memory.
DrawingAnswer image_answer(const cv::Mat& bgra) {
  DrawingAnswer answer;
  answer.payload = (bgra.isContinuous() ? bgra : bgra.clone()).reshape(1, 1);
  answer.header.columns = bgra.cols;
  answer.header.rows = bgra.rows;
  answer.header.bytes = answer.payload.total();
  return answer;
}

DrawingAnswer reason_answer(std::string_view reason) {
  DrawingAnswer answer = text_answer(reason.substr(0, kMostReasonBytes));
  answer.header.status = DrawingStatus::refused;
  return answer;
}

/// The message without the path in front, which the parent adds itself.
std::string_view without_path(std::string_view message, const std::string& path) {
  const std::string prefix = path + ": ";
  return message.starts_with(prefix) ? message.substr(prefix.size()) : message;
}

}  // namespace

DrawingAnswer answer_of(const DrawingRequest& request) {
  const auto& [kind, longest_side_px, width_pt, px_per_inch, tracing, path, scope_id, warp, bytes] = request;
  switch (kind) {
    case DrawingKind::page: return image_answer(render_artwork(bytes, path, longest_side_px));
    case DrawingKind::uncut_page: return image_answer(render_artwork(bytes, path, longest_side_px, Background::kept));
    case DrawingKind::png: return image_answer(png_picture(bytes, path, longest_side_px));
    case DrawingKind::whole: return image_answer(whole_picture(bytes, path, longest_side_px));
    case DrawingKind::natural_size: return size_answer(open_artwork_page(bytes, path)->natural_size());
    case DrawingKind::svg_import:
      return text_answer(import_svg(bytes, path, scope_id, open_artwork_page(bytes, path)->natural_size()));
    case DrawingKind::warped_svg: return text_answer(warped_svg(bytes, path, scope_id, decode_warp(warp)));
    case DrawingKind::shape: return bytes_answer(encode_shape_answer(shape_from_artwork(bytes, path, tracing)));
    case DrawingKind::pdf: return bytes_answer(pdf_of_svg(bytes, path, width_pt, true));
    case DrawingKind::plain_pdf: return bytes_answer(pdf_of_svg(bytes, path, width_pt, false));
    case DrawingKind::outlines: return bytes_answer(encode_outlines(svg_outlines(bytes, path, px_per_inch)));
    case DrawingKind::photo: return image_answer(photo_picture(bytes, path));
    case DrawingKind::labels: return image_answer(label_picture(bytes, path));
  }
  throw std::logic_error("no such kind of drawing");
}

DrawingAnswer answer_or_reason(const DrawingRequest& request) {
  try {
    return answer_of(request);
  } catch (const cv::Exception&) {
    return reason_answer("a damaged image");
  } catch (const std::exception& error) {
    return reason_answer(without_path(error.what(), request.path));
  }
}

}  // namespace tessera
