#include "dumb_buffer.h"

#include <cerrno>
#include <system_error>

#include <sys/mman.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

namespace vitrine {

DumbBuffer::DumbBuffer(int card, int width, int height, const DrmFormat& format) : card_(card) {
  const auto fail = [&](const char* what) {
    const int error = errno;
    release();
    throw std::system_error(error, std::generic_category(), what);
  };
  drm_mode_create_dumb made{};
  made.width = static_cast<std::uint32_t>(width);
  made.height = static_cast<std::uint32_t>(height);
  made.bpp = static_cast<std::uint32_t>(format.layout.bits_per_pixel);
  if (drmIoctl(card_, DRM_IOCTL_MODE_CREATE_DUMB, &made) != 0) fail("no memory for the screen");
  handle_ = made.handle;
  size_ = static_cast<std::size_t>(made.size);
  memory_ = {width, height, made.pitch, format.layout};

  const std::uint32_t handles[4] = {made.handle};
  const std::uint32_t pitches[4] = {made.pitch};
  const std::uint32_t offsets[4] = {};
  if (drmModeAddFB2(card_, made.width, made.height, format.code, handles, pitches, offsets, &framebuffer_,
                    0) != 0) {
    fail("the card refuses a framebuffer");
  }
  drm_mode_map_dumb map{};
  map.handle = made.handle;
  if (drmIoctl(card_, DRM_IOCTL_MODE_MAP_DUMB, &map) != 0) fail("the screen's memory cannot be mapped");
  void* const mapped =
      mmap64(nullptr, size_, PROT_READ | PROT_WRITE, MAP_SHARED, card_, static_cast<off64_t>(map.offset));
  if (mapped == MAP_FAILED) fail("the screen's memory cannot be mapped");
  pixels_ = static_cast<std::byte*>(mapped);
  madvise(mapped, size_, MADV_DONTFORK);  // a mapping keeps the card open: a child's would outlive ours
}

DumbBuffer::~DumbBuffer() { release(); }

void DumbBuffer::release() {
  if (pixels_ != nullptr) munmap(pixels_, size_);
  if (framebuffer_ != 0) drmModeRmFB(card_, framebuffer_);
  if (handle_ != 0) {
    drm_mode_destroy_dumb destroyed{};
    destroyed.handle = handle_;
    drmIoctl(card_, DRM_IOCTL_MODE_DESTROY_DUMB, &destroyed);
  }
}

}  // namespace vitrine
