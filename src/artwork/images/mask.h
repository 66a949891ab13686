// The silhouette of an image without transparency: a two-colour mask, or a picture on a plain background.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// Of a picture, CV_8UC3: the mean of the colours that are most frequent along its edge.
cv::Vec3d prevailing_edge_colour(const cv::Mat& bgr);

/// Whether two colours, a background's and that of what touches the edge, hold most of the pixels along the edge. Of
/// photographs that fill their frame they do not.
bool has_plain_edge(const cv::Mat& bgr);

/// `bgr`: CV_8UC3. The background is the colour that prevails along the edge. Returns straight BGRA.
/// A mask has two colours alone: its alpha rises from 0 at the background's mean difference to 1 at the shape's, on both
/// sides of Otsu's threshold, and holes are clear. In a picture of more colours, clear is what its edge is connected to
/// (picture_ground.h); what it encloses is opaque, whatever its colour. In both an antialiased edge keeps its sub-pixel
/// place, and its colours have the background taken out. Where nothing differs, alpha is 0 everywhere.
cv::Mat cut_from_background(const cv::Mat& bgr);

}  // namespace tessera
