#include "command_scenes.h"

#include <iomanip>
#include <iostream>

#include "exit_status.h"
#include "json_output.h"
#include "playlist.h"

namespace vitrine {

int execute(const ScenesRequest& request) {
  Json list = Json::array();
  for (const PlaylistScene& scene : find_playlist(request.playlist)) {
    const std::filesystem::path file = std::filesystem::absolute(scene.file).lexically_normal();
    const bool found = std::filesystem::exists(file);
    if (request.json) {
      list.push_back({{"name", scene.name},
                      {"title", scene.title},
                      {"caption", scene.caption},
                      {"mode", scene.mode == nullptr ? Json(nullptr) : Json(scene.mode->key)},
                      {"file", file.string()},
                      {"found", found}});
    } else {
      std::cout << std::left << std::setw(18) << scene.name << std::setw(28) << scene.title << file.string()
                << (found ? "" : " (missing)") << '\n';
    }
  }
  if (request.json) {
    print_json(list);
  } else if (list.empty() && !request.playlist && !installed_playlist()) {
    std::cerr << "vitrine: no playlist is installed; name one with --playlist FILE\n";
  }
  return kDone;
}

}  // namespace vitrine
