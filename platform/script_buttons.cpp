#include "script_buttons.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>
#include <sstream>
#include <string>

#include "nearest_name.h"

namespace vitrine {
namespace {

/// An event and the line that asked for it.
struct ScriptedEvent {
  ButtonEvent event;
  int line = 0;
};

class Parser {
 public:
  Parser(std::string_view file, std::span<const ButtonSpec> buttons) : file_(file) {
    for (const ButtonSpec& button : buttons) {
      if (std::ranges::find(names_, button.name) == names_.end()) names_.push_back(button.name);
    }
  }

  std::vector<ButtonEvent> parse(std::string_view text) {
    std::istringstream lines{std::string(text)};
    int number = 0;
    for (std::string line; std::getline(lines, line);) parse_line(line.substr(0, line.find('#')), ++number);
    std::ranges::stable_sort(events_, {}, [](const ScriptedEvent& e) { return e.event.time; });
    refuse_impossible_edges();
    std::vector<ButtonEvent> events;
    for (ScriptedEvent& scripted : events_) events.push_back(std::move(scripted.event));
    return events;
  }

 private:
  void parse_line(const std::string& line, int number) {
    std::istringstream stream(line);
    const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
    if (words.empty()) return;
    if (words.size() != 3) {
      fail(number, std::to_string(words.size()) + " words instead of three",
           "write SECONDS press|release|tap NAME");
    }
    const Clock::time_point time = parse_time(words[0], number);
    const std::string& name = words[2];
    if (std::ranges::find(names_, name) == names_.end()) {
      fail(number, "no button is named '" + name + "'", name_remedy(name, names_));
    }
    if (words[1] == "press") {
      events_.push_back({{name, Edge::kPress, time}, number});
    } else if (words[1] == "release") {
      events_.push_back({{name, Edge::kRelease, time}, number});
    } else if (words[1] == "tap") {
      events_.push_back({{name, Edge::kPress, time}, number});
      events_.push_back({{name, Edge::kRelease, time + kTapLength}, number});
    } else {
      fail(number, "'" + words[1] + "' is no event", "use press, release or tap");
    }
  }

  [[nodiscard]] Clock::time_point parse_time(const std::string& word, int number) const {
    constexpr double kLongestSeconds = 1e7;
    double seconds = 0.0;
    const char* end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), end, seconds);
    if (error != std::errc{} || rest != end || !(seconds >= 0.0 && seconds <= kLongestSeconds)) {
      fail(number, "'" + word + "' is no time",
           "give the seconds since the start as a decimal number from 0 to 1e7");
    }
    return Clock::time_point{std::chrono::nanoseconds{std::llround(seconds * 1e9)}};
  }

  void refuse_impossible_edges() const {
    std::set<std::string> held;
    for (const auto& [event, line] : events_) {
      if (event.edge == Edge::kPress && !held.insert(event.button).second) {
        fail(line, "'" + event.button + "' is pressed while it is held", "release it first");
      }
      if (event.edge == Edge::kRelease && held.erase(event.button) == 0) {
        fail(line, "'" + event.button + "' is released but not held", "press it first, or use tap");
      }
    }
  }

  [[noreturn]] void fail(int line, const std::string& problem, const std::string& remedy) const {
    throw ScriptError(file_ + ": line " + std::to_string(line) + ": " + problem + "; " + remedy);
  }

  std::string file_;
  std::vector<std::string> names_;
  std::vector<ScriptedEvent> events_;
};

}  // namespace

std::vector<ButtonEvent> parse_script(std::string_view text, std::string_view file,
                                      std::span<const ButtonSpec> buttons) {
  return Parser(file, buttons).parse(text);
}

std::vector<ButtonEvent> read_script(const std::filesystem::path& file, std::span<const ButtonSpec> buttons) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  if (stream && stream.peek() != std::ifstream::traits_type::eof()) text << stream.rdbuf();
  if (!stream && errno != 0) {
    throw ScriptError(file.string() + ": " + std::strerror(errno) +
                      "; name a readable text file of scripted presses");
  }
  return parse_script(text.str(), file.string(), buttons);
}

std::vector<ButtonEvent> ScriptButtons::poll(std::chrono::milliseconds /*timeout*/) {
  std::vector<ButtonEvent> due;
  while (next_ < events_.size() && events_[next_].time <= clock_.now()) due.push_back(events_[next_++]);
  return due;
}

}  // namespace vitrine
