#include "prs/input/fail_at.h"

#include "prs/input/document.h"

namespace prs::input {

void fail_at(const Source& source, std::string_view path, std::string_view message) {
  ErrorList errors(source);
  errors.fail(locate(read_document(source, errors), path), path, message);
}

}  // namespace prs::input
