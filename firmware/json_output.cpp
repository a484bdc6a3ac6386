#include "json_output.h"

#include <iostream>

namespace vitrine {

void print_json(const Json& value) {
  std::cout << value.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace vitrine
