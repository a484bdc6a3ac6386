// Word that a device came, went or changed, from udev where it runs and from the kernel itself where it does
// not.
#pragma once

#include <memory>

struct udev;
struct udev_monitor;

namespace vitrine {

/// Of one subsystem, such as "drm". Where the machine cannot tell, nothing is ever heard: look now and then.
class UdevMonitor {
 public:
  explicit UdevMonitor(const char* subsystem);

  /// Whether anything was heard since the last call. Never waits.
  [[nodiscard]] bool heard();

 private:
  struct Deleter {
    void operator()(udev* context) const;
    void operator()(udev_monitor* monitor) const;
  };
  std::unique_ptr<udev, Deleter> udev_;
  std::unique_ptr<udev_monitor, Deleter> monitor_;
};

}  // namespace vitrine
