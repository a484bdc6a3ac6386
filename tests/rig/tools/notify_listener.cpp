// The service manager's end of NOTIFY_SOCKET: prints each line that a service sends, after the seconds since
// boot. `notify_listener SOCKET` makes the socket and listens until it is ended.
#include <array>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <sstream>
#include <string>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

int main(int count, char** words) {
  if (count != 2) return 2;
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::strncpy(address.sun_path, words[1], sizeof address.sun_path - 1);
  unlink(words[1]);
  const int listener = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (listener < 0 || bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    std::perror(words[1]);
    return 1;
  }
  std::array<char, 4096> message{};
  for (;;) {
    const ssize_t size = recv(listener, message.data(), message.size(), 0);
    if (size < 0) return 1;
    timespec now{};
    clock_gettime(CLOCK_BOOTTIME, &now);
    std::istringstream lines(std::string(message.data(), static_cast<std::size_t>(size)));
    for (std::string line; std::getline(lines, line);) {
      std::printf("%.3f %s\n", static_cast<double>(now.tv_sec) + static_cast<double>(now.tv_nsec) / 1e9,
                  line.c_str());
    }
    std::fflush(stdout);
  }
}
