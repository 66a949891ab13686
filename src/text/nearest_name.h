// "Did you mean": the name of a list that is closest to a mistyped one.
#pragma once

#include <string>
#include <vector>

namespace tessera {

/// Levenshtein distance: the number of bytes to insert, delete or substitute to make `b` from `a`.
std::size_t edit_distance(const std::string& a, const std::string& b);

/// The nearest of `names`, the first of equals; empty where even that one is too different to help.
std::string nearest_name(const std::string& name, const std::vector<std::string>& names);

}  // namespace tessera
