// Buttons that can be wired anew while the kiosk runs. A pin can be requested only once, so the old sources
// are closed before the new ones are opened, and opened again when that fails.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "buttons.h"

namespace vitrine {

class RewirableButtons final : public Buttons {
 public:
  using Open = std::function<std::shared_ptr<Buttons>()>;

  /// Throws what `open` throws.
  explicit RewirableButtons(Open open) : open_(std::move(open)), buttons_(open_()) {}

  std::vector<ButtonEvent> poll(std::chrono::milliseconds timeout) override {
    return buttons_->poll(timeout);
  }

  [[nodiscard]] std::string notice() const override { return buttons_->notice(); }

  /// Throws what `open` throws; then all is as it was.
  void rewire(Open open) {
    buttons_.reset();
    try {
      buttons_ = open();
    } catch (...) {
      buttons_ = open_();
      throw;
    }
    open_ = std::move(open);
  }

 private:
  Open open_;
  std::shared_ptr<Buttons> buttons_;
};

}  // namespace vitrine
