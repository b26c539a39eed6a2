#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace prs::input {

/// "did you mean `WORD`?" of the known word that is spelled most alike; empty where none is.
std::string did_you_mean(std::string_view word, const std::vector<std::string_view>& known);

/// The known words that are spelled most alike: the nearest first, then those within two letters of
/// it, three at most.
std::vector<std::string_view> near_words(std::string_view word, const std::vector<std::string_view>& known);

}  // namespace prs::input
