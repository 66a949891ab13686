#include "products/elements/label_roles.h"

#include <cmath>

namespace tessera {

std::vector<LabelRole> label_roles(const LabelRuns& labels, const std::vector<PhotoElement>& elements,
                                   double least_px) {
  std::vector<LabelRole> roles(labels.regions().size(), LabelRole::ground);
  for (std::size_t label = 1; label < roles.size(); ++label) {
    const double area_px2 = labels.regions()[label].area_px2;
    if (area_px2 > 0 && std::sqrt(area_px2) >= least_px) roles[label] = LabelRole::cut;
  }
  for (const PhotoElement& element : elements) roles[std::size_t(element.label)] = LabelRole::element;
  return roles;
}

}  // namespace tessera
