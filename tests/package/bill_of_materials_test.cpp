// The list of what the program is made of, as the build has written it: CycloneDX 1.5 in JSON.
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/package/project_file.h"
#include "tests/support/places.h"

namespace ghostforce::bill_of_materials_test {
namespace {

using nlohmann::json;

json bill() {
  return json::parse(read_whole(GHOSTFORCE_BILL));
}

TEST(BillOfMaterials, HasWhatTheSpecificationRequires) {
  const json all = bill();
  EXPECT_EQ(all.at("bomFormat"), "CycloneDX");
  EXPECT_EQ(all.at("specVersion"), "1.5");
  EXPECT_GE(all.at("version"), 1);
  EXPECT_EQ(all.at("metadata").at("component").at("name"), "ghostforce");
  std::set<std::string> references{all.at("metadata").at("component").at("bom-ref").get<std::string>()};
  for (const json& component : all.at("components")) {
    EXPECT_EQ(component.at("type"), "library");
    EXPECT_FALSE(component.at("name").get<std::string>().empty());
    EXPECT_TRUE(references.insert(component.at("bom-ref").get<std::string>()).second) << component;
    // Each licence is an SPDX expression, and there is exactly one of them, as the specification has it.
    ASSERT_TRUE(component.contains("licenses")) << component << "; cmake/package/sbom.py has a table for it";
    ASSERT_EQ(component["licenses"].size(), 1U);
    EXPECT_TRUE(std::regex_match(component["licenses"][0].at("expression").get<std::string>(),
                                 std::regex(R"([A-Za-z0-9.-]+( (OR|AND|WITH) [A-Za-z0-9.-]+)*)")))
        << component;
  }
  for (const json& dependency : all.at("dependencies")) {
    EXPECT_TRUE(references.contains(dependency.at("ref").get<std::string>()));
    for (const json& on : dependency.at("dependsOn")) EXPECT_TRUE(references.contains(on.get<std::string>())) << on;
  }
}

TEST(BillOfMaterials, NamesEveryWorkInTheProgramAndEveryLibraryThatItIsLinkedWith) {
  std::set<std::string> names;
  const json all = bill();
  for (const json& component : all.at("components")) names.insert(component.at("name").get<std::string>());
  for (const std::string& work : works_in_program()) EXPECT_TRUE(names.contains(work)) << work;

  // Another program is asked than the one that made the list.
  const Outcome linked = run_program("/usr/bin/env", {"objdump", "-p", ghostforce_program()});
  ASSERT_EQ(linked.exit_code, 0) << linked.err;
  const std::vector<std::string> libraries = all_in(linked.out, R"(NEEDED +(\S+))");
  EXPECT_TRUE(std::ranges::any_of(libraries, [](const std::string& name) { return name.starts_with("libusb"); }));
  for (const std::string& library : libraries) EXPECT_TRUE(names.contains(library)) << library;
}

TEST(BillOfMaterials, TellsTheVersionsOfPackages) {
  const json all = bill();
  for (const json& component : all.at("components")) {
    if (!component.at("name").get<std::string>().starts_with("libusb")) continue;
    const std::string purl = component.at("purl");
    EXPECT_TRUE(std::regex_match(purl, std::regex(R"(pkg:deb/[a-z]+/libusb-1\.0-0@[^?]+\?arch=[a-z0-9]+&distro=\S+)")))
        << purl;
    EXPECT_FALSE(component.at("version").get<std::string>().empty());
    return;
  }
  FAIL() << "libusb is not in the list";
}

TEST(BillOfMaterials, IsTheSameWhenItIsMadeAgain) {
  const auto made = [](const std::string& epoch) {
    ProgramCall call;
    call.words = {"-B",
                  project_path("cmake/package/sbom.py"),
                  "--version=1",
                  "--notices=" + project_path("THIRD_PARTY_NOTICES.md"),
                  "--architecture=none",
                  ghostforce_program()};
    call.environment = {"SOURCE_DATE_EPOCH=" + epoch};
    const Outcome outcome = run_program(GHOSTFORCE_PYTHON, call);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  const std::string first = made("1000000000");
  EXPECT_EQ(made("1000000000"), first);
  EXPECT_EQ(json::parse(first).at("metadata").at("timestamp"), "2001-09-09T01:46:40Z");
}

}  // namespace
}  // namespace ghostforce::bill_of_materials_test
