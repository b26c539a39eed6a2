#pragma once

#include <nanobind/nanobind.h>

namespace prs::python {

void bind_theory(nanobind::module_& module);

}  // namespace prs::python
