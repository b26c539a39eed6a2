#pragma once

#include <nanobind/nanobind.h>

namespace prs::python {

void bind_optimization(nanobind::module_& module);

}  // namespace prs::python
