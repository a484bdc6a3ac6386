#include "drm_screen.h"

#include <cerrno>

#include <poll.h>
#include <xf86drm.h>

namespace vitrine {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kFlipPatience{1000};

}  // namespace

DrmScreen::DrmScreen(DrmCard card, const DrmPipe& pipe) : card_(std::move(card)), pipe_(pipe) {
  for (auto& buffer : buffers_) {
    buffer = std::make_unique<DumbBuffer>(card_.fd(), pipe.mode.width, pipe.mode.height, *pipe.format);
  }
}

DrmScreen::~DrmScreen() {
  // The buffers must not go while they are on their way to the screen.
  await_flip(kFlipPatience);
}

std::array<std::byte*, 2> DrmScreen::all_pixels() const {
  return {buffers_[0]->pixels(), buffers_[1]->pixels()};
}

std::byte* DrmScreen::back() {
  await_flip(kFlipPatience);
  return buffers_[1 - front_]->pixels();
}

void DrmScreen::await_flip(milliseconds timeout) {
  drmEventContext context{};
  context.version = 2;
  context.page_flip_handler = [](int, unsigned, unsigned, unsigned, void* pending) {
    *static_cast<bool*>(pending) = false;
  };
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  while (flip_pending_) {
    const auto left = std::chrono::ceil<milliseconds>(deadline - std::chrono::steady_clock::now());
    pollfd file{card_.fd(), POLLIN, 0};
    const int ready = poll(&file, 1, static_cast<int>(std::max(left, milliseconds{0}).count()));
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0 || (file.revents & POLLIN) == 0 || drmHandleEvent(card_.fd(), &context) != 0) {
      // No event came, or the card is gone: show() finds out what still works.
      flip_pending_ = false;
      way_ = Way::kSetCrtc;
    }
  }
}

bool DrmScreen::show(const PixelRect& damage) {
  await_flip(kFlipPatience);
  const std::size_t next = 1 - front_;
  const std::uint32_t framebuffer = buffers_[next]->id();
  if (mode_is_set_ && way_ == Way::kFlip) {
    if (drmModePageFlip(card_.fd(), pipe_.crtc, framebuffer, DRM_MODE_PAGE_FLIP_EVENT, &flip_pending_) == 0) {
      flip_pending_ = true;
      front_ = next;
      return true;
    }
    if (errno == EACCES || errno == ENODEV) return false;
    if (errno != EBUSY) way_ = Way::kSetCrtc;
  }
  if (!set_crtc(framebuffer)) return false;
  mode_is_set_ = true;
  front_ = next;
  hint_damage(framebuffer, damage);
  return true;
}

bool DrmScreen::set_crtc(std::uint32_t framebuffer) {
  return drmModeSetCrtc(card_.fd(), pipe_.crtc, framebuffer, 0, 0, &pipe_.connector, 1, &pipe_.timing) == 0;
}

void DrmScreen::hint_damage(std::uint32_t framebuffer, const PixelRect& damage) {
  if (!wants_damage_) return;
  drmModeClip clip{static_cast<std::uint16_t>(damage.x), static_cast<std::uint16_t>(damage.y),
                   static_cast<std::uint16_t>(damage.x + damage.width),
                   static_cast<std::uint16_t>(damage.y + damage.height)};
  // Most drivers need no hint and say so, each in its own way.
  if (drmModeDirtyFB(card_.fd(), framebuffer, &clip, 1) != 0) wants_damage_ = false;
}

void DrmScreen::drop() {
  await_flip(kFlipPatience);
  drmDropMaster(card_.fd());
}

bool DrmScreen::take() {
  mode_is_set_ = false;  // whoever had the card has set another
  way_ = Way::kFlip;
  return drmSetMaster(card_.fd()) == 0;
}

}  // namespace vitrine
