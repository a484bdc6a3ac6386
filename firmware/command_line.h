// What the user asked for: the command line, checked and turned into a request. Nothing is done yet.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "command_info.h"
#include "command_modes.h"
#include "command_probe.h"
#include "command_render.h"
#include "command_run.h"
#include "command_scenes.h"

namespace vitrine {

/// A text to print and no more: the help, the version.
struct TextRequest {
  std::string text;
};

int execute(const TextRequest& request);

using Request = std::variant<TextRequest, RunRequest, RenderRequest, ModesRequest, ProbeRequest,
                             ScenesRequest, InfoRequest>;

/// `arguments` without the program's name. Throws UsageError.
Request parse_command_line(std::vector<std::string> arguments);

}  // namespace vitrine
