// REQUIRE_THROWS_MATCHES(call, quell::Error, failsWith(code, {"words", "of the message"})).
#pragma once

#include <catch2/catch.hpp>
#include <quell/error.hpp>
#include <string>
#include <vector>

namespace quell::tests {

/// Matches a quell::Error with this code whose message contains all of the words.
class ErrorMatcher : public Catch::MatcherBase<Error> {
 public:
  ErrorMatcher(ErrorCode code, std::vector<std::string> words) : m_code(code), m_words(std::move(words)) {}

  bool match(const Error& error) const override {
    const std::string message = error.what();
    for (const std::string& word : m_words)
      if (message.find(word) == std::string::npos) return false;
    return error.code() == m_code;
  }

  std::string describe() const override {
    std::string text = std::string("has code ") + quell::toString(m_code) + " and mentions";
    for (const std::string& word : m_words) text += " \"" + word + "\"";
    return text;
  }

 private:
  ErrorCode m_code;
  std::vector<std::string> m_words;
};

inline ErrorMatcher failsWith(ErrorCode code, std::vector<std::string> words = {}) {
  return ErrorMatcher(code, std::move(words));
}

}  // namespace quell::tests
