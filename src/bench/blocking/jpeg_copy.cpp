#include "bench/blocking/jpeg_copy.h"

#include <algorithm>
#include <cstdio>  // jpeglib.h needs it
#include <cstdlib>
#include <memory>
#include <span>
#include <string>

#include <jpeglib.h>

#include "artwork/images/image_decoding.h"
#include "core/base/error.h"

namespace tessera::bench {

cv::Mat jpeg_copy(const cv::Mat& mask, int quality) {
  if (std::max(mask.cols, mask.rows) > JPEG_MAX_DIMENSION) {
    throw InputError("--jpeg: a query of " + std::to_string(mask.cols) + " x " + std::to_string(mask.rows) +
                     " px is too large for a JPEG; choose a smaller --size");
  }
  jpeg_compress_struct info{};
  jpeg_error_mgr errors;
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* memory = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &memory, &size);
  info.image_width = JDIMENSION(mask.cols);
  info.image_height = JDIMENSION(mask.rows);
  info.input_components = 1;
  info.in_color_space = JCS_GRAYSCALE;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, quality, TRUE);
  jpeg_start_compress(&info, TRUE);
  while (info.next_scanline < info.image_height) {
    auto* row = const_cast<JSAMPLE*>(mask.ptr<JSAMPLE>(int(info.next_scanline)));
    jpeg_write_scanlines(&info, &row, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  const std::unique_ptr<unsigned char, decltype(&std::free)> owner(memory, &std::free);
  return decode_image(std::span(memory, size), "the query", PixelBits::eight).pixels;
}

}  // namespace tessera::bench
