// Several sources of buttons as one: a window's keys and a script, a board's pins and a keyboard. None at all
// is a source that stays silent.
#pragma once

#include <memory>
#include <vector>

#include "buttons.h"

namespace vitrine {

class MergedButtons final : public Buttons {
 public:
  explicit MergedButtons(std::vector<std::shared_ptr<Buttons>> sources) : sources_(std::move(sources)) {}

  std::vector<ButtonEvent> poll(std::chrono::milliseconds timeout) override;
  [[nodiscard]] std::string notice() const override;

 private:
  std::vector<std::shared_ptr<Buttons>> sources_;
};

}  // namespace vitrine
