#include "core/io/heights/height_reading.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "core/city/building_heights.h"
#include "core/io/heights/height_text.h"

namespace noonmark {

namespace {

constexpr double maxLevels = 300;

// Reads the height of one feature; holds the state that its steps share.
class Reader {
public:
    Reader(const FeatureValues& values, const HeightRules& rules, const std::string& id, Warnings& warnings)
        : values_(values), rules_(rules), id_(id), warnings_(warnings) {}

    HeightReading read(bool canopy) {
        HeightReading reading;
        const auto groundM = ground();
        if (groundM) reading.groundElevationM = groundM->number;
        readTop(reading, canopy, groundM);
        auto bottom = underside(reading);
        if (!bottom) bottom = undersideOverGround(groundM);
        if (bottom && *bottom >= minHeightM) reading.bottomM = *bottom;
        if (reading.bottomM > reading.topM - minHeightM) settle(reading);
        if (canopy && !bottom) makeSlab(reading);
        return reading;
    }

private:
    using Check = bool (*)(double);
    struct Found {
        double number;
        std::string field;
    };

    void warn(const std::string& what, const std::string& where) {
        warnings_.push_back({WarningKind::assumed, what, where});
    }
    std::string placeOf(const FeatureValue& value) const {
        return fmt::format("{}: {} = \"{}\"", id_, value.field, value.text);
    }

    std::string formatText(const FeatureValue& value) const {
        return rules_.decimalComma ? withDecimalPoint(value.text) : value.text;
    }
    // The highest of a list of values, of which some may be missing.
    template <class Parse>
    static std::optional<double> highest(const std::vector<std::string>& list, const Parse& parse) {
        std::optional<double> highest;
        for (const std::string& item : list)
            if (const std::optional<double> number = parse(item))
                highest = std::max(highest.value_or(*number), *number);
        return highest;
    }
    std::optional<double> lengthOf(const FeatureValue& value) const {
        const auto parse = [&](const std::string& text) { return parseMetres(text, value.unit); };
        if (const auto list = splitCountedList(value.text); !list.empty()) return highest(list, parse);
        if (!value.number) return parse(formatText(value));
        if (!std::isfinite(*value.number)) return std::nullopt;
        return *value.number * metresPer(value.unit);
    }
    std::optional<double> levelsOf(const FeatureValue& value) const {
        const auto parse = [](const std::string& text) { return parseLevels(text); };
        if (const auto list = splitCountedList(value.text); !list.empty()) return highest(list, parse);
        if (!value.number) return parse(formatText(value));
        return std::isfinite(*value.number) ? value.number : std::nullopt;
    }

    // The first value of a role that can be read and passes `usable`; warns about the values before it.
    std::optional<Found> first(FieldRole role, Check usable, const char* unreadable, const char* unusable) {
        const bool storeys =
            role == FieldRole::levels || role == FieldRole::minLevel || role == FieldRole::roofLevels;
        for (const FeatureValue& value : values_) {
            if (value.role != role) continue;
            const auto number = storeys ? levelsOf(value) : lengthOf(value);
            if (number && usable(*number)) {
                if (!splitCountedList(value.text).empty())
                    warn("a list of values, as of the parts of a building; the highest is used",
                         placeOf(value));
                return Found{*number, value.field};
            }
            warn(number ? unusable : unreadable, placeOf(value));
        }
        return std::nullopt;
    }

    std::optional<Found> measured() {
        return first(
            FieldRole::height, [](double m) { return m >= minHeightM && m <= tallestBuildingM; },
            "a height that cannot be read; the next best source is used",
            "a height of zero or less, or over 2,000 m; the next best source is used");
    }
    std::optional<Found> overGround(const std::optional<Found>& groundM) {
        const auto top = first(
            FieldRole::topElevation,
            [](double m) { return m >= minLandM && m <= maxLandM + tallestBuildingM; },
            "a roof's elevation that cannot be read; the next best source is used",
            "a roof's elevation below -500 m or over 11,000 m; the next best source is used");
        if (top && !groundM) roofAlone_ = {top->number, top->field};
        if (!top || !groundM) return std::nullopt;
        const double heightM = top->number - groundM->number;
        const std::string origin = top->field + std::string(elevationsMinus) + groundM->field;
        if (heightM >= minHeightM && heightM <= tallestBuildingM) return Found{heightM, origin};
        warn("a roof that is not above its ground, or over 2,000 m; the next best source is used",
             fmt::format("{}: {} = {:g} m", id_, origin, heightM));
        return std::nullopt;
    }
    std::optional<Found> levels(FieldRole role) {
        return first(
            role, [](double count) { return count >= 0 && count <= maxLevels; },
            "a number of storeys that cannot be read; it is ignored",
            "a number of storeys below 0 or over 300; it is ignored");
    }
    std::optional<Found> fromLevels() {
        auto storeys = levels(FieldRole::levels);
        if (!storeys) return storeys;
        storeys->number = storeys->number * rules_.metresPerLevel + roof();
        return storeys->number >= minHeightM ? storeys : std::nullopt;
    }
    double roof() {
        Warnings unheard;  // not reported: an odd roof height has no effect worth a warning
        Reader quiet(values_, rules_, id_, unheard);
        const auto height = quiet.first(
            FieldRole::roofHeight, [](double m) { return m >= 0 && m < tallestBuildingM / 2; }, "", "");
        if (height) return height->number;
        const auto storeys = quiet.levels(FieldRole::roofLevels);
        return storeys ? storeys->number * rules_.metresPerLevel : 0;
    }

    void readTop(HeightReading& reading, bool canopy, const std::optional<Found>& groundM) {
        // Always read, so that its warnings appear even if a height exists
        const auto storeys = fromLevels();
        auto height = measured();
        if (!height) height = overGround(groundM);
        reading.byDefault = !height && !storeys;
        if (reading.byDefault) {
            reading.roof = roofAlone_;
            reading.topM = canopy ? rules_.metresPerLevel : rules_.defaultHeightM;
            return;
        }
        const Found& from = height ? *height : *storeys;
        reading.source = height ? HeightSource::measured : HeightSource::levels;
        reading.topM = from.number;
        reading.origin = from.field;
    }

    // What is not above the ground by half a metre stands on it.
    std::optional<double> undersideOverGround(const std::optional<Found>& groundM) {
        const auto bottom = first(
            FieldRole::bottomElevation, [](double m) { return m >= minLandM && m <= maxLandM; },
            "an underside's elevation that cannot be read; it is ignored",
            "an underside's elevation below -500 m or over 9,000 m; it is ignored");
        if (!bottom || !groundM || bottom->number - groundM->number < 0.5) return std::nullopt;
        return bottom->number - groundM->number;
    }

    // Counted in storeys, the underside is at most at the eaves of a measured height: what lies below a
    // storey of its own is below its roof.
    std::optional<double> underside(const HeightReading& reading) {
        const auto height = first(
            FieldRole::minHeight, [](double m) { return m >= 0 && m <= tallestBuildingM; },
            "a min_height that cannot be read; it is ignored",
            "a min_height below the ground or over 2,000 m; it is ignored");
        if (height) return height->number;
        const auto storeys = levels(FieldRole::minLevel);
        if (!storeys) return std::nullopt;
        const double countedM = storeys->number * rules_.metresPerLevel;
        const double eavesM = reading.topM - roof();
        const bool known = reading.source == HeightSource::measured && eavesM > 0 && eavesM < reading.topM;
        return known ? std::min(countedM, eavesM) : countedM;
    }

    void settle(HeightReading& reading) {
        if (reading.source == HeightSource::measured) {
            warn("its underside is not below its top; it is modelled from the ground to its top",
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
        warn(fmt::format("a roof without walls and without min_height; it is modelled as a slab {:g} m thick",
                         canopyThicknessM),
             id_);
    }

    std::optional<Found> ground() {
        return first(
            FieldRole::groundElevation, [](double m) { return m >= minLandM && m <= maxLandM; },
            "a ground elevation that cannot be read; it is ignored",
            "a ground elevation below -500 m or over 9,000 m; it is ignored");
    }

    const FeatureValues& values_;
    const HeightRules& rules_;
    const std::string& id_;
    Warnings& warnings_;
    std::optional<RoofElevation> roofAlone_ = {};
};

}  // namespace

HeightReading readHeights(const FeatureValues& values, const HeightRules& rules, bool canopy,
                          const std::string& featureId, Warnings& warnings) {
    return Reader(values, rules, featureId, warnings).read(canopy);
}

namespace {

// False if most heights are present.
bool manyLackHeights(const HeightOrigins& origins) {
    std::size_t all = 0;
    for (const auto& [origin, features] : origins) all += features;
    const auto without = origins.find("");
    return without != origins.end() && 10 * without->second > all;
}

// Heights that are outranked decide nothing; of the other roles the best field is read.
bool isUsed(const KnownField& field, const std::vector<KnownField>& fields, const HeightOrigins& origins) {
    const bool gaveHeights = std::ranges::any_of(origins, [&](const auto& origin) {
        const std::string& name = origin.first;
        return name == field.name || name.starts_with(field.name + std::string(elevationsMinus));
    });
    const FieldRole role = field.meaning.role;
    if (role == FieldRole::height || role == FieldRole::topElevation || role == FieldRole::levels)
        return gaveHeights;
    const auto best =
        std::ranges::find(fields, role, [](const KnownField& known) { return known.meaning.role; });
    return best->name == field.name;
}

bool stateHeights(const std::vector<KnownField>& fields) {
    return hasRole(fields, FieldRole::height) || hasRole(fields, FieldRole::levels) ||
           hasRole(fields, FieldRole::topElevation);
}

}  // namespace

void addHeightFacts(const HeightOrigins& origins, const std::vector<KnownField>& fields,
                    const UnknownFields& unknown, const std::string& file, HeightFacts& facts,
                    Warnings& warnings) {
    for (const auto& [origin, features] : origins) {
        auto field = findHeightField(fields, origin);
        if (origin.empty() || !field) continue;
        field->file = file;
        field->features = features;
        facts.fields.push_back(*std::move(field));
    }
    for (const KnownField& field : fields)
        if (!field.assumption.empty() && isUsed(field, fields, origins))
            warnings.push_back({WarningKind::assumed, field.assumption, file + ": " + field.name});
    if (!manyLackHeights(origins)) return;
    const std::vector<UnknownField> could = unknown.listPossibleHeights(file);
    if (!stateHeights(fields)) warnings.push_back(noKnownField(could, file));
    facts.unknown.insert(facts.unknown.end(), could.begin(), could.end());
}

}  // namespace noonmark
