#include "app/check/json_report.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "ghostforce_version.h"

namespace ghostforce {
namespace {

using Json = nlohmann::ordered_json;

Json null_if_empty(const std::string& text) {
  return text.empty() ? Json() : Json(text);
}

Json difference_as_json(const Comparison& comparison) {
  Json json{{"pixels", comparison.over},   {"compared_pixels", comparison.pixels}, {"masked_pixels", comparison.masked},
            {"share", comparison.share()}, {"greatest", comparison.greatest},      {"box", nullptr}};
  if (const PixelBox box = comparison.box(); comparison.over > 0) {
    json["box"] = Json::array({box.x, box.y, box.width, box.height});
  }
  return json;
}

Json case_as_json(const Case& checked, const Verdict& verdict, const Report* report) {
  Json json{{"name", verdict.name},
            {"pass", verdict.passes},
            {"reason", verdict.reason},
            {"remark", null_if_empty(verdict.remark)},
            {"update", null_if_empty(verdict.remedy)},
            {"compared_with", expectation_name(checked.expectation)},
            {"other", null_if_empty(checked.other)},
            {"difference", nullptr},
            {"tolerance", {{"channel", verdict.tolerance.channel}, {"share", verdict.tolerance.share}}},
            {"renderer", verdict.drawn_by.renderer},
            {"mesa", verdict.drawn_by.mesa},
            {"duration_s", verdict.duration_s},
            {"files", Json::object()}};
  if (verdict.comparison) json["difference"] = difference_as_json(*verdict.comparison);
  if (report != nullptr) {
    for (const auto& [word, path] : report->pictures_of(verdict)) json["files"][std::string(word)] = path;
  }
  return json;
}

}  // namespace

std::string report_as_json(const std::vector<const Case*>& cases, const std::vector<Verdict>& verdicts,
                           std::string_view folder, const Report* report) {
  Json all = Json::array();
  double duration_s = 0.0;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    all.push_back(case_as_json(*cases[i], verdicts[i], report));
    duration_s += verdicts[i].duration_s;
  }
  const auto failed = std::ranges::count(verdicts, false, &Verdict::passes);
  Json json{
      {"format", 1},       {"version", version},
      {"folder", folder},  {"total", {{"cases", verdicts.size()}, {"failed", failed}, {"duration_s", duration_s}}},
      {"report", nullptr}, {"cases", std::move(all)}};
  if (report != nullptr) json["report"] = {{"html", report->html_path()}, {"junit", report->junit_path()}};
  // Names of files may be no UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace ghostforce
