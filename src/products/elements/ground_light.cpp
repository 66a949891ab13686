#include "products/elements/ground_light.h"

#include <cstdint>

namespace tessera {

GroundLight::GroundLight(const cv::Mat& lab, const cv::Mat& is_ground) {
  constexpr double kRidge = 1e-6;  // keeps the fit solvable where few pixels do not determine all terms
  auto normal = cv::Matx<double, kTerms, kTerms>::eye() * kRidge;
  auto sums = cv::Matx<double, kTerms, 3>::zeros();
  for (int y = 0; y < lab.rows; ++y) {
    for (int x = 0; x < lab.cols; ++x) {
      if (!is_ground.at<std::uint8_t>(y, x)) continue;
      const cv::Vec<double, kTerms> at = terms(x, y, lab.size());
      const cv::Vec3d colour = lab.at<cv::Vec3f>(y, x);
      normal += at * at.t();
      sums += at * colour.t();
    }
  }
  weights_ = normal.solve(sums, cv::DECOMP_CHOLESKY);
}

cv::Mat GroundLight::over(cv::Size size) const {
  cv::Mat colours(size, CV_32FC3);
  const auto weights = weights_.t();
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) colours.at<cv::Vec3f>(y, x) = cv::Vec3f(weights * terms(x, y, size));
  }
  return colours;
}

cv::Vec<double, GroundLight::kTerms> GroundLight::terms(int x, int y, cv::Size size) {
  const double u = 2. * x / size.width - 1, v = 2. * y / size.height - 1;
  return {1, u, v, u * u, u * v, v * v};
}

}  // namespace tessera
