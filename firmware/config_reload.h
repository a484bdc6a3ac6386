// SIGHUP: the config is read anew while the box runs, as a whole or not at all. When it is wrong, the box
// goes on as before and says why.
#pragma once

#include <atomic>
#include <optional>

#include "backends.h"
#include "rewirable_buttons.h"
#include "session.h"

namespace vitrine {

class ConfigReload {
 public:
  /// All references must outlive this. `asked` is what the signal sets; `box` is what the session began with.
  ConfigReload(const RunRequest& request, const BoxConfig& box, std::atomic<bool>& asked, const Panel& panel,
               const SyntheticClock& synthetic, RewirableButtons& buttons, Supervisor& supervisor)
      : request_(request),
        box_(box),
        asked_(asked),
        panel_(panel),
        synthetic_(synthetic),
        buttons_(buttons),
        supervisor_(supervisor) {}

  /// What the kiosk has to change; nothing unless asked.
  std::optional<Refit> take();

 private:
  Refit read();

  const RunRequest& request_;
  const BoxConfig& box_;
  std::atomic<bool>& asked_;
  const Panel& panel_;
  const SyntheticClock& synthetic_;
  RewirableButtons& buttons_;
  Supervisor& supervisor_;
};

}  // namespace vitrine
