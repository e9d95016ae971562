#include "core/io/footprints/unknown_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/io/heights/height_text.h"

namespace noonmark {

namespace {

constexpr double mostFeet = 4000;
constexpr std::size_t enoughDifferent = 1000;
constexpr std::size_t fewDifferent = 20;
constexpr std::size_t mostListed = 8;

// Words in names of fields that hold something else; a name is split where letters meet other characters.
constexpr std::array<std::string_view, 40> otherThings{
    "id",        "fid",     "oid",    "gid",        "objectid", "code",       "kod",       "num",
    "year",      "date",    "datum",  "area",       "areal",    "surface",    "shape",     "length",
    "perimeter", "leng",    "lat",    "lon",        "latitude", "longitude",  "x",         "y",
    "zip",       "volume",  "vol",    "angle",      "prinx",    "member",     "yearbuilt", "annee",
    "jahr",      "flaeche", "umfang", "superficie", "version",  "confidence", "precision", "accuracy"};

std::vector<std::string> wordsOfName(std::string_view name) {
    std::vector<std::string> words{""};
    for (const char c : name) {
        if (std::isalpha(static_cast<unsigned char>(c)) != 0)
            words.back() += char(std::tolower(static_cast<unsigned char>(c)));
        else if (!words.back().empty())
            words.emplace_back();
    }
    return words;
}

bool saysOtherwise(const std::string& field) {
    return std::ranges::any_of(wordsOfName(field), [](const std::string& word) {
        return std::ranges::find(otherThings, word) != otherThings.end();
    });
}

}  // namespace

void UnknownFields::add(const std::string& field, std::string_view text, std::optional<double> number) {
    if (!number) number = parseMetres(withDecimalPoint(text));
    Values& values = fields_[field];
    if (!number || !std::isfinite(*number)) {
        values.odd = true;
        return;
    }
    if (!(*number > 0)) return;  // 0 and -9999 mean "unknown"
    values.low = values.above0 == 0 ? *number : std::min(values.low, *number);
    values.high = std::max(values.high, *number);
    values.whole = values.whole && *number == std::floor(*number);
    ++values.above0;
    if (values.different.size() < enoughDifferent) values.different.insert(*number);
}

bool UnknownFields::couldBeHeights(const std::string& field, const Values& values) {
    if (values.odd || values.above0 == 0 || values.high > mostFeet || saysOtherwise(field)) return false;
    const bool years = values.whole && values.low >= 1500 && values.high <= 2200;
    const bool numbersThem = values.whole && values.above0 > 10 &&
                             values.different.size() == std::min<std::size_t>(values.above0, enoughDifferent);
    const bool codes = values.whole && values.low >= 100 && values.different.size() <= fewDifferent;
    const bool varies = values.low < values.high || values.above0 == 1;
    return varies && !years && !numbersThem && !codes;
}

std::vector<UnknownField> UnknownFields::thatCouldBeHeights(const std::string& file) const {
    std::vector<UnknownField> listed;
    for (const auto& [field, values] : fields_)
        if (couldBeHeights(field, values))
            listed.push_back({file, field, values.low, values.high, values.whole, values.above0});
    std::ranges::stable_sort(listed, std::greater<>{}, &UnknownField::features);
    if (listed.size() > mostListed) listed.resize(mostListed);
    return listed;
}

Warning noKnownField(const std::vector<UnknownField>& unknown, const std::string& file) {
    constexpr const char* none = "no field of heights or storeys is known";
    if (unknown.empty())
        return {WarningKind::assumed, fmt::format("{}, and none of its fields could be one", none), file};
    std::vector<std::string> words;
    for (const UnknownField& field : unknown) words.push_back(describe(field));
    return {
        WarningKind::assumed,
        fmt::format("{}; one of these could be, if you name it as the height field or the storeys field: {}",
                    none, fmt::join(words, ", ")),
        file};
}

}  // namespace noonmark
