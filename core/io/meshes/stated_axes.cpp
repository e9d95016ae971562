#include "core/io/meshes/stated_axes.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <fstream>

#include "core/base/units.h"

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

namespace {

constexpr std::size_t headBytes = 4096;
constexpr int maxHeaderLines = 100'000;

struct DxfUnit {
    int code;
    double metres;
    const char* name;
};
// Values of $INSUNITS that buildings are drawn in (Autodesk, "DXF Reference").
constexpr std::array dxfUnits{DxfUnit{1, metresPerFoot / 12, "inches"},
                              DxfUnit{2, metresPerFoot, "feet"},
                              DxfUnit{4, 0.001, "millimetres"},
                              DxfUnit{5, 0.01, "centimetres"},
                              DxfUnit{6, 1, "metres"},
                              DxfUnit{7, 1000, "kilometres"},
                              DxfUnit{10, 3 * metresPerFoot, "yards"},
                              DxfUnit{14, 0.1, "decimetres"},
                              DxfUnit{21, 1200.0 / 3937, "US survey feet"}};

std::string_view trimmedLine(std::string_view line) {
    constexpr const char* blanks = " \t\r";
    const auto first = line.find_first_not_of(blanks);
    return first == line.npos ? std::string_view()
                              : line.substr(first, line.find_last_not_of(blanks) - first + 1);
}

// The value of $INSUNITS in the header of a DXF; "" where it is absent.
std::string findInsUnits(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::string line;
    bool found = false;
    for (int i = 0; i < maxHeaderLines && std::getline(stream, line); ++i) {
        const std::string_view word = trimmedLine(line);
        if (word == "ENDSEC" || (found && word != "70" && !word.empty())) break;
        found = found || word == "$INSUNITS";
    }
    return found ? std::string(trimmedLine(line)) : std::string();
}

StatedAxes axesOfDxf(const std::filesystem::path& file) {
    const std::string code = findInsUnits(file);
    const auto unit =
        std::ranges::find_if(dxfUnits, [&](const DxfUnit& one) { return std::to_string(one.code) == code; });
    if (unit == dxfUnits.end()) return {};
    return {false, unit->metres, fmt::format("{} ($INSUNITS {})", unit->name, unit->code)};
}

}  // namespace

bool beginsIfc(std::string_view head) {
    return head.starts_with("ISO-10303-21") && head.find("IFC", head.find("FILE_SCHEMA")) != head.npos;
}

bool beginsDxf(std::string_view head) {
    if (head.starts_with("AutoCAD Binary DXF")) return true;
    const auto end = head.find('\n');
    if (end == head.npos) return false;
    const std::string_view first = trimmedLine(head.substr(0, end));
    head.remove_prefix(end + 1);
    const std::string_view second = trimmedLine(head.substr(0, head.find('\n')));
    return (first == "0" && second == "SECTION") || first == "999";  // 999: a comment
}

std::optional<StatedAxes> findStatedAxes(const std::filesystem::path& file) {
    std::string head(headBytes, '\0');
    std::ifstream stream(file, std::ios::binary);
    stream.read(head.data(), std::streamsize(head.size()));
    head.resize(std::size_t(stream.gcount()));
    if (head.starts_with('<') && head.find("<COLLADA") != head.npos)
        return StatedAxes{true, 1, "the file's own unit"};
    if (beginsIfc(head)) return StatedAxes{true, 1, "the file's own unit"};
    if (beginsDxf(head)) return axesOfDxf(file);
    return std::nullopt;
}

}  // namespace noonmark
