#include "core/base/csv_field.h"

namespace noonmark {

std::string disarmFormula(const std::string& text) {
    if (text.empty()) return text;
    const bool begins = text.front() == '=' || text.front() == '@' || text.front() == '\t';
    // What begins with a sign harms only if it calls a function or a program, or refers to other cells.
    const bool calls =
        (text.front() == '+' || text.front() == '-') && text.find_first_of("(|!") != std::string::npos;
    return begins || calls ? "'" + text : text;
}

std::string quoteField(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char letter : text) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + '"';
}

std::string csvField(const std::string& text) { return quoteField(disarmFormula(text)); }

}  // namespace noonmark
