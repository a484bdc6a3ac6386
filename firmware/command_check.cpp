#include "command_check.h"

#include <iostream>

#include "exit_status.h"
#include "json_output.h"
#include "scene/gltf_import.h"
#include "session.h"

namespace vitrine {

int check_config(const RunRequest& request) {
  const BoxConfig box = box_of(request);
  const KioskSettings settings = kiosk_settings(request, box);
  for (const PlaylistScene& scene : settings.exhibit.scenes) (void)import_gltf(scene.file);
  const ButtonWiring wiring = box.hardware.wiring();
  if (request.json) {
    print_json({{"ok", true},
                {"display", box.display_key()},
                {"scenes", settings.exhibit.scenes.size()},
                {"stops", settings.lecture.size()},
                {"gpio", wiring.gpio.size()},
                {"evdev", wiring.evdev.size()},
                {"gestures", settings.gestures.size()}});
    return kDone;
  }
  std::cout << (request.config ? request.config->string() : "no config") << ": ok; display "
            << box.display_key() << ", " << settings.exhibit.scenes.size() << " scenes, "
            << settings.lecture.size() << " stops of the lecture, " << wiring.gpio.size() << " pins, "
            << wiring.evdev.size() << " input devices, " << settings.gestures.size() << " gestures\n";
  return kDone;
}

}  // namespace vitrine
