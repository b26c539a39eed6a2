#include "prs/input/schema.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "prs/input/document.h"
#include "prs/input/reader.h"
#include "tests/prs/input/abevi.h"
#include "tests/support/sanitized.h"
#include "tests/support/temporary_directory.h"

namespace prs::input {
namespace {

using Json = nlohmann::ordered_json;

/// The value that other readers of YAML 1.2 see.
Json to_json(const Node& node) {
  Json json;
  switch (node.kind) {
    case Node::Kind::null:
      return nullptr;
    case Node::Kind::sequence:
      json = Json::array();
      for (const Node& child : node.children) json.push_back(to_json(child));
      return json;
    case Node::Kind::map:
      json = Json::object();
      for (const Node& child : node.children) json[child.key] = to_json(child);
      return json;
    case Node::Kind::scalar:
      break;
  }
  if (scalar_type(node) == ScalarType::text) return node.text;
  return Json::parse(node.text);
}

/// The text of the Abevi case with overrides, and whether the reader takes it.
struct Sample {
  std::vector<std::string> overrides;
  bool accepted = false;
};

Json document_of(const Sample& sample) {
  const Source source{"case.yaml", kAbevi, sample.overrides};
  ErrorList errors(source);
  return to_json(read_document(source, errors));
}

bool reader_accepts(const Sample& sample) {
  try {
    read_case_text(kAbevi, "case.yaml", sample.overrides, Command::check);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// Verdict of an independent implementation of JSON Schema for each sample.
std::vector<bool> schema_accepts(const std::vector<Sample>& samples) {
  const test::TemporaryDirectory folder;
  const auto question = folder.path() / "question.json", answer = folder.path() / "answer";
  Json documents = Json::array();
  for (const Sample& s : samples) documents.push_back(document_of(s));
  std::ofstream(question) << Json{{"schema", schema()}, {"documents", documents}};

  const std::string script = PRS_SOURCE_DIR "/tests/prs/input/check_by_schema.py";
  const std::string command = "python3 '" + script + "' '" + question.string() + "' > '" + answer.string() + "'";
  std::vector<bool> verdicts;
  if (std::system(command.c_str()) == 0) {
    std::ifstream in(answer);
    for (std::string word; in >> word;) verdicts.push_back(word == "valid");
  }
  return verdicts;
}

bool validator_is_installed() {
  return std::system("python3 -c 'from jsonschema import Draft202012Validator' 2> /dev/null") == 0;
}

void expect_agreement(const std::vector<Sample>& samples) {
  if (!validator_is_installed()) GTEST_SKIP() << "python3-jsonschema is not installed";
  const std::vector<bool> verdicts = schema_accepts(samples);
  ASSERT_EQ(verdicts.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::string what = document_of(samples[i]).dump();
    EXPECT_EQ(reader_accepts(samples[i]), samples[i].accepted) << what;
    EXPECT_EQ(verdicts[i], samples[i].accepted) << what;
  }
}

/// Adds values that are, or are not, allowed at paths.
void add(std::vector<Sample>& samples, bool accepted,
         const std::vector<std::pair<std::string, std::vector<std::string>>>& values_at) {
  for (const auto& [path, values] : values_at)
    for (const std::string& value : values) samples.push_back({{path + "=" + value}, accepted});
}

/// A lubricant with the given keys besides those that are always there.
std::string lubricant(const std::string& keys) {
  return "lubricant={pressure_viscosity: 30 1/GPa, eyring_stress: 12 MPa, " + keys + "}";
}

TEST(Schema, TakesWhatTheReaderTakes) {
  SKIP_UNDER_SANITIZERS();
  std::vector<Sample> samples;
  add(samples, true,
      {{"mechanism.rollers", {"9"}},
       {"mechanism.type", {"standard", "\"standard\""}},
       {"mechanism.lead", {"-5 mm", "+5e-3 m", "5000µm", "\"5 mm\"", ".5 cm", "0.2 in", "-3/16 in", "+0003/16in"}},
       {"mechanism.starts", {"{screw: 3}"}},
       {"mechanism.profile_plane", {"axial"}},
       {"mechanism.pitch", {"{roller: 1.667 mm}"}},
       {"structure.nut.outer_diameter", {"1 7/8 in", "1-7/8in", "47.625 mm"}},
       {"mechanism.flank_angle", {"{screw: 45 deg, roller: 0.78 rad, nut: 45°}"}},
       {"mechanism.profile.nut", {"{concave: 60 mm}"}},
       {"mechanism.thread", {"{nut: {addendum: 0 mm, dedendum: 0.3 mm}}"}},
       {"structure.screw", {"{}"}},
       {"structure.roller.guidance", {"outer_node", "{ring: 2e4 N/mm}", "{ring: 1e5 lbf/in}"}},
       {"structure.nut.flanges", {"[]"}},
       {"materials.density", {"7810 kg/m^3"}},
       {"materials.poisson_ratio", {"0"}},
       {"materials",
        {"{screw: {youngs_modulus: 209 GPa, poisson_ratio: 0.3}, roller: {youngs_modulus: 209 GPa, "
         "poisson_ratio: 0.3}, nut: {youngs_modulus: 2.09e5 MPa, poisson_ratio: 0.3}}"}},
       {"contact", {"{}", "{hertz_constant: {screw: 3.6e5 N/mm^1.5}, normal_angle: {nut: 45 deg}}"}},
       {"model", {"{bodies: bars, roller: rigid_bending, roller_shear: true, patch_points: 9}"}},
       {"load_cases", {"[{axial_force: -1 kN, share: equal}]"}},
       {"load_cases[0].speed", {"400 rpm"}},
       {"load_cases[0].axial_force", {"{from: 1 kN, to: 2 kN, steps: 2}"}},
       {"load_cases[0].name", {"\"1\""}},
       {"lubricant",
        {"{viscosity: 166.5 mPa s, pressure_viscosity: 30 1/GPa, eyring_stress: 12 MPa}",
         "{name: iso-vg-100, temperature: 140 degF}",
         "{name: mil-prf-23699, viscosity: 0.02 Pa s, eyring_stress: 1 ksi}"}},
       {"friction", {"{model: jacod}", "{coulomb: 0.11}", "{model: {coulomb: 0}}"}},
       {"roughness", {"0.2 um", "{screw: 0.2 um, roller: 0.1 um, nut: 0.3 µm}"}},
       {"operation", {"{speed: -400 1/min}", "{speed: 0 rpm, slip_ratio: 1}"}},
       {"carrier", {"{bearing: {length: 4 mm, diameter: 5 mm, radial_clearance: 15 um}}", "{nut_torque: 3 N mm}"}},
       {"carrier.gear_pressure_angle", {"25 deg"}}});
  for (const char* keys : {"temperature: -10 degC, density: 870 kg/m^3, walther: {intercept: 9.5, slope: 3.7}",
                           "temperature: 60 °C, density: 870 kg/m^3, viscosity_at: [{temperature: 40 degC, "
                           "kinematic_viscosity: 46 cSt}, {temperature: 373.15 K, viscosity: 6 mPa s}]"})
    samples.push_back({{lubricant(keys)}, true});
  expect_agreement(samples);
}

TEST(Schema, RefusesWhatTheReaderRefuses) {
  SKIP_UNDER_SANITIZERS();
  std::vector<Sample> samples;
  add(samples, false,
      {{"mechanism", {"", "3", "{}"}},
       {"colour", {"red"}},
       {"mechanism.colour", {"red"}},
       {"mechanism.rollers", {"0", "1001", "2.5", "\"9\"", "nine", "true", "[9]"}},
       {"mechanism.type", {"invertd", "1", "{}"}},
       {"mechanism.lead",
        {"5", "0 mm", "0.0e5 mm", "5 kN", "5 mm mm", "five mm", ".nan mm", "1,5 mm", "", "[5 mm]", "1 1/4 mm", "1/0 in",
         "{screw: 5 mm}"}},
       {"mechanism.starts", {"3", "{}", "{screw: 3, nut: 3}"}},
       {"mechanism.pitch_diameter.screw", {"-21 mm"}},
       {"mechanism.flank_angle", {"{screw: 45 deg}", "45"}},
       {"mechanism.profile", {"{screw: straight}"}},
       {"mechanism.profile.nut",
        {"convex", "{convex: 0 mm}", "{convex: 3}", "{bulgy: 3 mm}", "{convex: 3 mm, concave: 3 mm}",
         "{straight: 3 mm}"}},
       {"mechanism.thread", {"{nut: {addendum: 1 mm}}", "{nut: {addendum: -1 mm, dedendum: 1 mm}}"}},
       {"structure", {"{}"}},
       {"structure.roller", {"{}"}},
       {"structure.nut.flanges", {"{}", "[3 mm]"}},
       {"structure.nut.flanges[0].outer_diameter", {"0 mm"}},
       {"structure.nut.thrust", {"10 mm"}},
       {"structure.roller.guidance", {"{ring: 2e4 N}", "ring"}},
       {"materials.poisson_ratio", {"0.5", "-0.1", "\"0.3\""}},
       {"materials.youngs_modulus", {"0 GPa"}},
       {"materials", {"{screw: {youngs_modulus: 209 GPa, poisson_ratio: 0.3}}"}},
       {"contact", {"3", "{hertz_constant: 3.6e5 N/mm^1.5}", "{hertz_constant: {roller: 1 N/m^1.5}}"}},
       {"model.bodies", {"beams"}},
       {"model.roller_shear", {"1", "\"true\""}},
       {"model.patch_points", {"0", "8"}},
       {"load_cases", {"[]", "{}", "[1]"}},
       {"load_cases[0].axial_force",
        {"45", "{from: 1 kN, to: 2 kN}", "{from: 1 kN, to: 2 kN, steps: 0}",
         "{from: 1 kN, to: 2 kN, steps: 2, by: 1}"}},
       {"load_cases[0].name", {"1", "\"\"", "\"a\\nb\""}},
       {"load_cases[0].share", {"half"}},
       {"lubricant", {"{viscosity: 166.5}", "{name: iso-vg-99, temperature: 60 degC}"}},
       {"roughness", {"0 um", "0.2", "{screw: 0.2 um}"}},
       {"friction", {"jacod", "{}", "{model: glue}", "{coulomb: -0.1}", "{jacod: 1}", "{model: jacod, coulomb: 0.1}"}},
       {"operation", {"{}", "{speed: 400}", "{speed: 400 rpm, slip_ratio: 1.1}", "{slip_ratio: 0.5}"}},
       {"carrier", {"{bearing: {length: 4 mm, diameter: 0 mm, radial_clearance: 9 um}}", "{nut_torque: -3 N mm}"}}});
  for (const char* keys : {"temperature: 60, density: 870 kg/m^3, walther: {intercept: 9.5, slope: 3.7}",
                           "temperature: 60 degC, density: 870 kg/m^3, walther: {intercept: 9.5, slope: 0}",
                           "temperature: 60 degC, density: 870 kg/m^3, walther: {slope: 3.7}",
                           "temperature: 60 degC, viscosity_at: [{temperature: 40 degC, viscosity: 46 mPa s}]",
                           "temperature: 60 degC, viscosity_at: [{temperature: 40 degC, viscosity: 46 mPa s}, "
                           "{viscosity: 6 mPa s}]",
                           "temperature: 60 degC, viscosity_at: [{temperature: 40 degC, viscosity: 46 mPa s}, "
                           "{temperature: 60 degC, viscosity: 26 mPa s}, {temperature: 90 degC, viscosity: 6 mPa s}]"})
    samples.push_back({{lubricant(keys)}, false});
  expect_agreement(samples);
}

const std::vector<std::string> kValues{
    "",         "0",      "7",       "0.2",     "true",   "\"7\"",          "7 mm",          "0 mm",          "-7 mm",
    "40 deg",   "20 deg", "40 degC", "-7 degC", "0 degC", "7 cSt",          "7 mPa s",       "20 kN",         "3 N m",
    "straight", "equal",  "tension", "{}",      "[]",     "{convex: 5 mm}", "{ring: 1 N/m}", "{coulomb: 0.2}"};

/// Every value of the case replaced by each of many texts: all that pass the reader must pass the schema, which is the
/// more lenient of the two.
TEST(Schema, NeverRefusesWhatTheReaderTakes) {
  SKIP_UNDER_SANITIZERS();
  if (!validator_is_installed()) GTEST_SKIP() << "python3-jsonschema is not installed";
  const std::string oil = lubricant(
      "temperature: 60 degC, density: 870 kg/m^3, viscosity_at: [{temperature: 30 degC, "
      "kinematic_viscosity: 46 cSt}, {temperature: 100 degC, viscosity: 6 mPa s}]");
  const CaseInput input =
      read_case_input({"case.yaml",
                       kAbevi,
                       {oil, "friction={coulomb: 0.1}", "operation.speed=4 rpm", "roughness=0.2 um",
                        "carrier={bearing: {length: 4 mm, diameter: 5 mm, radial_clearance: 15 um}}"}},
                      Command::check);
  std::vector<Sample> samples;
  for (const EchoEntry& entry : input.fields)
    for (const std::string& value : kValues) samples.push_back({{oil, entry.path + "=" + value}});
  std::erase_if(samples, [](const Sample& s) { return !reader_accepts(s); });
  EXPECT_GT(samples.size(), 50u);
  const std::vector<bool> verdicts = schema_accepts(samples);
  ASSERT_EQ(verdicts.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_TRUE(verdicts[i]) << samples[i].overrides.back();
}

TEST(Schema, StatesDefaultsUnitsAndMeaning) {
  const Json s = schema();
  const Json& mechanism = s["properties"]["mechanism"]["properties"];
  EXPECT_EQ(mechanism["geometry"]["default"], "simulation");
  EXPECT_EQ(mechanism["starts"]["properties"]["roller"]["default"], 1);
  EXPECT_FALSE(mechanism["type"].contains("default"));
  EXPECT_FALSE(mechanism["lead"].contains("default"));
  EXPECT_EQ(mechanism["lead"]["description"],
            "Lead of screw and nut; > 0 right-handed. In mm, m, cm, um, nm, in, ft, uin; other than 0");
  const Json& screw = s["properties"]["structure"]["properties"]["screw"]["properties"];
  EXPECT_EQ(screw["bore"]["default"], "0 mm");
  const Json& carrier = s["properties"]["carrier"]["properties"];
  EXPECT_EQ(carrier["gear_pressure_angle"]["default"], "20 deg");
  // Either one number or one per interface.
  for (const Json& law : s["properties"]["friction"]["oneOf"]) {
    if (!law["properties"].contains("mixed")) continue;
    EXPECT_EQ(law["properties"]["mixed"]["properties"]["exponent"]["default"], 2.0);
  }
  EXPECT_EQ(s["properties"]["lubricant"]["properties"]["temperature"]["description"],
            "In operation. In degC, K, degF; > -273.15 degC");
}

}  // namespace
}  // namespace prs::input
