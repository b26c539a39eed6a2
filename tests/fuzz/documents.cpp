#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>
#include <vector>

#include "modules/module.h"
#include "prs/engine/engine.h"
#include "prs/export/fmu.h"
#include "prs/input/echo.h"
#include "prs/input/optimize_reader.h"
#include "prs/optimize/optimize_pictures.h"
#include "prs/run/analyses.h"
#include "prs/run/study.h"
#include "prs/study/designs.h"
#include "prs/study/response.h"
#include "prs/study/study_json.h"
#include "prs/study/study_pictures.h"
#include "prs/study/study_table.h"
#include "tests/fuzz/bounds.h"
#include "tests/fuzz/documents.h"
#include "tests/fuzz/targets.h"

namespace prs::fuzz {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostStudied = 24;  ///< Designs of a study or an optimization.

bool agree(double a, double b, double tolerance) {
  return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

// Invariants of a document

/// Sum of all numbers of an array, whose arrays are rollers; none may be negative.
double sum_of_loads(const Json& loads, const std::string& what) {
  double sum = 0.0;
  for (const Json& load : loads) {
    if (load.is_number()) expect(load.get<double>() >= 0.0, what + ": a load is negative");
    sum += load.is_array() ? sum_of_loads(load, what) : load.get<double>();
  }
  return sum;
}

/// Checks that the loads of all threads of an interface sum to the axial force; for one sector, to that of one roller.
void expect_balance(const Json& load_case) {
  // Under preload the other flank carries too, with friction that the document does not list.
  if (load_case.contains("flanks")) return;
  const double force = std::abs(load_case.at("axial_force_N").get<double>());
  double sums[2] = {};
  for (const int side : {0, 1}) {
    const char* interface = side == 0 ? "screw" : "nut";
    if (!load_case.contains(interface)) return;
    const Json& threads = load_case.at(interface);
    if (!threads.contains("axial_load_N")) return;
    sums[side] = sum_of_loads(threads["axial_load_N"], interface);
    if (threads.contains("normal_load_N")) sum_of_loads(threads["normal_load_N"], interface);
  }
  // Rollers beside each other share the force evenly: their number is what is left.
  const double rollers = sums[0] > 0.0 ? force / sums[0] : 1.0;
  expect(agree(sums[0], sums[1], 1e-6), fmt::format("screw carries {} N, nut {} N", sums[0], sums[1]));
  expect(std::abs(rollers - std::round(rollers)) < 1e-5 * rollers,
         fmt::format("threads carry {} N of {} N", sums[0], force));
}

void expect_power_balance(const Json& slip) {
  if (slip.value("status", "") == "imposed") return;  // The constraint that imposes the slip ratio adds power.
  if (!slip.value("converged", false) || !slip.contains("power_loss_input_output_W")) return;
  const double lost = slip.at("power_loss_W").get<double>();
  const double less = slip.at("power_loss_input_output_W").get<double>();
  const double speed = std::abs(slip.value("speed_rpm", 0.0)) * 0.10472;
  const double turned = std::abs(slip.value("torque_screw_Nm", 0.0)) * speed;
  expect(lost >= 0.0, fmt::format("{} W are lost", lost));
  expect(std::abs(lost - less) <= 1e-5 * (std::abs(lost) + turned) + 1e-12,
         fmt::format("{} W are lost, {} W go in and do not come out", lost, less));
}

void expect_consistent(const Json& load_case, bool& converged) {
  if (load_case.contains("status")) {
    const bool good = load_case.at("converged").get<bool>();
    expect(good == (load_case.at("status") == "converged"), "`converged` is not `status`");
    converged = converged && good;
    if (good) expect_balance(load_case);
    if (!good) expect(!load_case.contains("axial_stiffness_N_per_um"), "a stiffness of what did not converge");
  }
  if (load_case.contains("slip")) {
    const Json& slip = load_case.at("slip");
    if (slip.contains("status"))
      expect(slip.at("converged").get<bool>() == (slip.at("status") == "converged" || slip.at("status") == "imposed"),
             "slip: `converged` is not `status`");
    expect_power_balance(slip);
  }
}

/// Checks that the energy input of a drive equals its stored and lost energy.
void expect_energies(const Json& response) {
  expect(response.at("converged").get<bool>() == (response.at("status") == "converged"), "`converged` is not `status`");
  if (!response.at("converged").get<bool>()) return;
  const Json& energy = response.at("energy_J");
  expect(energy.at("residual_relative").get<double>() < 1e-2, "energies do not close: " + energy.dump());
  for (const auto& [name, lost] : energy.at("lost").items())
    expect(lost.get<double>() >= -1e-6 * energy.at("turnover").get<double>(), name + " is won");
  const std::size_t samples = response.at("time_s").size();
  for (const auto& [name, series] : response.items())
    if (series.is_array() && name != "impacts") expect(series.size() == samples, name + " is of another length");
}

// A run, in all its forms

void expect_told(const input::InputError& error) {
  const std::string_view what = error.what();
  expect(what.find(": error: ") != std::string_view::npos, fmt::format("message: {}", what));
  expect(what.starts_with("case.yaml:") || what.find(".csv") != std::string_view::npos ||
             what.find("--set") != std::string_view::npos,
         fmt::format("message without a place: {}", what));
  expect(what.size() < 40'000, "a very long message");
}

void expect_forms(const Delivery& delivery, bool drawn) {
  expect(!delivery.table().empty(), "an empty table");
  if (delivery.full_table) delivery.full_table();
  if (delivery.files)
    for (const OutputFile& file : delivery.files({})) expect(!file.content.empty(), file.name + " is empty");
  if (drawn && delivery.pictures) expect_drawable(delivery.pictures());
}

/// Checks that the base case of a study is the case: every number of its document that a response can name.
void expect_study_agrees(const input::Source& source, const Json& document, Command command) {
  std::vector<std::string> paths = response_paths(document);
  std::erase_if(paths, [](const std::string& path) {
    return path.starts_with("resolved_input") || path.find("resid") != std::string::npos ||
           path.find("iterations") != std::string::npos || path.find("evaluations") != std::string::npos ||
           path.find_first_of("\",'") != std::string::npos;
  });
  if (paths.empty()) return;
  input::Source asked = source;
  asked.overrides.push_back(
      fmt::format("study={{command: {}, factors: [{{path: mechanism.rollers, values: [7]}}], responses: {}}}",
                  name(command), Json(paths).dump(-1, ' ', false, Json::error_handler_t::replace)));
  const input::StudyInput in = [&] {
    try {
      return input::read_study_input(asked);
    } catch (const input::InputError& error) {
      throw Finding(fmt::format("a study refuses what {} takes: {}", name(command), error.what()));
    }
  }();
  const DesignEngine engine = study_engine(in);
  const RowBlock base = engine.evaluate(0, 1);
  const bool fails = !base.failures.empty();
  // Without load, forces, moments and powers of friction are rounding.
  double rounding = 0.0;
  if (const auto cases = document.find("load_cases"); cases != document.end() && !cases->empty())
    rounding = 1e-12 * std::abs(cases->front().value("axial_force_N", 0.0));
  for (std::size_t k = 0; k < paths.size(); ++k) {
    const std::optional<double> said = response(document, paths[k]);
    const double studied = base.responses[k];
    if (fails && !std::isfinite(studied)) continue;
    const bool of_forces = paths[k].find("_N") != std::string::npos || paths[k].find("_W") != std::string::npos;
    expect(said.has_value() == std::isfinite(studied) &&
               (!said || agree(*said, studied, 1e-6) || (of_forces && std::abs(*said - studied) < rounding)),
           fmt::format("{} is {} in a study", paths[k], studied));
  }
}

/// Checks that the input stated in a document reads as that input again.
void expect_stable_echo(const Json& resolved) {
  const input::Source again = input::source_of_text("case.yaml", resolved.dump(), {});
  Json second;
  try {
    second = input::resolved_input(again);
  } catch (const input::InputError& error) {
    throw Finding(fmt::format("the echo is refused: {}", error.what()));
  }
  expect(second == resolved, "the echo of the echo is another one");
}

void run_command(const AnyAnalysis& row, const input::Source& source) {
  const input::CaseInput in = input::read_case_input(source, row.command);
  const Delivery delivery = row.run(source, in);
  const Json document = delivery.document(document_info(source, row.command));
  expect_finite(document, "");
  expect_stable_echo(document.at("resolved_input"));
  bool converged = true;
  if (document.contains("load_cases") && row.command != Command::compare)
    for (const Json& load_case : document.at("load_cases")) expect_consistent(load_case, converged);
  expect(converged || !delivery.converged, "status 0, and a load case did not converge");
  if (row.command == Command::response) expect_energies(document.at("response"));
  if (row.command == Command::fit) expect_fitted(document.at("fit"));
  expect_forms(delivery, source.text.size() % 8 == 0);  // Pictures take longest.
  const bool studied = row.command == Command::solve || row.command == Command::slip ||
                       row.command == Command::measures || row.command == Command::contact;
  if (studied && delivery.converged && !in.study && !in.optimize && !in.values.heat)
    expect_study_agrees(source, document, row.command);
}

/// Runs a file other than a case.
void run_other(const OtherFile& file, const input::Source& source) {
  const Delivery delivery = file.run(source);
  expect_finite(delivery.document(document_info(source, file.command)), "");
  expect_forms(delivery, source.text.size() % 8 == 0);
  file.check(source);
  file.resolved_input(source);
}

// Many designs

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// Checks that a design has the same result alone as among others.
void expect_pure(const DesignEngine& engine, const RowBlock& all) {
  const std::size_t width = engine.study().responses.size();
  for (const std::size_t k : {std::size_t{0}, all.rows / 2, all.rows - 1}) {
    const RowBlock one = engine.evaluate(k, 1);
    const bool fails = std::ranges::any_of(all.failures, [&](const RowBlock::Failure& failure) {
      return failure.row == k && one.failures.size() == 1 && failure.status.name == one.failures[0].status.name;
    });
    const bool failed = std::ranges::any_of(all.failures, [&](const auto& failure) { return failure.row == k; });
    expect(failed == !one.failures.empty() && failed == fails, "a verdict by itself is another one");
    for (std::size_t r = 0; r < width; ++r)
      expect(same(one.responses[r], all.responses[k * width + r]),
             fmt::format("{} of design {} by itself is another one", engine.study().responses[r], k));
  }
}

void expect_known_status(const RowBlock& block) {
  for (const RowBlock::Failure& failure : block.failures)
    expect(failure.status.name != "failed", fmt::format("design {} failed: {}", failure.row, failure.status.reason));
}

/// Runs a study; returns whether it was small enough.
bool run_study_document(const input::Source& source) {
  const input::StudyInput in = input::read_study_input(source);
  if (in.study.plan == Plan::derivatives) {
    if (in.study.factors.size() > 6) return false;
    const CaseDerivatives result = run_derivatives(in);
    expect_finite(derivatives_json(result, document_info(source, Command::study)), "");
    derivatives_table(result);
    derivatives_csv(result, {});
    expect_drawable(derivatives_pictures(result));
    return true;
  }
  if (design_count(in.study) > kMostStudied) return false;
  const DesignEngine engine = study_engine(in);
  const Study& study = engine.study();
  const RowBlock rows = engine.evaluate(0, design_count(study));
  expect_known_status(rows);
  expect_pure(engine, rows);
  StudyResult result{study, {}, 0, 0, 0, {}};
  StudyAnalysis analysis(study);
  add(result, rows);
  analysis.add(rows);
  result.summary = analysis.summary();
  result.warnings = study_warnings(in, result, [&]() -> const DesignEngine& { return engine; });
  expect_stored_study(result, document_info(source, Command::study));
  return true;
}

bool run_optimize_document(const input::Source& source) {
  const input::OptimizeInput in = input::read_optimize_input(source);
  if (design_count(in.optimization) > kMostStudied) return false;
  const std::optional<OptimizationResult> result =
      run_optimization(in, 1, [](const JournalHeader& header) { return Journal::temporary(header); }, {});
  expect(result.has_value(), "an optimization was interrupted");
  const Json document = optimize_json(*result, document_info(source, Command::optimize));
  expect_finite(document, "");
  optimize_table(*result);
  front_csv(*result, {});
  history_csv(*result, {});
  expect_drawable(optimization_pictures(*result));
  if (const std::optional<std::string> best = chosen_case(*result, source))
    input::read_case_input(input::source_of_text("case.yaml", *best, {}), Command::check);
  return true;
}

bool run_on_engine(const char* command, const input::Source& source) {
  const Json question{{"command", command},
                      {"yaml", source.text},
                      {"file", "case.yaml"},
                      {"set", Json::array({Json::array({"model.patch_points", "9"})})},
                      {"histories", *source.files}};
  const std::string text = question.dump(-1, ' ', false, Json::error_handler_t::replace);
  const Json answer = Json::parse(prs::answer(text));
  const int status = answer.at("status").get<int>();
  expect(status == 0 || status == 2 || status == 3, fmt::format("status {}", answer.dump()));
  expect((status == 2) == answer.at("document").is_null(), "a document and an error");
  expect(status == 0 || !answer.at("messages").empty() || status == 3, "an error without a message");
  return status != 2;
}

// Curves for models of systems

/// Checks that forces rise with the deflection, and that written curves read back as the same.
bool run_export(input::Source source) {
  // With few points: the losses of all temperatures, forces and speeds are computed.
  source.overrides.emplace_back("model.patch_points=9");
  const SystemModel model = system_model(source, {});
  const SystemCurves& curves = model.curves;
  expect_finite(curves_json(curves), "");
  const std::vector<double> written = curves.data();
  PrsCurves here = curves.view(), read = {};
  expect(prs_read_curves(written.data(), written.size(), &read) != 0, "the curves are refused");
  PrsCurves half = {};
  expect(prs_read_curves(written.data(), written.size() / 2, &half) == 0, "half of them are taken");

  const auto reach = [](const BranchTable& sense) { return sense.deflection(sense.at.size() - 1); };
  const double from = -1.2 * reach(curves.senses.compression);
  const double to = 1.2 * reach(curves.senses.tension);
  constexpr int kPoints = 200;
  double stiffness = 0.0, same_stiffness = 0.0;
  int beyond = 0;
  double before = prs_force(&here, from, &stiffness, &beyond);
  for (int k = 0; k <= kPoints; ++k) {
    const double deflection = from + (to - from) * k / kPoints;
    const double force = prs_force(&here, deflection, &stiffness, &beyond);
    expect(std::isfinite(force) && force >= before - 1e-12 * std::abs(before),
           fmt::format("{} N after {} N", force, before));
    expect(std::isfinite(stiffness) && stiffness >= 0.0, fmt::format("{} N/m", stiffness));
    expect(prs_force(&read, deflection, &same_stiffness, &beyond) == force && same_stiffness == stiffness,
           "what was written has another force");
    for (const double speed : {-1e3, -1e-3, 0.0, 50.0})
      expect(std::isfinite(prs_torque(&here, force, speed, &beyond)), "a torque is not finite");
    before = force;
  }
  expect(functional_mockup_unit(model).starts_with("PK"), "no archive");
  expect(modelica_package(curves, model.text).ends_with("end " + model.text.name + ";\n"), "no whole package");
  expect(!curves_text(curves).empty(), "nothing is said of the curves");
  return true;
}

/// Checks that lives of threads are null exactly if their load is zero, else positive.
void expect_lives_of(const Json& lives, const Json& loads, const std::string& at) {
  expect(lives.size() == loads.size(), at + " is not of as many threads as the loads");
  for (std::size_t k = 0; k < lives.size(); ++k)
    if (lives[k].is_array())
      expect_lives_of(lives[k], loads[k], fmt::format("{}/{}", at, k));
    else
      expect(loads[k].get<double>() == 0.0 ? lives[k].is_null() : lives[k].get<double>() > 0.0,
             fmt::format("{}/{} is {} under {} N", at, k, lives[k].dump(), loads[k].dump()));
}

/// Checks the lives of a system, which are single numbers.
void expect_lives(const Json& lives, const Json& object, const std::string& at) {
  if (lives.is_array())
    expect_lives_of(lives, object.at("equivalent_load_N"), at);
  else
    expect_finite(lives, at);
}

}  // namespace

void expect_finite(const Json& value, const std::string& at) {
  expect(!value.is_null(), at + " is null");
  if (value.is_number_float())
    expect(std::isfinite(value.get<double>()), fmt::format("{} is {}", at, value.get<double>()));
  if (!value.is_structured()) return;
  for (const auto& [key, child] : value.items())
    if (key == "l10_revolutions" || key == "rated_revolutions")
      expect_lives(child, value, at + '/' + key);
    else if (key != "resolved_input")
      expect_finite(child, at + '/' + key);
}

void expect_fitted(const Json& fit) {
  expect(fit.at("converged").get<bool>() == (fit.at("status") == "converged"), "`converged` is not `status`");
  for (const Json& parameter : fit.at("parameters")) {
    if (!parameter.contains("value") || !parameter.contains("low")) continue;
    const double value = parameter.at("value").get<double>();
    expect(value >= parameter.at("low").get<double>() && value <= parameter.at("high").get<double>(),
           "a value outside of its interval: " + parameter.dump());
    if (parameter.at("name").get<std::string>().starts_with("offset of ")) continue;
    const double from = parameter.at("from").get<double>(), to = parameter.at("to").get<double>();
    const double slack = 1e-9 * (std::abs(from) + std::abs(to));
    expect(value >= from - slack && value <= to + slack, "a value beyond its bounds: " + parameter.dump());
  }
}

void expect_stored_study(const StudyResult& result, const DocumentInfo& info) {
  expect_finite(study_json(result, info), "");
  expect(!study_table(result).empty(), "an empty table");
  expect_drawable(study_pictures(result));
}

void expect_drawable(const Pictures& pictures) {
  const auto expect_bounded = [](const auto& self, const Json& value, const std::string& at) -> void {
    if (value.is_number_float()) expect(!std::isinf(value.get<double>()), "figures" + at + " is infinite");
    if (!value.is_structured()) return;
    for (const auto& [key, child] : value.items()) self(self, child, at + '/' + key);
  };
  expect_bounded(expect_bounded, to_json(figures(pictures)), "");
}

const char* const kBench =
    "n_rpm,M_Nm,F_kN,x_um\n100,4.1,-8,-21\n300,4.3,-4,-17\n500,4.2,-1,-12\n700,4.5,1,11.5\n900,4.4,4,16\n1100,4.6,8,"
    "22\n";
const char* const kMaker =
    "screw,screw_diameter_mm,lead_mm,starts,dynamic_capacity_kN,static_capacity_kN,efficiency,back_driving_efficiency\n"
    "24x12,24,12,6,77,132,0.77,0.77\n30x10,30,10,5,105,180,0.8,0.75\n";
const char* const kFlight = "time_s,force_kN,position_mm\n0,1,0\n1,12.5,3\n2,-7,5\n3,19.7,-2\n4,2,0\n";

bool documents(std::string_view input) {
  const std::size_t end = std::min(input.find('\n'), input.size());
  const std::string_view line = input.substr(0, end);
  input::Source source = input::source_of_text("case.yaml", std::string(input), {});
  source.files = {{"flight.csv", kFlight}, {"bench.csv", kBench}, {"maker.csv", kMaker}};
  if (input.size() > kLongest || asks_for_much(source)) return false;
  const std::string_view command = line.starts_with("# ") ? line.substr(2) : "solve";
  try {
    if (command == "study") return run_study_document(source);
    if (command == "optimize") return run_optimize_document(source);
    if (command == "export") return run_export(source);
    for (const char* page : {"report", "write"})
      if (command == page) return run_on_engine(page, source);
    for (const OtherFile& file : other_files())
      if (name(file.command) == command) {
        run_other(file, source);
        return true;
      }
    for (const AnyAnalysis& row : analyses())
      if (row.run && name(row.command) == command) {
        run_command(row, source);
        return true;
      }
  } catch (const input::InputError& error) {
    expect_told(error);
  } catch (const modules::Missing&) {  // The library of the algorithm is missing.
  }
  return false;
}

}  // namespace prs::fuzz
