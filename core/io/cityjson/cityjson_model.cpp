#include "core/io/cityjson/cityjson_model.h"

#include <algorithm>
#include <charconv>

namespace noonmark {

Result<LodChoice> parseLodChoice(const std::string& lod) {
    if (lod.empty()) return LodChoice{};
    double number = 0;
    const auto [end, error] = std::from_chars(lod.data(), lod.data() + lod.size(), number);
    if (error != std::errc() || end != lod.data() + lod.size())
        return failure("\"" + lod + "\" is not a level of detail", {}, "Give a number such as 1.2 or 2.2");
    return LodChoice{number};
}

bool isBetter(const LodRank& a, const LodRank& b, const LodChoice& choice) {
    const double wished = choice.wished.value_or(1e9);
    const bool aReachable = a.lod <= wished;
    const bool bReachable = b.lod <= wished;
    if (aReachable != bReachable) return aReachable;
    if (a.lod != b.lod) return aReachable ? a.lod > b.lod : a.lod < b.lod;
    return a.solid && !b.solid;
}

namespace {

const ObjectAttribute& attributeOf(const std::vector<ObjectAttribute>& attributes, const std::string& name) {
    return *std::ranges::find(attributes, name, &ObjectAttribute::name);
}

}  // namespace

void ObjectValues::add(const std::vector<ObjectAttribute>& attributes, CityJsonObject& object,
                       CityJsonData& data) {
    learnFields(attributes, data);
    for (const KnownField& field : fields_) {
        const ObjectAttribute& attribute = attributeOf(attributes, field.name);
        if (!attribute.text.empty())
            object.values.push_back({field.meaning.role, field.name, attribute.text, attribute.number,
                                     attribute.unit.value_or(field.unit)});
    }
    for (const std::string& name : unknown_) {
        const ObjectAttribute& attribute = attributeOf(attributes, name);
        if (attribute.number)
            data.unknown.add(name, {}, attribute.number);
        else if (!attribute.text.empty())
            data.unknown.add(name, attribute.text, {});
    }
}

void ObjectValues::learnFields(const std::vector<ObjectAttribute>& attributes, CityJsonData& data) {
    if (std::ranges::equal(attributes, names_, {}, &ObjectAttribute::name)) return;
    names_.clear();
    for (const ObjectAttribute& attribute : attributes) names_.push_back(attribute.name);
    unknown_ = names_;
    std::erase_if(unknown_, [](const std::string& name) { return findMeaning(name).has_value(); });
    fields_ = knownFields(names_, {settings_.heightField, settings_.levelsField, settings_.nameField}, false);
    settleUnits(fields_, {settings_.heightUnit, false});
    for (const KnownField& field : fields_)
        if (std::ranges::find(data.fields, field.name, &KnownField::name) == data.fields.end())
            data.fields.push_back(field);
}

}  // namespace noonmark
