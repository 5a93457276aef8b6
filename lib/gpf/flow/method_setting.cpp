#include "gpf/flow/method_setting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <vector>

#include "gpf/base/error.hpp"

namespace gpf {
namespace {

constexpr std::array<std::string_view, 5> names{"event_driven", "all_pairs", "soft_disks", "monte_carlo",
                                                "hydrodynamics"};

/// A number of a setting, by its key.
struct Field {
  std::string_view key;
  std::function<std::string(const MethodSetting&)> show;
  std::function<bool(MethodSetting&, std::string_view)> read;
  std::string_view silent{};  ///< the value that a text leaves out
};

template <class Number>
bool read_number(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

template <class Access>
Field field(std::string_view key, Access access) {
  return {key, [access](const MethodSetting& s) { return fmt::format("{}", access(s)); },
          [access](MethodSetting& s, std::string_view text) { return read_number(text, access(s)); }};
}

Field closure_field() {
  return {"closure",
          [](const MethodSetting& s) -> std::string {
            return s.hydrodynamics.closure == Closure::garzo_dufty ? "garzo_dufty" : "jenkins_richman";
          },
          [](MethodSetting& s, std::string_view text) {
            s.hydrodynamics.closure = text == "garzo_dufty" ? Closure::garzo_dufty : Closure::jenkins_richman;
            return text == "garzo_dufty" || text == "jenkins_richman";
          }};
}

/// Records made before there was this number are found under a text without it.
Field along_field() {
  Field along = field(
      "along", [](auto& s) -> auto& { return s.monte_carlo.cells_along; });
  along.silent = "1";
  return along;
}

std::vector<Field> fields_of(Method method) {
  switch (method) {
    case Method::soft_disks:
      return {field(
                  "contact", [](auto& s) -> auto& { return s.contact; }),
              field(
                  "steps", [](auto& s) -> auto& { return s.steps; })};
    case Method::monte_carlo:
      return {field(
                  "cells", [](auto& s) -> auto& { return s.monte_carlo.cells; }),
              field(
                  "particles", [](auto& s) -> auto& { return s.monte_carlo.particles_per_cell; }),
              field(
                  "step", [](auto& s) -> auto& { return s.monte_carlo.step; }),
              along_field()};
    case Method::hydrodynamics:
      return {field(
                  "cells", [](auto& s) -> auto& { return s.hydrodynamics.cells; }),
              closure_field()};
    case Method::event_driven:
    case Method::all_pairs:
      break;
  }
  return {};
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (true) {
    const auto begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) return words;
    text.remove_prefix(begin);
    words.push_back(text.substr(0, text.find(' ')));
    text.remove_prefix(words.back().size());
  }
}

}  // namespace

std::string_view name_of(Method method) { return names[static_cast<std::size_t>(method)]; }

std::string text_of(const MethodSetting& setting) {
  std::string text{name_of(setting.method)};
  for (const Field& f : fields_of(setting.method))
    if (const std::string value = f.show(setting); value != f.silent) text += fmt::format(" {}={}", f.key, value);
  return text;
}

MethodSetting parse_method(std::string_view text) {
  const std::vector<std::string_view> words = words_of(text);
  const auto name = words.empty() ? names.end() : std::find(names.begin(), names.end(), words.front());
  if (name == names.end())
    throw InputError(fmt::format("no method is called '{}'", words.empty() ? "" : words.front()),
                     fmt::format("there are {}", fmt::join(names, ", ")),
                     "write one of them, then its numbers: \"monte_carlo cells=40 particles=200\"");
  MethodSetting setting;
  setting.method = static_cast<Method>(name - names.begin());
  const std::vector<Field> fields = fields_of(setting.method);
  for (std::size_t k = 1; k < words.size(); ++k) {
    const auto equals = words[k].find('=');
    const auto key = words[k].substr(0, equals);
    const auto found = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.key == key; });
    if (equals == std::string_view::npos || found == fields.end() ||
        !found->read(setting, words[k].substr(equals + 1))) {
      std::vector<std::string> known;
      for (const Field& f : fields) known.push_back(fmt::format("{}={}", f.key, f.show({})));
      throw InputError(
          fmt::format("cannot read '{}' of the method {}", words[k], *name),
          known.empty() ? "this method has no numbers to set" : fmt::format("it has {}", fmt::join(known, " ")),
          "write key=number, without spaces");
    }
  }
  return setting;
}

}  // namespace gpf
