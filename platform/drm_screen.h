// A lit screen of a KMS card: a mode that is set, two buffers, and the flip from one to the other. One flip
// is in flight at a time: who wants the back buffer waits for it, so no buffer is written while it is shown,
// and the frame after next is never queued. A driver that cannot flip with an event, or forgets to send it,
// gets its buffers by setting the CRTC, with a hint of what changed for those that copy it to the panel.
#pragma once

#include <array>
#include <chrono>
#include <memory>

#include "drm_card.h"
#include "dumb_buffer.h"
#include "surface.h"

namespace vitrine {

class DrmScreen {
 public:
  /// Makes the buffers; nothing is shown before show(). Takes the card. Throws std::system_error.
  DrmScreen(DrmCard card, const DrmPipe& pipe);
  ~DrmScreen();
  DrmScreen(const DrmScreen&) = delete;
  DrmScreen& operator=(const DrmScreen&) = delete;

  [[nodiscard]] const DrmCard& card() const { return card_; }
  [[nodiscard]] const DrmPipe& pipe() const { return pipe_; }
  [[nodiscard]] const ScreenMemory& memory() const { return buffers_[0]->memory(); }
  /// The first bytes of both buffers.
  [[nodiscard]] std::array<std::byte*, 2> all_pixels() const;

  /// The buffer to write the next frame to. Waits until it is no longer shown, at most a second: a driver
  /// that forgets a flip must not stop the program.
  [[nodiscard]] std::byte* back();
  /// Shows the back buffer, of which `damage` was written, and returns with the flip in flight. False: the
  /// screen, or the right to it, is gone.
  [[nodiscard]] bool show(const PixelRect& damage);

  /// Gives the card to whoever wants it, and takes it back; false: somebody else has it.
  void drop();
  [[nodiscard]] bool take();

 private:
  enum class Way : std::uint8_t { kFlip, kSetCrtc };

  void await_flip(std::chrono::milliseconds timeout);
  [[nodiscard]] bool set_crtc(std::uint32_t framebuffer);
  void hint_damage(std::uint32_t framebuffer, const PixelRect& damage);

  DrmCard card_;
  DrmPipe pipe_;
  std::array<std::unique_ptr<DumbBuffer>, 2> buffers_{};
  std::size_t front_ = 1;
  Way way_ = Way::kFlip;
  bool mode_is_set_ = false;
  bool flip_pending_ = false;
  bool wants_damage_ = true;
};

}  // namespace vitrine
