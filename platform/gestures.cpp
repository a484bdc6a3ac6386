#include "gestures.h"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <utility>

namespace vitrine {
namespace {

using std::chrono::milliseconds;

milliseconds default_after(GestureKind kind) {
  switch (kind) {
    case GestureKind::kShort:
      break;
    case GestureKind::kLong:
      return kLongPress;
    case GestureKind::kRepeat:
      return kRepeatDelay;
    case GestureKind::kChord:
      return kChordWindow;
  }
  return {};
}

GestureRule completed(GestureRule rule) {
  if (rule.after == milliseconds{0}) rule.after = default_after(rule.kind);
  if (rule.every == milliseconds{0}) rule.every = kRepeatPeriod;
  return rule;
}

std::set<std::string> members(const GestureRule& rule) { return {rule.buttons.begin(), rule.buttons.end()}; }

bool contains(const GestureRule& chord, const std::string& button) {
  return std::ranges::find(chord.buttons, button) != chord.buttons.end();
}

/// Whether `larger` is `smaller` with further buttons.
bool surrounds(const GestureRule& larger, const GestureRule& smaller) {
  return larger.buttons.size() > smaller.buttons.size() &&
         std::ranges::all_of(smaller.buttons,
                             [&](const std::string& name) { return contains(larger, name); });
}

}  // namespace

std::string rule_problem(std::span<const GestureRule> rules, std::size_t index) {
  const GestureRule& rule = rules[index];
  const bool chord = rule.kind == GestureKind::kChord;
  if (chord && rule.buttons.size() < 2) return "a chord has two buttons or more; name all of them";
  if (!chord && rule.buttons.size() != 1) return "only a chord has several buttons; name one";
  if (std::ranges::count(rule.buttons, std::string()) > 0) return "a button without a name; name it";
  if (members(rule).size() < rule.buttons.size()) return "a button stands twice in a chord; name it once";
  if (rule.action.empty()) return "nothing to do; name an action";
  if (rule.after < milliseconds{0} || rule.every < milliseconds{0})
    return "a time before the press; give one after it";
  if (rule.kind == GestureKind::kShort && rule.after != milliseconds{0})
    return "a short press does not wait; leave its time out";
  if (rule.kind != GestureKind::kRepeat && rule.every != milliseconds{0})
    return "only a repeat has a period; leave it out";
  const bool again = std::ranges::any_of(rules.first(index), [&](const GestureRule& other) {
    return other.kind == rule.kind && members(other) == members(rule);
  });
  return again ? "the same gesture stands above with another action; keep one of them" : "";
}

GestureRecogniser::GestureRecogniser(std::span<const GestureRule> rules) {
  for (std::size_t i = 0; i < rules.size(); ++i) {
    const std::string problem = rule_problem(rules, i);
    if (!problem.empty()) throw std::invalid_argument("gesture " + std::to_string(i + 1) + ": " + problem);
    const GestureRule rule = completed(rules[i]);
    if (rule.kind == GestureKind::kChord) chords_.push_back(rule);
    for (const std::string& button : rule.buttons) {
      Manners& manners = manners_[button];
      if (rule.kind == GestureKind::kShort) manners.short_action = rule.action;
      if (rule.kind == GestureKind::kLong) manners.long_press = rule;
      if (rule.kind == GestureKind::kRepeat) manners.repeat = rule;
      if (rule.kind == GestureKind::kChord) manners.chord_window = std::max(manners.chord_window, rule.after);
    }
  }
  for (auto& [button, manners] : manners_) {
    if (manners.short_action.empty()) manners.short_action = manners.repeat ? manners.repeat->action : button;
  }
  std::ranges::stable_sort(chords_, std::ranges::greater{},
                           [](const GestureRule& chord) { return chord.buttons.size(); });
}

std::vector<Gesture> GestureRecogniser::take(std::span<const ButtonEvent> events, Clock::time_point now) {
  for (const ButtonEvent& event : events) {
    const Clock::time_point time = std::min(event.time, now);
    advance(time);
    if (event.edge == Edge::kPress) {
      press(event.button, time);
    } else {
      release(event.button, time);
    }
  }
  advance(now);
  return std::exchange(done_, {});
}

std::optional<Clock::time_point> GestureRecogniser::deadline() const {
  std::optional<Clock::time_point> earliest;
  for (const auto& [button, press] : down_) {
    const auto due = press.deadline();
    if (due && (!earliest || *due < *earliest)) earliest = due;
  }
  return earliest;
}

std::optional<Clock::time_point> GestureRecogniser::Press::deadline() const {
  if (decided) return next_repeat;
  if (chord_until && long_at) return std::min(*chord_until, *long_at);
  return chord_until ? chord_until : long_at;
}

GestureRecogniser::Manners GestureRecogniser::manners_of(const std::string& button) const {
  const auto found = manners_.find(button);
  if (found != manners_.end()) return found->second;
  Manners manners;
  manners.short_action = button;
  return manners;
}

void GestureRecogniser::press(const std::string& button, Clock::time_point time) {
  release(button, time);
  const Manners manners = manners_of(button);
  Press press{.began = time, .decided = false, .chord_until = {}, .long_at = {}, .next_repeat = {}};
  if (manners.chord_window > milliseconds{0}) press.chord_until = time + manners.chord_window;
  if (manners.long_press) press.long_at = time + manners.long_press->after;
  const bool waits = press.deadline().has_value();
  down_.emplace(button, press);
  if (!waits) return decide(button, GestureKind::kShort, manners.short_action, time);

  const GestureRule* const chord = complete_chord(button);
  if (chord == nullptr) return;
  const std::optional<Clock::time_point> end = grows_until(*chord, time);
  if (!end) return decide(button, GestureKind::kChord, chord->action, time);
  for (const std::string& member : chord->buttons) {
    auto& until = down_.at(member).chord_until;
    until = until ? std::min(*until, *end) : *end;
  }
}

void GestureRecogniser::release(const std::string& button, Clock::time_point time) {
  const auto found = down_.find(button);
  if (found == down_.end()) return;
  if (!found->second.decided) decide(button, GestureKind::kShort, manners_of(button).short_action, time);
  down_.erase(found);
}

void GestureRecogniser::advance(Clock::time_point time) {
  while (true) {
    const auto due = std::ranges::find_if(down_, [&, earliest = deadline()](const auto& entry) {
      return earliest && *earliest <= time && entry.second.deadline() == earliest;
    });
    if (due == down_.end()) return;
    meet_deadline(due->first, due->second, time);
  }
}

void GestureRecogniser::meet_deadline(const std::string& button, Press& press, Clock::time_point horizon) {
  const Manners manners = manners_of(button);
  const Clock::time_point time = *press.deadline();
  if (press.decided) {
    done_.push_back({manners.repeat->action, GestureKind::kRepeat, time});
    // A loop that stalled gets one repeat, not all that it missed.
    while (*press.next_repeat <= horizon) *press.next_repeat += manners.repeat->every;
  } else if (press.chord_until == time) {
    press.chord_until.reset();
    if (complete_chord(button) != nullptr || !press.long_at)
      decide(button, GestureKind::kShort, manners.short_action, time);
  } else {
    decide(button, GestureKind::kLong, manners.long_press->action, time);
  }
}

void GestureRecogniser::decide(const std::string& button, GestureKind kind, const std::string& action,
                               Clock::time_point time) {
  if (const GestureRule* const chord = complete_chord(button)) {
    done_.push_back({chord->action, GestureKind::kChord, time});
    for (const std::string& member : chord->buttons) down_.at(member).decided = true;
    return;
  }
  done_.push_back({action, kind, time});
  Press& press = down_.at(button);
  press.decided = true;
  if (const auto repeat = manners_of(button).repeat) {
    press.next_repeat = press.began + repeat->after;
    if (*press.next_repeat <= time) press.next_repeat = time + repeat->every;
  }
}

const GestureRule* GestureRecogniser::complete_chord(const std::string& button) const {
  const auto complete = [&](const GestureRule& chord) {
    if (!contains(chord, button)) return false;
    const std::optional<Span> span = span_of(chord);
    return span && span->missing == 0 && span->last - span->first < chord.after;
  };
  const auto found = std::ranges::find_if(chords_, complete);
  return found == chords_.end() ? nullptr : &*found;
}

std::optional<Clock::time_point> GestureRecogniser::grows_until(const GestureRule& chord,
                                                                Clock::time_point time) const {
  std::optional<Clock::time_point> latest;
  for (const GestureRule& larger : chords_) {
    const std::optional<Span> span = surrounds(larger, chord) ? span_of(larger) : std::nullopt;
    if (!span || span->missing == 0) continue;
    const Clock::time_point end = span->first + larger.after;
    if (end > time && (!latest || end > *latest)) latest = end;
  }
  return latest;
}

std::optional<GestureRecogniser::Span> GestureRecogniser::span_of(const GestureRule& chord) const {
  Span span{.missing = 0, .first = Clock::time_point::max(), .last = Clock::time_point::min()};
  for (const std::string& member : chord.buttons) {
    const auto found = down_.find(member);
    if (found == down_.end()) {
      ++span.missing;
      continue;
    }
    if (found->second.decided) return std::nullopt;
    span.first = std::min(span.first, found->second.began);
    span.last = std::max(span.last, found->second.began);
  }
  return span;
}

}  // namespace vitrine
