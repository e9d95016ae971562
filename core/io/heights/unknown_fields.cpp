#include "core/io/heights/unknown_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/io/heights/field_roles.h"
#include "core/io/heights/height_text.h"
#include "core/io/heights/name_words.h"

namespace noonmark {

namespace {

constexpr std::size_t enoughDifferent = 1000;
constexpr std::size_t fewDifferent = 20;
constexpr std::size_t maxListed = 8;

constexpr double maxStoreys = 170;  // of any building, with some to spare

bool namesOtherThing(const std::string& field) {
    const NameWords words(field);
    if (words.has(NameWord::otherThing)) return true;
    const bool height = words.has(NameWord::height) || words.has(NameWord::storey);
    return !height && (words.has(NameWord::count) || words.has(NameWord::otherLayer));
}

// Names that say what they are come first.
bool namesHeights(const UnknownField& field) {
    const NameWords words(field.field);
    return words.has(NameWord::height) || words.has(NameWord::storey);
}

struct KindByStorey {
    FieldKind kind;
    std::string_view unit;  // as --height-unit takes it; empty: metres
};

std::optional<KindByStorey> findKindByStorey(const FieldEvidence& evidence) {
    if (!evidence.perStorey) return std::nullopt;
    if (*evidence.perStorey >= 0.85 && *evidence.perStorey <= 1.2)
        return KindByStorey{FieldKind::storeys, ""};
    const auto unit = unitPerStorey(*evidence.perStorey);
    if (!unit) return std::nullopt;
    return KindByStorey{FieldKind::heights, *unit == LengthUnit::metres ? "" : entryOf(*unit).key};
}

bool isRoofElevation(const std::string& field) {
    const auto meaning = findMeaning(field);
    return meaning && meaning->role == FieldRole::topElevation;
}

std::string unitInName(const NameWords& words) {
    const auto unit = unitOfWords(words);
    return unit && *unit != LengthUnit::metres ? std::string(entryOf(*unit).key) : "";
}

// Names that say height may be in any unit.
double mostOf(const std::string& field) {
    constexpr double maxFeet = 4000, maxMillimetres = 1e6;
    return NameWords(field).has(NameWord::height) ? maxMillimetres : maxFeet;
}

}  // namespace

void UnknownFields::add(const std::string& field, std::string_view text, std::optional<double> number) {
    const bool code = !number && text.size() > 1 && text[0] == '0' && text[1] >= '0' && text[1] <= '9';
    if (!number) number = parseMetres(withDecimalPoint(text));
    Values& values = fields_[field];
    if (code || !number || !std::isfinite(*number)) {
        values.odd = true;
        return;
    }
    if (!(*number > 0)) return;  // 0 and -9999 mean "unknown"
    values.low = values.above0 == 0 ? *number : std::min(values.low, *number);
    values.high = std::max(values.high, *number);
    values.whole = values.whole && *number == std::floor(*number);
    values.halves = values.halves && 2 * *number == std::floor(2 * *number);
    ++values.above0;
    if (values.different.size() < enoughDifferent) values.different.insert(*number);
}

FieldEvidence UnknownFields::evidenceOf(const std::string& field) const {
    const auto found = evidence_.find(field);
    return found == evidence_.end() ? FieldEvidence() : found->second;
}

bool UnknownFields::couldBeHeights(const std::string& field, const Values& values) const {
    if (values.odd || values.above0 == 0 || values.high > mostOf(field) || namesOtherThing(field))
        return false;
    const bool years = values.whole && values.low >= 1500 && values.high <= 2200;
    const bool numbersThem = values.whole && values.above0 > 10 &&
                             values.different.size() == std::min<std::size_t>(values.above0, enoughDifferent);
    const bool codes = values.whole && values.low >= 100 && values.different.size() <= fewDifferent;
    const bool varies = values.low < values.high || values.above0 == 1;
    const NameWords words(field);
    const bool ofOneStorey = words.has(NameWord::height) && words.has(NameWord::storey) && !values.halves &&
                             values.low >= 2 && values.high <= 6.5;
    return varies && !years && !numbersThem && !codes && !ofOneStorey && !evidenceOf(field).followsFootprint;
}

// The name decides; where it says nothing or both, storeys of another field, then the values alone.
UnknownField UnknownFields::describeField(const std::string& file, const std::string& field,
                                          const Values& values) const {
    const NameWords words(field);
    UnknownField described{file, field, values.low, values.high, values.whole, values.above0};
    const bool height = words.has(NameWord::height), storey = words.has(NameWord::storey);
    const auto byStorey = findKindByStorey(evidenceOf(field));
    described.unit = unitInName(words);
    if (words.has(NameWord::elevation) || isRoofElevation(field))
        described.kind = FieldKind::elevations;
    else if (field == outlineZ || height != storey)
        described.kind = field == outlineZ || height ? FieldKind::heights : FieldKind::storeys;
    else if (byStorey)
        described.kind = byStorey->kind;
    else if (storey && values.halves && values.high <= maxStoreys)
        described.kind = FieldKind::storeys;
    else if (!values.whole || values.high > maxStoreys)
        described.kind = FieldKind::heights;
    const bool bare = described.kind == FieldKind::heights && described.unit.empty();
    if (bare && byStorey && byStorey->kind == FieldKind::heights) described.unit = byStorey->unit;
    return described;
}

std::vector<UnknownField> UnknownFields::listPossibleHeights(const std::string& file) const {
    std::vector<UnknownField> listed;
    for (const auto& [field, values] : fields_)
        if (couldBeHeights(field, values)) listed.push_back(describeField(file, field, values));
    std::ranges::stable_sort(listed, std::greater<>{}, [](const UnknownField& field) {
        return std::pair(namesHeights(field), field.features);
    });
    if (listed.size() > maxListed) listed.resize(maxListed);
    return listed;
}

Warning noKnownField(const std::vector<UnknownField>& unknown, const std::string& file) {
    if (unknown.empty())
        return {WarningKind::assumed, fmt::format("{}, and none of its fields could be one", noFieldKnown),
                file};
    std::vector<std::string> words;
    for (const UnknownField& field : unknown) words.push_back(describe(field));
    return {
        WarningKind::assumed,
        fmt::format("{}; one of these could be, if you name it as the height field or the storeys field: {}",
                    noFieldKnown, fmt::join(words, ", ")),
        file};
}

}  // namespace noonmark
