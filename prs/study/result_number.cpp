#include "prs/study/result_number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "prs/quantities/contact_quantities.h"
#include "prs/quantities/measure_quantities.h"
#include "prs/quantities/quantities.h"
#include "prs/quantities/slip_quantities.h"

namespace prs {
namespace {

using Value = std::function<std::optional<double>(const Answer&)>;

std::optional<double> shown(std::optional<double> si, double factor) {
  if (!si || !std::isfinite(*si)) return std::nullopt;
  return *si * factor;
}

/// Takes the key before the first dot from the head of a path.
std::string_view take_key(std::string_view& path) {
  const std::size_t end = std::min(path.find('.'), path.size());
  const std::string_view key = path.substr(0, end);
  path.remove_prefix(std::min(end + 1, path.size()));
  return key;
}

/// Takes `[k]` from the head of a path.
std::optional<std::size_t> take_index(std::string_view& path) {
  if (!path.starts_with('[')) return std::nullopt;
  std::size_t index = 0;
  const char* end = path.data() + path.size();
  const auto [stop, error] = std::from_chars(path.data() + 1, end, index);
  if (error != std::errc{} || stop == end || *stop != ']') return std::nullopt;
  path.remove_prefix(static_cast<std::size_t>(stop + 1 - path.data()));
  return index;
}

std::optional<Interface> interface_named(std::string_view key) {
  for (const Interface i : kInterfaces)
    if (key == name(i)) return i;
  return std::nullopt;
}

using Summary = std::function<double(const std::vector<double>&)>;

/// What `max`, `min`, `mean` or an index makes of shown values: as of an array of the document.
Summary summary_named(std::string_view word, double factor) {
  if (word == "max")
    return [factor](const std::vector<double>& v) { return std::ranges::max(v) * factor; };
  if (word == "min")
    return [factor](const std::vector<double>& v) { return std::ranges::min(v) * factor; };
  if (word == "mean")
    return [factor](const std::vector<double>& v) {
      return std::accumulate(v.begin(), v.end(), 0.0,
                             [factor](double sum, double x) { return sum + x * factor; }) /
             static_cast<double>(v.size());
    };
  return {};
}

/// A number of a list with one value a thread, which `list` finds or not.
template <class List>
Value thread_value(std::string_view rest, double factor, List list) {
  if (const std::optional<std::size_t> index = take_index(rest)) {
    if (!rest.empty()) return {};
    return [=](const Answer& a) -> std::optional<double> {
      const std::vector<double>* values = list(a);
      if (!values || *index >= values->size()) return std::nullopt;
      return (*values)[*index] * factor;
    };
  }
  if (rest.starts_with('.')) rest.remove_prefix(1);
  const Summary summary = summary_named(rest, factor);
  if (!summary) return {};
  return [=](const Answer& a) -> std::optional<double> {
    const std::vector<double>* values = list(a);
    if (!values || values->empty()) return std::nullopt;
    return summary(*values);
  };
}

/// Whether a path is a key followed by nothing, an index or a summary; `rest` is what follows.
bool is_list(std::string_view path, std::string_view key, std::string_view& rest) {
  if (!path.starts_with(key)) return false;
  rest = path.substr(key.size());
  return rest.starts_with('[') || rest.starts_with('.');
}

Value of_threads(Interface i, std::string_view path) {
  std::string_view rest;
  for (const ThreadQuantity& q : kThreadQuantities)
    if (is_list(path, q.key, rest))
      return thread_value(rest, q.factor, [i, q](const Answer& a) {
        const auto& threads = a.load_case->threads;
        return threads ? &((*threads)[i].*q.values) : nullptr;
      });
  if (path == "normal_angle_deg")
    return [i](const Answer& a) {
      const auto& threads = a.load_case->threads;
      return threads ? shown((*threads)[i].normal_angle, per_si::degree) : std::nullopt;
    };
  if (path == "hertz_constant_N_per_mm1_5")
    return [i](const Answer& a) {
      const auto& threads = a.load_case->threads;
      return threads ? shown((*threads)[i].hertz_constant, per_si::newton_per_millimetre1_5)
                     : std::nullopt;
    };
  return {};
}

/// A number of a converged slip result.
template <class Number>
Value of_converged_slip(Number number, double factor) {
  return [=](const Answer& a) {
    return has_slip(*a.load_case) ? shown(number(*a.load_case->slip), factor) : std::nullopt;
  };
}

Value of_slip(std::string_view path) {
  for (const SlipQuantity& q : kSlipQuantities)
    if (path == q.key) return of_converged_slip(q.value, q.factor);
  const std::string_view key = take_key(path);
  if (key == "slip_ratio_estimates")
    for (const SlipQuantity& q : kSlipEstimates)
      if (path == q.key) return of_converged_slip(q.value, q.factor);
  if (key == "equal_shares")
    for (const EqualShareQuantity& q : kEqualShareQuantities)
      if (path == q.key)
        return of_converged_slip(
            [q](const SlipResult& slip) {
              return slip.equal_shares ? q.value(*slip.equal_shares) : std::nullopt;
            },
            q.factor);
  if (key == "share_percent")
    for (const PowerSource& source : kPowerSources)
      if (path == source.key)
        return of_converged_slip(
            [source](const SlipResult& slip) -> std::optional<double> {
              const double total = slip.power.total();
              return total > 0.0 ? std::optional(slip.power.*source.value / total) : std::nullopt;
            },
            per_si::percent);
  const std::optional<Interface> i = interface_named(key);
  std::string_view rest;
  if (i)
    for (const SlipThreadQuantity& q : kSlipThreadQuantities)
      if (is_list(path, q.key, rest))
        return thread_value(rest, q.factor, [i, q](const Answer& a) {
          return has_slip(*a.load_case) ? &(a.load_case->slip->threads[*i].*q.values) : nullptr;
        });
  return {};
}

Value of_load_measures(std::string_view path) {
  for (const LoadMeasure& q : kLoadMeasures)
    if (path == q.key)
      return [q](const Answer& a) {
        return a.load_measures ? shown(q.value(*a.load_measures), q.factor) : std::nullopt;
      };
  std::string_view rest;
  for (const ThreadMeasure& q : kThreadMeasures)
    if (is_list(path, q.key, rest))
      return thread_value(rest, q.factor, [q](const Answer& a) {
        return a.load_measures ? &(a.load_measures->*q.values) : nullptr;
      });
  return {};
}

/// Of the mechanism.
Value of_measures(std::string_view path) {
  for (const DesignMeasure& q : kDesignMeasures)
    if (path == q.key)
      return [q](const Answer& a) {
        return a.measures ? shown(q.value(*a.measures), q.factor) : std::nullopt;
      };
  return {};
}

Value of_load_case(std::string_view path) {
  for (const CaseQuantity& q : kCaseQuantities)
    if (path == q.key)
      return [q](const Answer& a) { return shown(a.load_case->*q.value, q.factor); };
  const std::string_view key = take_key(path);
  if (key == "slip") return of_slip(path);
  if (key == "measures") return of_load_measures(path);
  if (const std::optional<Interface> i = interface_named(key)) return of_threads(*i, path);
  return {};
}

Value of_contact(std::string_view path) {
  const std::optional<Interface> i = interface_named(take_key(path));
  if (!i) return {};
  const auto value_in = [&](const auto& quantities) -> Value {
    for (const ContactQuantity& q : quantities)
      if (path == q.key)
        return [i, q](const Answer& a) {
          const InterfaceContact& contact = a.contacts.interfaces[*i];
          return contact.geometry.ok() ? shown(q.value(contact), q.factor) : std::nullopt;
        };
    return {};
  };
  for (const Value& value : {value_in(kContactPointQuantities), value_in(kCurvatureQuantities),
                             value_in(kHertzQuantities)})
    if (value) return value;
  return {};
}

Value of_thread_widths(std::string_view path) {
  const std::string_view key = take_key(path);
  for (const Part part : kParts)
    for (const WidthQuantity& q : kWidthQuantities)
      if (key == name(part) && path == q.key)
        return [part, q](const Answer& a) {
          return shown(q.value(thread_of(a.contacts.threads, part)), q.factor);
        };
  return {};
}

}  // namespace

std::optional<ResultNumber> result_number(std::string_view path) {
  ResultNumber number;
  number.needs_complete = path.find("max_shear") != std::string_view::npos;
  constexpr std::string_view contact = "contact.", cases = "load_cases", measures = "measures.",
                             threads = "threads.";
  if (path.starts_with(measures)) number.value = of_measures(path.substr(measures.size()));
  if (number.value) return number;
  if (path.starts_with(contact)) {
    number.value = of_contact(path.substr(contact.size()));
  } else if (path.starts_with(threads)) {
    number.value = of_thread_widths(path.substr(threads.size()));
  } else {
    number.load_case = 0;
    if (path.starts_with(cases)) {
      path.remove_prefix(cases.size());
      number.load_case = take_index(path);
      if (!number.load_case || !path.starts_with('.')) return std::nullopt;
      path.remove_prefix(1);
    }
    number.value = of_load_case(path);
  }
  if (!number.value) return std::nullopt;
  return number;
}

}  // namespace prs
