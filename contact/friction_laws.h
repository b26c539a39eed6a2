#pragma once

#include <array>
#include <string_view>

#include "contact/film.h"
#include "simd/inlined.h"

/// Laws of friction at a point of a contact. Each is written once, for numbers, batches with one point or one contact
/// per lane, and either with slopes; `LawParametersOf` lists them.
namespace contact {

/// Separation of the flanks in a law: none; a film that carries all of the load; a film through which they touch.
enum class Lubrication { dry, film, mixed };

/// Properties of a law that the rest of the program needs.
struct LawFacts {
  std::string_view name;  ///< Name in case files.
  std::string_view meaning;
  Lubrication lubrication = Lubrication::dry;
  bool changes_with_speed = false;

  constexpr bool has_film() const { return lubrication != Lubrication::dry; }
  /// Whether there is friction without motion, and thus without a film.
  constexpr bool holds_at_rest() const { return lubrication != Lubrication::film; }
};

/// A number that a law takes, as a file writes it. None may be negative.
template <class Law>
struct LawParameter {
  std::string_view key;  ///< Empty: the value of the law's own key.
  typename Law::Real Law::*member;
  std::string_view unit, example;
  std::string_view meaning = {};
  bool required = true;
  bool may_be_zero = true;
};

/// A contact that rolls: properties that are alike at all of its points. Film ratio and shear factor are 0 without
/// rolling, and for a dry law.
template <class Number>
struct RollingContactOf {
  using Real = simd::ValueOf<Number>;
  Real peak_pressure{};    ///< p_0 [Pa]
  Real temperature{};      ///< Temperature of the oil [K]; NaN where the file states a viscosity alone.
  Number film_ratio{};     ///< Lambda, central film over composite roughness; of mixed laws.
  Number eyring_stress{};  ///< tau_0/p_0
  Number shear_factor{};   ///< K of `sliding_factor` [s/m]
};

/// A point of a contact.
template <class Number>
struct FrictionPointOf {
  using Real = simd::ValueOf<Number>;
  Number speed;          ///< Sliding speed |v| [m/s]
  Real dome;             ///< p/p_0
  Real viscosity_ratio;  ///< eta_bar(p); 0 of a dry law.
};

/// Jacod's law, point by point (Sandu 2018, (2.27)): Eyring fluid, Roelands viscosity at the Hertz pressure of the
/// *static* load, Sandu's film of the whole contact, thinned by `film_factor`,
///
///     mu p/p_0 = tau_0/p_0 asinh(eta_bar K |v|)
template <class Of>
struct Jacod {
  using Real = Of;
  static constexpr LawFacts facts{"jacod", "lubricated contact, after Jacod", Lubrication::film, true};
  static constexpr std::array<LawParameter<Jacod>, 0> parameters{};

  /// Friction in the contact `c`: mu p/p_0 as a function of the point. Every law has this member.
  template <class Number>
  PRS_INLINED auto in(const RollingContactOf<Number>& c) const {
    return [c](const FrictionPointOf<Number>& at) PRS_INLINED {
      return c.eyring_stress * simd::asinh_of_positive(Number(c.shear_factor * at.viscosity_ratio * at.speed));
    };
  }
};

template <class Of>
struct Coulomb {
  using Real = Of;
  Real coefficient{};

  static constexpr LawFacts facts{"coulomb", "a constant coefficient of friction"};
  static constexpr std::array<LawParameter<Coulomb>, 1> parameters{{{"", &Coulomb::coefficient, "", "0.1"}}};

  template <class Number>
  PRS_INLINED auto in(const RollingContactOf<Number>&) const {
    return [mu = coefficient](const FrictionPointOf<Number>& at) PRS_INLINED { return Number(mu * at.dome); };
  }
};

/// Mixed friction (Olver and Spikes 1998): mu = (1 - s) mu_film + s mu_touching at each point, mu_film Jacod's, s the
/// `boundary_share` of the whole contact. Jacod's for thick films, Coulomb's without film or entrainment.
template <class Of>
struct Mixed {
  using Real = Of;
  Real boundary{};
  Real exponent = simd::filled_with<Real>(2.0);

  static constexpr LawFacts facts{"mixed", "a film after Jacod through which flanks touch, by film over roughness",
                                  Lubrication::mixed, true};
  static constexpr std::array<LawParameter<Mixed>, 2> parameters{
      {{"boundary", &Mixed::boundary, "", "0.12", "Coefficient of friction of flanks that touch"},
       {"exponent", &Mixed::exponent, "", "2",
        "Of (1 + film over roughness)^-exponent, the share of the load on flanks that touch", false, false}}};

  template <class Number>
  PRS_INLINED auto in(const RollingContactOf<Number>& c) const {
    const Number share = boundary_share(c.film_ratio, exponent);
    RollingContactOf<Number> rest = c;
    rest.eyring_stress = c.eyring_stress * (1.0 - share);
    return [mu = Number(share * boundary), film = Jacod<Real>{}.in(rest)](const FrictionPointOf<Number>& at)
               PRS_INLINED { return mu * at.dome + film(at); };
  }
};

template <class Real>
Coulomb(Real) -> Coulomb<Real>;
template <class Real>
Mixed(Real, Real) -> Mixed<Real>;

/// Place of a law in `LawParametersOf`.
enum class FrictionKind : std::int64_t {};

template <class Real, template <class> class... Law>
struct LawList : Law<Real>... {
  /// Calls visit(kind, law) with each.
  template <class Visit>
  PRS_INLINED constexpr void for_each(Visit visit) const {
    std::int64_t k = 0;
    (visit(FrictionKind{k++}, static_cast<const Law<Real>&>(*this)), ...);
  }
};

/// Parameters of every law, in the order in which files list them.
template <class Real>
using LawParametersOf = LawList<Real, Jacod, Coulomb, Mixed>;

constexpr LawFacts facts_of(FrictionKind kind) {
  LawFacts found;
  LawParametersOf<double>{}.for_each([&](FrictionKind k, const auto& law) {
    if (k == kind) found = law.facts;
  });
  return found;
}

template <template <class> class Law>
inline constexpr FrictionKind kind_of = [] {
  FrictionKind found{};
  LawParametersOf<double>{}.for_each([&]<class L>(FrictionKind k, const L&) {
    if (std::is_same_v<L, Law<double>>) found = k;
  });
  return found;
}();

/// The law of friction of a contact, with the film that it may ask for.
template <class Real>
struct FrictionLawOf : LawParametersOf<Real> {
  simd::EnumOf<FrictionKind, Real> kind{};
  LubricantOf<Real> oil{};
  FilmContactOf<Real> film{};
  Real roughness{};  ///< Composite Rq [m]; of mixed laws.

  /// Calls visit(law, which) with each law that a lane has, and with the lanes that have it.
  template <class Visit>
  PRS_INLINED void visit(Visit visit) const {
    using simd::any;
    this->for_each([&](FrictionKind k, const auto& law) PRS_INLINED {
      const simd::Lanes<Real> which = kind == k;
      if (any(which)) visit(law, which);
    });
  }
  simd::Lanes<Real> is(Lubrication lubrication) const {
    simd::Lanes<Real> found = Real(0.0) < Real(0.0);
    visit([&](const auto& law, const simd::Lanes<Real>& which) {
      if (law.facts.lubrication == lubrication) found = found || which;
    });
    return found;
  }
  simd::Lanes<Real> has_film() const { return is(Lubrication::film) || is(Lubrication::mixed); }
};
using FrictionLaw = FrictionLawOf<double>;

template <template <class> class Law>
FrictionLaw friction_law(const Law<double>& parameters, const Lubricant& oil = {}, const FilmContact& film = {},
                         double roughness = 0.0) {
  FrictionLaw law{{}, kind_of<Law>, oil, film, roughness};
  static_cast<Law<double>&>(law) = parameters;
  return law;
}

/// Coefficient of friction of a contact that hardly moves.
inline double friction_at_rest(const FrictionLaw& law) {
  double coefficient = 0.0;
  law.visit([&](const auto& one, bool) { coefficient = one.in(RollingContactOf<double>{})({0.0, 1.0, 0.0}); });
  return coefficient;
}

}  // namespace contact
