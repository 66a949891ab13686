#include "comm/teams/replacer_team.h"

#include <cstdint>
#include <numeric>
#include <utility>

#include "comm/encode.h"
#include "comm/teams/remote_replacer.h"
#include "core/ranks/partition.h"
#include "core/ranks/worker_tree.h"

namespace tessera::comm {
namespace {

class ReplacerTeam : public Replacer {
 public:
  /// `parts` (at least one): the workers, then this rank itself, if it takes part.
  explicit ReplacerTeam(std::vector<std::unique_ptr<Replacer>> parts) : parts_(std::move(parts)) {
    for (const auto& part : parts_) breadths_.push_back(part->breadth());
  }

  int breadth() const override { return std::accumulate(breadths_.begin(), breadths_.end(), 0); }

  void post_replace(std::vector<ReplacementWindow> windows) override {
    std::vector<std::uint64_t> trials;
    for (const ReplacementWindow& window : windows) trials.push_back(window.trials);
    shares_ = fair_shares(trials, breadths_);
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      std::vector<ReplacementWindow> share;
      for (const std::size_t i : shares_[p]) share.push_back(std::move(windows[i]));
      parts_[p]->post_replace(std::move(share));
    }
  }

  /// This rank's own part is last and computes only when it is taken; the workers compute meanwhile.
  std::vector<ReplacementOutcome> take_replaced() override {
    std::size_t windows = 0;
    for (const auto& share : shares_) windows += share.size();
    std::vector<ReplacementOutcome> outcomes(windows);
    for (std::size_t p = parts_.size(); p-- > 0;) {
      std::vector<ReplacementOutcome> of_part = parts_[p]->take_replaced();
      for (std::size_t k = 0; k < of_part.size(); ++k) outcomes[shares_[p][k]] = std::move(of_part[k]);
    }
    return outcomes;
  }

 private:
  std::vector<std::unique_ptr<Replacer>> parts_;
  std::vector<int> breadths_;                     // of the parts
  std::vector<std::vector<std::size_t>> shares_;  // windows of the posted request, for each part
};

}  // namespace

std::unique_ptr<Replacer> gather_replacers(Communicator& ranks) { return gather_replacers(ranks, nullptr); }

std::unique_ptr<Replacer> gather_replacers(Communicator& ranks, std::unique_ptr<Replacer> own) {
  const std::vector<int> workers = place_in_tree(ranks.rank(), ranks.size()).children;
  if (workers.empty()) return own;
  std::vector<std::unique_ptr<Replacer>> parts;
  for (const int worker : workers) {
    const int breadth = decode<int>(ranks.receive(worker, Tag::breadth));
    parts.push_back(std::make_unique<RemoteReplacer>(ranks, worker, breadth));
  }
  if (own) parts.push_back(std::move(own));
  return std::make_unique<ReplacerTeam>(std::move(parts));
}

}  // namespace tessera::comm
