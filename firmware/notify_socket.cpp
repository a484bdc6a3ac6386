#include "notify_socket.h"

#include <cstddef>
#include <cstring>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace vitrine {

NotifySocket::NotifySocket(std::string_view address) : address_(address) {
  const bool usable = address_.size() > 1 && (address_.front() == '/' || address_.front() == '@') &&
                      address_.size() < sizeof(sockaddr_un::sun_path);
  if (usable) descriptor_ = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
}

NotifySocket::~NotifySocket() {
  if (descriptor_ >= 0) close(descriptor_);
}

bool NotifySocket::send(std::string_view message) const {
  if (descriptor_ < 0) return false;
  sockaddr_un name{};
  name.sun_family = AF_UNIX;
  std::memcpy(static_cast<char*>(name.sun_path), address_.data(), address_.size());
  if (address_.front() == '@') name.sun_path[0] = '\0';
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + address_.size());
  const auto* const to = reinterpret_cast<const sockaddr*>(&name);
  const ssize_t sent =
      sendto(descriptor_, message.data(), message.size(), MSG_NOSIGNAL | MSG_DONTWAIT, to, length);
  return sent == static_cast<ssize_t>(message.size());
}

}  // namespace vitrine
