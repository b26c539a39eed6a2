#pragma once

#include "prs/report/tables.h"

namespace prs {

/// A text that leads to the meaning of a word in the glossary of the page.
std::string term_html(std::string_view word, std::string_view shown);

/// Whether the glossary has the word on every page.
bool is_general_term(std::string_view title);

/// Meanings of words of the field and of the quantities that these records have, in alphabetical order.
std::string glossary_html(const std::vector<std::pair<const RecordInfo*, const Json*>>& records);

}  // namespace prs
