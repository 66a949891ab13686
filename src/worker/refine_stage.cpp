#include "worker/refine_stage.h"

#include <bit>
#include <stdexcept>

namespace tessera::worker {
namespace {

static_assert(sizeof(DockingTerms) == sizeof(TermsRecord) && sizeof(Similarity) == sizeof(PoseRecord));

RefinedDocking refined_docking(Docking docking, const RefinedRecord& record) {
  docking.canvas_from_shape = std::bit_cast<Similarity>(record.canvas_from_shape);
  return {docking,
          std::bit_cast<DockingTerms>(record.terms),
          record.feasible != 0,
          std::bit_cast<Extent>(record.extent),
          record.perimeter,
          record.radius};
}

/// The work for so many dockings, one work group each.
WorkSize work_of(std::size_t dockings, DockingLanes lanes) {
  return {dockings * items_of_docking(lanes), 1, items_of_docking(lanes)};
}

}  // namespace

RefineStage::RefineStage(DeviceLibrary& library)
    : library_(&library),
      refine_dockings_(library.session(), "refine_dockings"),
      measure_dockings_(library.session(), "measure_dockings"),
      dockings_(library.session()),
      refined_(library.session()),
      terms_(library.session()) {}

/// Writes the dockings to the device and gives their number.
std::uint32_t RefineStage::upload(const std::vector<Docking>& dockings) {
  const MatchRecord& match = library_->match();
  const ShapeRange own{match.first_shape, match.first_shape + match.shapes};
  std::vector<DockingRecord> records;
  records.reserve(dockings.size());
  std::vector<ShapeId> shapes;
  for (const Docking& docking : dockings) {
    if (!own.contains(docking.shape)) {
      throw std::out_of_range("a docking is of a shape of another part of the library");
    }
    records.push_back(std::bit_cast<DockingRecord>(docking));
    shapes.push_back(docking.shape);
  }
  library_->contours().need(shapes);
  dockings_.write(records);
  return std::uint32_t(records.size());
}

void RefineStage::post(const std::vector<Docking>& dockings) {
  const std::uint32_t count = upload(dockings);
  posted_ = dockings;
  refined_.reserve(count);
  refine_dockings_.launch(work_of(count, library_->lanes()), {{"match", library_->match_buffer()},
                                                              {"stances", library_->stances().stances()},
                                                              {"size_map", library_->size_map()},
                                                              {"field_value", library_->field()},
                                                              {"colour", library_->colours().record()},
                                                              {"texels", library_->colours().texels()},
                                                              {"contours", library_->contours().contours()},
                                                              {"contour_places", library_->contours().places()},
                                                              {"shapes", library_->shapes()},
                                                              {"count", count},
                                                              {"dockings", dockings_},
                                                              {"refined", refined_}});
  library_->session().flush();
}

std::vector<RefinedDocking> RefineStage::take() {
  const std::vector<RefinedRecord> records = refined_.read(posted_.size());
  std::vector<RefinedDocking> refined;
  refined.reserve(records.size());
  for (std::size_t i = 0; i < records.size(); ++i) refined.push_back(refined_docking(posted_[i], records[i]));
  return refined;
}

void RefineStage::post_measure(const std::vector<Docking>& dockings) {
  const std::uint32_t count = upload(dockings);
  measured_ = count;
  terms_.reserve(count);
  measure_dockings_.launch(work_of(count, library_->lanes()), {{"match", library_->match_buffer()},
                                                               {"field_value", library_->field()},
                                                               {"colour", library_->colours().record()},
                                                               {"texels", library_->colours().texels()},
                                                               {"contours", library_->contours().contours()},
                                                               {"contour_places", library_->contours().places()},
                                                               {"shapes", library_->shapes()},
                                                               {"count", count},
                                                               {"dockings", dockings_},
                                                               {"terms", terms_}});
  library_->session().flush();
}

std::vector<DockingTerms> RefineStage::take_measure() {
  std::vector<DockingTerms> measured;
  measured.reserve(measured_);
  for (const TermsRecord& terms : terms_.read(measured_)) measured.push_back(std::bit_cast<DockingTerms>(terms));
  return measured;
}

}  // namespace tessera::worker
