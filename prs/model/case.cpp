#include "prs/model/case.h"

namespace prs {

Conditions::Conditions() = default;
Conditions::Conditions(const Conditions&) = default;
Conditions::Conditions(Conditions&&) noexcept = default;
Conditions& Conditions::operator=(const Conditions&) = default;
Conditions& Conditions::operator=(Conditions&&) noexcept = default;
Conditions::~Conditions() = default;

}  // namespace prs
