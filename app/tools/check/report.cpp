#include "app/tools/check/report.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/base/failure.h"
#include "app/base/quoted.h"
#include "app/files/input_file.h"
#include "app/files/xml_text.h"
#include "embedded_report_style.h"
#include "ghostforce_version.h"

namespace ghostforce {
namespace {

constexpr std::string_view page_name = "report.html";
constexpr std::string_view junit_name = "junit.xml";
// What tells the two from other files of their names.
constexpr std::string_view page_title_ends = " – ghostforce check</title>";
constexpr std::string_view junit_begins = "<testsuites name=\"ghostforce check\"";

struct PictureKind {
  std::string_view word;
  std::string_view ending;
  std::string_view caption;
  std::optional<std::string> VerdictPictures::*bytes;
};
constexpr std::array<PictureKind, 3> picture_kinds{{
    {"expected", "expected.png", "expected", &VerdictPictures::expected},
    {"actual", "actual.png", "actual", &VerdictPictures::actual},
    {"difference", "diff.png",
     "what differs: magenta, inside the blue frame; orange where within the tolerance; hatched where masked",
     &VerdictPictures::difference},
}};

// A file's name as a link beside the page.
std::string link_to(std::string_view file_name) {
  std::string link = "./";  // a colon in the path must not be read as a scheme
  for (const char c : file_name) {
    const bool is_plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    link += is_plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return link;
}

std::string picture_name(const Verdict& verdict, const PictureKind& kind) {
  return fmt::format("{}.{}", verdict.name, kind.ending);
}

std::string_view word_of(const Verdict& verdict) {
  return verdict.passes ? "pass" : "FAIL";
}

std::string path_in(const std::string& folder, std::string_view name) {
  return (std::filesystem::path(folder) / name).string();
}

std::string section_about(const Verdict& verdict, std::size_t number) {
  std::string html =
      fmt::format("<h2 id=\"case{}\">{}</h2>\n<p>{}</p>\n", number, xml_text(verdict.name), xml_text(verdict.reason));
  if (!verdict.remark.empty()) html += fmt::format("<p><strong>{}</strong></p>\n", xml_text(verdict.remark));
  if (!verdict.remedy.empty()) {
    html += fmt::format("<p>If the new picture is right: <code>{}</code></p>\n", xml_text(verdict.remedy));
  }
  html += "<div class=\"pictures\">\n";
  for (const PictureKind& kind : picture_kinds) {
    if (!(verdict.pictures.*kind.bytes).has_value()) continue;
    const std::string link = link_to(picture_name(verdict, kind));
    html += fmt::format(
        "<figure><figcaption>{}</figcaption><a href=\"{}\"><img src=\"{}\" alt=\"{} picture of {}\">"
        "</a></figure>\n",
        kind.caption, link, link, kind.word, xml_text(verdict.name));
  }
  if (verdict.pictures.expected && verdict.pictures.actual) {
    const std::string expected = link_to(picture_name(verdict, picture_kinds[0]));
    const std::string actual = link_to(picture_name(verdict, picture_kinds[1]));
    html += fmt::format(
        "<figure><figcaption>expected to the left of the slider, actual to its right</figcaption>\n"
        "<input type=\"checkbox\" class=\"blink\" id=\"blink{0}\"><label for=\"blink{0}\">blink</label>\n"
        "<input type=\"range\" class=\"slider\" min=\"0\" max=\"100\" value=\"50\" "
        "aria-label=\"where the actual picture begins\" "
        "oninput=\"this.nextElementSibling.style.setProperty('--from', this.value + '%')\">\n"
        "<div class=\"pair\"><img src=\"{1}\" alt=\"expected picture of {3}\"><img src=\"{2}\" "
        "alt=\"actual picture of {3}\"></div></figure>\n",
        number, expected, actual, xml_text(verdict.name));
  }
  return html + "</div>\n";
}

void remove_picture(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(std::filesystem::symlink_status(path, error))) return;
  std::filesystem::remove(path, error);
  if (!error) return;
  throw Failure(ExitCode::file_trouble,
                fmt::format("{} cannot be removed: {}", quoted_text(path, longest_path), reason_of(error.value())));
}

// The folder, which is there from now on.
std::string made(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (!error) return folder;
  throw Failure(ExitCode::file_trouble, fmt::format("the folder {} cannot be created: {}",
                                                    quoted_text(folder, longest_path), reason_of(error.value())));
}

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

Json numbers_as_json(const Verdict& verdict) {
  Json json = Json::array();
  for (std::size_t i = 0; i < quantity_count; ++i) {
    if (!verdict.numbers[i]) continue;
    const CheckedNumber& number = *verdict.numbers[i];
    json.push_back({{"name", quantity_catalog()[i].column},
                    {"pass", number.passes()},
                    {"expected", number.expected},
                    {"actual", number.actual},
                    {"tolerance", number.tolerance}});
  }
  return json;
}

Json case_as_json(const Case& checked, const Verdict& verdict, const std::string& pictures) {
  Json json{{"name", verdict.name},
            {"pass", verdict.passes},
            {"reason", verdict.reason},
            {"remark", null_if_empty(verdict.remark)},
            {"update", null_if_empty(verdict.remedy)},
            {"compared_with", expectation_name(checked.expectation)},
            {"other", null_if_empty(checked.other)},
            {"difference", nullptr},
            {"tolerance", {{"channel", verdict.tolerance.channel}, {"share", verdict.tolerance.share}}},
            {"numbers", numbers_as_json(verdict)},
            {"renderer", verdict.drawn_by.renderer},
            {"mesa", verdict.drawn_by.mesa},
            {"duration_s", verdict.duration_s},
            {"files", Json::object()}};
  if (verdict.comparison) json["difference"] = difference_as_json(*verdict.comparison);
  for (const PictureKind& kind : picture_kinds) {
    if (pictures.empty() || !(verdict.pictures.*kind.bytes).has_value()) continue;
    json["files"][std::string(kind.word)] = path_in(pictures, picture_name(verdict, kind));
  }
  return json;
}

}  // namespace

std::ptrdiff_t CheckReport::failed() const {
  return std::ranges::count(verdicts, false, &Verdict::passes);
}

std::string CheckReport::counts() const {
  return fmt::format("{} {}, {} failed", verdicts.size(), verdicts.size() == 1 ? "case" : "cases", failed());
}

double CheckReport::duration_s() const {
  double sum = 0.0;
  for (const Verdict& verdict : verdicts) sum += verdict.duration_s;
  return sum;
}

std::string report_as_html(const CheckReport& report) {
  const std::vector<Verdict>& verdicts = report.verdicts;
  const std::string title = report.counts();
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{}{}\n"
      "<style>\n{}</style>\n</head>\n<body>\n<h1>{}</h1>\n<p>ghostforce {} check <code>{}</code></p>\n"
      "<table>\n<thead><tr><th>verdict</th><th>case</th><th>what was found</th><th>time</th></tr></thead>\n<tbody>\n",
      title, page_title_ends, embedded_report_style.front().contents, title, version, xml_text(report.folder));
  std::string sections;
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const Verdict& verdict = verdicts[i];
    const std::string name = verdict.passes ? xml_text(verdict.name)
                                            : fmt::format("<a href=\"#case{}\">{}</a>", i + 1, xml_text(verdict.name));
    html += fmt::format("<tr><td class=\"{}\">{}</td><td>{}</td><td>{}</td><td class=\"time\">{:.2f} s</td></tr>\n",
                        word_of(verdict), word_of(verdict), name, xml_text(verdict.reason), verdict.duration_s);
    if (!verdict.passes) sections += section_about(verdict, i + 1);
  }
  return html + "</tbody>\n</table>\n" + sections + "</body>\n</html>\n";
}

std::string report_as_junit(const CheckReport& report) {
  const std::string folder = xml_text(report.folder);
  const std::string counts = fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"0\" time=\"{:.3f}\"",
                                         report.verdicts.size(), report.failed(), report.duration_s());
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n{} {}>\n"
      "  <testsuite name=\"{}\" {}>\n",
      junit_begins, counts, folder, counts);
  for (const Verdict& verdict : report.verdicts) {
    xml += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\"", folder, xml_text(verdict.name),
                       verdict.duration_s);
    if (verdict.passes) {
      xml += "/>\n";
      continue;
    }
    const std::string more = fmt::format("{}{}{}{}{}", verdict.reason, verdict.remark.empty() ? "" : "\n",
                                         verdict.remark, verdict.remedy.empty() ? "" : "\nto update: ", verdict.remedy);
    xml += fmt::format(">\n      <failure type=\"picture\" message=\"{}\">{}</failure>\n    </testcase>\n",
                       xml_text(verdict.reason), xml_text(more));
  }
  return xml + "  </testsuite>\n</testsuites>\n";
}

std::string report_as_json(const CheckReport& report) {
  Json all = Json::array();
  for (std::size_t i = 0; i < report.verdicts.size(); ++i) {
    all.push_back(case_as_json(*report.cases[i], report.verdicts[i], report.to_folder));
  }
  const Json total{{"cases", report.verdicts.size()}, {"failed", report.failed()}, {"duration_s", report.duration_s()}};
  Json json{{"format", 1},    {"version", version}, {"folder", report.folder},
            {"total", total}, {"report", nullptr},  {"cases", std::move(all)}};
  if (!report.to_folder.empty()) {
    json["report"] = {{"html", path_in(report.to_folder, page_name)}, {"junit", path_in(report.to_folder, junit_name)}};
  }
  // Names of files may be no UTF-8.
  return json.dump(1, ' ', false, Json::error_handler_t::replace);
}

ReportFolder::ReportFolder(const std::string& folder)
    : folder_(made(folder)), html_(path_in(folder, page_name)), junit_(path_in(folder, junit_name)) {}

bool ReportFolder::may_write(std::string_view path) {
  const std::string_view name = path.substr(path.rfind('/') + 1);
  return name == page_name || name == junit_name ||
         std::ranges::any_of(picture_kinds, [&](const PictureKind& kind) { return name.ends_with(kind.ending); });
}

void ReportFolder::remove_earlier_pages(const std::string& folder) {
  for (const auto& [name, sign] : {std::pair(page_name, page_title_ends), std::pair(junit_name, junit_begins)}) {
    const std::string path = path_in(folder, name);
    if (!kind_instead_of_file(path).empty()) continue;  // a pipe would have it wait
    constexpr std::size_t signs_end = 4096;
    std::string beginning(signs_end, '\0');
    std::ifstream(path).read(beginning.data(), signs_end);
    std::error_code ignored;
    if (beginning.find(sign) != std::string::npos) std::filesystem::remove(path, ignored);
  }
}

void ReportFolder::take_pictures(Verdict& verdict) {
  for (const PictureKind& kind : picture_kinds) {
    std::optional<std::string>& bytes = verdict.pictures.*kind.bytes;
    if (!bytes) continue;
    OutputFile& file = pictures_.emplace_back(path_in(folder_, picture_name(verdict, kind)));
    file.write(*bytes);
    file.finish();
    bytes.emplace();
  }
}

void ReportFolder::write(const CheckReport& report) {
  // The pages come last: they never show a picture that is not there.
  for (OutputFile& picture : pictures_) picture.commit();
  for (const Verdict& verdict : report.verdicts) {
    for (const PictureKind& kind : picture_kinds) {
      if (!(verdict.pictures.*kind.bytes).has_value()) remove_picture(path_in(folder_, picture_name(verdict, kind)));
    }
  }
  html_.write(report_as_html(report));
  junit_.write(report_as_junit(report));
  html_.commit();
  junit_.commit();
}

}  // namespace ghostforce
