// What a service manager listens to: datagrams of KEY=VALUE lines on the socket that NOTIFY_SOCKET names
// (sd_notify(3) describes the protocol and promises that it stays; this much needs no library).
#pragma once

#include <string>
#include <string_view>

namespace vitrine {

class NotifySocket {
 public:
  /// `address`: an absolute path, or "@NAME" for the abstract socket NAME; empty or anything else: nobody
  /// listens.
  explicit NotifySocket(std::string_view address);
  ~NotifySocket();
  NotifySocket(const NotifySocket&) = delete;
  NotifySocket& operator=(const NotifySocket&) = delete;

  /// Never waits; returns whether the manager got it.
  bool send(std::string_view message) const;

 private:
  std::string address_;
  int descriptor_ = -1;
};

}  // namespace vitrine
