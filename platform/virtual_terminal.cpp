#include "virtual_terminal.h"

#include <cerrno>
#include <csignal>

#include <fcntl.h>
#include <linux/kd.h>
#include <linux/vt.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/wait.h>
#include <termios.h>

namespace vitrine {
namespace {

// Two flags, as the kernel may ask to release and to acquire before we look.
volatile std::sig_atomic_t release_asked = 0;
volatile std::sig_atomic_t acquire_asked = 0;

extern "C" void ask_to_release(int) { release_asked = 1; }
extern "C" void ask_to_acquire(int) { acquire_asked = 1; }

struct Console {
  FileDescriptor tty{};
  int number = 0;
};

/// The number of the virtual terminal that a file is, or 0.
int console_number(int fd) {
  struct stat status {};
  int mode = 0;
  if (fstat(fd, &status) != 0 || !S_ISCHR(status.st_mode) || ioctl(fd, KDGETMODE, &mode) != 0) return 0;
  return major(status.st_rdev) == 4 ? static_cast<int>(minor(status.st_rdev)) : 0;
}

FileDescriptor open_console(int number) {
  const std::string path = "/dev/tty" + std::to_string(number);
  return FileDescriptor(open(path.c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
}

Console find_console() {
  if (const int own = console_number(STDIN_FILENO); own > 0) return {open_console(own), own};
  const FileDescriptor any(open("/dev/tty0", O_WRONLY | O_NOCTTY | O_CLOEXEC));
  vt_stat state{};
  if (!any || ioctl(any.get(), VT_GETSTATE, &state) != 0) return {};
  Console shown{open_console(state.v_active), state.v_active};
  vt_mode mode{};
  int drawn = KD_TEXT;
  if (!shown.tty || ioctl(shown.tty.get(), VT_GETMODE, &mode) != 0 || mode.mode != VT_AUTO ||
      ioctl(shown.tty.get(), KDGETMODE, &drawn) != 0 || drawn != KD_TEXT) {
    return {};  // a desktop's: it is not ours to switch
  }
  return shown;
}

void handle(int signal, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

/// The life of the child: everything here must be safe after a fork from a program with threads.
[[noreturn]] void keep(int pipe, int tty, int number) {
  constexpr int kMostFiles = 1024;  // where the kernel cannot close a range of them
  prctl(PR_SET_NAME, "vitrine-console");
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
  // Nothing else of the program's may stay open because of us, least of all a card.
  dup2(pipe, STDIN_FILENO);
  dup2(tty, STDOUT_FILENO);
  dup2(tty, STDERR_FILENO);
  if (close_range(STDERR_FILENO + 1, ~0U, 0) != 0) {
    for (int fd = STDERR_FILENO + 1; fd < kMostFiles; ++fd) close(fd);
  }
  char byte = 0;
  while (read(STDIN_FILENO, &byte, 1) < 0 && errno == EINTR) {
  }
  vt_mode automatic{};
  automatic.mode = VT_AUTO;
  if (ioctl(STDOUT_FILENO, KDSETMODE, KD_TEXT) != 0) {
    // The file was hung up with the program's session: a fresh one does, if we have the right to it.
    char path[] = "/dev/tty00";
    char* at = path + 8;
    if (number >= 10) *at++ = static_cast<char>('0' + number / 10);
    *at++ = static_cast<char>('0' + number % 10);
    *at = '\0';
    dup2(open(path, O_RDWR | O_NOCTTY), STDOUT_FILENO);
    ioctl(STDOUT_FILENO, KDSETMODE, KD_TEXT);
  }
  ioctl(STDOUT_FILENO, VT_SETMODE, &automatic);
  tcflush(STDOUT_FILENO, TCIFLUSH);  // what visitors typed is no command
  _exit(0);
}

}  // namespace

VirtualTerminal::VirtualTerminal() {
  Console console = find_console();
  if (!console.tty) return;
  int ends[2] = {-1, -1};
  if (pipe2(ends, O_CLOEXEC) != 0) return;
  FileDescriptor reading(ends[0]);
  FileDescriptor writing(ends[1]);
  keeper_ = fork();
  if (keeper_ < 0) return;
  if (keeper_ == 0) keep(reading.get(), console.tty.get(), console.number);
  alive_ = std::move(writing);

  release_asked = 0;
  acquire_asked = 0;
  handle(SIGRTMIN + 4, ask_to_release);
  handle(SIGRTMIN + 5, ask_to_acquire);
  vt_mode asking{};
  asking.mode = VT_PROCESS;
  asking.relsig = static_cast<short>(SIGRTMIN + 4);
  asking.acqsig = static_cast<short>(SIGRTMIN + 5);
  if (ioctl(console.tty.get(), VT_SETMODE, &asking) != 0 ||
      ioctl(console.tty.get(), KDSETMODE, KD_GRAPHICS) != 0) {
    return;  // no right to it; the child has nothing to restore that it could
  }
  tty_ = std::move(console.tty);
  vt_stat state{};
  if (ioctl(tty_.get(), VT_GETSTATE, &state) == 0 && state.v_active != console.number) {
    shown_ = false;
    ioctl(tty_.get(), VT_ACTIVATE, console.number);  // the kernel tells when it is
  }
}

VirtualTerminal::~VirtualTerminal() {
  alive_ = FileDescriptor();
  if (keeper_ > 0) {
    while (waitpid(keeper_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
  handle(SIGRTMIN + 4, SIG_IGN);  // the default would kill, should one still be on its way
  handle(SIGRTMIN + 5, SIG_IGN);
}

VirtualTerminal::Wish VirtualTerminal::wish() {
  if (shown_ && release_asked != 0) {
    release_asked = 0;
    return Wish::kRelease;
  }
  if (acquire_asked != 0) {
    acquire_asked = 0;
    return Wish::kAcquire;
  }
  return Wish::kNone;
}

void VirtualTerminal::released() {
  shown_ = false;
  ioctl(tty_.get(), VT_RELDISP, 1);
}

void VirtualTerminal::acquired() {
  shown_ = true;
  ioctl(tty_.get(), VT_RELDISP, VT_ACKACQ);
}

}  // namespace vitrine
