// Finds how large the elements of a photograph are, where the user does not say.
#pragma once

#include <opencv2/core.hpp>

namespace tessera {

/// The short side of a typical element, px of the photo: the size at which the ways to find elements agree best.
/// `photo`: CV_8UC3 or CV_8UC4, BGR first. 0: they agree at no size. The same photo gives the same size on any number of
/// threads.
double found_element_px(const cv::Mat& photo);

}  // namespace tessera
