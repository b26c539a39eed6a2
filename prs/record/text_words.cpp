#include "prs/record/text_words.h"

#include <algorithm>
#include <utility>

namespace prs {

std::string words_of_text(std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> kWords[] = {
      {"flank_edge", "flank's edge"}, {"lemor", "Lemor's formula"}, {"given", "stated value"}};
  for (const auto& [known, words] : kWords)
    if (text == known) return std::string(words);
  std::string words(text);
  std::ranges::replace(words, '_', ' ');
  return words;
}

}  // namespace prs
