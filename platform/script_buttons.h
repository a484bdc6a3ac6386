// Scripted presses on synthetic time, for tests and for sessions that can be replayed exactly. A script has
// one event a line, `SECONDS press|release|tap NAME`, and comments from `#` to the end of the line:
//
//     0.5  tap scene       # pressed for kTapLength
//     2    press mode      # held for 1.5 s
//     3.5  release mode
#pragma once

#include <filesystem>
#include <span>
#include <stdexcept>
#include <string_view>

#include "clocks.h"

namespace vitrine {

/// A script that cannot be read. `what()` is "FILE: line N: PROBLEM; REMEDY", a single line.
class ScriptError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

inline constexpr std::chrono::milliseconds kTapLength{60};

/// The events of a script in order of time, which counts from SyntheticClock's start. `file` is for messages
/// only. Throws ScriptError; refuses names that `buttons` lacks, and a press of what is held or a release of
/// what is not.
std::vector<ButtonEvent> parse_script(std::string_view text, std::string_view file,
                                      std::span<const ButtonSpec> buttons);
std::vector<ButtonEvent> read_script(const std::filesystem::path& file, std::span<const ButtonSpec> buttons);

class ScriptButtons final : public Buttons {
 public:
  /// `events` in order of time; `clock` must outlive this.
  ScriptButtons(const SyntheticClock& clock, std::vector<ButtonEvent> events)
      : clock_(clock), events_(std::move(events)) {}

  /// The events due by the clock's now(). Never waits: only its owner moves a synthetic clock.
  std::vector<ButtonEvent> poll(std::chrono::milliseconds timeout) override;

 private:
  const SyntheticClock& clock_;
  std::vector<ButtonEvent> events_;
  std::size_t next_ = 0;
};

}  // namespace vitrine
