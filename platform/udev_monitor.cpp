#include "udev_monitor.h"

#include <libudev.h>
#include <unistd.h>

namespace vitrine {

void UdevMonitor::Deleter::operator()(udev* context) const { udev_unref(context); }
void UdevMonitor::Deleter::operator()(udev_monitor* monitor) const { udev_monitor_unref(monitor); }

UdevMonitor::UdevMonitor(const char* subsystem) : udev_(udev_new()) {
  if (!udev_) return;
  // udev speaks when its rules have given the device file its group; without udev that never comes.
  const bool has_udev = access("/run/udev/control", F_OK) == 0;
  monitor_.reset(udev_monitor_new_from_netlink(udev_.get(), has_udev ? "udev" : "kernel"));
  if (!monitor_) return;
  udev_monitor_filter_add_match_subsystem_devtype(monitor_.get(), subsystem, nullptr);
  if (udev_monitor_enable_receiving(monitor_.get()) < 0) monitor_.reset();
}

bool UdevMonitor::heard() {
  if (!monitor_) return false;
  bool any = false;
  while (udev_device* const device = udev_monitor_receive_device(monitor_.get())) {
    udev_device_unref(device);
    any = true;
  }
  return any;
}

}  // namespace vitrine
