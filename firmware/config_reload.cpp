#include "config_reload.h"

#include <exception>
#include <iostream>

namespace vitrine {
namespace {

/// What takes effect at the next start only, if it was changed.
std::string left_for_restart(const BoxConfig& before, const BoxConfig& after) {
  std::string keys;
  const auto compare = [&](const char* key, bool same) {
    if (!same) keys += (keys.empty() ? "" : ", ") + std::string(key);
  };
  compare("display",
          before.display_key() == after.display_key() && before.hardware.display == after.hardware.display);
  compare("size", before.size == after.size);
  compare("threads", before.threads == after.threads);
  return keys;
}

}  // namespace

std::optional<Refit> ConfigReload::take() {
  if (!asked_.exchange(false)) return std::nullopt;
  supervisor_.manager().reloading();
  Refit refit;
  try {
    refit = read();
    supervisor_.manager().reloaded("the config was read anew");
  } catch (const std::exception& error) {
    std::cerr << "vitrine: " << error.what() << " (the config before it stays)\n";
    refit = {.settings = {}, .notice = "config unchanged: " + std::string(error.what())};
    supervisor_.manager().reloaded("the config is wrong, the one before it stays: " +
                                   std::string(error.what()));
  }
  return refit;
}

Refit ConfigReload::read() {
  const BoxConfig box = box_of(request_);
  KioskSettings settings = kiosk_settings(request_, box);
  // A script's presses were read once, and are not to be played again.
  if (!request_.script) {
    buttons_.rewire([this, box] { return open_buttons_of(request_, box, panel_, synthetic_); });
  }
  supervisor_.refit(supervisor_settings(request_, box));
  const std::string left = left_for_restart(box_, box);
  const std::string missing = buttons_.notice();
  return {.settings = std::move(settings),
          .notice = "config read anew" + (left.empty() ? "" : "; at the next start: " + left) +
                    (missing.empty() ? "" : ". " + missing)};
}

}  // namespace vitrine
