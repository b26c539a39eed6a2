#include "prs/life/life_record.h"
#include "prs/loads/load_record.h"

#include "prs/record/record_table.h"

namespace prs {
namespace {

/// Lives of an interface, with the whole result.
struct InterfaceLife {
  const ThreadLives* threads = nullptr;
  std::optional<double> peak_pressure;
};

struct DirectionLife {
  const LifeResult* life = nullptr;
  const FlankLife* flank = nullptr;
};

/// A part of the document of lives.
struct PartOfLife {
  const LifeResult* life = nullptr;
};

struct WeakestLife : PartOfLife {};
struct LifeAtRest : PartOfLife {};
struct Modified : PartOfLife {};
struct LifeWithBearings : PartOfLife {};
struct BearingLives : PartOfLife {};
struct FixedBearing : PartOfLife {};
struct Capacity : PartOfLife {};
struct Loads : PartOfLife {};
struct Cycles : PartOfLife {};

}  // namespace

Record<InterfaceLife> record_of(Type<InterfaceLife>);
Record<DirectionLife> record_of(Type<DirectionLife>);
Record<WeakestLife> record_of(Type<WeakestLife>);
Record<LifeAtRest> record_of(Type<LifeAtRest>);
Record<Modified> record_of(Type<Modified>);
Record<LifeWithBearings> record_of(Type<LifeWithBearings>);
Record<BearingLives> record_of(Type<BearingLives>);
Record<FixedBearing> record_of(Type<FixedBearing>);
Record<Capacity> record_of(Type<Capacity>);
Record<Loads> record_of(Type<Loads>);
Record<Cycles> record_of(Type<Cycles>);
Record<CycleMatrix> record_of(Type<CycleMatrix>);

namespace {

constexpr std::string_view kMiner = "FKM; Miner elementary", kPalmgrenMean = "ISO 281; cubic mean",
                           kLemorCapacity = "Lemor, in Jung 2017, (6.1) to (6.3)";

constexpr std::string_view kFactorRange =
    "f_c at d_r cos/d_n, d_r cos/(2 c) and D_c cos/(2 c): Lemor's ratio of diameters and ISO 281's";

using Range = std::array<double, 2>;
Range range_of(const Interval& i) { return {i.least, i.greatest}; }

bool is_finite(const LifeInUse& life) { return std::isfinite(life.revolutions); }

constexpr std::string_view kReliability = "ISO 281:2007, a1",
                           kRated = "the L10 value times reliability_factor and modification_factor";

/// A life, scaled to the requested reliability.
template <auto member>
constexpr auto rated_of = of<[](auto& life) {
  const auto& value = std::invoke(member, life);
  if constexpr (detail::is_optional<std::remove_cvref_t<decltype(value)>>)
    return value ? std::optional(life.rated * *value) : std::nullopt;
  else
    return life.rated * value;
},
                             is_finite>;

constexpr Quantity<LifeInUse> kLifeInUse[] = {
    {"l10_revolutions", of<&LifeInUse::revolutions, is_finite>,
     "turns under load, which 90 % reach; travel without load does not count", source::kLife,
     "life L10 in turns under load"},
    {"l10_revolutions_range", of<&LifeInUse::revolutions_range, is_finite>, "by the range of the dynamic capacity",
     source::kLife, "life L10, by the range of C_a"},
    {"l10_hours", of<&LifeInUse::hours, is_finite>,
     "clock hours where the file states time, duration or period, else hours in motion at operation.speed",
     source::kLife, "life L10 in time"},
    {"l10_moving_hours", of<&LifeInUse::moving_hours, is_finite>, "in motion under load at operation.speed",
     source::kLife, "life L10 in time of motion under load"},
    {"l10_travel_km", of<&LifeInUse::travel, is_finite>, "under load; with life.travel all travel", source::kLife,
     "life L10 in travel"},
    {"l10_passes", of<&LifeInUse::passes, is_finite>, "of the history or the spectrum", source::kLife,
     "life L10 in passes"},
    {"rated_revolutions", rated_of<&LifeInUse::revolutions>, kRated, kReliability, "rated life in revolutions"},
    {"rated_revolutions_range",
     of<[](auto& l) {
       return Range{l.rated * l.revolutions_range[0], l.rated * l.revolutions_range[1]};
     },
        is_finite>,
     kRated, kReliability, "rated life, by the range of C_a"},
    {"rated_hours", rated_of<&LifeInUse::hours>, kRated, kReliability, "rated life in hours"},
    {"rated_moving_hours", rated_of<&LifeInUse::moving_hours>, kRated, kReliability, "rated life in hours of motion"},
    {"rated_travel_km", rated_of<&LifeInUse::travel>, kRated, kReliability, "rated life in travel"},
    {"rated_passes", rated_of<&LifeInUse::passes>, kRated, kReliability, "rated life in passes"},
};

constexpr Quantity<ThreadLives> kThreadLives[] = {
    {"equivalent_load_N", of<&ThreadLives::equivalent_load>, "axial, cubic mean over all revolutions", kPalmgrenMean},
    {"l10_revolutions", of<&ThreadLives::life>, "of the thread on all rollers; null where it is never loaded",
     source::kLife, "life L10 in turns"},
    {"rated_revolutions", of<&ThreadLives::rated_life>, kRated, kReliability, "rated life in revolutions"},
    {"largest_load_N", of<&ThreadLives::largest_load>,
     "axial, the largest of all forces: at rest, and of a running screw where life is of its loads"},
    {"equivalent_range_N", of<&ThreadLives::equivalent_range>, "of the axial load over the cycles of the history",
     kMiner},
    {"rollers", of<&ThreadLives::rollers>, "threads of the rollers of a full mechanism"},
};

constexpr Quantity<RollerLives> kRollerLives[] = {
    {"equivalent_load_N", of<&RollerLives::equivalent_load>, "[roller][thread], axial, cubic mean over all revolutions",
     kPalmgrenMean},
    {"l10_revolutions", of<&RollerLives::life>, "[roller][thread]; null where the thread is never loaded",
     source::kLife},
    {"rated_revolutions", of<&RollerLives::rated_life>, kRated, kReliability},
};

constexpr Quantity<InterfaceLife> kInterfaceLife[] = {
    {"", of<&InterfaceLife::threads>},
    {"peak_pressure_MPa", of<&InterfaceLife::peak_pressure>, "under the largest loads of its threads", source::kHertz},
};

template <auto get>
constexpr auto of_flank = of<[](auto& d) { return std::invoke(get, *d.flank); }>;

template <Interface i>
constexpr auto threads_of = of<[](auto& d) {
  return InterfaceLife{&d.flank->threads[i], d.flank->peak_pressure[i]};
}>;

constexpr Quantity<DirectionLife> kDirectionLife[] = {
    {"", of<[](auto& d) { return in_use(*d.life, d.flank->life); }>},
    {"share_of_revolutions", of<[](auto& d) { return d.flank->revolutions / d.life->revolutions; }>,
     "under loads of this direction"},
    {"mean_load_N", of_flank<&FlankLife::mean_load>, "cubic mean over the revolutions of both directions",
     kPalmgrenMean},
    {"largest_force_N", of_flank<&FlankLife::largest_force>, "of this direction"},
    {"static_capacity_N", of_flank<&FlankLife::static_capacity>,
     "force at which the first thread has the peak pressure of 4.0 GPa, of steel, or of "
     "materials.static_pressure_limit",
     "ISO 76:2006", "static capacity, real thread loads"},
    {"flank_edge_load_N", of_flank<&FlankLife::flank_edge_load>,
     "force at which the first ellipse reaches a crest or root", source::kHertz,
     "load at which edge loading begins, real thread loads"},
    {"flank_edge_margin", of_flank<&FlankLife::flank_edge_margin>, "that force over the largest force", source::kHertz,
     "safety against edge loading"},
    {"static_safety", of_flank<&FlankLife::static_safety>,
     "stated static capacity, else force at which the first thread has 4.0 GPa, over the largest force", "ISO 76"},
    {"static_safety_limit", of<[](auto& d) {
       const auto& rating = d.flank->static_rating;
       return rating ? std::optional(rating->limit) : std::nullopt;
     }>,
     "pressure | given", "", "what limits the static safety"},
    {"equilibria", of_flank<&FlankLife::solves>, "that were solved", "", "loads at which the threads were solved"},
    {"interpolation_error", of_flank<&FlankLife::interpolation_error>,
     "of thread loads between the equilibria, relative", "", "error of thread loads between them"},
    {"screw", threads_of<Interface::screw>, "threads of one roller at the screw"},
    {"nut", threads_of<Interface::nut>, "threads of one roller at the nut"},
};

constexpr Quantity<WeakestLife> kWeakestLife[] = {
    {"", of<[](auto& w) { return in_use(*w.life, w.life->weakest->life); }>},
    {"direction", of<[](auto& w) { return w.life->weakest->direction; }>, "tension | compression"},
    {"interface", of<[](auto& w) { return w.life->weakest->interface; }>, "screw | nut"},
    {"thread", of<[](auto& w) { return w.life->weakest->thread + 1; }>, "from 1, next to the loaded end of the screw"},
    {"part", of<[](auto& w) { return w.life->weakest->part; }>,
     "screw | roller | nut: whose thread; of a full mechanism"},
    {"roller", of<[](auto& w) {
       const auto& roller = w.life->weakest->roller;
       return roller ? std::optional(*roller + 1) : std::nullopt;
     }>,
     "from 1; of a roller of a full mechanism"},
    {"equivalent_load_N", of<[](auto& w) { return w.life->weakest->equivalent_load; }>,
     "axial, cubic mean over all revolutions", kPalmgrenMean},
};

constexpr Quantity<LifeAtRest> kLifeAtRest[] = {
    {"system", of<[](auto& l) { return in_use(*l.life, *l.life->life_at_rest); }>, "of the mechanism", "",
     "life of the mechanism on static loads"},
};

template <auto get>
constexpr auto of_modified = of<[](auto& m) { return std::invoke(get, *m.life->modified); }>;

constexpr std::string_view kIsoLife = "ISO 281:2007, 9.3.3";
constexpr Quantity<Modified> kModified[] = {
    {"film_ratio", of_modified<&ModifiedLife::film_ratio>,
     "Lambda under the mean load at the operation's speed, the smallest of all threads"},
    {"viscosity_ratio", of_modified<&ModifiedLife::viscosity_ratio>, "kappa = Lambda^1.3", kIsoLife},
    {"load_ratio", of_modified<&ModifiedLife::load_ratio>,
     "C_u/P, (1.5 GPa over the largest peak pressure)^3 under the mean load", kIsoLife},
    {"factor", of_modified<&ModifiedLife::factor>, "a_ISO, next to the modification_factor that the case states",
     kIsoLife, "life modification factor of film and contamination"},
    {"system", of<[](auto& m) { return in_use(*m.life, m.life->modified->factor * m.life->system_life); }>,
     "of the mechanism, real thread loads", "", "life of the mechanism with film and contamination"},
};

template <auto get>
constexpr auto of_life = of<[](const PartOfLife& part) { return std::invoke(get, *part.life); }>;

template <auto get>
constexpr auto of_lemor =
    of<[](auto& c) { return c.life->lemor ? std::optional(std::invoke(get, *c.life->lemor)) : std::nullopt; }>;

constexpr Quantity<Capacity> kCapacity[] = {
    {"dynamic_capacity_N", of_life<&LifeResult::dynamic_capacity>, "C_a; life.dynamic_capacity where stated",
     kLemorCapacity},
    {"dynamic_capacity_range_N", of<[](auto& c) { return range_of(c.life->dynamic_capacity_range); }>, kFactorRange,
     "docs/life.md"},
    {"source", of<[](auto& c) { return c.life->lemor ? "lemor" : "given"; }>, "lemor | given", "",
     "where the dynamic capacity comes from"},
    {"geometry_factor", of_lemor<&LemorCapacity::factor>, "f_c", kLemorCapacity},
    {"geometry_factor_range", of_lemor<[](const LemorCapacity& l) { return range_of(l.factor_range); }>, kFactorRange,
     "docs/life.md"},
    {"diameter_ratio", of_lemor<&LemorCapacity::ratio>, "d_r cos(alpha)/d_n", kLemorCapacity},
    {"element_diameter_mm", of_lemor<&LemorCapacity::element_diameter>, "diameter of the equivalent ball",
     kLemorCapacity},
    {"failure_share", of_life<&LifeResult::failure_shares>,
     "share of each interface in the failures under equal loads"},
    {"roller_failure_share", of_life<&LifeResult::roller_shares>,
     "part of the rollers in the failures of each interface; of a full mechanism", "Lundberg and Palmgren"},
    {"static_capacity_equal_shares_N", of_life<&LifeResult::equal_shares_static_capacity>,
     "force at which equal thread loads have the peak pressure of 4.0 GPa, of steel, or of "
     "materials.static_pressure_limit",
     "ISO 76:2006", "static capacity, equal thread loads"},
    {"flank_edge_load_equal_shares_N", of_life<&LifeResult::equal_shares_flank_edge_load>,
     "force at which ellipses of equal loads reach a crest or root", source::kHertz,
     "load at which edge loading begins, equal thread loads"},
    {"static_capacity_given_N", of<[](auto& c) { return c.life->life.static_capacity; }>, "life.static_capacity"},
};

template <auto get>
constexpr auto of_bearing = of<[](auto& b) { return std::invoke(get, *b.life->bearing); }>;

constexpr std::string_view kBearing = "ISO 281; preload by the rule of makers";
constexpr Quantity<FixedBearing> kFixedBearing[] = {
    {"equivalent_load_N", of_bearing<&BearingLife::equivalent_load>,
     "of the loads with preload over all revolutions, travel without load included", kBearing},
    {"l10_revolutions", of_bearing<&BearingLife::life>, "of the part that turns in it, all of them; that 90 % reach",
     kBearing, "life L10 of the bearing"},
    {"l10_hours", of<[](auto& b) {
       const auto life = b.life->bearing_life();
       return life ? in_use(*b.life, *life).hours : std::nullopt;
     }>,
     "as those of the screw", kBearing, "life L10 of the bearing in hours"},
    {"static_safety", of_bearing<&BearingLife::static_safety>, "static capacity over the largest force", "ISO 76",
     "static safety of the bearing"},
};

constexpr Quantity<BearingLives> kBearings[] = {
    {"fixed", of<[](auto& b) { return FixedBearing{b.life}; }>, "that holds the part that turns along its axis"},
};

template <auto get>
constexpr auto other_life =
    of<[](auto& o) { return std::invoke(get, in_use(*o.life, *o.life->life_with_bearings())); }>;

constexpr Quantity<LifeWithBearings> kWithBearings[] = {
    {"l10_revolutions", other_life<&LifeInUse::revolutions>, "of screw and bearings together, e = 10/9", source::kLife,
     "life L10 with bearings"},
    {"l10_hours", other_life<&LifeInUse::hours>, "as those of the screw", source::kLife,
     "life L10 with bearings in hours"},
    {"l10_travel_km", other_life<&LifeInUse::travel>, "as that of the screw", source::kLife,
     "life L10 with bearings in travel"},
};

template <auto get>
constexpr auto where_revolutions_are_known =
    of<[](auto& l) { return std::invoke(get, *l.life); }, [](const Loads& l) { return l.life->revolutions_known; }>;

constexpr Quantity<Loads> kLoads[] = {
    {"samples", of<[](auto& l) { return l.life->steps.size(); }>, "of the history or the spectrum", "",
     "load steps of one pass"},
    {"revolutions", where_revolutions_are_known<&LifeResult::revolutions>, "of one pass"},
    {"travel_m", where_revolutions_are_known<[](const LifeResult& r) {
       return r.revolutions * std::abs(r.contacts.mechanism.lead);
     }>,
     "of one pass"},
    {"duration_h", of_life<&LifeResult::duration>, "of one pass"},
    {"mean_load_N", of_life<&LifeResult::mean_load>, "cubic mean over the revolutions under load", kPalmgrenMean},
    {"largest_force_N", of_life<&LifeResult::largest_force>, "of either direction"},
};

constexpr Quantity<CycleMatrix> kCycleMatrix[] = {
    {"range_to_N", of<&CycleMatrix::range_to>, "end of the last class of ranges, from 0"},
    {"mean_from_N", of<&CycleMatrix::mean_from>, "start of the first class of means"},
    {"mean_to_N", of<&CycleMatrix::mean_to>, "end of the last class of means"},
    {"count", of<[](auto& matrix) {
       std::vector<std::vector<double>> rows(static_cast<std::size_t>(matrix.bins));
       for (int i = 0; i < matrix.bins; ++i)
         for (int k = 0; k < matrix.bins; ++k) rows[static_cast<std::size_t>(i)].push_back(matrix.at(i, k));
       return rows;
     }>,
     "of cycles, by range and mean"},
};

constexpr Quantity<Cycles> kCycles[] = {
    {"count", of<[](auto& c) { return count(c.life->cycles->cycles); }>, "half cycles as halves", "ASTM E1049-85"},
    {"fatigue_slope", of<[](auto& c) { return c.life->life.fatigue_slope; }>, "of the S-N curve", "FKM"},
    {"equivalent_range_N", of<[](auto& c) { return c.life->cycles->equivalent_range; }>,
     "constant range that does the same damage in as many cycles", kMiner},
    {"largest_range_N", of<[](auto& c) { return c.life->cycles->matrix.range_to; }>, "of a cycle"},
    {"matrix", of<[](auto& c) { return c.life->cycles->matrix; }>, "cycles by range and mean"},
};

bool converged(const LifeResult& r) { return r.converged(); }

template <auto get>
constexpr auto life_at = of<[](auto& r) { return in_use(r, std::invoke(get, r)); }, converged>;

/// A part of results that have this value.
template <class Part, auto value, auto guard = nullptr>
constexpr auto part_with =
    of<[](const LifeResult& r) { return std::invoke(value, r) ? std::optional(Part{{&r}}) : std::nullopt; }, guard>;

template <Direction d>
constexpr auto flank_of = of<[](auto& r) {
  return r.flanks[d] ? std::optional(DirectionLife{&r, &*r.flanks[d]}) : std::nullopt;
},
                             converged>;

constexpr Quantity<LifeResult> kLife[] = {
    {"converged", of<converged>, "whether every load has an equilibrium"},
    {"status", of<&LifeResult::failure>, "why there are no lives"},
    {"share", of<[](auto& r) { return r.life.share == LoadCase::Share::equal ? "equal" : "solved"; }>,
     "solved | equal: thread loads", "", "sharing of the load"},
    {"thread_loads", of<&LifeResult::loads>,
     "static | running: of a screw that turns, with friction; static safety is always static", "",
     "thread loads for the life"},
    {"temperature_degC",
     of<[](auto& r) { return r.temperature ? std::optional(celsius_of(*r.temperature)) : std::nullopt; }>,
     "of the parts under all loads: that at which the mean heat of the spectrum flows off, or the "
     "mean of the duty cycle; with heat"},
    {"temperature_status", of<&LifeResult::temperature_status>,
     "converged | no_steady_state | iteration_limit; with heat"},
    {"reliability_factor", of<&LifeResult::reliability_factor>, "a1 of the required reliability", kReliability},
    {"modification_factor", of<[](auto& r) { return r.life.modification_factor; }>, "a_ISO as the case states it",
     "ISO 281:2007"},
    {"capacity", of<[](auto& r) { return Capacity{&r}; }>, "of the mechanism"},
    {"loads", of<[](auto& r) { return Loads{&r}; }>, "of the history or the spectrum"},
    {"cycles", part_with<Cycles, &LifeResult::cycles>, "counted from a history (rainflow)"},
    {"system", life_at<&LifeResult::system_life>, "of the mechanism, real thread loads", "", "life of the mechanism"},
    {"static", part_with<LifeAtRest, &LifeResult::life_at_rest, converged>,
     "the same on the loads of a screw at rest; where thread_loads is running"},
    {"equal_shares", life_at<&LifeResult::equal_shares_life>, "of the mechanism, equal thread loads", "",
     "life with equal thread loads"},
    {"catalogue", life_at<&LifeResult::catalogue_life>, "(C_a/F_m)^3", "", "life by the catalogue's formula"},
    {"bearings", part_with<BearingLives, &LifeResult::bearing>, "at the ends of the shaft; with bearings"},
    {"system_with_bearings", part_with<LifeWithBearings, &LifeResult::bearing_life, converged>,
     "of screw, by the catalogue where its capacity is stated, and bearings"},
    {"static_safety", of<&LifeResult::static_safety, converged>, "the smaller of both directions", "ISO 76",
     "static safety under the loads of the life"},
    {"static_safety_limit", of<&LifeResult::static_safety_limit, converged>, "pressure | given", "",
     "what limits the static safety"},
    {"modified", part_with<Modified, &LifeResult::modified, converged>,
     "with film and contamination; where life.contamination is stated"},
    {"weakest_thread", part_with<WeakestLife, &LifeResult::weakest, converged>, "that fails first"},
    {"tension", flank_of<Direction::tension>, "flanks that carry tension"},
    {"compression", flank_of<Direction::compression>, "flanks that carry compression"},
};

}  // namespace

LifeInUse in_use(const LifeResult& r, double revolutions) {
  const auto scaled = [&](double capacity) {
    return revolutions * std::pow(capacity / r.dynamic_capacity, kLifeExponent);
  };
  const Interval& range = r.dynamic_capacity_range;
  LifeInUse life;
  life.revolutions = revolutions;
  life.revolutions_range = {scaled(range.least), scaled(range.greatest)};
  life.travel = revolutions * std::abs(r.contacts.mechanism.lead);
  if (r.life.travel) life.travel = revolutions / r.revolutions * *r.life.travel;
  if (r.revolution_rate) life.hours = revolutions / *r.revolution_rate / 3600.0;
  if (r.moving_rate) life.moving_hours = revolutions / *r.moving_rate / 3600.0;
  life.rated = r.rated_over_l10();
  if (r.revolutions_known) life.passes = revolutions / r.revolutions;
  return life;
}

PRS_RECORD(LifeInUse, "LifeInUse", "A life L10 at the value of the dynamic capacity.", kLifeInUse);
PRS_RECORD(ThreadLives, "ThreadLives", "Lives of the threads of one interface.", kThreadLives);
PRS_RECORD(RollerLives, "RollerLives", "Lives of the threads of the rollers at one interface.", kRollerLives);
PRS_RECORD(InterfaceLife, "InterfaceLife", "Lives of the threads of one interface.", kInterfaceLife);
PRS_RECORD(DirectionLife, "DirectionLife", "Lives under the loads of one direction.", kDirectionLife);
PRS_RECORD(WeakestLife, "WeakestThread", "The thread that fails first, of those that turn under load.", kWeakestLife);
PRS_RECORD(Modified, "ModifiedLife", "What film and dirt do to the life, by ISO 281.", kModified);
PRS_RECORD(LifeAtRest, "LifeAtRest", "Lives on the loads of a screw at rest.", kLifeAtRest);
PRS_RECORD(LifeWithBearings, "LifeWithBearings", "Life of screw and bearings.", kWithBearings);
PRS_RECORD(BearingLives, "BearingLives", "Bearings at the ends of the shaft.", kBearings);
PRS_RECORD(FixedBearing, "FixedBearing", "The bearing that holds the part that turns.", kFixedBearing);
PRS_RECORD(Capacity, "Capacity", "What the mechanism can carry.", kCapacity);
PRS_RECORD(Loads, "LifeLoads", "The history or the spectrum.", kLoads);
PRS_RECORD(Cycles, "Cycles", "Load cycles of a history: rainflow, ASTM E1049-85.", kCycles);
PRS_RECORD(CycleMatrix, "CycleMatrix", "Load cycles by range and mean.", kCycleMatrix);
PRS_RECORD(LifeResult, "Life", "Lives of mechanism and threads.", kLife);

}  // namespace prs
