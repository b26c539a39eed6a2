#include <string>

#include "prs/engine/engine.h"

/// `prs::answer` for JavaScript: a question in UTF-8, zero-terminated. The answer is valid until the next question.
extern "C" __attribute__((export_name("prs_answer"))) const char* prs_answer(const char* question) {
  static std::string answer;
  answer.clear();
  answer.shrink_to_fit();
  answer = prs::answer(question);
  return answer.c_str();
}
