#include "nearest_name.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace vitrine {
namespace {

/// The least number of letters to insert, delete or replace (Levenshtein), a row of the table at a time.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char letter : a) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (letter == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string name_remedy(std::string_view name, std::span<const std::string> known) {
  const auto nearest = std::ranges::min_element(
      known, {}, [name](const std::string& candidate) { return edit_distance(name, candidate); });
  if (nearest == known.end()) return "there is none to choose from";
  if (edit_distance(name, *nearest) <= 2) return "did you mean '" + *nearest + "'?";
  std::string list = "known are ";
  for (const std::string& candidate : known) list += (&candidate == known.data() ? "" : ", ") + candidate;
  return list;
}

std::vector<std::string> nearest_names(std::string_view name, std::span<const std::string> known,
                                       std::size_t count) {
  std::vector<std::string> names(known.begin(), known.end());
  std::ranges::stable_sort(names, {},
                           [&](const std::string& candidate) { return edit_distance(name, candidate); });
  names.resize(std::min(names.size(), count));
  return names;
}

}  // namespace vitrine
