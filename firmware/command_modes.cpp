#include "command_modes.h"

#include <iomanip>
#include <iostream>
#include <string>

#include "exit_status.h"
#include "frame/renderer.h"
#include "integrators/modes.h"
#include "integrators/parameters.h"
#include "json_output.h"

namespace vitrine {
namespace {

/// The options that change the mode: what they take, the mode's own choice, what a button goes through.
Json parameters_of(const Mode& mode) {
  Json list = Json::array();
  for (const Parameter& parameter : parameters()) {
    if (!parameter.belongs(mode.parts)) continue;
    list.push_back({{"name", parameter.name},
                    {"label", parameter.label},
                    {"meaning", parameter.meaning},
                    {"values", parameter.values},
                    {"value", parameter.show(mode.parts)},
                    {"cycle", parameter.cycle}});
  }
  return list;
}

/// "shadow-rays 1, sequence random"
std::string parameters_line(const Mode& mode) {
  std::string line;
  for (const Parameter& parameter : parameters()) {
    if (!parameter.belongs(mode.parts)) continue;
    line += (line.empty() ? "" : ", ") + std::string(parameter.name) + ' ' + parameter.show(mode.parts);
  }
  return line;
}

}  // namespace

int execute(const ModesRequest& request) {
  Json list = Json::array();
  for (const Mode& mode : modes()) {
    if (request.json) {
      list.push_back({{"key", mode.key},
                      {"label", mode.label},
                      {"section", mode.section},
                      {"compare_with", mode.compare_with},
                      {"parameters", parameters_of(mode)},
                      {"unbiased", bias(mode.parts).empty()},
                      {"numbers", {numbers_name(Numbers::kFloat), numbers_name(Numbers::kFixed)}}});
    } else {
      std::cout << std::left << std::setw(19) << mode.key << std::setw(41) << mode.label
                << (bias(mode.parts).empty() ? "unbiased" : "biased  ") << "  float, fixed  " << mode.section
                << "\n    " << parameters_line(mode) << '\n';
    }
  }
  if (request.json) print_json(list);
  return kDone;
}

}  // namespace vitrine
