// `vitrine modes`: every sampling mode there is.
#pragma once

namespace vitrine {

struct ModesRequest {
  bool json = false;
};

int execute(const ModesRequest& request);

}  // namespace vitrine
