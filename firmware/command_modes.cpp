#include "command_modes.h"

#include <iomanip>
#include <iostream>
#include <string>

#include "exit_status.h"
#include "frame/renderer.h"
#include "integrators/modes.h"
#include "json_output.h"

namespace vitrine {

int execute(const ModesRequest& request) {
  Json list = Json::array();
  for (const Mode& mode : modes()) {
    if (request.json) {
      list.push_back({{"key", mode.key},
                      {"label", mode.label},
                      {"section", mode.section},
                      {"unbiased", mode.unbiased},
                      {"numbers", {numbers_name(Numbers::kFloat), numbers_name(Numbers::kFixed)}}});
    } else {
      std::cout << std::left << std::setw(10) << mode.key << std::setw(32) << mode.label
                << (mode.unbiased ? "unbiased" : "biased  ") << "  float, fixed  " << mode.section << '\n';
    }
  }
  if (request.json) print_json(list);
  return kDone;
}

}  // namespace vitrine
