// The times of a run's ranks, and the messages that they sent: the table at the end of a run, and a section of card.json.
#pragma once

#include <algorithm>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/ranks/rank_statistics.h"

namespace tessera {

/// The range of one figure over all workers.
struct Spread {
  double min = 0;
  double average = 0;
  double max = 0;

  /// The additional time that all wait for the slowest worker, compared with an average one, in percent; 0 where nothing was measured.
  double imbalance_percent() const { return average > 0 ? 100 * (max / average - 1) : 0; }
};

/// The range of a figure. There must be at least one worker.
template <class Figure>
Spread spread_of(const std::vector<WorkerTimes>& workers, Figure figure) {
  Spread spread{figure(workers.front()), 0, figure(workers.front())};
  for (const WorkerTimes& worker : workers) {
    const double value = figure(worker);
    spread.min = std::min(spread.min, value);
    spread.average += value / double(workers.size());
    spread.max = std::max(spread.max, value);
  }
  return spread;
}

/// The table for people: a line for each stage with least, average and greatest seconds over the workers, share of the
/// loop, and imbalance; then the master's stages, then messages. Lines have less than 80 characters. Empty where there was
/// no worker.
std::string ranks_text(const RankStatistics& ranks);

/// The table for programs. Its keys differ from those of the card's other sections.
nlohmann::ordered_json ranks_json(const RankStatistics& ranks);

}  // namespace tessera
