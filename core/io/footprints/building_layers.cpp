#include "core/io/footprints/building_layers.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/units.h"
#include "core/io/heights/height_text.h"
#include "core/io/heights/name_words.h"
#include "core/io/settings/read_settings.h"

namespace noonmark {

namespace {

constexpr std::size_t fewestCompared = 5;

double numberAt(const SampledFeature& feature, int index) {
    const auto i = std::size_t(index);
    return i < feature.numbers.size() ? feature.numbers[i] : SampledFeature::none;
}

double sampledMedian(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

// The median of a / b over the features that have both above 0; nothing if they are few, or if the quotients
// differ too much to be one relation: half of them by more than a third.
std::optional<double> findRatio(const LayerSample& sample, int a, int b) {
    std::vector<double> ratios;
    for (const SampledFeature& feature : sample.features)
        if (numberAt(feature, a) > 0 && numberAt(feature, b) > 0)
            ratios.push_back(numberAt(feature, a) / numberAt(feature, b));
    if (ratios.size() < fewestCompared) return std::nullopt;
    const double median = sampledMedian(ratios);
    for (double& ratio : ratios) ratio = std::abs(ratio - median);
    return sampledMedian(ratios) <= median / 3 ? std::optional(median) : std::nullopt;
}

// Pearson's correlation of the logarithms of a field and of the footprints' area.
bool growsWithArea(const LayerSample& sample, int index) {
    constexpr std::size_t fewestCorrelated = 20;
    constexpr double strong = 0.95;
    double n = 0, sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
    for (const SampledFeature& feature : sample.features) {
        const double value = numberAt(feature, index);
        if (!(value > 0) || !(feature.area > 0)) continue;
        const double x = std::log(value), y = std::log(feature.area);
        n += 1, sx += x, sy += y, sxx += x * x, syy += y * y, sxy += x * y;
    }
    const double spread = (n * sxx - sx * sx) * (n * syy - sy * sy);
    return n >= fewestCorrelated && spread > 0 && (n * sxy - sx * sy) / std::sqrt(spread) > strong;
}

// The median of the values above 0; nothing if they are few.
std::optional<double> medianAt(const LayerSample& sample, int index) {
    std::vector<double> values;
    for (const SampledFeature& feature : sample.features)
        if (const double value = numberAt(feature, index); value > 0 && std::isfinite(value))
            values.push_back(value);
    return values.size() < fewestCompared ? std::nullopt : std::optional(sampledMedian(std::move(values)));
}

const KnownField* fieldOfRole(const std::vector<KnownField>& fields, FieldRole role) {
    const auto found =
        std::ranges::find_if(fields, [&](const KnownField& field) { return field.meaning.role == role; });
    return found == fields.end() ? nullptr : &*found;
}

bool isBetween(double value, double minimum, double maximum) { return value >= minimum && value <= maximum; }

struct Finding {
    LengthUnit unit;
    std::string why;
};

// "height_in" where metres would make towers, inches make houses, and feet, whose name a table may have cut,
// would make towers, too.
std::optional<Finding> findInches(const KnownField& field, const LayerSample& sample) {
    if (!field.meaning.maybeInches) return std::nullopt;
    const std::optional<double> median = medianAt(sample, field.index);
    const double inch = metresPer(LengthUnit::inches);
    if (!median || isTypicalHeight(*median) || !isTypicalHeight(*median * inch)) return std::nullopt;
    if (isTypicalHeight(*median * metresPer(LengthUnit::feet))) return std::nullopt;
    return Finding{LengthUnit::inches,
                   fmt::format("its name ends in \"in\" and half of its values are over {:.4g}", *median)};
}

std::optional<Finding> findUnit(const KnownField& field, const std::vector<KnownField>& fields,
                                const LayerSample& sample) {
    if (const KnownField* storeys = fieldOfRole(fields, FieldRole::levels))
        if (const auto ratio = findRatio(sample, field.index, storeys->index))
            if (const auto unit = unitPerStorey(*ratio); unit && *unit != LengthUnit::metres)
                return Finding{
                    *unit, fmt::format("its values are {:.3g} for each storey of {}", *ratio, storeys->name)};
    for (const KnownField& other : fields) {
        if (other.meaning.role != FieldRole::height || other.index == field.index) continue;
        const double unitM = metresPer(other.meaning.unit.value_or(LengthUnit::metres));
        const auto ratio = findRatio(sample, field.index, other.index);
        if (const auto unit = ratio ? unitBeside(*ratio / unitM) : std::nullopt)
            return Finding{*unit, fmt::format("its values are {:.3g} times {}", *ratio, other.name)};
    }
    return findInches(field, sample);
}

bool repeatsStoreys(const KnownField& field, const std::vector<KnownField>& fields,
                    const LayerSample& sample) {
    const KnownField* const storeys = fieldOfRole(fields, FieldRole::levels);
    const auto ratio = storeys != nullptr ? findRatio(sample, field.index, storeys->index) : std::nullopt;
    return ratio && isBetween(*ratio, 0.95, 1.05);
}

void weighHeight(KnownField& field, const std::vector<KnownField>& all, const LayerSample& sample) {
    if (repeatsStoreys(field, all, sample)) {
        field.meaning = {FieldRole::levels, field.meaning.rank, {}, {}, {}};
        field.assumption = "its values repeat the storeys; they are counted as storeys, not as heights";
        return;
    }
    const auto found = findUnit(field, all, sample);
    if (!found) return;
    field.meaning.unit = found->unit;
    field.meaning.inFeetIn = {};
    field.assumption =
        fmt::format("no unit is stated; {} are assumed, since {}", entryOf(found->unit).plural, found->why);
}

}  // namespace

void weighHeights(std::vector<KnownField>& fields, const LayerSample& sample) {
    const std::vector<KnownField> all = fields;
    for (KnownField& field : fields)
        if (field.meaning.role == FieldRole::height && !field.meaning.unit) weighHeight(field, all, sample);
    std::ranges::stable_sort(fields, {}, [](const KnownField& field) {
        return std::pair(field.meaning.role, field.meaning.rank);
    });
}

std::vector<HeightDoubt> doubtHeights(const std::vector<KnownField>& fields, const LayerSample& sample,
                                      const std::string& file) {
    const KnownField* const field = fieldOfRole(fields, FieldRole::height);
    if (field == nullptr) return {};
    const std::optional<double> median = medianAt(sample, field->index);
    if (!median) return {};
    if (auto doubt = doubtUnit(*median, field->unit)) return {{file, field->name, *std::move(doubt)}};
    if (!field->meaning.maybeInches || field->unit != LengthUnit::metres) return {};
    return {{file, field->name,
             "its name breaks off before its unit, and metres are assumed; if its heights are feet: " +
                 readOption("height_unit", entryOf(LengthUnit::feet).key)}};
}

void dropRoofsAlone(std::vector<KnownField>& fields, const LayerSample& sample, const std::string& where,
                    Warnings& warnings) {
    constexpr double minBuildingM = 3;
    for (KnownField& field : fields) {
        if (field.meaning.role != FieldRole::height || field.meaning.meaning != heightOfRoof) continue;
        const auto median = medianAt(sample, field.index);
        if (!median || *median * metresPer(field.unit) >= minBuildingM) continue;
        field.meaning.role = FieldRole::roofHeight;
        warnings.push_back(
            {WarningKind::leftOut,
             fmt::format("the height of the roof alone, {:.3g} m at the median, which is not that "
                         "of the building",
                         *median * metresPer(field.unit)),
             where + ": " + field.name});
    }
}

FieldEvidence weighField(int index, const std::vector<KnownField>& fields, const LayerSample& sample) {
    FieldEvidence evidence;
    if (const KnownField* storeys = fieldOfRole(fields, FieldRole::levels))
        evidence.perStorey = findRatio(sample, index, storeys->index);
    evidence.followsFootprint = growsWithArea(sample, index);
    return evidence;
}

bool areOutlinesAtRoofs(const std::vector<KnownField>& fields, const LayerSample& sample) {
    const KnownField* const ground = fieldOfRole(fields, FieldRole::groundElevation);
    if (ground == nullptr) return false;
    std::vector<double> heights;
    for (const SampledFeature& feature : sample.features)
        if (const double over = feature.topZ - numberAt(feature, ground->index) * metresPer(ground->unit);
            std::isfinite(over) && std::abs(over) < 1000)
            heights.push_back(over);
    if (heights.size() < fewestCompared) return false;
    const auto above = std::ranges::count_if(heights, [](double heightM) { return heightM > 0; });
    return 10 * std::size_t(above) >= 9 * heights.size() && sampledMedian(heights) >= 2;
}

bool namesBuilding(const std::string& text) { return NameWords(text).has(NameWord::building); }

bool namesOtherLayer(const std::string& text) {
    return !namesBuilding(text) && NameWords(text).has(NameWord::otherLayer);
}

int findKindField(const std::vector<std::string>& names, const LayerSample& sample) {
    constexpr std::array<std::string_view, 6> kindNames{"type",       "featuretype", "objecttype",
                                                        "objectkind", "objekttyp",   "featurekind"};
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (std::ranges::find(kindNames, foldName(names[i])) == kindNames.end()) continue;
        std::size_t filled = 0, buildings = 0, others = 0;
        for (const SampledFeature& feature : sample.features) {
            if (i >= feature.texts.size() || feature.texts[i].empty()) continue;
            ++filled;
            buildings += namesBuilding(feature.texts[i]) ? 1 : 0;
            others += namesOtherLayer(feature.texts[i]) ? 1 : 0;
        }
        // Kinds of buildings ("garage", "school") say neither: then the field does not tell buildings from
        // others.
        if (buildings > 0 && others > 0 && buildings + others == filled) return int(i);
    }
    return -1;
}

}  // namespace noonmark
