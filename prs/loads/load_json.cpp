#include "prs/loads/load_json.h"

#include "prs/loads/contact_record.h"
#include "prs/loads/load_record.h"
#include "prs/loads/model_summary_record.h"

namespace prs {
namespace {

/// Documents of more cases leave the histories out.
constexpr std::size_t kMostHistories = 100;

std::vector<Place> joined(std::vector<Place> first, std::initializer_list<Place> others) {
  first.insert(first.end(), others);
  return first;
}

}  // namespace

void put_contacts(Json& document, const Contacts& contacts) {
  document["contact"] = object_of(contacts);
  if (Json threads = object_of(contacts.threads); !threads.empty())
    document["threads"] = std::move(threads);
}

void put_loads(Json& document, const Result& result) {
  if (result.contacts.threads.centre_distance > 0.0) put_contacts(document, result.contacts);
  const auto is_solved = [](const LoadCaseResult& load_case) {
    return load_case.solve.has_value();
  };
  if (std::ranges::any_of(result.load_cases, is_solved))
    document["model"] = object_of(ModelSummary{&result});
  document["load_cases"] = Json::array();
}

std::optional<Json> load_case_json(const Result& result, std::size_t k) {
  if (k >= result.load_cases.size()) return std::nullopt;
  Json json = object_of(result.load_cases[k]);
  if (result.load_cases.size() > kMostHistories) json.erase("newton_history");
  return json;
}

std::vector<Place> with_contacts(std::initializer_list<Place> places) {
  return joined(
      {{"contact", describe<Contacts>}, {"threads", describe<contact::MechanismGeometry>, false}},
      places);
}

std::vector<Place> with_loads(std::initializer_list<Place> places) {
  return joined({{"contact", describe<Contacts>, false},
                 {"threads", describe<contact::MechanismGeometry>, false},
                 {"model", describe<ModelSummary>, false},
                 {"load_cases[]", describe<LoadCaseResult>}},
                places);
}

}  // namespace prs
