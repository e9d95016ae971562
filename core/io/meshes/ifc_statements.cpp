#include "core/io/meshes/ifc_statements.h"

#include <algorithm>

namespace noonmark {

bool takeIfcStatement(std::streambuf& bytes, std::string& statement, std::size_t longest) {
    statement.clear();
    bool quoted = false;
    using Traits = std::streambuf::traits_type;
    for (auto c = bytes.sbumpc(); !Traits::eq_int_type(c, Traits::eof()); c = bytes.sbumpc()) {
        const char letter = Traits::to_char_type(c);
        if (letter == '\'') quoted = !quoted;
        if (letter == ';' && !quoted) return true;
        if (statement.size() < longest) statement += letter;
    }
    return false;
}

std::vector<std::string> ifcArguments(std::string_view statement) {
    std::vector<std::string> words{""};
    int depth = 0;
    bool quoted = false;
    for (const char c : statement.substr(std::min(statement.find('('), statement.size()))) {
        if (c == '\'') quoted = !quoted;
        if (!quoted && c == '(' && ++depth == 1) continue;
        if (!quoted && c == ')' && --depth == 0) break;
        if (!quoted && c == ',' && depth == 1)
            words.emplace_back();
        else
            words.back() += c;
    }
    return words;
}

std::string withoutIfcBlanks(std::string_view statement) {
    std::string plain;
    bool quoted = false;
    for (const char c : statement) {
        if (c == '\'') quoted = !quoted;
        if (quoted || (c != ' ' && c != '\t' && c != '\r' && c != '\n')) plain += c;
    }
    return plain;
}

}  // namespace noonmark
