// A bad input file, told in one line: which file, where in it, what is wrong and what to do about it.
#pragma once

#include <stdexcept>
#include <string>

namespace vitrine {

/// Thrown by every reader of files. `what()` is "FILE: PLACE: PROBLEM; REMEDY", a single line.
class InputError : public std::runtime_error {
 public:
  InputError(const std::string& file, const std::string& place, const std::string& problem,
             const std::string& remedy)
      : std::runtime_error(file + ": " + (place.empty() ? "" : place + ": ") + problem + "; " + remedy) {}
};

}  // namespace vitrine
