#include "python/engine/theory.h"

#include <nanobind/ndarray.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "contact/film.h"
#include "contact/hertz.h"
#include "prs/life/load_history.h"
#include "prs/life/rating_life.h"
#include "python/engine/document.h"
#include "python/engine/interpreter_guard.h"

namespace nb = nanobind;

namespace prs::python {
namespace {

using Samples = nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu>;
using Table = nb::ndarray<const double, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

constexpr const char* kTable = "(table: numpy.typing.NDArray[numpy.float64]) -> numpy.typing.NDArray[numpy.float64]";

/// A function of rows of numbers, with `in` inputs and `out` results per row.
template <std::size_t in, std::size_t out, class Function>
void bind_rows(nb::module_& module, const char* name, const char* signature, const char* doc, Function function) {
  module.def(
      name,
      [function](const Table& table) {
        if (table.shape(1) != in) throw std::invalid_argument("got another number of columns");
        auto answers = std::make_shared<std::vector<double>>(table.shape(0) * out);
        {
          const GilRelease released;
          for (std::size_t row = 0; row < table.shape(0); ++row)
            function(table.data() + row * in, answers->data() + row * out);
        }
        return view(answers, table.shape(0), out);
      },
      nb::arg("table"), nb::sig(signature), doc);
}

/// Inputs: kappa_1, kappa_2, E*, N.
void hertz(const double* in, double* out) {
  const contact::HertzConstants constants = contact::hertz_constants(in[0], in[1], in[2]);
  const contact::HertzContact loaded = contact::at_load(constants, in[3]);
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double answers[] = {constants.ellipticity, constants.hertz_constant, loaded.approach,
                            loaded.semi_major,     loaded.semi_minor,        loaded.peak_pressure};
  for (const double answer : answers) *out++ = constants.ok() ? answer : none;
}

/// Inputs: eta_0, alpha, |u|, N, rho_x, E*, lambda.
void film(const double* in, double* out) {
  *out = contact::nijenbanning_film(
             {.viscosity = in[0], .pressure_viscosity = in[1]},
             {.normal_load = in[3], .curvature = in[4], .contact_modulus = in[5], .curvature_ratio = in[6]}, in[2])
             .thickness;
}

/// Inputs: eta_0, alpha, tau_0, |u|, |v_D|, N, rho_x, E*, p_D.
void friction(const double* in, double* out) {
  const contact::Lubricant lubricant{.viscosity = in[0], .pressure_viscosity = in[1], .eyring_stress = in[2]};
  const contact::FilmContact at{.normal_load = in[5], .curvature = in[6], .contact_modulus = in[7]};
  const contact::Film formed = contact::sandu_film(lubricant, at, in[3]);
  const double factor = contact::sliding_factor(lubricant, at, formed, in[3]);
  *out = in[2] / in[8] * std::asinh(contact::roelands_viscosity_ratio(in[0], in[8]) * factor * in[4]);
}

}  // namespace

void bind_theory(nb::module_& module) {
  const auto signature = [](const char* name) { return std::string("def ") + name + kTable; };
  static const std::string hertz_signature = signature("hertz"), film_signature = signature("film"),
                           friction_signature = signature("friction");
  bind_rows<4, 6>(module, "hertz", hertz_signature.c_str(), "See rollerscrew.theory.hertz.", hertz);
  bind_rows<7, 1>(module, "film", film_signature.c_str(), "See rollerscrew.theory.central_film.", film);
  bind_rows<9, 1>(module, "friction", friction_signature.c_str(), "See rollerscrew.theory.friction_coefficient.",
                  friction);
  module.def(
      "contact_modulus",
      [](double e_1, double nu_1, double e_2, double nu_2) {
        return contact::contact_modulus({e_1, nu_1}, {e_2, nu_2});
      },
      nb::arg("youngs_modulus_1"), nb::arg("poisson_ratio_1"), nb::arg("youngs_modulus_2"), nb::arg("poisson_ratio_2"));
  module.def(
      "rainflow",
      [](const Samples& history, double hysteresis) {
        auto rows = std::make_shared<std::vector<double>>();
        for (const Cycle& cycle : rainflow({history.data(), history.shape(0)}, hysteresis))
          for (const double number : {cycle.range(), cycle.mean(), cycle.count, static_cast<double>(cycle.start.index),
                                      static_cast<double>(cycle.end.index)})
            rows->push_back(number);
        const std::size_t count = rows->size() / 5;
        return view(rows, count, 5);
      },
      nb::arg("history"), nb::arg("hysteresis"),
      nb::sig("def rainflow(history: numpy.typing.NDArray[numpy.float64], hysteresis: float) -> "
              "numpy.typing.NDArray[numpy.float64]"));
  module.def("rating_life", &rating_life, nb::arg("capacity"), nb::arg("load"));
  module.def(
      "mean_load",
      [](const Samples& forces, const Samples& revolutions) {
        std::vector<LoadStep> steps;
        for (std::size_t k = 0; k < forces.shape(0); ++k) steps.push_back({forces.data()[k], revolutions.data()[k]});
        return mean_load(steps);
      },
      nb::arg("forces"), nb::arg("revolutions"),
      nb::sig("def mean_load(forces: numpy.typing.NDArray[numpy.float64], revolutions: "
              "numpy.typing.NDArray[numpy.float64]) -> float"));
}

}  // namespace prs::python
