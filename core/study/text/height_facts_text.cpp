#include "core/study/text/height_facts_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/json_number.h"
#include "core/base/safe_text.h"
#include "core/city/terrain/building_ground.h"
#include "core/describe/text.h"
#include "core/io/heights/unknown_fields.h"
#include "core/io/pieces/read_part.h"
#include "core/io/read_city.h"
#include "core/sun/zone_country.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

namespace {

Amount countAmount(std::size_t count) { return {double(count), FigureUnit::none, 0}; }

HeightField heightFieldFrom(const Json& json) {
    return {json.at("file").get<std::string>(), json.at("field").get<std::string>(),
            json.at("meaning").get<std::string>(), json.at("unit").get<std::string>(),
            wholeNumberFrom<std::size_t>(json.at("features"))};
}

constexpr std::array<std::string_view, 4> kindNames{"heights", "storeys", "elevations", "either"};

// Without a kind in what older versions wrote.
FieldKind kindFrom(const Json& json) {
    const auto found = std::ranges::find(kindNames, json.value("kind", std::string("either")));
    return found == kindNames.end() ? FieldKind::either : FieldKind(found - kindNames.begin());
}

UnknownField unknownFieldFrom(const Json& json) {
    return {json.at("file").get<std::string>(),
            json.at("field").get<std::string>(),
            json.at("low").get<double>(),
            json.at("high").get<double>(),
            json.at("whole").get<bool>(),
            wholeNumberFrom<std::size_t>(json.at("features")),
            kindFrom(json),
            json.value("unit", "")};
}

HeightDoubt heightDoubtFrom(const Json& json) {
    return {json.at("file").get<std::string>(), json.at("field").get<std::string>(),
            json.at("why").get<std::string>()};
}

BaseFit baseFitFrom(const Json& json) {
    return {.file = json.at("file").get<std::string>(),
            .buildings = wholeNumberFrom<std::size_t>(json.at("buildings")),
            .gapM = json.at("gap_m").get<double>(),
            .spreadM = json.at("spread_m").get<double>(),
            .rule = parseStandRule(json.at("rule").get<std::string>()).value(),
            .aloft = wholeNumberFrom<std::size_t>(json.at("aloft")),
            .apart = wholeNumberFrom<std::size_t>(json.at("apart"))};
}

Json baseFitJson(const BaseFit& fit) {
    return {{"file", fit.file},        {"buildings", fit.buildings}, {"gap_m", fit.gapM},
            {"spread_m", fit.spreadM}, {"rule", nameOf(fit.rule)},   {"aloft", fit.aloft},
            {"apart", fit.apart},      {"text", describe(fit)}};
}

}  // namespace

Json heightFactsJson(const HeightFacts& facts) {
    Json json;
    json["fields"] = Json::array();
    for (const HeightField& field : facts.fields)
        json["fields"].push_back({{"file", field.file},
                                  {"field", field.field},
                                  {"meaning", field.meaning},
                                  {"unit", field.unit},
                                  {"features", field.features}});
    json["could_be"] = Json::array();
    for (const UnknownField& field : facts.unknown)
        json["could_be"].push_back({{"file", field.file},
                                    {"field", field.field},
                                    {"low", field.low},
                                    {"high", field.high},
                                    {"whole", field.whole},
                                    {"features", field.features},
                                    {"kind", kindNames[std::size_t(field.kind)]},
                                    {"unit", field.unit}});
    json["doubts"] = Json::array();
    for (const HeightDoubt& doubt : facts.doubts)
        json["doubts"].push_back({{"file", doubt.file}, {"field", doubt.field}, {"why", doubt.why}});
    json["bases"] = Json::array();
    for (const BaseFit& fit : facts.bases) json["bases"].push_back(baseFitJson(fit));
    return json;
}

std::optional<HeightFacts> parseHeightFacts(const std::string& text) try {
    const Json json = Json::parse(text);
    HeightFacts facts;
    for (const Json& field : json.at("fields")) facts.fields.push_back(heightFieldFrom(field));
    for (const Json& field : json.at("could_be")) facts.unknown.push_back(unknownFieldFrom(field));
    if (json.contains("doubts"))
        for (const Json& doubt : json.at("doubts")) facts.doubts.push_back(heightDoubtFrom(doubt));
    if (json.contains("bases"))  // older files have none
        for (const Json& fit : json.at("bases")) facts.bases.push_back(baseFitFrom(fit));
    const auto finite = [](const UnknownField& field) {
        return std::isfinite(field.low) && std::isfinite(field.high);
    };
    if (!std::ranges::all_of(facts.unknown, finite)) return std::nullopt;
    const auto isFinite = [](const BaseFit& fit) {
        return std::isfinite(fit.gapM) && std::isfinite(fit.spreadM);
    };
    if (!std::ranges::all_of(facts.bases, isFinite)) return std::nullopt;
    return facts;
} catch (const std::exception&) {  // not JSON, or of another structure
    return std::nullopt;
}

std::optional<Sentence> describeAssumed(const HeightCounts& counts) {
    if (!(counts.assumedShare() > maxAssumedShare)) return std::nullopt;
    constexpr int decimals = 2;
    return Sentence{counts.assumedAlike ? NM_TEXT("%1 of %2 heights are assumed (%3 m)")
                                        : NM_TEXT("%1 of %2 heights are assumed (most of them %3 m)"),
                    {countAmount(counts.of(HeightSource::assumed)), countAmount(counts.parts),
                     Amount{counts.assumedM, FigureUnit::none, decimals}}};
}

std::optional<std::string> makeAssumedHeadline(const HeightCounts& counts) {
    const auto sentence = describeAssumed(counts);
    return sentence ? std::optional(formatText(*sentence)) : std::nullopt;
}

std::optional<std::string> makeDoubtHeadline(const HeightFacts& facts) {
    if (facts.doubts.empty()) return std::nullopt;
    std::vector<std::string> texts;
    for (const HeightDoubt& doubt : facts.doubts) texts.push_back(describe(doubt));
    return fmt::format("{}", fmt::join(texts, "; "));
}

std::optional<std::string> makeStandHeadline(const HeightFacts& facts) {
    std::vector<std::string> texts;
    for (const BaseFit& fit : facts.bases)
        if (fit.isRemarkable()) texts.push_back(describe(fit));
    if (texts.empty()) return std::nullopt;
    return fmt::format("{}", fmt::join(texts, "; "));
}

std::optional<Sentence> describeEstimatedTrees(const std::shared_ptr<const Trees>& trees) {
    if (!trees) return std::nullopt;
    const auto countGuesses = [&](TreeSource Tree::*source) {
        return std::size_t(std::ranges::count_if(trees->trees, [&](const Tree& tree) {
            return tree.*source == TreeSource::estimated || tree.*source == TreeSource::assumed;
        }));
    };
    const std::size_t all = trees->trees.size(), heights = countGuesses(&Tree::heightSource),
                      crowns = countGuesses(&Tree::crownSource);
    if (double(std::max(heights, crowns)) <= maxAssumedShare * double(all)) return std::nullopt;
    return Sentence{NM_TEXT("Estimated or assumed of %1 trees: height of %2, crown of %3"),
                    {countAmount(all), countAmount(heights), countAmount(crowns)}};
}

std::vector<GeometryHeadline> listGeometryHeadlines(const City& city, const HeightFacts& facts) {
    std::vector<GeometryHeadline> headlines;
    const auto add = [&](const char* of, std::optional<std::string> text) {
        if (text) headlines.push_back({of, *std::move(text)});
    };
    add("heights", makeAssumedHeadline(countHeights(city)));
    add("unit of heights", makeDoubtHeadline(facts));
    add("bases", makeStandHeadline(facts));
    if (const auto trees = describeEstimatedTrees(city.trees)) add("heights of trees", formatText(*trees));
    return headlines;
}

std::vector<Sentence> describeHeights(const City& city, const HeightFacts& facts) {
    std::vector<Sentence> sentences;
    const auto assumed = describeAssumed(countHeights(city));
    if (assumed) sentences.push_back(*assumed);
    std::vector<std::string> fields;
    for (const UnknownField& field : facts.unknown) fields.push_back(describe(field));
    if (assumed && !fields.empty())
        sentences.push_back({NM_TEXT("Fields that could hold heights or storeys: %1"),
                             {fmt::format("{}", fmt::join(fields, ", "))}});
    for (const HeightDoubt& doubt : facts.doubts)
        sentences.push_back({NM_TEXT("In doubt: %1"), {describe(doubt)}});
    for (const BaseFit& fit : facts.bases)
        if (fit.isRemarkable()) std::ranges::move(listSentences(fit), std::back_inserter(sentences));
    if (const auto trees = describeEstimatedTrees(city.trees)) sentences.push_back(*trees);
    return sentences;
}

Json heightsJson(const HeightCounts& counts, const HeightFacts& facts) {
    Json json;
    json["parts"] = counts.parts;
    json["by_source"] = Json::object();
    for (const HeightSource source : heightSources)
        json["by_source"][std::string(nameOf(source))] = counts.of(source);
    json["assumed_share"] = counts.assumedShare();
    json["assumed_m"] = counts.of(HeightSource::assumed) > 0 ? Json(counts.assumedM) : Json();
    json.update(heightFactsJson(facts));
    return json;
}

namespace {
constexpr std::array warningKinds{WarningKind::repaired, WarningKind::clipped, WarningKind::dropped,
                                  WarningKind::leftOut, WarningKind::assumed};

// That a whole file has no heights is said of each of its buildings, too.
bool isOfFeature(const Warning& warning) { return !warning.what.starts_with(noFieldKnown); }

}  // namespace

Json changesJson(const Warnings& warnings) {
    Json json = Json::object();
    for (const WarningKind kind : warningKinds) {
        std::string key(nameOf(kind));
        std::ranges::replace(key, ' ', '_');
        json[key] = std::ranges::count_if(warnings, [kind](const Warning& warning) {
            return warning.kind == kind && isOfFeature(warning);
        });
    }
    json["duplicates"] = std::ranges::count_if(
        warnings, [](const Warning& warning) { return warning.what.starts_with(secondBuilding); });
    return json;
}

std::vector<ReadingChange> countChanges(const Warnings& warnings) {
    const Json changes = changesJson(warnings);  // items() refers to it
    std::vector<ReadingChange> counts;
    for (const auto& [key, count] : changes.items()) {
        std::string name = key;
        std::ranges::replace(name, '_', ' ');
        if (count != 0) counts.push_back({name, count.get<std::size_t>()});
    }
    return counts;
}

std::string describeChanges(const Warnings& warnings) {
    std::vector<std::string> texts;
    for (const ReadingChange& change : countChanges(warnings))
        texts.push_back(formatThousands(change.count) + " " + change.kind);
    return texts.empty() ? "nothing" : fmt::format("{}", fmt::join(texts, ", "));
}

namespace {

// "2,377 left out (2,371: a tree far from the buildings)": what most of a kind are.
std::string describeLargest(const Warnings& warnings, WarningKind kind, const std::string& what,
                            std::size_t largest) {
    const auto all = std::size_t(std::ranges::count(warnings, kind, &Warning::kind));
    return fmt::format("{} {} ({}{})", formatThousands(all), nameOf(kind),
                       largest == all ? "" : formatThousands(largest) + ": ", what);
}

// describeChanges() with what most of each kind are.
std::string describeChangesWithReasons(const Warnings& warnings) {
    const auto groups = groupWarnings(warnings);
    std::vector<std::string> texts;
    for (const WarningKind kind : warningKinds) {
        const WarningGroup* largest = nullptr;
        for (const WarningGroup& group : groups)
            if (group.kind == kind && (largest == nullptr || group.where.size() > largest->where.size()))
                largest = &group;
        if (largest != nullptr)
            texts.push_back(describeLargest(warnings, kind, largest->what, largest->where.size()));
    }
    return texts.empty() ? "nothing" : fmt::format("{}", fmt::join(texts, "; "));
}

Sentence describeSource(const CityRead& read) {
    const std::string format = read.crs.empty() ? read.format : fmt::format("{} ({})", read.format, read.crs);
    const Box2 box = bounds(read.city);
    if (box.empty()) return {"%1", {format}};
    const auto middle = (glm::dvec2(box.low) + glm::dvec2(box.high)) / 2.0;
    const auto town = findNearestTown(read.city.frame.lonLatFromLocal(middle));
    if (!town) return {"%1", {format}};
    return {NM_TEXT("%1, %2 km from %3, %4"),
            {format, Amount{town->distanceM / 1000}, town->name, countryName(town->country)}};
}

Sentence describeSize(const City& city) {
    if (city.buildings.empty()) return {NM_TEXT("no buildings"), {}};
    std::size_t parts = 0;
    float tallestM = 0;
    for (const auto& building : city.buildings) {
        parts += building->parts.size();
        tallestM = std::max(tallestM, heightM(*building, city));
    }
    return {NM_TEXT("buildings: %1, parts: %2, up to %3 m high"),
            {countAmount(city.buildings.size()), countAmount(parts), Amount{tallestM}}};
}

}  // namespace

std::vector<Sentence> listFacts(const CityRead& read) {
    return {describeSource(read),
            describeSize(read.city),
            {read.city.terrain ? NM_TEXT("on a terrain") : NM_TEXT("on flat ground"), {}}};
}

std::string summariseReading(const CityRead& read) {
    std::string text;
    for (const Sentence& fact : listFacts(read)) text += formatText(fact) + ". ";
    return text + fmt::format("Changed in reading: {}.", describeChangesWithReasons(read.warnings));
}

}  // namespace noonmark
