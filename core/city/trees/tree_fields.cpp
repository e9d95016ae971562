#include <algorithm>
#include <array>

#include "core/city/trees/tree_facts.h"
#include "core/describe/field.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

template <double glm::dvec2::*axis>
FieldOf<Tree> placeField(std::string_view key) {
    return derivedField<Tree>(
        ValueKind::number, [](const Tree& tree) { return Value(tree.place.*axis); },
        [](Tree& tree, const Value& value) -> Result<void> {
            return codecOf<double>().fromValue(value).map([&](double metres) { tree.place.*axis = metres; });
        },
        {.key = key, .unit = "m", .range = ValueRange{-1e6, 1e6}, .restated = true});
}

FieldFacts lengthFacts(std::string_view key, double maxM) {
    return {.key = key, .unit = "m", .range = ValueRange{0, maxM}, .restated = true};
}
FieldFacts shareFacts(std::string_view key) {
    return {.key = key, .range = ValueRange{0, 1}, .restated = true};
}

template <class E>
Result<E> orUnknown(const std::optional<E>& found, std::string_view text) {
    if (!found) return failure("The word is unknown", std::string(text));
    return *found;
}

std::string formatSource(TreeSource source) { return std::string(nameOf(source)); }
Result<TreeSource> parseSource(std::string_view text) { return orUnknown(parseTreeSource(text), text); }

constexpr std::array leafCycles{KeyedLabel{"evergreen", NM_TEXT("evergreen")},
                                KeyedLabel{"deciduous", NM_TEXT("loses its leaves")}};

Value leafCycleOf(const TreeFacts& facts) {
    return facts.evergreen ? Value(std::string(leafCycles[*facts.evergreen ? 0 : 1].key)) : Value();
}

Result<void> setLeafCycle(TreeFacts& facts, const Value& value) {
    facts.evergreen.reset();
    if (value == Value()) return {};
    const auto* key = std::get_if<std::string>(&value);
    const auto found =
        key ? std::ranges::find(leafCycles, *key, &KeyedLabel::key) : std::ranges::end(leafCycles);
    if (found == leafCycles.end()) return failure("Leaves are evergreen or deciduous", key ? *key : "");
    facts.evergreen = found == leafCycles.begin();
    return {};
}

}  // namespace

const Fields<Tree>& treeRecordFields() {
    constexpr double maxHeightM = 120, maxCrownM = 1000;  // cells of a canopy raster may be wide
    static const Fields<Tree> fields{
        field(&Tree::sourceId, {.key = "id", .restated = true}),
        field(&Tree::species, {.key = "species"}),
        placeField<&glm::dvec2::x>("east_m"),
        placeField<&glm::dvec2::y>("north_m"),
        field(&Tree::heightM, lengthFacts("height_m", maxHeightM)),
        field(&Tree::crownBaseM, lengthFacts("crown_base_m", maxHeightM)),
        field(&Tree::crownDiameterM, lengthFacts("crown_diameter_m", maxCrownM)),
        textField<Tree, CrownShape>(
            &Tree::shape, [](CrownShape shape) { return std::string(nameOf(shape)); },
            [](std::string_view text) { return orUnknown(parseCrownShape(text), text); }, {.key = "shape"}),
        field(&Tree::evergreen, {.key = "evergreen"}),
        textField<Tree, TreeSource>(&Tree::heightSource, formatSource, parseSource, {.key = "height_source"}),
        textField<Tree, TreeSource>(&Tree::crownSource, formatSource, parseSource, {.key = "crown_source"}),
        field(&Tree::leafOnTransmissivity, shareFacts("leaf_on")),
        field(&Tree::leafOffTransmissivity, shareFacts("leaf_off")),
        textField(&Tree::leafOnDay, formatDayOfYear, parseDayOfYear, {.key = "leaf_on_day"}),
        textField(&Tree::leafOffDay, formatDayOfYear, parseDayOfYear, {.key = "leaf_off_day"}),
    };
    return fields;
}

const Fields<TreeFacts>& treeFactFields() {
    static const Fields<TreeFacts> fields{
        field(&TreeFacts::species,
              {.key = "species",
               .flag = "--species",
               .label = NM_TEXT("Species"),
               .help = NM_TEXT("Latin name; its genus decides shape, density and leaves"),
               .hint = "NAME"}),
        field(&TreeFacts::heightM, {.key = "height_m",
                                    .flag = "--height",
                                    .label = NM_TEXT("Height"),
                                    .help = NM_TEXT("Height above the ground, m"),
                                    .unit = "m",
                                    .range = ValueRange{0.5, 120},
                                    .whenEmpty = NM_TEXT("estimated from crown or stem")}),
        field(&TreeFacts::crownDiameterM, {.key = "crown_diameter_m",
                                           .flag = "--crown",
                                           .label = NM_TEXT("Crown diameter"),
                                           .help = NM_TEXT("Diameter of the crown, m"),
                                           .unit = "m",
                                           .range = ValueRange{0.3, 50},
                                           .whenEmpty = NM_TEXT("estimated from stem or height")}),
        field(&TreeFacts::crownBaseM, {.key = "crown_base_m",
                                       .flag = "--crown-base",
                                       .label = NM_TEXT("Crown base"),
                                       .help = NM_TEXT("Height of the crown's lower end above the ground, m"),
                                       .unit = "m",
                                       .range = ValueRange{0, 119},
                                       .whenEmpty = NM_TEXT("a share of the height")}),
        field(&TreeFacts::stemDiameterM, {.key = "stem_diameter_m",
                                          .flag = "--stem",
                                          .label = NM_TEXT("Stem diameter"),
                                          .help = NM_TEXT("Diameter of the stem at breast height, m"),
                                          .unit = "m",
                                          .range = ValueRange{0.01, 5},
                                          .whenEmpty = NM_TEXT("not known")}),
        derivedField<TreeFacts>(ValueKind::choice, leafCycleOf, setLeafCycle,
                                {.key = "leaves",
                                 .flag = "--leaves",
                                 .label = NM_TEXT("Leaves"),
                                 .help = NM_TEXT("Whether it keeps its leaves (default: as its genus)"),
                                 .hint = "CYCLE",
                                 .whenEmpty = NM_TEXT("as its genus")})
            .among(leafCycles),
        textField(&TreeFacts::leafOnDay, formatDayOfYear, parseDayOfYear,
                  {.key = "leaf_on_day",
                   .flag = "--leaf-on",
                   .label = NM_TEXT("First day in leaf"),
                   .help = NM_TEXT("First day in leaf of a tree that loses its leaves (default: as the "
                                   "city's trees)"),
                   .hint = "MM-DD",
                   .whenEmpty = NM_TEXT("MM-DD; as the city's trees")}),
        textField(&TreeFacts::leafOffDay, formatDayOfYear, parseDayOfYear,
                  {.key = "leaf_off_day",
                   .flag = "--leaf-off",
                   .label = NM_TEXT("First day without leaves"),
                   .help = NM_TEXT("First day without leaves of a tree that loses them (default: as the "
                                   "city's trees)"),
                   .hint = "MM-DD",
                   .whenEmpty = NM_TEXT("MM-DD; as the city's trees")}),
    };
    return fields;
}

}  // namespace noonmark
