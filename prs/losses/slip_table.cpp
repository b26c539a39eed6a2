#include "prs/losses/slip_table.h"

#include "prs/indices.h"
#include "prs/loads/case_table.h"
#include "prs/record/csv_rows.h"
#include "prs/record/table_layout.h"
#include "prs/slip/slip_warnings.h"
#include "prs/text.h"

namespace prs {
namespace {

constexpr std::size_t kMostBlocks = 4;
constexpr TableRows kRows{30, 16};

std::string failure(const LoadCaseResult& result) {
  if (has_slip(result)) return {};
  if (is_held(result))
    return fmt::format("at rest: held by {} to {}",
                       fixed_with_unit(result.slip->holding->with_load.holding_torque, "N m", 3),
                       fixed_with_unit(result.slip->holding->against_load.holding_torque, "N m", 3));
  std::string text = fmt::format("NOT CONVERGED ({})", slip_status_name(result));
  if (result.slip && result.slip->relative_residue)
    text += fmt::format(", residue {:.1e}", *result.slip->relative_residue);
  return text;
}

/// Number of decimals that shows about four digits.
int decimals_of(double largest) {
  if (!(largest > 0.0)) return 0;
  return std::clamp(3 - static_cast<int>(std::floor(std::log10(largest))), 0, 6);
}

std::string four_digits(double value) { return fixed(value, 1.0, decimals_of(std::abs(value))); }

// A case at length.

std::string block_line(std::string_view label, const std::string& value, const std::string& remark = {}) {
  return kRows("  " + with_table_unit(label), {value}, "   " + remark);
}

std::string number_line(std::string_view label, double si, std::string_view unit, const std::string& remark = {}) {
  return block_line(fmt::format("{}, {}", label, unit), four_digits(shown(si, unit)), remark);
}

/// Further values of a line.
std::string beside(const std::vector<std::string>& cells) {
  std::string text;
  for (const std::string& cell : cells) text += padded(cell, kRows.cell_width, false);
  return text;
}

std::string title_line(const LoadCaseResult& result) {
  std::string load = fixed_with_unit(result.load_case.axial_force, "kN", force_decimals(result.load_case.axial_force));
  if (result.load_case.direction) load += fmt::format(", {}", name(*result.load_case.direction));
  load += result.load_case.share == LoadCase::Share::equal ? ", equal thread loads"
                                                           : ", thread loads " + words_of_text(name(result.loads));
  if (has_slip(result)) load += fmt::format(", {:.6g} rpm", result.slip->speed * "rpm"_per_si);
  constexpr std::size_t kSeparator = 2;
  const std::size_t room = kTableWidth - kSeparator - width(load);
  return fmt::format("{}: {}\n", shortened(case_name_cell(result), room), load);
}

std::string slip_ratio_lines(const SlipResult& slip) {
  const std::string origin =
      slip.status == SlipStatus::imposed
          ? fmt::format("imposed; moment left on a roller {} {}", four_digits(shown(slip.moments.residue(), "N mm")),
                        table_unit("N mm").text)
          : fmt::format("optimality {:.4g} % (pure sliding 0, ideal 100)", slip.optimality * "%"_per_si);
  const std::string second =
      slip.second_nut ? block_line("  of the second nut", fixed(slip.second_nut->slip_ratio, 1.0, 6),
                                   fmt::format("optimality {:.4g} %", slip.second_nut->optimality * "%"_per_si))
                      : "";
  return block_line(slip.second_nut ? "slip ratio, first nut" : "slip ratio", fixed(slip.slip_ratio, 1.0, 6), origin) +
         second + block_line("  ideal", fixed(slip.ideal_slip_ratio, 1.0, 6)) +
         block_line("  at the pitch points", fixed(slip.estimates.simple, 1.0, 6));
}

std::string efficiency_lines(const SlipResult& slip, bool all) {
  const bool by_screw = slip.driven_by == DrivenBy::screw;
  std::string remark = slip.efficiency ? "the load drives" : "the load helps, self-locking";
  if (by_screw)
    remark = all && slip.efficiency_fit ? fmt::format("Sandu's fit {:.2f} %", *slip.efficiency_fit * "%"_per_si) : "";
  return block_line("efficiency, %", fixed(slip.efficiency, "%"_per_si, 2), remark) +
         (by_screw ? ""
                   : number_line("holding torque", *slip.holding_torque, "N m",
                                 slip.efficiency ? "holds back the load" : "releases the screw")) +
         number_line("torque on the screw", slip.torque_screw, "N m") +
         number_line("torque on the nut", slip.torque_nut, "N m");
}

std::string power_lines(const SlipResult& slip) {
  const double total = slip.power.total();
  const int decimals = decimals_of(total);
  std::string lines = block_line("power lost, W", fixed(total, 1.0, decimals),
                                 fmt::format("input less output {:.{}f} W", slip.power_loss_input_output, decimals));
  for (const PowerSource& source : kPowerSources) {
    const double power = slip.power.*source.value;
    if (power == 0.0) continue;
    lines += block_line(fmt::format("  {}", source.title), fixed(power, 1.0, decimals),
                        fmt::format("{:6.2f} %", power / total * "%"_per_si));
  }
  return lines;
}

/// A quantity of the threads shown as a range.
struct RangeLine {
  std::string_view label;
  std::string_view key;
  int decimals;
};

constexpr RangeLine kRangeLines[] = {
    {"friction coefficient", "friction_coefficient", 4},
    {"sliding, largest, mm/s", "max_sliding_speed_mm_per_s", 2},
    {"film by Sandu, nm", "film_thickness_nm", 0},
    {"central film, nm", "central_film_nm", 0},
    {"film ratio", "film_ratio", 2},
    {"share on touching flanks", "boundary_share", 3},
    {"wear, mm³/km", "wear_mm3_per_km", 6},
};

/// The ends of a range, `0.0812–0.0934`, or one where they are alike.
std::string range(std::string_view from, std::string_view to) {
  return from == to ? std::string(to) : fmt::format("{}–{}", from, to);
}

/// The lubrication from the thinnest film to the thickest, `boundary–mixed`.
std::string regimes(const InterfaceSlip& slip) {
  double least = HUGE_VAL, largest = 0.0;
  for (const double ratio : slip.film_ratio)
    if (ratio > 0.0) least = std::min(least, ratio), largest = std::max(largest, ratio);
  if (least > largest) return std::string(kAbsent);
  return range(lubrication(least), lubrication(largest));
}

/// The values of the threads that carry load.
std::string range(const InterfaceSlip& slip, const RangeLine& line) {
  double least = HUGE_VAL, largest = -HUGE_VAL;
  const Quantity<InterfaceSlip>& q = quantity<InterfaceSlip>(line.key);
  const std::span<const double> values = q.value.series(slip);
  for (const auto k : indices(values))
    if (entry_if_any(slip.dynamic_normal_load, k).value_or(0.0) > 0.0)
      least = std::min(least, values[k]), largest = std::max(largest, values[k]);
  if (least > largest) return std::string(kAbsent);
  return range(fixed(least, q.unit.text, line.decimals), fixed(largest, q.unit.text, line.decimals));
}

std::string range_lines(const SlipResult& slip, std::string_view title) {
  const InterfaceSlip &screw = slip.threads.screw, &nut = slip.threads.nut;
  std::string lines = block_line(title, "screw", beside({"nut"}));
  for (const RangeLine& line : kRangeLines)
    if (!quantity<InterfaceSlip>(line.key).value.series(screw).empty())
      lines += block_line(fmt::format("  {}", line.label), range(screw, line), beside({range(nut, line)}));
  if (!screw.film_ratio.empty()) lines += block_line("  lubrication", regimes(screw), beside({regimes(nut)}));
  return lines;
}

/// Ranges of the threads, of a double nut each nut for itself.
std::string thread_lines(const SlipResult& slip) {
  std::string lines;
  if (slip.viscosity) lines += number_line("viscosity in operation", *slip.viscosity, "mPa s");
  if (!slip.second_nut) return lines + range_lines(slip, "over the threads");
  return lines + range_lines(slip, "threads of the first nut") +
         range_lines(*slip.second_nut, "threads of the second nut");
}

/// A line with a number for screw, rollers and nut; rollers may have none.
std::string parts_line(std::string_view label, double screw, std::optional<double> rollers, double nut, int decimals) {
  return block_line(label, fixed(screw, 1.0, decimals),
                    beside({rollers ? fixed(rollers, 1.0, decimals) : "", fixed(nut, 1.0, decimals)}));
}

std::string parts_line(std::string_view label, const PerPart<double>& kelvin) {
  const PartNumbers t = celsius_of(kelvin);
  return parts_line(fmt::format("  {}, °C", label), t.screw, t.rollers, t.nut, 2);
}

std::string heat_lines(const std::optional<HeatResult>& heat) {
  if (!heat) return {};
  std::string lines =
      block_line("heat balance", "screw", beside({"rollers", "nut"})) + parts_line("temperature", heat->temperature);
  if (heat->oil) {
    const InterfaceNumbers oil = celsius_of(*heat->oil);
    lines += parts_line("  oil at the contacts, °C", oil.screw, std::nullopt, oil.nut, 2);
  }
  const auto& [screw, roller, nut] = heat->heat;
  return lines + parts_line("  heat from friction, W", screw, roller, nut, decimals_of(screw + roller + nut));
}

std::string cycle_block(const HeatCycle& cycle) {
  const bool is_mission = cycle.is_mission();
  const std::string title = is_mission ? fmt::format("mission: {} x {:.7g} s\n", cycle.cycles, cycle.period)
                                       : fmt::format("duty cycle: {:.7g} s\n", cycle.period);
  if (!cycle.converged()) return title + fmt::format("  NOT CONVERGED ({})\n", name(cycle.status));
  const auto& until = cycle.time_to_limit;
  const auto seconds = [](std::optional<double> t) { return t ? fmt::format("{:.1f}", *t) : std::string(kAbsent); };
  return title + block_line("temperature", "screw", beside({"rollers", "nut"})) +
         (is_mission ? parts_line("start", *cycle.start) + parts_line("end", *cycle.end) : "") +
         parts_line("peak", cycle.peak) + parts_line("mean", cycle.mean) +
         (until.screw || until.roller || until.nut ? block_line("time to the limit, s", seconds(until.screw),
                                                                beside({seconds(until.roller), seconds(until.nut)}))
                                                   : "") +
         number_line("energy in", cycle.energy_in, "J") + number_line("energy lost", cycle.energy_lost, "J") +
         block_line("efficiency, %", fixed(cycle.efficiency, "%"_per_si, 2));
}

std::string hottest_line(const SlipResult& slip) {
  const std::optional<HottestThread> hottest = hottest_thread(slip);
  if (!hottest || !hottest->power || *hottest->power == 0.0) return {};
  return block_line("hottest thread",
                    fmt::format("{} {}{}{}", name(hottest->interface), hottest->thread,
                                hottest->roller ? fmt::format(", roller {}", *hottest->roller) : "",
                                hottest->of_nut ? (*hottest->of_nut == 1 ? ", first nut" : ", second nut") : ""),
                    fmt::format("{} W, {} {}", four_digits(*hottest->power),
                                four_digits(shown(hottest->power_density, "W/mm²")), table_unit("W/mm²").text));
}

double largest(const SlipResult& slip, std::vector<double> InterfaceSlip::*values) {
  double most = 0.0;
  for (const Interface i : kInterfaces)
    for (const double value : slip.threads[i].*values) most = std::max(most, value);
  return most;
}

/// A number with equal shares, with the loads of the case, and the change.
std::string change_line(std::string_view label, const std::string& equal, const std::string& solved,
                        const std::string& change) {
  return block_line(label, equal, beside({solved}) + fmt::format(" {:>10}", change));
}

/// Change of a value by the solved loads, in percent.
std::string ratio_line(std::string_view label, double equal, double solved, std::string_view unit) {
  return change_line(fmt::format("{}, {}", label, unit), four_digits(shown(equal, unit)),
                     four_digits(shown(solved, unit)),
                     equal > 0.0 ? fixed_change((solved / equal - 1.0) * "%"_per_si, 2) + " %" : "");
}

std::string difference_line(std::string_view label, double equal, double solved, int decimals) {
  return change_line(label, fixed(equal, 1.0, decimals), fixed(solved, 1.0, decimals),
                     fixed_change(solved - equal, decimals));
}

std::string equal_share_lines(const SlipResult& slip) {
  if (!slip.equal_shares) return {};
  const EqualShareSlip& equal = *slip.equal_shares;
  std::string lines = block_line("thread loads", "equal", beside({"of the case"})) +
                      difference_line("  slip ratio", equal.slip_ratio, slip.slip_ratio, 6) +
                      ratio_line("  power lost", equal.power_loss, slip.power.total(), "W");
  if (equal.efficiency && slip.efficiency)
    lines += difference_line("  efficiency, %", *equal.efficiency * "%"_per_si, *slip.efficiency * "%"_per_si, 2);
  return lines +
         ratio_line("  most at a thread", std::max(equal.thread_power.screw, equal.thread_power.nut),
                    largest(slip, &InterfaceSlip::power), "W") +
         ratio_line("  most at a thread", equal.max_power_density, largest(slip, &InterfaceSlip::power_density),
                    "W/mm²");
}

std::string held_block(const LoadCaseResult& result) {
  const auto line = [](std::string_view label, const Holding::Bound& bound, const std::string& remark) {
    return number_line(label, bound.holding_torque, "N m", remark) +
           number_line("  force on the carrier", std::hypot(bound.forces.carrier_x, bound.forces.carrier_y), "N",
                       "by each roller");
  };
  const Holding& h = *result.slip->holding;
  return title_line(result) + line("largest holding torque", h.against_load, "more moves the load") +
         line("least holding torque", h.with_load,
              h.with_load.holding_torque > 0.0 ? "less lets the load move the screw" : "self-locking");
}

std::string block(const LoadCaseResult& result, bool all) {
  if (is_held(result)) return held_block(result);
  if (!has_slip(result)) return title_line(result) + fmt::format("  {}\n", failure(result));
  const SlipResult& slip = *result.slip;
  return title_line(result) + slip_ratio_lines(slip) + efficiency_lines(slip, all) + power_lines(slip) +
         heat_lines(result.heat) + thread_lines(slip) + hottest_line(slip) + (all ? equal_share_lines(slip) : "");
}

// A case in a row.

template <double PowerBySource::*source>
std::string share(const LoadCaseResult& result) {
  const PowerBySource& power = result.slip->power;
  if (!(power.total() > 0.0)) return std::string(kAbsent);
  return fixed(power.*source / power.total(), "%", 2);
}

std::string hottest_cell(const LoadCaseResult& result) {
  const std::optional<HottestThread> hottest = hottest_thread(*result.slip);
  if (!hottest) return std::string(kAbsent);
  return fmt::format("{} {}: {}", name(hottest->interface), hottest->thread,
                     four_digits(shown(hottest->power_density, "W/mm²")));
}

constexpr CaseColumn kColumns[] = {
    {"", "load case", true, case_name_cell},
    {"force", "kN", false, force_cell},
    {"", "direction", true, direction_cell},
    {"speed", "rpm", false,
     [](const LoadCaseResult& r) { return fmt::format("{:.5g}", r.slip->speed * "rpm"_per_si); }},
    {"slip", "ratio", false, [](const LoadCaseResult& r) { return fixed(r.slip->slip_ratio, 1.0, 6); }},
    {"effic.", "%", false, [](const LoadCaseResult& r) { return fixed(r.slip->efficiency, "%"_per_si, 2); }},
    {"torque", "N m", false, [](const LoadCaseResult& r) { return fixed(r.slip->torque_screw, "N m", 3); }},
    {"lost", "W", false, [](const LoadCaseResult& r) { return fixed(r.slip->power.total(), 1.0, 2); }},
    {"screw", "%", false, share<&PowerBySource::screw>},
    {"nut", "%", false, share<&PowerBySource::nut>},
    {"hottest", "thread: W/mm²", true, hottest_cell},
};

std::vector<double> power_of_rollers(const InterfaceSlip& slip) {
  const auto row = static_cast<std::size_t>(slip.threads_per_roller);
  std::vector<double> sums(slip.power.size() / row, 0.0);
  for (const auto k : indices(slip.power)) sums[k / row] += slip.power[k];
  return sums;
}

/// Whether a load case has slip of two nuts.
bool has_two_nuts(const Result& result) {
  return std::ranges::any_of(result.load_cases, [](const LoadCaseResult& r) { return r.slip && r.slip->second_nut; });
}

}  // namespace

std::string slip_table(const Result& result, bool all) {
  std::string table;
  if (result.load_cases.size() > kMostBlocks)
    table = case_table({kColumns, 3, failure, "slip.csv"}, result.load_cases);
  else
    for (const LoadCaseResult& load_case : result.load_cases)
      table += (table.empty() ? "" : "\n") + block(load_case, all);
  if (result.heat_cycle) table += '\n' + cycle_block(*result.heat_cycle);
  return table + warning_section(all_warnings(result));
}

std::string slip_chart(const LoadCaseResult& result) {
  const std::string title = case_name_cell(result);
  if (!has_slip(result)) return fmt::format("{}: no power at the threads ({})\n", title, slip_status_name(result));

  const PerInterface<InterfaceSlip>& threads = result.slip->of_nut_that_carries(result.load_case).threads;
  const bool rollers = threads.screw.threads_per_roller > 0;
  const auto power_of = [&](const InterfaceSlip& slip) { return rollers ? power_of_rollers(slip) : slip.power; };
  const PerInterface<std::vector<double>> power = {power_of(threads.screw), power_of(threads.nut)};
  const double most = std::max(std::ranges::max(power.screw), std::ranges::max(power.nut));
  return fmt::format("{}: power lost at each {}\n", title, rollers ? "roller" : "thread of a roller") +
         bar_chart(power, decimals_of(most), "W");
}

std::string slip_csv(const Result& result, const CsvStyle& style) {
  CsvRows csv(style);
  const bool two_nuts = has_two_nuts(result);
  for (const LoadCaseResult& r : result.load_cases) {
    csv.load_case(r.load_case);
    // A search for the slip ratio has fields even without a result.
    const SlipResult* slip = r.slip ? &*r.slip : nullptr;
    csv("converged", slip && slip->has_answer());
    csv("status", slip ? name(slip->status) : slip_status_name(r));
    csv.record("", slip, "evaluations");
    if (slip && !slip->converged()) slip = nullptr;
    csv.record("slip_ratio_", slip ? &slip->estimates : nullptr);
    if (two_nuts)
      csv("second_nut_slip_ratio",
          slip && slip->second_nut ? std::optional(slip->second_nut->slip_ratio) : std::nullopt);
    for (const PowerSource& source : kPowerSources)
      csv(fmt::format("{}_power_W", source.key), slip ? std::optional(slip->power.*source.value) : std::nullopt);
    const std::optional<HottestThread> hottest = slip ? hottest_thread(*slip) : std::nullopt;
    csv.record("hottest_", hottest, "", "power_W");
    csv.record("hottest_thread_", hottest, "power_W", "roller");
    csv.record("hottest_", hottest, "roller");
    csv.record("equal_shares_", slip ? slip->equal_shares : std::nullopt);
    csv.end_row();
  }
  return csv.take();
}

std::string slip_threads_csv(const Result& result, const CsvStyle& style) {
  CsvRows csv(style);
  const bool all_rollers =
      std::ranges::any_of(result.load_cases, [](const LoadCaseResult& r) { return r.full != nullptr; });
  const bool two_nuts = has_two_nuts(result);
  const auto add_row = [&](const LoadCaseResult& r, const SlipResult& nut, Interface i, std::size_t k) {
    const InterfaceSlip& slip = nut.threads[i];
    const auto row = static_cast<std::size_t>(slip.threads_per_roller);
    csv.load_case(r.load_case);
    if (all_rollers) csv("roller", row ? std::optional(k / row + 1) : std::nullopt);
    const bool is_second = r.slip && &nut == r.slip->second_nut.get();
    if (two_nuts) csv("of_nut", r.slip && r.slip->second_nut ? std::optional(is_second ? 2 : 1) : std::nullopt);
    csv("interface", name(i));
    csv("thread", row ? k % row + 1 : k + 1);
    const bool is_other = r.slip && &nut != &r.slip->of_nut_that_carries(r.load_case);
    csv("axial_load_N",
        !r.threads ? std::nullopt
                   : entry_if_any(is_other ? r.other_flank->threads[i].axial_load : (*r.threads)[i].axial_load, k));
    csv.series("", slip, k);
    csv.end_row();
  };
  add_row({}, {}, Interface::screw, 0);
  csv.drop_rows();
  for (const LoadCaseResult& r : result.load_cases)
    if (has_slip(r) && r.threads)
      for (const SlipResult* nut : {&*r.slip, static_cast<const SlipResult*>(r.slip->second_nut.get())})
        for (const Interface i : kInterfaces)
          for (std::size_t k = 0; nut && k < nut->threads[i].power.size(); ++k) add_row(r, *nut, i, k);
  return csv.take();
}

std::string heat_csv(const Result& result, const CsvStyle& style) {
  CsvRows csv(style);
  for (const LoadCaseResult& r : result.load_cases) {
    if (!r.heat) continue;
    csv.load_case(r.load_case);
    csv.record("", r.heat);
    const std::optional<HeatResult> heat = r.heat->converged() ? r.heat : std::nullopt;
    csv.record("temperature_degC", heat ? std::optional(celsius_of(heat->temperature)) : std::nullopt);
    csv.record("oil_degC", heat && heat->oil ? std::optional(celsius_of(*heat->oil)) : std::nullopt);
    csv.record("heat_W",
               heat ? std::optional(PartNumbers{heat->heat.screw, heat->heat.roller, heat->heat.nut}) : std::nullopt);
    csv.end_row();
  }
  return csv.take();
}

std::string heat_cycle_csv(const HeatCycle& cycle, const CsvStyle& style) {
  CsvRows csv(style);
  const PartSeries temperature = celsius_of(cycle.temperature);
  for (const auto k : indices(cycle.time)) {
    csv("time_s", cycle.time[k]);
    csv.series("temperature_degC", temperature, k);
    csv.end_row();
  }
  return csv.take();
}

}  // namespace prs
