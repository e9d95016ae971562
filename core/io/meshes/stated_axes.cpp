#include "core/io/meshes/stated_axes.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <utility>

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

namespace {

std::optional<double> ifcNumber(std::string_view text) {
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

double metresOfPrefix(std::string_view prefix) {
    constexpr std::array<std::pair<std::string_view, double>, 4> prefixes{
        {{".MILLI.", 0.001}, {".CENTI.", 0.01}, {".DECI.", 0.1}, {".KILO.", 1000}}};
    for (const auto& [name, metres] : prefixes)
        if (prefix == name) return metres;
    return 1;
}

}  // namespace

void IfcLengthUnit::take(const std::string& id, std::string_view body,
                         const std::vector<std::string>& words) {
    // Of models of a whole town there are some hundred; names of statements are numbers.
    constexpr std::size_t maxUnits = 10'000, maxName = 24;
    constexpr double minUnitM = 1e-6, maxUnitM = 1e6;
    if (id.size() > maxName || siM_.size() + conversions_.size() + measures_.size() > maxUnits) return;
    const bool isLength = words.size() > 2 && words[1] == ".LENGTHUNIT.";
    if (isLength && body.starts_with("IFCSIUNIT(")) siM_[id] = metresOfPrefix(words[2]);
    if (isLength && body.starts_with("IFCCONVERSIONBASEDUNIT(") && words.size() > 3 &&
        words[3].size() <= maxName)
        conversions_[id] = words[3];
    if (body.starts_with("IFCUNITASSIGNMENT(")) assigned_ = ifcArguments(words.front());
    if (!body.starts_with("IFCMEASUREWITHUNIT(") || words.size() < 2 || words[1].size() > maxName) return;
    const auto value = ifcNumber(ifcArguments(words[0]).front());
    if (value && *value >= minUnitM && *value <= maxUnitM) measures_[id] = {*value, words[1]};
}

std::optional<double> IfcLengthUnit::conversionM(const std::string& id) const {
    const auto conversion = conversions_.find(id);
    if (conversion == conversions_.end()) return std::nullopt;
    const auto measure = measures_.find(conversion->second);
    if (measure == measures_.end()) return std::nullopt;
    const auto si = siM_.find(measure->second.unit);
    return measure->second.value * (si == siM_.end() ? 1 : si->second);
}

double IfcLengthUnit::metres() const {
    for (const std::string& id : assigned_) {
        if (const auto si = siM_.find(id); si != siM_.end()) return si->second;
        if (const auto metres = conversionM(id)) return *metres;
    }
    return 1;
}

bool IfcLengthUnit::isConversion() const {
    return std::ranges::any_of(assigned_, [&](const std::string& id) { return conversionM(id).has_value(); });
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

// False at the end of the file, and at a line that is longer than those of a DXF may be.
bool takeShortLine(std::streambuf& bytes, std::string& line) {
    constexpr std::size_t longest = 65536;
    using Traits = std::streambuf::traits_type;
    line.clear();
    auto c = bytes.sbumpc();
    for (; !Traits::eq_int_type(c, Traits::eof()) && c != '\n'; c = bytes.sbumpc()) {
        if (line.size() == longest) return false;
        line += Traits::to_char_type(c);
    }
    return c == '\n' || !line.empty();
}

// The value of $INSUNITS in the header of a DXF; "" where it is absent.
std::string findInsUnits(const std::filesystem::path& file) {
    std::filebuf bytes;
    if (bytes.open(file, std::ios::in | std::ios::binary) == nullptr) return {};
    std::string line;
    bool found = false;
    for (int i = 0; i < maxHeaderLines && takeShortLine(bytes, line); ++i) {
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

IfcLengthUnit findIfcUnit(const std::filesystem::path& file) {
    constexpr std::size_t longestStatement = 4096;
    IfcLengthUnit unit;
    std::filebuf bytes;
    if (bytes.open(file, std::ios::in | std::ios::binary) == nullptr) return unit;
    for (std::string statement; takeIfcStatement(bytes, statement, longestStatement);) {
        // Most statements are points and lists of them.
        if (statement.find("UNIT") == statement.npos) continue;
        const std::string plain = withoutIfcBlanks(statement);
        const std::size_t equals = plain.find('=');
        if (equals == plain.npos) continue;
        const std::string body = plain.substr(equals + 1);
        unit.take(plain.substr(0, equals), body, ifcArguments(body));
    }
    return unit;
}

StatedAxes axesOfIfc(const std::filesystem::path& file) {
    const IfcLengthUnit unit = findIfcUnit(file);
    if (!unit.isConversion()) return {true, 1, "the file's own unit"};
    return {true, unit.metres(), fmt::format("units of {:.7g} m", unit.metres())};
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
    if (beginsIfc(head)) return axesOfIfc(file);
    if (beginsDxf(head)) return axesOfDxf(file);
    return std::nullopt;
}

}  // namespace noonmark
