// `vitrine run --check-config`: reads everything that the box would read, and says what it comes to.
#pragma once

#include "command_run.h"

namespace vitrine {

/// Throws InputError with what is wrong.
int check_config(const RunRequest& request);

}  // namespace vitrine
