#include "run/results/found_cards.h"

#include "core/base/error.h"
#include "render/ranking.h"
#include "terminal/terminal.h"

namespace tessera {

std::vector<ResultCard> found_cards(const std::vector<std::string>& arguments) {
  FoundResults all;
  for (const std::string& argument : arguments) {
    const FoundResults found = find_results(argument);
    all.cards.insert(all.cards.end(), found.cards.begin(), found.cards.end());
    all.damages.insert(all.damages.end(), found.damages.begin(), found.damages.end());
  }
  if (all.cards.empty()) throw InputError("no whole result to rank: " + all.damages.front());
  for (const std::string& damage : all.damages) print_warning("not ranked: " + damage);
  return all.cards;
}

}  // namespace tessera
