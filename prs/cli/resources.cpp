#include "prs/cli/resources.h"

#include "prs/sector/influence/matrix_cache.h"

#include "prs/components/components.h"

namespace prs::cli {

void open_matrix_cache(bool quiet) {
  shared_matrix_cache().keep_in(cache_directory());
  shared_matrix_cache().report_to([line = std::make_shared<ProgressLine>(quiet)](bool working, int computed) {
    if (working)
      line->tell(fmt::format("matrices of `influence`: {} made; a screw has about ten", computed));
    else
      line->clear();
  });
}

void require_png() { modules::loaded<PictureModule>(); }

std::string matrix_cache_refusal() { return shared_matrix_cache().refusal(); }

}  // namespace prs::cli
