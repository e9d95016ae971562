#include "core/study/text/height_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/study/text/height_facts_json.h"

namespace noonmark {

using Json = nlohmann::ordered_json;

std::optional<std::string> makeAssumedHeadline(const HeightCounts& counts) {
    if (!(counts.assumedShare() > maxAssumedShare)) return std::nullopt;
    return fmt::format("{} of {} heights are assumed ({}{:.4g} m)",
                       formatThousands(counts.of(HeightSource::assumed)), formatThousands(counts.parts),
                       counts.assumedAlike ? "" : "most of them ", counts.assumedM);
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
        if (fit.rule != StandRule::asStated || fit.apart > 0 || !fit.fits()) texts.push_back(describe(fit));
    if (texts.empty()) return std::nullopt;
    return fmt::format("{}", fmt::join(texts, "; "));
}

std::optional<std::string> makeAssumedHeightsMessage(const HeightCounts& counts, const HeightFacts& facts) {
    auto text = makeAssumedHeadline(counts);
    if (!text || facts.unknown.empty()) return text;
    std::vector<std::string> fields;
    for (const UnknownField& field : facts.unknown) fields.push_back(describe(field));
    *text += fmt::format(". Fields that could hold heights or storeys: {}", fmt::join(fields, ", "));
    return text;
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

}  // namespace noonmark
