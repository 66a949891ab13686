// The silhouette of an image without transparency: a two-colour mask, or a picture on a plain background.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// The mean of the most frequent colours along the edge of a picture, CV_8UC3.
cv::Vec3d prevailing_edge_colour(const cv::Mat& bgr);

/// Whether two colours (the background's, and that of what touches the edge) cover most pixels along the edge. For
/// photographs that fill their frame they do not.
bool has_plain_edge(const cv::Mat& bgr);

/// The picture as straight BGRA without its background. `bgr`: CV_8UC3. The background is the prevailing colour along
/// the edge. In a mask, which has only two colours, alpha rises from 0 at the background's mean difference to 1 at the
/// shape's, and holes are clear. In a picture with more colours the area connected to its edge is clear
/// (picture_ground.h); everything that it encloses is opaque, whatever its colour. In both, an antialiased edge keeps
/// its sub-pixel place, and the background is removed from its colours. Where nothing differs, alpha is 0 everywhere.
cv::Mat cut_from_background(const cv::Mat& bgr);

}  // namespace tessera
