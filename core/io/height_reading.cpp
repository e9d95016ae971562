#include "core/io/height_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/io/height_text.h"

namespace noonmark {

namespace {

constexpr double tallestM = 1200;
constexpr double mostLevels = 300;
constexpr double lowestGroundM = -500;
constexpr double highestGroundM = 9000;

// Reads one feature's values; holds what all of its steps need.
class Reader {
public:
    Reader(const FeatureValues& values, const HeightRules& rules, const std::string& id, Warnings& warnings)
        : values_(values), rules_(rules), id_(id), warnings_(warnings) {}

    HeightReading read(bool canopy) {
        HeightReading reading;
        readTop(reading, canopy);
        const auto bottom = underside();
        reading.bottomM = bottom.value_or(0);
        if (reading.bottomM >= reading.topM) settle(reading);
        if (canopy && !bottom) makeSlab(reading);
        reading.groundElevationM = ground();
        return reading;
    }

private:
    using Check = bool (*)(double);

    void warn(const std::string& what, const std::string& where) {
        warnings_.push_back({WarningKind::assumed, what, where});
    }
    std::string placeOf(const FeatureValue& value) const {
        return fmt::format("{}: {} = \"{}\"", id_, value.field, value.text);
    }

    static std::optional<double> lengthOf(const FeatureValue& value) {
        if (!value.number) return metresFromText(value.text, value.unit);
        if (!std::isfinite(*value.number)) return std::nullopt;
        return *value.number * metresPer(value.unit);
    }
    static std::optional<double> levelsOf(const FeatureValue& value) {
        if (!value.number) return levelsFromText(value.text);
        return std::isfinite(*value.number) ? value.number : std::nullopt;
    }

    // The first value of a role that can be read and passes `usable`; what does not is a warning.
    template <class Parse>
    std::optional<double> first(FieldRole role, Parse parse, Check usable, const char* unreadable,
                                const char* unusable) {
        for (const FeatureValue& value : values_) {
            if (value.role != role) continue;
            const auto number = parse(value);
            if (number && usable(*number)) return number;
            warn(number ? unusable : unreadable, placeOf(value));
        }
        return std::nullopt;
    }

    std::optional<double> measured() {
        return first(
            FieldRole::height, lengthOf, [](double m) { return m > 0 && m <= tallestM; },
            "a height that cannot be read; the next best source stands in",
            "a height of zero or less, or over 1,200 m; the next best source stands in");
    }
    std::optional<double> levels(FieldRole role) {
        return first(
            role, levelsOf, [](double count) { return count >= 0 && count <= mostLevels; },
            "a number of storeys that cannot be read; it is left out",
            "a number of storeys below 0 or over 300; it is left out");
    }
    std::optional<double> fromLevels() {
        const auto storeys = levels(FieldRole::levels);
        const double body = storeys.value_or(0) * rules_.metresPerLevel;
        if (!storeys || body + roof() <= 0) return std::nullopt;
        return body + roof();
    }
    double roof() {
        Warnings unheard;  // a roof's odd height matters to nobody
        Reader quiet(values_, rules_, id_, unheard);
        const auto height = quiet.first(
            FieldRole::roofHeight, lengthOf, [](double m) { return m >= 0 && m < tallestM / 2; }, "", "");
        return height ? *height : quiet.levels(FieldRole::roofLevels).value_or(0) * rules_.metresPerLevel;
    }

    void readTop(HeightReading& reading, bool canopy) {
        const auto storeys = fromLevels();  // asked first, so that what it cannot read is always said
        if (const auto height = measured()) {
            reading.topM = *height;
            reading.source = HeightSource::measured;
        } else if (storeys) {
            reading.topM = *storeys;
            reading.source = HeightSource::levels;
        } else {
            reading.topM = canopy ? rules_.metresPerLevel : rules_.defaultHeightM;
            reading.byDefault = true;
        }
    }

    std::optional<double> underside() {
        const auto height = first(
            FieldRole::minHeight, lengthOf, [](double m) { return m >= 0 && m <= tallestM; },
            "a min_height that cannot be read; it is left out",
            "a min_height below the ground or over 1,200 m; it is left out");
        if (height) return height;
        const auto storeys = levels(FieldRole::minLevel);
        if (!storeys) return std::nullopt;
        return *storeys * rules_.metresPerLevel;
    }

    void settle(HeightReading& reading) {
        if (reading.source == HeightSource::measured) {
            warn("its underside is not below its top; it is drawn from the ground to its top",
                 fmt::format("{}: {:g} m to {:g} m", id_, reading.bottomM, reading.topM));
            reading.bottomM = 0;
        } else {
            warn("its underside is above its guessed height; the height is counted from the underside",
                 fmt::format("{}: {:g} m and {:g} m", id_, reading.bottomM, reading.topM));
            reading.topM += reading.bottomM;
        }
    }

    void makeSlab(HeightReading& reading) {
        reading.bottomM = reading.topM - std::min(canopyThicknessM, reading.topM / 2);
        reading.slab = true;
        warn(fmt::format("a roof without walls and without min_height; it is a slab {:g} m thick",
                         canopyThicknessM),
             id_);
    }

    std::optional<double> ground() {
        return first(
            FieldRole::groundElevation, lengthOf,
            [](double m) { return m >= lowestGroundM && m <= highestGroundM; },
            "a ground elevation that cannot be read; it is left out",
            "a ground elevation below -500 m or over 9,000 m; it is left out");
    }

    const FeatureValues& values_;
    const HeightRules& rules_;
    const std::string& id_;
    Warnings& warnings_;
};

}  // namespace

HeightReading readHeights(const FeatureValues& values, const HeightRules& rules, bool canopy,
                          const std::string& featureId, Warnings& warnings) {
    return Reader(values, rules, featureId, warnings).read(canopy);
}

}  // namespace noonmark
