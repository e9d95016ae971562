#include "core/io/heights/height_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "core/base/safe_text.h"
#include "core/base/units.h"
#include "core/io/files/readable_text.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

constexpr double minTypicalM = 2.5, maxTypicalM = 60;

struct PerStorey {
    double minimum, maximum;
    LengthUnit unit;
};
// 2.2 m in centimetres are more than most storeys in inches: there a storey is at most 5.5 m high.
constexpr std::array perStoreys{
    PerStorey{2.2, 6.5, LengthUnit::metres},      PerStorey{7.2, 21.5, LengthUnit::feet},
    PerStorey{22, 65, LengthUnit::decimetres},    PerStorey{87, 219, LengthUnit::inches},
    PerStorey{220, 650, LengthUnit::centimetres}, PerStorey{2200, 6500, LengthUnit::millimetres}};

// The units that would make a median typical, that nearest to a house of three storeys first.
std::vector<LengthUnit> findTypicalUnits(double median, LengthUnit readIn) {
    std::vector<LengthUnit> units;
    for (const PerStorey& one : perStoreys)
        if (one.unit != readIn && isTypicalHeight(median * metresPer(one.unit))) units.push_back(one.unit);
    std::ranges::sort(units, {}, [&](LengthUnit unit) {
        constexpr double houseM = 9;
        return std::abs(std::log(median * metresPer(unit) / houseM));
    });
    return units;
}

}  // namespace

std::optional<LengthUnit> unitPerStorey(double perStorey) {
    for (const PerStorey& one : perStoreys)
        if (perStorey >= one.minimum && perStorey <= one.maximum) return one.unit;
    return std::nullopt;
}

std::optional<LengthUnit> unitBeside(double ratio) {
    constexpr double tolerance = 0.04;
    for (const PerStorey& one : perStoreys)
        if (std::abs(ratio * metresPer(one.unit) - 1) <= tolerance && one.unit != LengthUnit::metres)
            return one.unit;
    return std::nullopt;
}

bool isTypicalHeight(double medianM) { return medianM >= minTypicalM && medianM <= maxTypicalM; }

std::optional<std::string> doubtUnit(double median, LengthUnit readIn) {
    const double readM = median * metresPer(readIn);
    if (readM <= maxTypicalM) return std::nullopt;
    std::vector<std::string> texts;
    for (const LengthUnit unit : findTypicalUnits(median, readIn))
        texts.push_back(fmt::format("{} ({:.3g} m: {})", entryOf(unit).plural, median * metresPer(unit),
                                    readOption("height_unit", entryOf(unit).key)));
    const std::string half = fmt::format("half of its heights are over {:.6g} m as they are read, in {}",
                                         readM, entryOf(readIn).plural);
    if (texts.empty()) return half + ", and no other unit makes them those of a town";
    return fmt::format("{}; they look like {}", half, fmt::join(texts, " or "));
}

namespace {

constexpr double inchM = 0.0254;

// Parses a folded text from the left; every function consumes what it recognises and leaves the rest.
class TextReader {
public:
    explicit TextReader(std::string_view text) : rest_(text) {}

    [[nodiscard]] bool atEnd() const { return rest_.empty(); }

    void skipBlanks() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }

    bool take(std::string_view word) {
        if (!rest_.starts_with(word)) return false;
        rest_.remove_prefix(word.size());
        return true;
    }

    // "12", "12.5", "50.", ".05": no sign, no exponent, no thousands separators.
    std::optional<double> takeNumber() {
        const std::size_t length = std::min(rest_.find_first_not_of("0123456789."), rest_.size());
        const std::string_view digits = rest_.substr(0, length);
        if (!std::any_of(digits.begin(), digits.end(), isDigit)) return std::nullopt;
        double value = 0;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + length, value, std::chars_format::fixed);
        if (error != std::errc() || end != digits.data() + length) return std::nullopt;
        rest_.remove_prefix(length);
        return value;
    }

    // The letters or marks of a unit, with a closing dot.
    std::string_view takeUnit() {
        const auto isUnit = [](char c) { return (c >= 'a' && c <= 'z') || c == '\'' || c == '"'; };
        const auto end = std::find_if_not(rest_.begin(), rest_.end(), isUnit);
        const std::string_view unit = rest_.substr(0, std::size_t(end - rest_.begin()));
        rest_.remove_prefix(unit.size());
        if (!unit.empty()) take(".");
        return unit;
    }

private:
    std::string_view rest_;
};

struct UnitName {
    std::string_view name;
    double metres;
};
constexpr std::array unitNames{
    UnitName{"m", 1},
    UnitName{"meter", 1},
    UnitName{"meters", 1},
    UnitName{"metre", 1},
    UnitName{"metres", 1},
    UnitName{"cm", 0.01},
    UnitName{"centimeter", 0.01},
    UnitName{"centimeters", 0.01},
    UnitName{"centimetre", 0.01},
    UnitName{"centimetres", 0.01},
    UnitName{"dm", 0.1},
    UnitName{"mm", 0.001},
    UnitName{"km", 1000},
    UnitName{"ft", metresPerFoot},
    UnitName{"foot", metresPerFoot},
    UnitName{"feet", metresPerFoot},
    UnitName{"'", metresPerFoot},
    UnitName{"in", inchM},
    UnitName{"inch", inchM},
    UnitName{"inches", inchM},
    UnitName{"\"", inchM},
    UnitName{"''", inchM},
};

std::optional<double> metresOf(std::string_view unit) {
    for (const UnitName& known : unitNames)
        if (known.name == unit) return known.metres;
    return std::nullopt;
}

// The inches after feet: "4\"", "11 in". 0 if the text ends; nothing if something else follows.
std::optional<double> takeInches(TextReader& reader) {
    TextReader ahead = reader;
    ahead.skipBlanks();
    const auto inches = ahead.takeNumber();
    if (!inches) return 0.0;
    ahead.skipBlanks();
    if (metresOf(ahead.takeUnit()) != inchM || *inches >= 12) return std::nullopt;
    reader = ahead;
    return *inches * inchM;
}

std::optional<double> takeLength(TextReader& reader, double bareUnitM) {
    const bool negative = reader.take("-");
    if (!negative) reader.take("+");
    const auto number = reader.takeNumber();
    if (!number) return std::nullopt;
    reader.skipBlanks();
    const std::string_view unit = reader.takeUnit();
    const auto unitM = unit.empty() ? std::optional(bareUnitM) : metresOf(unit);
    if (!unitM) return std::nullopt;
    const bool feet = !unit.empty() && *unitM == metresPerFoot;
    const auto inches = feet ? takeInches(reader) : std::optional(0.0);
    if (!inches) return std::nullopt;
    const double metres = *number * *unitM + *inches;
    return negative ? -metres : metres;
}

// "4.60m (15'1\")": the same height repeated in another unit. Tolerance 5 %: people round to whole feet.
bool repeats(TextReader& reader, double metres, double bareUnitM) {
    if (!reader.take("(")) return false;
    const auto again = takeLength(reader, bareUnitM);
    reader.skipBlanks();
    return again && reader.take(")") && std::abs(*again - metres) <= 0.05 * std::abs(metres);
}

}  // namespace

std::optional<double> parseMetres(std::string_view text, LengthUnit bareUnit) {
    const std::string folded = foldText(text);
    TextReader reader(folded);
    const auto metres = takeLength(reader, metresPer(bareUnit));
    if (!metres) return std::nullopt;
    reader.skipBlanks();
    if (!reader.atEnd() && !repeats(reader, *metres, metresPer(bareUnit))) return std::nullopt;
    return reader.atEnd() ? metres : std::nullopt;
}

std::vector<std::string> splitCountedList(std::string_view text) {
    const std::size_t colon = text.find(':');
    const bool isList = text.starts_with('(') && colon != text.npos && colon > 1 &&
                        std::all_of(text.begin() + 1, text.begin() + std::ptrdiff_t(colon), isDigit);
    if (!isList) return {};
    const bool isWhole = text.ends_with(')');
    text.remove_prefix(colon + 1);
    if (isWhole) text.remove_suffix(1);
    std::vector<std::string> values;
    for (std::size_t comma = text.find(','); comma != text.npos; comma = text.find(',')) {
        values.emplace_back(text.substr(0, comma));
        text.remove_prefix(comma + 1);
    }
    if (isWhole && !text.empty()) values.emplace_back(text);
    return values;
}

std::string withDecimalPoint(std::string_view text) {
    std::string pointed(text);
    const auto comma = pointed.find(',');
    if (comma == pointed.npos || pointed.find(',', comma + 1) != pointed.npos) return pointed;
    if (pointed.find('.') != pointed.npos || comma == 0 || !isDigit(pointed[comma - 1])) return pointed;
    const auto decimals = pointed.find_first_not_of("0123456789", comma + 1);
    const std::size_t count = std::min(decimals, pointed.size()) - (comma + 1);
    if (count > 0 && count != 3) pointed[comma] = '.';
    return pointed;
}

namespace {

// "5R", "12RC": so many storeys of concrete, as Taiwan's and Japan's maps write them. Longest first.
std::string_view withoutStructure(std::string_view text) {
    constexpr std::array<std::string_view, 9> structures{"SRC", "RC", "SS", "R", "S", "B", "W", "M", "T"};
    for (const std::string_view structure : structures)
        if (text.size() > structure.size() && text.ends_with(structure)) {
            const std::string_view count = text.substr(0, text.size() - structure.size());
            return count.find_first_not_of("0123456789") == count.npos ? count : text;
        }
    return text;
}

}  // namespace

std::optional<double> parseLevels(std::string_view text) {
    const std::string folded = foldText(withoutStructure(text));
    TextReader reader(folded);
    const auto levels = reader.takeNumber();
    return reader.atEnd() ? levels : std::nullopt;
}

}  // namespace noonmark
