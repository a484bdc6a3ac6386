#include "scene/gltf_schema.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <sstream>
#include <string_view>

#include <nlohmann/json.hpp>

#include "scene/gltf_schema_rules.h"

namespace vitrine {
namespace {

using nlohmann::json;
using namespace gltf_schema;

std::string parent_of(std::string_view path) {
  const auto slash = path.rfind('/');
  return std::string(slash == std::string_view::npos ? "" : path.substr(0, slash));
}

std::string shortest(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

// RFC 6901
std::string pointer_token(const std::string& key) {
  std::string token;
  for (const char c : key) token += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return token;
}

class SchemaWalk {
 public:
  SchemaWalk(const GltfFile& file, const json& root) : file_(file) {
    for (const Rule& rule : kRules) {
      rules_.emplace(rule.path, &rule);
      if (rule.required)
        required_[parent_of(rule.path)].push_back(rule.path.substr(rule.path.rfind('/') + 1));
      if (rule.check.kind == Kind::kIndex) sizes_.emplace(rule.check.text, size_of(root, rule.check.text));
    }
  }

  /// `path` is where the table lists the members of `object`, `place` where it is.
  void check_members(json& object, const std::string& path, const std::string& place, bool closed = false) {
    for (const std::string_view key : required_[path]) {
      if (!object.contains(key)) refuse(place, "\"" + std::string(key) + "\" is missing");
    }
    for (auto member = object.begin(); member != object.end();) {
      const std::string member_path = path.empty() ? member.key() : path + "/" + member.key();
      const std::string member_place = place + "/" + pointer_token(member.key());
      const auto rule = rules_.find(member_path);
      if (rule != rules_.end()) {
        check(member.value(), *rule->second, member_place);
        ++member;
      } else if (closed) {
        refuse(member_place, "is not known");
      } else {
        member = object.erase(member);
      }
    }
  }

 private:
  static std::size_t size_of(const json& root, std::string_view collection) {
    const json::json_pointer pointer("/" + std::string(collection));
    if (!root.contains(pointer)) return 0;
    const json& array = root[pointer];
    return array.is_array() ? array.size() : 0;
  }

  void check(json& value, const Rule& rule, const std::string& place) {
    const std::string path(rule.path);
    switch (rule.check.kind) {
      case Kind::kObject:
        return check_object(value, path, place, false);
      case Kind::kClosedObject:
        return check_object(value, path, place, true);
      case Kind::kShared:
        return check_object(value, std::string(rule.check.text), place, false);
      case Kind::kMap:
        expect(value.is_object(), value, "an object", place);
        return check_elements(value, path, place);
      case Kind::kExtras:
        if (value.is_object()) return check_members(value, path, place);
        value = json::object();
        return;
      case Kind::kArray:
        expect(value.is_array(), value, "an array", place);
        return check_elements(value, path, place);
      case Kind::kIndex:
        return check_index(value, rule.check.text, place);
      case Kind::kInteger:
        return check_integer(value, rule.check, place);
      case Kind::kNumber:
        return check_number(value, rule.check, place);
      case Kind::kNumbers:
        return check_numbers(value, rule.check, place);
      case Kind::kString:
        return check_string(value, rule.check, place);
      case Kind::kBoolean:
        return expect(value.is_boolean(), value, "true or false", place);
    }
  }

  void check_object(json& value, const std::string& path, const std::string& place, bool closed) {
    expect(value.is_object(), value, "an object", place);
    check_members(value, path, place, closed);
  }

  void check_elements(json& value, const std::string& path, const std::string& place) {
    const Rule& rule = *rules_.at(path + "/*");
    if (value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) check(value[i], rule, place + "/" + std::to_string(i));
    } else {
      for (auto& [key, element] : value.items()) check(element, rule, place + "/" + pointer_token(key));
    }
  }

  void check_integer(json& value, const Check& limits, const std::string& place) {
    // JSON has one number type: 5.0 is an integer too.
    if (value.is_number_float() && std::floor(value.get<double>()) == value.get<double>() &&
        std::abs(value.get<double>()) <= kMaxInteger) {
      value = static_cast<std::int64_t>(value.get<double>());
    }
    expect(value.is_number_integer(), value, "an integer", place);
    check_range(value.get<double>(), limits, place);
    check_permitted(value.dump(), limits, place);
  }

  void check_index(json& value, std::string_view collection, const std::string& place) {
    const std::size_t size = sizes_.at(std::string(collection));
    check_integer(value, integer(-FLT_MAX, FLT_MAX), place);
    const double index = value.get<double>();
    if (index < 0 || index >= static_cast<double>(size)) {
      refuse(place, "refers to /" + std::string(collection) + "/" + value.dump() + ", but there are " +
                        std::to_string(size) + " of them");
    }
  }

  void check_number(json& value, const Check& limits, const std::string& place) {
    expect(value.is_number(), value, "a number", place);
    check_range(value.get<double>(), limits, place);
    value = value.get<double>();
  }

  void check_numbers(json& value, const Check& limits, const std::string& place) {
    expect(value.is_array(), value, "an array of numbers", place);
    if (value.size() != limits.count) {
      refuse(place, "has " + std::to_string(value.size()) + " numbers, not " + std::to_string(limits.count));
    }
    for (std::size_t i = 0; i < value.size(); ++i)
      check_number(value[i], limits, place + "/" + std::to_string(i));
  }

  void check_string(const json& value, const Check& permitted, const std::string& place) {
    expect(value.is_string(), value, "a string", place);
    check_permitted(value.get_ref<const std::string&>(), permitted, place);
  }

  void check_permitted(const std::string& value, const Check& permitted, const std::string& place) {
    if (permitted.text.empty() || permitted.text.find("|" + value + "|") != std::string_view::npos) return;
    refuse(place, "\"" + value + "\" is none of " +
                      std::string(permitted.text.substr(1, permitted.text.size() - 2)));
  }

  void check_range(double value, const Check& limits, const std::string& place) {
    if (value >= limits.min && value <= limits.max) return;
    const bool below = value < limits.min;
    const double limit = below ? limits.min : limits.max;
    refuse(place, std::abs(limit) >= FLT_MAX
                      ? "the number is too large for a float"
                      : shortest(value) + (below ? " is less than " : " is more than ") + shortest(limit));
  }

  void expect(bool as_expected, const json& value, const char* expected, const std::string& place) {
    if (as_expected) return;
    const std::string found = value.is_number() ? value.dump() : value.type_name();
    refuse(place, "is " + found + " where " + expected + " belongs");
  }

  [[noreturn]] void refuse(const std::string& place, const std::string& problem) {
    file_.refuse(place, problem, "correct the file or export it again");
  }

  const GltfFile& file_;
  std::map<std::string, const Rule*, std::less<>> rules_;
  std::map<std::string, std::vector<std::string_view>, std::less<>> required_;
  std::map<std::string, std::size_t, std::less<>> sizes_;
};

}  // namespace

void check_gltf_schema(const GltfFile& file, json& document) {
  SchemaWalk(file, document).check_members(document, "", "");
}

}  // namespace vitrine
