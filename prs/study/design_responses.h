#pragma once

#include "prs/input/force_history.h"
#include "prs/measures/measures_analysis.h"
#include "prs/mechanism/full_distribution.h"
#include "prs/slip/slip.h"
#include "prs/study/design_reader.h"
#include "prs/study/recorded.h"
#include "prs/study/response.h"
#include "prs/threads/contact_batch.h"

namespace prs {

/// Results of batches besides loads and approaches, and whether load cases have their modes.
struct NumberDetail {
  LoadDetail loads;
  SlipDetail slip;
  bool modes = true;
};

/// Runs `compute` and returns the reason if it stopped.
template <class Compute>
DesignStatus status_after(Compute compute) {
  try {
    return compute();
  } catch (const input::InputError& error) {
    return {"refused", error.what()};
  } catch (const CaseError& error) {
    return {"refused", error.problem().text()};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return {"failed", error.what()};
  }
}

/// Responses of a study, and how one design gets them: as numbers of its results or, where one of them is none, from
/// its document. After the base case is known it is only read, from any thread.
struct DesignResponses {
  explicit DesignResponses(const input::StudyInput& given) : input(given), study(given.study) {}

  const input::StudyInput& input;
  Study study;
  std::optional<std::vector<ResultNumber>> numbers;
  std::vector<std::size_t> load_cases;                 ///< Load cases that the numbers need.
  bool needs_duty = false;                             ///< Whether one of the numbers, or temperatures, is of a duty.
  NumberDetail number_detail;                          ///< Load-case data for the numbers.
  Detail detail = Detail::numbers;                     ///< Detail of the results for the numbers.
  ContactDetail contact_detail = ContactDetail::laws;  ///< Detail of the contacts for the numbers.
  bool of_references = false;                          ///< Whether deviations of references are recorded.
  std::optional<LoadHistory> history;                  ///< History of the base case.
  std::optional<HistorySource> history_source;

  /// Memory of a thread.
  struct Memory {
    FullSolver full;
    std::vector<LoadCase> load_cases;
  };

  bool measures() const { return study.command == Command::measures; }

  /// Reads the history of the base case, if lives need it.
  void keep_history(const Case& base);

  /// The document of a case and its source; `document` is unchanged where there is none.
  DesignStatus by_document(const Case& c, const input::Source& source, Json& document) const;

  /// Chooses the responses to record, the numbers and what they need, from the base case and its document (null where
  /// it has no answer). Throws UnknownResponse.
  void choose(const std::optional<Case>& base, const Json& document, Arrays arrays);

  /// Sets the row of a design that is solved alone, the last one of its reader. `found`: its contacts, where they are
  /// known.
  DesignStatus answer(Case& c, const DesignReader& reader, Memory& memory, double* row,
                      const Contacts* found = nullptr) const;

  /// Sets the numbers of a row. `known`: all that does not depend on the load case.
  void set_numbers(double* row, const Answer& known, const std::vector<LoadCaseResult>& results = {},
                   const std::vector<std::optional<LoadMeasures>>& load_measures = {}) const;
  void set_numbers(double* row, const MeasuresResult& result) const;

 private:
  std::optional<LoadHistory> history_of(const Case& c) const;
  template <class Use>
  DesignStatus with_lives(const Case& c, Use use) const;
  Json document_with_references(const Case& c, const input::Source& source, Result result) const;
};

}  // namespace prs
