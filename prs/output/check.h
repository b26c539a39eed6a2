#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "prs/input/echo.h"
#include "prs/quantities/json.h"
#include "prs/threads/contacts.h"

namespace prs {

/// The resolved case: every value, whether it is a default, what follows from it, what is unusual.
std::string check_table(const std::vector<input::EchoEntry>& fields, const Contacts& contacts,
                        const std::vector<std::string>& warnings);

nlohmann::ordered_json check_json(const std::vector<input::EchoEntry>& fields,
                                  const Contacts& contacts,
                                  const std::vector<std::string>& warnings,
                                  const DocumentInfo& info);

}  // namespace prs
