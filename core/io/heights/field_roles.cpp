#include "core/io/heights/field_roles.h"

#include <fmt/format.h>
#include <algorithm>
#include <array>

#include "core/io/heights/height_reading.h"
#include "core/io/heights/height_text.h"

namespace noonmark {

const FeatureValue* firstOf(const FeatureValues& values, FieldRole role) {
    const auto found = std::ranges::find(values, role, &FeatureValue::role);
    return found == values.end() ? nullptr : &*found;
}

namespace {

using enum FieldRole;

constexpr std::size_t shapefileNameLength = 10;

struct UnitEnding {
    std::string_view ending;
    LengthUnit unit;
};
constexpr std::array unitEndings{
    UnitEnding{"usft", LengthUnit::usSurveyFeet}, UnitEnding{"feet", LengthUnit::feet},
    UnitEnding{"foot", LengthUnit::feet},         UnitEnding{"ft", LengthUnit::feet},
    UnitEnding{"metres", LengthUnit::metres},     UnitEnding{"meters", LengthUnit::metres},
    UnitEnding{"metre", LengthUnit::metres},      UnitEnding{"meter", LengthUnit::metres},
    UnitEnding{"inches", LengthUnit::inches},     UnitEnding{"inch", LengthUnit::inches},
    UnitEnding{"cm", LengthUnit::centimetres},    UnitEnding{"dm", LengthUnit::decimetres},
    UnitEnding{"mm", LengthUnit::millimetres},    UnitEnding{"m", LengthUnit::metres},
};

std::optional<FieldMeaning> meaningAt(std::size_t rank) {
    const FieldName& known = listFieldNames()[rank];
    if (!known.role) return std::nullopt;
    return FieldMeaning{*known.role, int(rank), known.unit, known.meaning, known.inFeetIn};
}

// Index of a name in the list; the size of the list if the name is not in it.
std::size_t rankOf(std::string_view letters) {
    return std::size_t(std::ranges::find(listFieldNames(), letters, &FieldName::name) -
                       listFieldNames().begin());
}

bool isLength(FieldRole role) {
    return role == height || role == minHeight || role == roofHeight || role == groundElevation ||
           role == topElevation || role == bottomElevation;
}

std::optional<FieldMeaning> meaningWithUnit(std::string_view letters) {
    for (const UnitEnding& unit : unitEndings) {
        if (!letters.ends_with(unit.ending)) continue;
        const std::size_t rank = rankOf(letters.substr(0, letters.size() - unit.ending.size()));
        if (rank == listFieldNames().size()) continue;
        auto meaning = meaningAt(rank);
        if (!meaning || !isLength(meaning->role)) continue;
        meaning->unit = unit.unit;
        meaning->inFeetIn = {};
        return meaning;
    }
    return std::nullopt;
}

bool areAlike(const FieldName& a, const FieldName& b) { return a.role == b.role && a.unit == b.unit; }

std::optional<FieldMeaning> meaningOfBeginning(std::string_view beginning) {
    std::optional<std::size_t> only;
    for (std::size_t rank = 0; rank < listFieldNames().size(); ++rank) {
        if (!listFieldNames()[rank].name.starts_with(beginning)) continue;
        if (only && !areAlike(listFieldNames()[*only], listFieldNames()[rank])) return std::nullopt;
        if (!only) only = rank;
    }
    return only ? meaningAt(*only) : std::nullopt;
}

bool beginsListedName(std::string_view beginning) {
    return std::ranges::any_of(listFieldNames(),
                               [&](const FieldName& known) { return known.name.starts_with(beginning); });
}

bool before(const KnownField& a, const KnownField& b) {
    return std::pair(a.meaning.role, a.meaning.rank) < std::pair(b.meaning.role, b.meaning.rank);
}

// Behind every listed name: a typical height, one at the eaves, the highest point.
FieldMeaning lengthOfWords(const NameWords& words, FieldRole role) {
    FieldMeaning meaning{role, int(listFieldNames().size()), unitOfWords(words), "", ""};
    meaning.maybeInches = !meaning.unit && words.endsInIn();
    const auto say = [&](int later, std::string_view what) { meaning.rank += later, meaning.meaning = what; };
    if (words.has(NameWord::typical)) say(1, "mean or median of the roof");
    if (words.has(NameWord::eaves)) say(2, "base of the roof");
    if (words.has(NameWord::greatest)) say(3, "highest point");
    return meaning;
}

std::optional<FieldMeaning> heightOfWords(const NameWords& words) {
    const bool overGround = words.has(NameWord::above);
    if (words.has(NameWord::terrainModel) && !overGround) return lengthOfWords(words, groundElevation);
    if (words.has(NameWord::below) || words.has(NameWord::minimum)) return std::nullopt;
    if (words.has(NameWord::elevation))
        return lengthOfWords(words, words.has(NameWord::ground) ? groundElevation : topElevation);
    if (words.has(NameWord::ground) && !overGround) return std::nullopt;  // an elevation, or above the ground
    return lengthOfWords(words, height);
}

std::optional<FieldMeaning> groundHeightOfWords(std::string_view name) {
    const NameWords words(name);
    const bool says = words.areAllKnown() && words.has(NameWord::ground) && words.has(NameWord::height);
    const bool other = words.has(NameWord::above) || words.has(NameWord::below) ||
                       words.has(NameWord::storey) || words.has(NameWord::roof) ||
                       words.has(NameWord::elevation) || words.has(NameWord::otherThing);
    if (!says || other) return std::nullopt;
    return lengthOfWords(words, groundElevation);
}

std::optional<FieldMeaning> storeysOfWords(const NameWords& words) {
    const bool groundFloor = words.has(NameWord::ground) && !words.has(NameWord::above);
    const bool other = words.has(NameWord::below) || words.has(NameWord::roof) ||
                       words.has(NameWord::minimum) || words.has(NameWord::elevation) || unitOfWords(words);
    if (groundFloor || other) return std::nullopt;
    return FieldMeaning{levels, int(listFieldNames().size()), {}, "", ""};
}

// What the words of a name that is not listed say, if all of them are known. Storeys and height in one name
// mean the height of a storey or of all: nobody knows.
std::optional<FieldMeaning> meaningOfWords(std::string_view name) {
    const NameWords words(name);
    if (!words.areAllKnown() || words.has(NameWord::otherThing) || words.has(NameWord::otherLayer))
        return std::nullopt;
    const bool isHeight = words.has(NameWord::height), isStoreys = words.has(NameWord::storey);
    if (isHeight && isStoreys) return std::nullopt;
    if (isHeight) return heightOfWords(words);
    if (isStoreys) return storeysOfWords(words);
    if (words.has(NameWord::terrainModel)) return heightOfWords(words);
    const bool place = words.has(NameWord::roof) != words.has(NameWord::ground);
    if (!words.has(NameWord::elevation) || !place) return std::nullopt;
    return lengthOfWords(words, words.has(NameWord::roof) ? topElevation : groundElevation);
}

// A clearance in OpenStreetMap; other data writes MAX_HEIGHT.
constexpr std::string_view clearance = "maxheight";

}  // namespace

std::optional<LengthUnit> unitOfWords(const NameWords& words) {
    if (words.has(NameWord::usSurveyFeet)) return LengthUnit::usSurveyFeet;
    if (words.has(NameWord::feet)) return LengthUnit::feet;
    if (words.has(NameWord::inches)) return LengthUnit::inches;
    if (words.has(NameWord::centimetres)) return LengthUnit::centimetres;
    if (words.has(NameWord::decimetres)) return LengthUnit::decimetres;
    if (words.has(NameWord::millimetres)) return LengthUnit::millimetres;
    return words.has(NameWord::metres) ? std::optional(LengthUnit::metres) : std::nullopt;
}

std::optional<FieldMeaning> findMeaning(std::string_view fieldName, bool cutShort) {
    const std::string letters = foldName(fieldName);
    if (fieldName == clearance) return std::nullopt;
    if (const std::size_t rank = rankOf(letters); rank < listFieldNames().size()) return meaningAt(rank);
    if (const auto withUnit = meaningWithUnit(letters)) return withUnit;
    if (cutShort && fieldName.size() == shapefileNameLength && beginsListedName(letters))
        return meaningOfBeginning(letters);
    return meaningOfWords(fieldName);
}

bool isSameField(std::string_view a, std::string_view b) { return foldName(a) == foldName(b); }

std::optional<FieldMeaning> findTagMeaning(std::string_view key) {
    constexpr std::array<std::string_view, 4> tags{"height", "buildingheight", "buildinglevels", "levels"};
    const auto meaning = findMeaning(key);
    if (!meaning) return meaning;
    const bool shownWith = meaning->role == height || meaning->role == levels ||
                           meaning->role == topElevation || meaning->role == groundElevation;
    if (shownWith && std::ranges::find(tags, foldName(key)) == tags.end()) return std::nullopt;
    return meaning;
}

bool hasRole(const std::vector<KnownField>& fields, FieldRole role) {
    return std::ranges::any_of(fields, [&](const KnownField& field) { return field.meaning.role == role; });
}

namespace {

// Determines the meanings of a layer's fields; the functions are called in this order.
class FieldChooser {
public:
    FieldChooser(const std::vector<std::string>& names, bool cutShort) {
        for (int i = 0; i < int(names.size()); ++i)
            if (const auto meaning = findMeaning(names[std::size_t(i)], cutShort))
                fields_.push_back({i, names[std::size_t(i)], *meaning});
    }

    void dropStatisticsAsUndersides() {
        const bool statistics = std::ranges::any_of(fields_, [](const KnownField& field) {
            return field.meaning.role == height && !field.meaning.meaning.empty();
        });
        if (statistics && !hasRole(fields_, buildingPart))
            std::erase_if(fields_, [](const KnownField& field) { return isNamed(field, "minheight"); });
    }

    // Outside OpenStreetMap's tags the height of the roof is that of the building.
    void takeRoofHeightsAsHeights() {
        const bool tags = hasRole(fields_, building) || hasRole(fields_, buildingPart) ||
                          hasRole(fields_, roofShape) || hasRole(fields_, roofLevels);
        if (tags || hasRole(fields_, height)) return;
        for (KnownField& field : fields_)
            if (field.meaning.role == roofHeight && field.name.find(':') == std::string::npos)
                field.meaning.role = height, field.meaning.meaning = heightOfRoof;
    }

    // "Ground height" is an elevation beside that of the roof.
    void takeGroundHeightsAsElevations(const std::vector<std::string>& names) {
        if (!hasRole(fields_, topElevation) || hasRole(fields_, groundElevation)) return;
        for (int i = 0; i < int(names.size()); ++i)
            if (const auto meaning = groundHeightOfWords(names[std::size_t(i)]))
                fields_.push_back({i, names[std::size_t(i)], *meaning});
    }

    void takeUndersidesAsGround() {
        if (hasRole(fields_, groundElevation)) return;
        for (KnownField& field : fields_)
            if (field.meaning.role == bottomElevation) field.meaning.role = groundElevation;
    }

    void takeBasesAsElevations() {
        if (std::ranges::none_of(fields_, [](const auto& field) { return isNamed(field, "topheight"); }))
            return;
        for (KnownField& field : fields_)
            if (isNamed(field, "baseheight")) field.meaning.role = groundElevation;
    }

    // `role`: height or levels. Other fields of that role are dropped in favour of the user's field.
    void take(const std::string& chosen, FieldRole role, const std::vector<std::string>& names) {
        if (chosen.empty()) return;
        const auto isChosen = [&](const std::string& name) { return isSameField(name, chosen); };
        const auto here = std::ranges::find_if(names, isChosen);
        std::optional<FieldMeaning> known;
        for (const KnownField& field : fields_)
            if (isChosen(field.name)) known = field.meaning;
        std::erase_if(fields_, [&](const KnownField& field) {
            return isChosen(field.name) || field.meaning.role == role ||
                   (role == height && field.meaning.role == topElevation);
        });
        if (here == names.end()) return;
        KnownField field{int(here - names.begin()), *here, known.value_or(FieldMeaning{})};
        const bool elevation = known && known->role == topElevation;
        field.meaning.role = role == height && elevation ? topElevation : role;
        field.meaning.inFeetIn = {};
        fields_.push_back(std::move(field));
    }

    std::vector<KnownField> ordered() {
        std::ranges::stable_sort(fields_, before);
        return std::move(fields_);
    }

private:
    static bool isNamed(const KnownField& field, std::string_view name) {
        const auto rank = std::size_t(field.meaning.rank);
        return rank < listFieldNames().size() && listFieldNames()[rank].name == name;
    }
    std::vector<KnownField> fields_;
};

}  // namespace

std::vector<KnownField> knownFields(const std::vector<std::string>& names, const FieldChoice& choice,
                                    bool cutShort) {
    FieldChooser chooser(names, cutShort);
    chooser.dropStatisticsAsUndersides();
    chooser.takeBasesAsElevations();
    chooser.takeGroundHeightsAsElevations(names);
    chooser.takeUndersidesAsGround();
    chooser.takeRoofHeightsAsHeights();
    chooser.take(choice.height, height, names);
    chooser.take(choice.levels, levels, names);
    chooser.take(choice.name, FieldRole::name, names);
    return chooser.ordered();
}

namespace {

constexpr std::string_view newYork = "New York";

bool isNewYork(const std::vector<KnownField>& fields) {
    const bool heightroof = std::ranges::any_of(fields, [](const KnownField& field) {
        return field.meaning.inFeetIn == newYork && field.meaning.role == height;
    });
    return heightroof && hasRole(fields, groundElevation);
}

void settleUnit(KnownField& field, bool mapInFeet, bool inNewYork) {
    const auto assume = [&](LengthUnit unit, std::string what) {
        field.unit = unit;
        field.assumption = std::move(what);
    };
    std::string_view city = field.meaning.inFeetIn;
    if (inNewYork && field.meaning.role == groundElevation) city = newYork;
    if (!city.empty() && (mapInFeet || (inNewYork && city == newYork)))
        assume(LengthUnit::feet,
               fmt::format("no unit is stated; feet are assumed, as in {}'s building footprints", city));
    else if (!city.empty())
        assume(LengthUnit::metres,
               fmt::format("no unit is stated; metres are assumed, though {}'s field of this name is in feet "
                           "(if these are: {})",
                           city, readOption("height_unit", entryOf(LengthUnit::feet).key)));
    else if (mapInFeet && (field.meaning.role == height || field.meaning.role == topElevation))
        assume(
            LengthUnit::metres,
            fmt::format("the map is in feet, but metres are assumed for its heights (if they are feet: {})",
                        readOption("height_unit", entryOf(LengthUnit::feet).key)));
}

}  // namespace

void settleUnits(std::vector<KnownField>& fields, const UnitRules& rules) {
    const bool inNewYork = isNewYork(fields);
    for (KnownField& field : fields) {
        if (!isLength(field.meaning.role)) continue;
        if (rules.stated || field.meaning.unit)
            field.unit = rules.stated ? *rules.stated : *field.meaning.unit;
        else
            settleUnit(field, rules.mapInFeet, inNewYork);
    }
}

std::optional<HeightField> findHeightField(const std::vector<KnownField>& fields, const std::string& origin) {
    const std::string_view name = std::string_view(origin).substr(0, origin.find(elevationsMinus));
    const auto found = std::ranges::find(fields, name, &KnownField::name);
    if (found == fields.end()) return std::nullopt;
    const bool storeys = found->meaning.role == levels;
    return HeightField{{},
                       origin,
                       std::string(found->meaning.meaning),
                       std::string(storeys ? "storeys" : entryOf(found->unit).name)};
}

}  // namespace noonmark
