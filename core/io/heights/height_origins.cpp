#include "core/io/heights/height_origins.h"

namespace noonmark {

namespace {

// False if most heights are present.
bool manyLackHeights(const HeightOrigins& origins) {
    std::size_t all = 0;
    for (const auto& [origin, features] : origins) all += features;
    const auto without = origins.find("");
    return without != origins.end() && 10 * without->second > all;
}

bool tellsHeights(const std::vector<KnownField>& fields) {
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
    if (!manyLackHeights(origins)) return;
    const std::vector<UnknownField> could = unknown.thatCouldBeHeights(file);
    if (!tellsHeights(fields)) warnings.push_back(noKnownField(could, file));
    facts.unknown.insert(facts.unknown.end(), could.begin(), could.end());
}

}  // namespace noonmark
