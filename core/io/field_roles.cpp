#include "core/io/field_roles.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

namespace noonmark {

namespace {

constexpr std::size_t shapefileNameLength = 10;

// In the order in which they are asked; lower-case letters and digits only.
struct RoleName {
    std::string_view name;
    FieldRole role;
};
using enum FieldRole;
constexpr std::array roleNames{
    RoleName{"height", height},
    RoleName{"buildingheight", height},
    RoleName{"measuredheight", height},
    RoleName{"heightroof", height},
    RoleName{"bldgheight", height},
    RoleName{"bldght", height},
    RoleName{"bldghgt", height},
    RoleName{"renderheight", height},
    RoleName{"hgt", height},
    RoleName{"buildinglevels", levels},
    RoleName{"levels", levels},
    RoleName{"numfloors", levels},
    RoleName{"numberoffloors", levels},
    RoleName{"nfloors", levels},
    RoleName{"floors", levels},
    RoleName{"numstories", levels},
    RoleName{"stories", levels},
    RoleName{"storeys", levels},
    RoleName{"storeysaboveground", levels},
    RoleName{"minheight", minHeight},
    RoleName{"buildingminheight", minHeight},
    RoleName{"renderminheight", minHeight},
    RoleName{"baseheight", minHeight},
    RoleName{"buildingminlevel", minLevel},
    RoleName{"minlevel", minLevel},
    RoleName{"minfloor", minLevel},
    RoleName{"roofheight", roofHeight},
    RoleName{"rooflevels", roofLevels},
    RoleName{"roofshape", roofShape},
    RoleName{"groundelevation", groundElevation},
    RoleName{"groundelev", groundElevation},
    RoleName{"groundz", groundElevation},
    RoleName{"building", building},
    RoleName{"buildingpart", buildingPart},
    RoleName{"location", location},
    RoleName{"layer", layer},
    RoleName{"underground", underground},
    RoleName{"isunderground", underground},
    RoleName{"sourceid", id},
    RoleName{"id", id},
    RoleName{"osmid", id},
    RoleName{"gmlid", id},
    RoleName{"globalid", id},
    RoleName{"objectid", id},
    RoleName{"buildingid", buildingId},
    RoleName{"name", name},
    RoleName{"buildingname", name},
    RoleName{"bldgname", name},
    RoleName{"status", status},
    RoleName{"heightsource", heightSource},
    RoleName{"hangs", hangs},
};

struct UnitEnding {
    std::string_view ending;
    LengthUnit unit;
};
constexpr std::array unitEndings{
    UnitEnding{"usft", LengthUnit::usSurveyFeet}, UnitEnding{"feet", LengthUnit::feet},
    UnitEnding{"foot", LengthUnit::feet},         UnitEnding{"ft", LengthUnit::feet},
    UnitEnding{"metres", LengthUnit::metres},     UnitEnding{"meters", LengthUnit::metres},
    UnitEnding{"metre", LengthUnit::metres},      UnitEnding{"meter", LengthUnit::metres},
    UnitEnding{"m", LengthUnit::metres},
};

std::string plain(std::string_view name) {
    std::string letters;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            letters += char(std::tolower(static_cast<unsigned char>(c)));
    return letters;
}

FieldMeaning meaningAt(std::size_t rank, std::optional<LengthUnit> unit) {
    const RoleName& known = roleNames[rank];
    return {known.role, int(rank), unit, known.name == "heightroof" || known.name == "groundelev"};
}

std::optional<FieldMeaning> exactMeaning(std::string_view letters, std::optional<LengthUnit> unit) {
    const auto found = std::ranges::find(roleNames, letters, &RoleName::name);
    if (found == roleNames.end()) return std::nullopt;
    return meaningAt(std::size_t(found - roleNames.begin()), unit);
}

bool isLength(FieldRole role) {
    return role == height || role == minHeight || role == roofHeight || role == groundElevation;
}

std::optional<FieldMeaning> meaningWithUnit(std::string_view letters) {
    for (const UnitEnding& unit : unitEndings) {
        if (!letters.ends_with(unit.ending)) continue;
        const auto meaning = exactMeaning(letters.substr(0, letters.size() - unit.ending.size()), unit.unit);
        if (meaning && isLength(meaning->role)) return meaning;
    }
    return std::nullopt;
}

std::optional<FieldMeaning> meaningOfBeginning(std::string_view beginning) {
    std::optional<FieldMeaning> only;
    for (std::size_t rank = 0; rank < roleNames.size(); ++rank) {
        if (!roleNames[rank].name.starts_with(beginning)) continue;
        if (only && only->role != roleNames[rank].role) return std::nullopt;
        if (!only) only = meaningAt(rank, std::nullopt);
    }
    return only;
}

bool before(const KnownField& a, const KnownField& b) {
    return std::pair(a.meaning.role, a.meaning.rank) < std::pair(b.meaning.role, b.meaning.rank);
}

}  // namespace

std::optional<FieldMeaning> meaningOf(std::string_view fieldName, bool cutShort) {
    const std::string letters = plain(fieldName);
    if (const auto exact = exactMeaning(letters, std::nullopt)) return exact;
    if (const auto withUnit = meaningWithUnit(letters)) return withUnit;
    if (cutShort && fieldName.size() == shapefileNameLength) return meaningOfBeginning(letters);
    return std::nullopt;
}

std::vector<KnownField> knownFields(const std::vector<std::string>& names, const std::string& heightField,
                                    bool cutShort) {
    std::vector<KnownField> fields;
    for (int i = 0; i < int(names.size()); ++i) {
        const std::string& fieldName = names[std::size_t(i)];
        const bool chosen = !heightField.empty() && plain(fieldName) == plain(heightField);
        auto meaning = meaningOf(fieldName, cutShort);
        if (chosen) meaning = FieldMeaning{height, 0, meaning ? meaning->unit : std::nullopt, false};
        if (!meaning || (meaning->role == height && !heightField.empty() && !chosen)) continue;
        fields.push_back({i, fieldName, *meaning});
    }
    std::ranges::stable_sort(fields, before);
    return fields;
}

namespace {

bool isNewYork(const std::vector<KnownField>& fields) {
    bool heightroof = false;
    bool ground = false;
    for (const KnownField& field : fields) {
        heightroof |= field.meaning.newYork && field.meaning.role == height;
        ground |= field.meaning.role == groundElevation;
    }
    return heightroof && ground;
}

void settleUnit(KnownField& field, bool mapInFeet, bool newYork, const std::string& where,
                Warnings& warnings) {
    const auto assume = [&](LengthUnit unit, const char* what) {
        field.unit = unit;
        warnings.push_back({WarningKind::assumed, what, where + ": " + field.name});
    };
    const bool feetByName = field.meaning.newYork || (newYork && field.meaning.role == groundElevation);
    if (feetByName && (newYork || mapInFeet))
        assume(LengthUnit::feet, "no unit is stated; taken as feet, as in New York's building footprints");
    else if (feetByName)
        assume(LengthUnit::metres,
               "no unit is stated; taken as metres, though New York's field of this name is in feet");
    else if (mapInFeet && field.meaning.role == height)
        assume(LengthUnit::metres,
               "the map is in feet, but its heights are taken as metres: state the unit if they are not");
}

}  // namespace

void settleUnits(std::vector<KnownField>& fields, const UnitRules& rules, const std::string& where,
                 Warnings& warnings) {
    const bool newYork = isNewYork(fields);
    for (KnownField& field : fields) {
        if (!isLength(field.meaning.role)) continue;
        if (rules.stated || field.meaning.unit)
            field.unit = rules.stated ? *rules.stated : *field.meaning.unit;
        else
            settleUnit(field, rules.mapInFeet, newYork, where, warnings);
    }
}

bool hasRole(const std::vector<KnownField>& fields, FieldRole role) {
    return std::ranges::any_of(fields, [&](const KnownField& field) { return field.meaning.role == role; });
}

}  // namespace noonmark
