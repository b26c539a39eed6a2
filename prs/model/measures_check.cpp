#include "prs/model/block_checks.h"
#include "prs/model/quantity_text.h"

namespace prs {

void check_measures(const MeasureOptions& m, Problems& problems) {
  if (!m.system || !m.system->shaft) return;
  const MeasureOptions::System::Shaft& shaft = *m.system->shaft;
  if (shaft.from_bearing && *shaft.from_bearing >= shaft.length)
    problems.add("measures.system.shaft.from_bearing",
                 "got {}; expected less than `length`, {}, between whose ends the loaded section "
                 "lies; change one of them",
                 mm(*shaft.from_bearing), mm(shaft.length));
}

}  // namespace prs
