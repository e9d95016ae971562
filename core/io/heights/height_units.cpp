#include "core/io/heights/height_units.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/base/display_units.h"
#include "core/io/heights/height_text.h"
#include "core/io/settings/read_fields.h"

namespace noonmark {

namespace {

constexpr double minTypicalM = 2.5, maxTypicalM = 60;

struct PerStorey {
    double least, most;
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
        if (perStorey >= one.least && perStorey <= one.most) return one.unit;
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

}  // namespace noonmark
