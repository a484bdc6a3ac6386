// Screen memory that every KMS driver can make, without a GPU: a "dumb buffer", mapped for writing and known
// to the card as a framebuffer.
#pragma once

#include <cstddef>
#include <cstdint>

#include "drm_format.h"
#include "scan_out.h"

namespace vitrine {

class DumbBuffer {
 public:
  /// Of a card's open device file, which must outlive it. Throws std::system_error.
  DumbBuffer(int card, int width, int height, const DrmFormat& format);
  ~DumbBuffer();
  DumbBuffer(const DumbBuffer&) = delete;
  DumbBuffer& operator=(const DumbBuffer&) = delete;

  [[nodiscard]] std::uint32_t id() const { return framebuffer_; }  ///< of the framebuffer
  [[nodiscard]] std::byte* pixels() const { return pixels_; }
  [[nodiscard]] const ScreenMemory& memory() const { return memory_; }

 private:
  void release();

  int card_;
  std::uint32_t handle_ = 0;
  std::uint32_t framebuffer_ = 0;
  std::byte* pixels_ = nullptr;
  std::size_t size_ = 0;
  ScreenMemory memory_;
};

}  // namespace vitrine
