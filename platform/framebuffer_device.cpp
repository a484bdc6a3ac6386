#include "framebuffer_device.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstring>

#include <fcntl.h>
#include <linux/fb.h>
#include <sys/ioctl.h>
#include <sys/mman.h>

namespace vitrine {
namespace {

BitField field_of(const fb_bitfield& field) {
  return {static_cast<int>(field.offset), static_cast<int>(field.length)};
}

int bits_of(PixelFormat format) {
  switch (format) {
    case PixelFormat::kRgb565:
      return 16;
    case PixelFormat::kRgb888:
      return 24;
    case PixelFormat::kXrgb8888:
      break;
  }
  return 32;
}

/// Asks for other bits a pixel; which of them are which colour is left to the driver.
bool set_bits(int fd, fb_var_screeninfo variable, int bits) {
  variable.bits_per_pixel = static_cast<__u32>(bits);
  variable.red = variable.green = variable.blue = variable.transp = {};
  variable.grayscale = 0;
  variable.activate = FB_ACTIVATE_NOW;
  return ioctl(fd, FBIOPUT_VSCREENINFO, &variable) == 0 &&
         variable.bits_per_pixel == static_cast<__u32>(bits);
}

/// DIRECTCOLOR has a table after the bits: made a straight line, what is written is what is shown.
void straighten_colours(int fd, const fb_var_screeninfo& variable) {
  const __u32 most = std::max({variable.red.length, variable.green.length, variable.blue.length});
  std::vector<__u16> line(std::size_t{1} << std::min(most, 8U));
  for (std::size_t i = 0; i < line.size(); ++i) line[i] = static_cast<__u16>(i * 0xffff / (line.size() - 1));
  fb_cmap map{};
  map.len = static_cast<__u32>(line.size());
  map.red = map.green = map.blue = line.data();
  ioctl(fd, FBIOPUTCMAP, &map);
}

std::vector<std::filesystem::path> framebuffer_paths() {
  std::vector<std::pair<int, std::filesystem::path>> devices;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator("/dev", none)) {
    const std::string name = entry.path().filename();
    int number = 0;
    if (!name.starts_with("fb")) continue;
    const auto [end, error] = std::from_chars(name.data() + 2, name.data() + name.size(), number);
    if (error == std::errc{} && end == name.data() + name.size()) devices.emplace_back(number, entry.path());
  }
  std::ranges::sort(devices);
  std::vector<std::filesystem::path> paths;
  for (auto& [number, path] : devices) paths.push_back(std::move(path));
  return paths;
}

FileDescriptor open_device(const std::filesystem::path& path) {
  FileDescriptor file(open(path.c_str(), O_RDWR | O_CLOEXEC));
  if (!file) {
    const std::string why = path.string() + " cannot be opened: " + std::strerror(errno);
    throw DisplayUnavailable(why + (errno == EACCES ? "; join the group 'video'" : "; check 'ls /dev/fb*'"));
  }
  return file;
}

}  // namespace

FramebufferInfo framebuffer_info(const std::string& path, const fb_fix_screeninfo& fixed,
                                 const fb_var_screeninfo& variable) {
  FramebufferInfo info{.path = path,
                       .id = std::string(fixed.id, strnlen(fixed.id, sizeof fixed.id)),
                       .width = static_cast<int>(variable.xres),
                       .height = static_cast<int>(variable.yres),
                       .stride_bytes = fixed.line_length,
                       .layout = {static_cast<int>(variable.bits_per_pixel), field_of(variable.red),
                                  field_of(variable.green), field_of(variable.blue), 0}};
  if (variable.transp.length > 0 && variable.transp.length + variable.transp.offset <= 32) {
    info.layout.always_set = static_cast<std::uint32_t>(((std::uint64_t{1} << variable.transp.length) - 1)
                                                        << variable.transp.offset);
  }
  const std::string name = path + " (" + info.id + ") cannot show pictures: ";
  const auto row_bytes = std::uint64_t{variable.xres} * variable.bits_per_pixel / 8;
  const auto bytes = (std::uint64_t{variable.yoffset} + variable.yres) * fixed.line_length;
  if (const std::string problem = layout_problem(info.layout); !problem.empty()) {
    info.problem = name + problem + "; set 16, 24 or 32 bits by its driver's option or 'fbset -depth 32'";
  } else if (fixed.type != FB_TYPE_PACKED_PIXELS ||
             (fixed.visual != FB_VISUAL_TRUECOLOR && fixed.visual != FB_VISUAL_DIRECTCOLOR) ||
             variable.grayscale != 0) {
    info.problem = name + "its pixels are no packed true colours; use another device";
  } else if (info.width < 1 || info.height < 1 ||
             (std::uint64_t{variable.xoffset} * variable.bits_per_pixel / 8 + row_bytes) >
                 fixed.line_length ||
             bytes > fixed.smem_len) {
    info.problem = name + "its " + std::to_string(fixed.smem_len) + " bytes do not hold its " +
                   std::to_string(variable.xres) + "x" + std::to_string(variable.yres) +
                   " pixels; set a mode, as by 'fbset'";
  }
  return info;
}

ScreenInventory list_framebuffers() {
  ScreenInventory inventory;
  for (const std::filesystem::path& path : framebuffer_paths()) {
    FramebufferInfo info{.path = path.string()};
    try {
      const FileDescriptor file = open_device(path);
      fb_fix_screeninfo fixed{};
      fb_var_screeninfo variable{};
      if (ioctl(file.get(), FBIOGET_FSCREENINFO, &fixed) == 0 &&
          ioctl(file.get(), FBIOGET_VSCREENINFO, &variable) == 0) {
        info = framebuffer_info(path.string(), fixed, variable);
      } else {
        info.problem = path.string() + " tells nothing of itself: " + std::strerror(errno) + "; use another";
      }
    } catch (const DisplayUnavailable& error) {
      info.problem = error.what();
    }
    inventory.framebuffers.push_back(std::move(info));
  }
  return inventory;
}

FramebufferDevice::FramebufferDevice(const std::filesystem::path& path, std::optional<PixelFormat> format)
    : file_(open_device(path)) {
  const int fd = file_.get();
  fb_fix_screeninfo fixed{};
  fb_var_screeninfo variable{};
  if (ioctl(fd, FBIOGET_VSCREENINFO, &variable) != 0) {
    throw DisplayUnavailable(path.string() + " is no framebuffer device; name one of /dev/fb*");
  }
  variable.activate = FB_ACTIVATE_NOW;
  ioctl(fd, FBIOPUT_VSCREENINFO, &variable);  // a refusal does no harm: the mode is as it was
  const auto bits = static_cast<int>(variable.bits_per_pixel);
  if (format && bits_of(*format) != bits) {
    set_bits(fd, variable, bits_of(*format));
  } else if (!format && bits != 16 && bits != 24 && bits != 32) {
    if (!set_bits(fd, variable, 32)) set_bits(fd, variable, 16);
  }
  ioctl(fd, FBIOBLANK, FB_BLANK_UNBLANK);
  if (ioctl(fd, FBIOGET_VSCREENINFO, &variable) != 0 || ioctl(fd, FBIOGET_FSCREENINFO, &fixed) != 0) {
    throw DisplayUnavailable(path.string() + " tells nothing of itself: " + std::strerror(errno) +
                             "; name another device");
  }
  info_ = framebuffer_info(path.string(), fixed, variable);
  if (!info_.problem.empty()) throw DisplayUnavailable(info_.problem);
  if (fixed.visual == FB_VISUAL_DIRECTCOLOR) straighten_colours(fd, variable);

  // Some devices start within a page; the mapping does at its beginning.
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  const std::size_t start = static_cast<std::size_t>(fixed.smem_start) & (page - 1);
  mapped_bytes_ = start + fixed.smem_len;
  void* const mapped = mmap(nullptr, mapped_bytes_, PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0);
  if (mapped == MAP_FAILED) {
    throw DisplayUnavailable(path.string() + " cannot be mapped: " + std::strerror(errno) +
                             "; name another device");
  }
  mapped_ = static_cast<std::byte*>(mapped);
  madvise(mapped, mapped_bytes_, MADV_DONTFORK);  // a mapping keeps the device open
  pixels_ = mapped_ + start + std::size_t{variable.yoffset} * fixed.line_length +
            std::size_t{variable.xoffset} * variable.bits_per_pixel / 8;
}

FramebufferDevice::~FramebufferDevice() {
  if (mapped_ != nullptr) munmap(mapped_, mapped_bytes_);
}

ScreenMemory FramebufferDevice::memory() const {
  return {info_.width, info_.height, info_.stride_bytes, info_.layout};
}

void FramebufferDevice::await_vsync() {
  __u32 first = 0;
  while (tells_vsync_ && ioctl(file_.get(), FBIO_WAITFORVSYNC, &first) != 0) {
    if (errno != EINTR) tells_vsync_ = false;  // it cannot: do not ask again
  }
}

bool FramebufferDevice::alive() const {
  fb_var_screeninfo variable{};
  return ioctl(file_.get(), FBIOGET_VSCREENINFO, &variable) == 0;
}

}  // namespace vitrine
