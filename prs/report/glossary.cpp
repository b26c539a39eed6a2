#include "prs/report/glossary.h"

#include <cctype>
#include <map>
#include <regex>
#include <set>

#include "prs/indices.h"
#include "prs/report/findings.h"
#include "prs/text.h"

namespace prs {

std::string_view glossary_text();  // docs/glossary.md

namespace {

struct Term {
  std::vector<std::string> words;  ///< Words in one row: `lead`, `pitch`, `starts`.
  std::string meaning;
};

/// Rows of the tables of docs/glossary.md; links to other documents, which a page does not have, are left out.
const std::vector<Term>& general_terms() {
  static const std::vector<Term> all = [] {
    static const std::regex kRow(R"(\n\| (?!word |---)([^|\n]*) \| ([^|\n]*) \|)"), kComma(", "),
        kLink(R"( ?\[[^\]]*\.md\]\([^)]*\))"), kNamedLink(R"(\[([^\]]*)\]\([^)]*\))");
    const std::string text(glossary_text());
    std::vector<Term> terms;
    for (std::sregex_iterator row(text.begin(), text.end(), kRow), end; row != end; ++row) {
      const std::string words = (*row)[1];
      Term& term = terms.emplace_back();
      term.meaning = std::regex_replace(std::regex_replace((*row)[2].str(), kLink, ""), kNamedLink, "$1");
      for (std::sregex_token_iterator word(words.begin(), words.end(), kComma, -1), last; word != last; ++word)
        term.words.push_back(capitalised(*word));
    }
    return terms;
  }();
  return all;
}

std::string term_id(std::string_view word) {
  std::string id = "term-";
  for (const char c : word)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      id += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    else if (id.back() != '-')
      id += '-';
  return id;
}

using Meanings = std::map<std::string, std::vector<std::string>>;

/// Adds the quantities that a record of a document has.
void add_quantities(const RecordInfo& info, const Json& record, Meanings& meanings) {
  for (const QuantityInfo& q : info.quantities) {
    const Json& value = under(record, std::string(q.key));
    if (value.is_null()) continue;
    if (q.kind == Kind::record && q.unit.empty()) add_quantities(q.record(), value, meanings);
    std::vector<std::string>& known = meanings[capitalised(q.title)];
    if (std::string meaning(q.meaning); !meaning.empty() && !contains(known, meaning))
      known.push_back(std::move(meaning));
  }
}

}  // namespace

std::string term_html(std::string_view word, std::string_view shown) {
  return fmt::format("<a class=\"term\" href=\"#{}\">{}</a>", term_id(word), prose_html(shown));
}

bool is_general_term(std::string_view title) {
  return std::ranges::any_of(general_terms(), [&](const Term& term) { return contains(term.words, title); });
}

std::string glossary_html(const std::vector<std::pair<const RecordInfo*, const Json*>>& records) {
  Meanings meanings;
  for (const auto& [info, record] : records) add_quantities(*info, *record, meanings);
  std::map<std::string, std::string> entries;  // By the order of their words.
  std::set<std::string> ids;
  const auto add = [&](const std::string& word, const std::string& meaning) {
    if (meaning.empty() || !ids.insert(term_id(word)).second) return;
    std::string order = word;
    std::ranges::transform(order, order.begin(), [](unsigned char c) { return std::tolower(c); });
    entries[order] = fmt::format("<dt id=\"{}\">{}</dt><dd>{}</dd>\n", term_id(word), prose_html(word), meaning);
  };
  for (const Term& term : general_terms())
    for (const std::string& word : term.words) {
      std::string meaning = prose_html(term.meaning);
      if (const auto own = meanings.find(word); own != meanings.end())
        for (const std::string& more : own->second)
          meaning += fmt::format("</dd><dd>{}", prose_html(capitalised(more)));
      add(word, meaning);
    }
  for (const auto& [word, known] : meanings) {
    std::string meaning;
    for (const std::string& one : known)
      meaning += fmt::format("{}{}", meaning.empty() ? "" : "</dd><dd>", prose_html(capitalised(one)));
    add(word, meaning);
  }
  std::string text = "<dl class=\"terms\">\n";
  for (const auto& [order, entry] : entries) text += entry;
  return folded_html(fmt::format("{} words and quantities", entries.size()), text + "</dl>\n");
}

}  // namespace prs
