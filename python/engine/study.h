#pragma once

#include <nanobind/nanobind.h>

namespace prs::python {

void bind_study(nanobind::module_& module);

}  // namespace prs::python
