#pragma once

#include <string>

namespace noonmark {

/// A text as one word of a POSIX shell: unchanged if a shell cannot misread it, else in single quotes.
std::string quoteForShell(const std::string& text);

}  // namespace noonmark
