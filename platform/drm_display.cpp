#include "drm_display.h"

#include <system_error>

#include "screen_choice.h"

namespace vitrine {
namespace {

bool is_same(const DrmPipe& a, const DrmPipe& b) {
  return a.connector == b.connector && a.mode.width == b.mode.width && a.mode.height == b.mode.height &&
         a.timing.clock == b.timing.clock && a.timing.vrefresh == b.timing.vrefresh &&
         a.timing.flags == b.timing.flags;
}

}  // namespace

DrmDisplay::DrmDisplay(Extent picture, DisplayOptions options, bool insists)
    : options_(std::move(options)), frame_(picture) {
  if (!options_.mode.empty()) static_cast<void>(parse_mode(options_.mode));  // throws now rather than later
  find_screen();
  if (!screen_ && !card_seen_ && !insists) throw DisplayUnavailable(notice_);
}

DisplayMode DrmDisplay::mode() const {
  const auto [width, height] = frame_.size();
  DisplayMode mode{.width = width, .height = height};
  if (screen_ && screen_->pipe().mode.refresh_hz > 0.0) mode.refresh_hz = screen_->pipe().mode.refresh_hz;
  return mode;
}

void DrmDisplay::find_screen() {
  pace_.looked();
  std::string reasons;
  const auto add = [&](const std::string& reason) { reasons += (reasons.empty() ? "" : ". ") + reason; };
  card_seen_ = false;
  for (const std::filesystem::path& path : drm_card_paths()) {
    try {
      DrmCard card(path);
      if (!is_meant(card.identity(), options_.card)) continue;
      if (!card.is_ours()) {
        add(path.string() + " is held by another program; end that, or use its desktop");
        continue;
      }
      const std::optional<DrmPipe> pipe = card.choose_pipe(options_, Probe::kAnew);
      if (!pipe) {
        card_seen_ = true;
        add("no screen is plugged into " + path.string() +
            (options_.connector.empty() ? "" : " at " + options_.connector) + "; waiting for one");
        continue;
      }
      light(std::move(card), *pipe);
      if (screen_) {
        notice_ = pipe->notice;
        return;
      }
      add(path.string() + " refuses the mode " + mode_text(pipe->mode) + "; set another");
    } catch (const std::runtime_error& error) {  // also std::system_error of a driver
      add(error.what());
    }
  }
  if (reasons.empty()) {
    add(options_.card.empty() ? "no KMS card in /dev/dri; load its driver"
                              : "no KMS card '" + options_.card + "'; 'vitrine probe' lists the cards");
  }
  notice_ = reasons;
}

void DrmDisplay::light(DrmCard card, const DrmPipe& pipe) {
  auto screen = std::make_unique<DrmScreen>(std::move(card), pipe);
  frame_.fit({pipe.mode.width, pipe.mode.height}, options_.rotation);
  scan_out_.emplace(frame_.size(), screen->memory(), options_.rotation, options_.scaling);
  for (std::byte* const pixels : screen->all_pixels()) scan_out_->blacken(pixels);
  screen_ = std::move(screen);
  if (!console_shown()) return;  // serve_console() shows it
  if (!show()) return screen_.reset();
  // Only now that the screen is surely ours: a console beneath another's picture is not to be touched.
  if (!console_) console_.emplace();
  if (!console_shown()) screen_->drop();
}

bool DrmDisplay::show() {
  scan_out_->copy(frame_.surface(), screen_->back());
  return screen_->show(scan_out_->rect());
}

void DrmDisplay::watch_screen() {
  // Hotplug is told by an event; where that is lost or never sent, a look now and then finds out.
  const bool heard = monitor_.heard();
  if (!heard && !pace_.look_is_due()) return;
  pace_.looked();
  if (screen_) {
    const std::optional<DrmPipe> pipe =
        screen_->card().choose_pipe(options_, heard ? Probe::kAnew : Probe::kLastSeen);
    if (pipe && is_same(*pipe, screen_->pipe())) return;
    screen_.reset();
  }
  find_screen();
}

void DrmDisplay::serve_console() {
  if (!console_) return;
  for (auto wish = console_->wish(); wish != VirtualTerminal::Wish::kNone; wish = console_->wish()) {
    if (wish == VirtualTerminal::Wish::kRelease) {
      if (screen_) screen_->drop();
      console_->released();
    } else {
      console_->acquired();
      if (screen_ && !screen_->take()) screen_.reset();
    }
  }
}

void DrmDisplay::present() {
  serve_console();
  if (console_shown()) watch_screen();
  if (!waiting_for_screen()) {
    if (show()) return pace_.presented();
    screen_.reset();
  }
  pace_.wait_a_frame();
}

}  // namespace vitrine
