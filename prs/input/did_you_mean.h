#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace prs::input {

/// "did you mean `WORD`?" with the known word of most similar spelling; empty if no word is similar.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known);

/// Known words of most similar spelling: the nearest first, then those within two letters of it, at most three.
std::vector<std::string_view> near_words(std::string_view word, const std::vector<std::string_view>& known);

}  // namespace prs::input
