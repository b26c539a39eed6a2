#pragma once

#include <initializer_list>

#include "prs/loads/result.h"
#include "prs/record/analysis.h"

namespace prs {

/// Adds what every document says of the contacts, under `contact`, and of the threads by
/// themselves, under `threads`; nothing of these where no heights are given.
void put_contacts(Json& document, const Contacts& contacts);

/// Adds contacts and model, and an empty list for the load cases.
void put_loads(Json& document, const Result& result);
/// A load case: units stand in the keys, arrays start at the thread next to the loaded end of the
/// screw. What the result does not define is absent, as is a number that is not finite. Absent
/// behind the last.
std::optional<Json> load_case_json(const Result& result, std::size_t k);

/// `places` behind those of contacts and loads.
std::vector<Place> with_loads(std::initializer_list<Place> places = {});
/// `places` behind those of contacts.
std::vector<Place> with_contacts(std::initializer_list<Place> places);

}  // namespace prs
