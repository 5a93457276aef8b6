#include "verify/verdict_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "gpf/base/error.hpp"
#include "gpf/base/hash.hpp"
#include "gpf/io/atomic_file.hpp"
#include "verify/file_lock.hpp"

namespace gpf {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::string_view format_name = "gpf verdict 1";

// JSON has no infinity and no NaN.
Json number(double value) {
  if (std::isfinite(value)) return value;
  return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

double number(const Json& json) {
  if (!json.is_string()) return json.get<double>();
  const auto& word = json.get_ref<const std::string&>();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (word == "inf") return infinity;
  if (word == "-inf") return -infinity;
  if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
  throw InputError(fmt::format("'{}' is not a number", word), "a verdict holds numbers there", "judge again");
}

Json numbers(const std::vector<double>& values) {
  Json json = Json::array();
  for (const double v : values) json.push_back(number(v));
  return json;
}

std::vector<double> numbers(const Json& json) {
  std::vector<double> values;
  for (const Json& v : json) values.push_back(number(v));
  return values;
}

Json interval_json(Interval interval) { return Json::array({number(interval.lo), number(interval.hi)}); }
Interval interval_from(const Json& json) { return {number(json.at(0)), number(json.at(1))}; }

Json range_json(const std::optional<std::pair<double, double>>& range) {
  return range ? Json::array({number(range->first), number(range->second)}) : Json(nullptr);
}
std::optional<std::pair<double, double>> range_from(const Json& json) {
  if (json.is_null()) return std::nullopt;
  return std::pair{number(json.at(0)), number(json.at(1))};
}

Json plot_json(const Plot& plot) {
  Json series = Json::array();
  for (const Series& s : plot.series)
    series.push_back({{"label", s.label},
                      {"style", name_of(s.style)},
                      {"x", numbers(s.x)},
                      {"y", numbers(s.y)},
                      {"yerr", numbers(s.yerr)},
                      {"lower", numbers(s.lower)},
                      {"upper", numbers(s.upper)}});
  return {{"title", plot.title},   {"xlabel", plot.xlabel},
          {"ylabel", plot.ylabel}, {"logx", plot.logx},
          {"logy", plot.logy},     {"xrange", range_json(plot.xrange)},
          {"series", series},      {"yrange", range_json(plot.yrange)}};
}

SeriesStyle style_named(const std::string& name) {
  for (const SeriesStyle style : {SeriesStyle::points, SeriesStyle::line, SeriesStyle::band})
    if (name_of(style) == name) return style;
  throw InputError(fmt::format("unknown style '{}' of a series", name), "a verdict's plot cannot be read",
                   "judge again");
}

Plot plot_from(const Json& json) {
  Plot plot{json.at("title"),
            json.at("xlabel"),
            json.at("ylabel"),
            json.at("logx"),
            json.at("logy"),
            range_from(json.at("xrange")),
            range_from(json.at("yrange"))};
  for (const Json& s : json.at("series"))
    plot.series.push_back({s.at("label"), style_named(s.at("style")), numbers(s.at("x")), numbers(s.at("y")),
                           numbers(s.at("yerr")), numbers(s.at("lower")), numbers(s.at("upper"))});
  return plot;
}

Json check_json(const JudgedCheck& c) {
  Json json{{"label", c.check.label},
            {"outcome", name_of(c.outcome)},
            {"mean", number(c.summary.mean)},
            {"deviation", number(c.summary.deviation)},
            {"interval", interval_json(c.interval)},
            {"band", interval_json(c.check.band)},
            {"reference", number(c.check.reference)},
            {"x", number(c.check.x)},
            {"exact", c.check.exact},
            {"replicas_needed", number(c.replicas_needed)},
            {"values", numbers(c.check.values)}};
  if (c.check.share) json["share"] = true;
  return json;
}

JudgedCheck check_from(const Json& json) {
  JudgedCheck c;
  c.check = {json.at("label"),     numbers(json.at("values")),   interval_from(json.at("band")), json.at("exact"),
             number(json.at("x")), number(json.at("reference")), json.value("share", false)};
  c.summary = {number(json.at("mean")), number(json.at("deviation")), c.check.values.size()};
  c.interval = interval_from(json.at("interval"));
  c.outcome = outcome_named(json.at("outcome").get<std::string>());
  c.replicas_needed = number(json.at("replicas_needed"));
  return c;
}

Verdict verdict_from(const Json& json) {
  if (json.at("format") != format_name)
    throw InputError(fmt::format("its format is not '{}'", format_name), "another version of gpf wrote it",
                     "judge again");
  Verdict v;
  v.claim_id = json.at("claim");
  v.tier = tier_named(json.at("tier").get<std::string>());
  v.outcome = outcome_named(json.at("outcome").get<std::string>());
  v.expected = expectation_named(json.at("expected").get<std::string>());
  v.green = json.at("green");
  v.replicas = json.at("replicas");
  v.look = json.at("look");
  v.alpha = number(json.at("alpha"));
  v.summary = json.at("summary");
  for (const Json& c : json.at("checks")) v.checks.push_back(check_from(c));
  for (const Json& h : json.at("health"))
    v.health.push_back({h.at("name"), h.at("passed"), h.at("detail"), number(h.value("chance", Json(0.0)))});
  v.notes = json.at("notes").get<std::vector<std::string>>();
  v.plot = plot_from(json.at("plot"));
  for (const Json& d : json.value("drawings", Json::array())) v.drawings.push_back({d.at("title"), d.at("svg")});
  v.cpu_seconds = number(json.at("cpu_seconds"));
  v.records = json.at("records").get<std::vector<std::string>>();
  v.claim_hash = json.at("claim_hash");
  v.physics_version = json.at("physics_version");
  v.program_hash = json.at("program_hash");
  v.release_seed = json.at("release_seed");
  return v;
}

}  // namespace

std::filesystem::path verdict_path(const std::filesystem::path& store, Tier tier, std::string_view claim_id) {
  return store / "verdicts" / name_of(tier) / fmt::format("{}.json", claim_id);
}

std::string verdict_text(const Verdict& v) {
  Json checks = Json::array(), health = Json::array();
  for (const JudgedCheck& c : v.checks) checks.push_back(check_json(c));
  for (const HealthCheck& h : v.health)
    health.push_back({{"name", h.name}, {"passed", h.passed}, {"detail", h.detail}, {"chance", number(h.chance)}});
  Json drawings = Json::array();
  for (const Drawing& d : v.drawings) drawings.push_back({{"title", d.title}, {"svg", d.svg}});
  Json json{{"format", format_name},
            {"claim", v.claim_id},
            {"tier", name_of(v.tier)},
            {"outcome", name_of(v.outcome)},
            {"expected", name_of(v.expected)},
            {"green", v.green},
            {"summary", v.summary},
            {"replicas", v.replicas},
            {"look", v.look},
            {"alpha", number(v.alpha)},
            {"checks", checks},
            {"health", health},
            {"notes", v.notes},
            {"plot", plot_json(v.plot)},
            {"cpu_seconds", number(v.cpu_seconds)},
            {"records", v.records},
            {"claim_hash", v.claim_hash},
            {"physics_version", v.physics_version},
            {"program_hash", v.program_hash},
            {"release_seed", v.release_seed}};
  if (!drawings.empty()) json["drawings"] = drawings;
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Verdict parse_verdict(std::string_view text, std::string_view name) {
  try {
    return verdict_from(Json::parse(text));
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("'{}' is not a usable verdict", name), error.what(), "judge again: gpf validate");
  } catch (const InputError& error) {
    throw InputError(fmt::format("'{}' is not a usable verdict", name), error.problem(), "judge again: gpf validate");
  }
}

void write_verdict(const Verdict& verdict, const std::filesystem::path& store) {
  const std::filesystem::path path = verdict_path(store, verdict.tier, verdict.claim_id);
  std::error_code failure;
  std::filesystem::create_directories(path.parent_path(), failure);
  if (failure)
    throw StorageError(fmt::format("cannot create '{}'", path.parent_path().string()), failure.message(),
                       "choose another folder with --store");
  const auto lock = FileLock::wait(path.string() + ".lock");  // another process may be judging the same
  write_text_atomically(path, verdict_text(verdict));
}

Verdict read_verdict(const std::filesystem::path& store, Tier tier, std::string_view claim_id) {
  const std::filesystem::path path = verdict_path(store, tier, claim_id);
  return parse_verdict(read_text(path), path.string());
}

}  // namespace gpf
