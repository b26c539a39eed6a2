#include "prs/model/named_lubricants.h"

namespace prs {
namespace {

using enum contact::BaseOil;

/// Midpoints of the grades; at 100 degC what the viscosity index of 95 gives, for which the annex
/// of ISO 3448 tabulates the grades. Densities are typical ones of such oils, no data of a sheet,
/// where the source says so.
constexpr std::string_view kIso =
    "midpoints of ISO 3448, viscosity index 95 by ASTM D2270; density: typical";
constexpr std::string_view kAeroShell =
    "The AeroShell Book, 19th edition (2012): base oil, typical; density: typical";
constexpr std::string_view kSkf =
    "SKF bearing grease selection chart: base oil at 40 degC; at 100 degC viscosity index 95 by "
    "ASTM D2270; density: typical";

constexpr NamedLubricant kLubricants[] = {
    {"iso-vg-32", "mineral oil", mineral, 32e-6, 5.29e-6, 875.0, kIso},
    {"iso-vg-46", "mineral oil", mineral, 46e-6, 6.64e-6, 879.0, kIso},
    {"iso-vg-68", "mineral oil", mineral, 68e-6, 8.53e-6, 887.0, kIso},
    {"iso-vg-100", "mineral oil", mineral, 100e-6, 11.07e-6, 891.0, kIso},
    {"iso-vg-150", "mineral oil", mineral, 150e-6, 14.54e-6, 897.0, kIso},
    {"iso-vg-220", "mineral oil", mineral, 220e-6, 18.75e-6, 899.0, kIso},
    {"iso-vg-320", "mineral oil", mineral, 320e-6, 23.95e-6, 903.0, kIso},
    {"iso-vg-460", "mineral oil", mineral, 460e-6, 30.34e-6, 904.0, kIso},
    {"mil-prf-23699", "turbine oil, ester: Mobil Jet Oil II", ester, 27.6e-6, 5.1e-6, 1003.5,
     "Mobil Jet Oil II, product data sheet: typical values"},
    {"mil-prf-7808", "turbine oil, ester: grade 3", ester, 11.5e-6, 3.0e-6, 950.0,
     "MIL-PRF-7808L, least viscosities of grade 3; density: typical"},
    {"mil-prf-83282", "hydraulic fluid, polyalphaolefin", polyalphaolefin, 14.0e-6, 3.45e-6, 850.0,
     "MIL-PRF-83282D, least viscosities; density: typical"},
    {"mil-prf-23827", "grease for screws and gears: AeroShell Grease 33", polyalphaolefin, 14.2e-6,
     3.4e-6, 850.0, kAeroShell},
    {"mil-prf-81322", "grease, wide temperature range: AeroShell Grease 22", polyalphaolefin,
     30.5e-6, 5.7e-6, 830.0, kAeroShell},
    {"skf-lgmt-2", "grease, lithium soap: SKF LGMT 2", mineral, 110e-6, 11.80e-6, 890.0, kSkf},
    {"skf-lgep-2", "grease, lithium soap, EP: SKF LGEP 2", mineral, 200e-6, 17.61e-6, 898.0, kSkf},
    {"skf-lgwa-2", "grease, lithium complex, EP: SKF LGWA 2", mineral, 185e-6, 16.73e-6, 898.0,
     kSkf},
    {"skf-lghb-2", "grease, calcium sulphonate: SKF LGHB 2", mineral, 400e-6, 27.69e-6, 904.0,
     kSkf},
};

}  // namespace

std::span<const NamedLubricant> named_lubricants() { return kLubricants; }

const NamedLubricant& data_of(LubricantName name) {
  return kLubricants[static_cast<std::size_t>(name)];
}

}  // namespace prs
