#pragma once

#include "prs/export/system_model.h"

namespace prs {

/// A co-simulation unit of FMI 2.0: a ZIP archive. The same curves and text give the same bytes.
/// Inputs `deflection` [m] and `speed` [rad/s], outputs `force` [N], `stiffness` [N/m] and `torque`
/// [N m].
/// With its drive it has states, and the inputs and outputs of docs/response.md.
std::string functional_mockup_unit(const SystemModel& model);

/// A Modelica package of the same curves: block `Curves` with the same inputs and outputs, and
/// `Screw` between a rotational and a translational flange.
std::string modelica_package(const SystemCurves& curves, const ModelText& text);

}  // namespace prs
