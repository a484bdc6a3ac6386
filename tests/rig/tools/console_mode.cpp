// Says what a virtual terminal's screen and keyboard are in the hands of: "text unicode" for a usable
// console, "graphics off" while a program draws and reads the keys itself. `console_mode [/dev/ttyN]`
#include <cstdio>

#include <fcntl.h>
#include <linux/kd.h>
#include <sys/ioctl.h>

int main(int count, char** words) {
  const char* const path = count > 1 ? words[1] : "/dev/tty1";
  const int terminal = open(path, O_RDWR | O_CLOEXEC | O_NOCTTY);
  int screen = 0;
  int keyboard = 0;
  if (terminal < 0 || ioctl(terminal, KDGETMODE, &screen) != 0 ||
      ioctl(terminal, KDGKBMODE, &keyboard) != 0) {
    std::perror(path);
    return 1;
  }
  std::printf("%s %s\n", screen == KD_TEXT ? "text" : "graphics",
              keyboard == K_OFF ? "off" : (keyboard == K_UNICODE || keyboard == K_XLATE ? "on" : "raw"));
}
