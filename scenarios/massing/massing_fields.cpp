#include "scenarios/massing/massing_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/city/building_heights.h"
#include "core/describe/field_values.h"
#include "core/describe/shown_as.h"
#include "core/describe/text.h"

namespace noonmark {

namespace {

constexpr ValueRange storeyRange{0, maxStoreys}, aboveGroundRangeM{0, tallestBuildingM},
    turnRangeDeg{-360, 360};

/// What the tower and its podium call the same settings.
struct PartFlags {
    std::string_view share, area, taper, twist;
    std::string_view needs = {};
};

Fields<PlateSize> makePlateFields(const PartFlags& flags) {
    return {field(&PlateSize::shareOfLot, {.key = "share_of_lot",
                                           .flag = flags.share,
                                           .label = NM_TEXT("Share of the lot"),
                                           .help = NM_TEXT("Floor plate, % of the lot (default: all of it)"),
                                           .hint = "PERCENT",
                                           .unit = "%",
                                           .range = ValueRange{0, 1},
                                           .shownTimes = percentOfWhole,
                                           .needs = flags.needs}),
            field(&PlateSize::areaM2, {.key = "area_m2",
                                       .flag = flags.area,
                                       .label = NM_TEXT("Area"),
                                       .help = NM_TEXT("Floor plate, m2"),
                                       .hint = "M2",
                                       .unit = "m2",
                                       .range = ValueRange{0, 1e12},
                                       .excludes = {flags.share},
                                       .needs = flags.needs})};
}

Fields<WallShape> makeWallFields(const PartFlags& flags) {
    return {field(&WallShape::taper,
                  {.key = "taper",
                   .flag = flags.taper,
                   .label = NM_TEXT("Taper"),
                   .help = NM_TEXT("How much narrower the volume is at its top than at its bottom"),
                   .hint = "PERCENT",
                   .unit = "%",
                   .range = ValueRange{0, 0.95},
                   .shownTimes = percentOfWhole,
                   .hasDefault = false,
                   .needs = flags.needs}),
            field(&WallShape::twistDeg,
                  {.key = "twist_clockwise_deg",
                   .flag = flags.twist,
                   .label = NM_TEXT("Twist"),
                   .help = NM_TEXT("Turn of the volume from its bottom to its top, clockwise"),
                   .unit = "deg",
                   .range = turnRangeDeg,
                   .hasDefault = false,
                   .needs = flags.needs})};
}

// The numbers between colons; empty where one of them is no number.
std::vector<double> numbersBetweenColons(const std::string& text) {
    std::vector<double> numbers;
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        const auto [next, error] = std::from_chars(at, end, numbers.emplace_back());
        if (error != std::errc{} || (next != end && *next != ':')) return {};
        if (next == end) return numbers;
        at = next + 1;
    }
}

std::string textOf(const Setback& setback) {
    std::string text = fmt::format("{}:{}", setback.aboveM, setback.insetM);
    if (!setback.walls.upright())
        text += fmt::format(":{}:{}", setback.walls.taper * percentOfWhole, setback.walls.twistDeg);
    return text;
}

Result<Setback> setbackFrom(const std::string& text) {
    std::vector<double> numbers = numbersBetweenColons(text);
    if (numbers.size() < 2 || numbers.size() > 4)
        return failure("It is not a setback", text,
                       "Give HEIGHT:INSET in metres, for example 60:3, or HEIGHT:INSET:TAPER:TWIST");
    numbers.resize(4);
    return Setback{numbers[0], numbers[1], {.taper = numbers[2] / percentOfWhole, .twistDeg = numbers[3]}};
}

std::string textOf(const FloorUse& use) {
    return use.storeys == 0 ? use.use + ":rest" : fmt::format("{}:{}", use.use, use.storeys);
}

Result<FloorUse> useFrom(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    FloorUse use{text.substr(0, colon), 0};
    if (colon == text.npos || text.substr(colon + 1) == "rest") return use;
    const char* const end = text.data() + text.size();
    const auto [last, error] = std::from_chars(text.data() + colon + 1, end, use.storeys);
    if (error == std::errc{} && last == end && use.storeys > 0) return use;
    return failure("It is not a use of storeys", text,
                   "Give USE:STOREYS, for example retail:2, or USE:rest for all storeys above");
}

std::string textOf(const FurtherTower& tower) {
    std::string text = fmt::format("{}", tower.storeys);
    if (tower.plate.areaM2) text += fmt::format(":{}", *tower.plate.areaM2);
    if (tower.plate.shareOfLot) text += fmt::format(":{}%", *tower.plate.shareOfLot * percentOfWhole);
    return text;
}

Result<FurtherTower> furtherFrom(const std::string& text) {
    const bool isShare = text.ends_with('%');
    const std::vector<double> numbers = numbersBetweenColons(text.substr(0, text.size() - (isShare ? 1 : 0)));
    const bool sound = numbers.size() == (isShare ? 2 : std::max<std::size_t>(numbers.size(), 1)) &&
                       numbers.size() <= 2 && numbers[0] == std::floor(numbers[0]) &&
                       std::abs(numbers[0]) <= storeyRange.max;
    if (!sound)
        return failure("It is not a further tower", text,
                       "Give STOREYS, STOREYS:M2 or STOREYS:PERCENT%, for example 20:600 or 20:30%");
    FurtherTower tower{.storeys = int(numbers[0])};
    if (isShare)
        tower.plate.shareOfLot = numbers[1] / percentOfWhole;
    else if (numbers.size() == 2)
        tower.plate.areaM2 = numbers[1];
    return tower;
}

template <auto list>
Value getTexts(const MassingSettings& settings) {
    std::vector<std::string> texts;
    for (const auto& one : settings.*list) texts.push_back(textOf(one));
    return texts;
}

template <auto list, auto parse>
Result<void> setTexts(MassingSettings& settings, const Value& value) {
    (settings.*list).clear();
    for (const std::string& text : std::get<std::vector<std::string>>(value)) {
        auto one = parse(text);
        if (!one) return tl::make_unexpected(one.error());
        (settings.*list).push_back(*std::move(one));
    }
    return {};
}

}  // namespace

const Fields<MassingSettings>& massingFields() {
    constexpr PartFlags flags{"--plate-share", "--plate-area", "--taper", "--twist"};
    static const auto fields =
        Fields<MassingSettings>{
            field(&MassingSettings::storeyHeightM, {.key = "storey_height_m",
                                                    .flag = "--storey-height",
                                                    .label = NM_TEXT("Storey height"),
                                                    .help = NM_TEXT("Height of a storey, floor to floor"),
                                                    .unit = "m",
                                                    .range = ValueRange{2, 10},
                                                    .restated = true}),
            field(&MassingSettings::storeys, {.key = "storeys",
                                              .flag = "--storeys",
                                              .label = NM_TEXT("Storeys"),
                                              .help = NM_TEXT("Number of storeys, podium included"),
                                              .hint = "N",
                                              .range = storeyRange,
                                              .hasDefault = false}),
            field(&MassingSettings::heightM, {.key = "height_m",
                                              .flag = "--height",
                                              .label = NM_TEXT("Height above ground"),
                                              .help = NM_TEXT("Total height"),
                                              .unit = "m",
                                              .range = aboveGroundRangeM,
                                              .hasDefault = false,
                                              .excludes = {"--storeys"}}),
            field(&MassingSettings::clockwiseDeg,
                  {.key = "clockwise_deg",
                   .flag = "--turn",
                   .label = NM_TEXT("Rotation"),
                   .help = NM_TEXT(
                       "Rotation clockwise about the middle of the tower, which must stay on its lot"),
                   .unit = "deg",
                   .range = turnRangeDeg,
                   .hasDefault = false}),
            field(&MassingSettings::gapM, {.key = "gap_m",
                                           .flag = "--gap",
                                           .label = NM_TEXT("Gap"),
                                           .help = NM_TEXT("Between the pieces of the lot of several towers"),
                                           .unit = "m",
                                           .range = ValueRange{1, maxStoreys}})}
            .embed(&MassingSettings::plate, makePlateFields(flags), "plate")
            .embed(&MassingSettings::walls, makeWallFields(flags));
    return fields;
}

const Fields<Podium>& podiumFields() {
    constexpr PartFlags flags{"--podium-share", "--podium-area", "--podium-taper", "--podium-twist",
                              "--podium"};
    static const auto fields =
        Fields<Podium>{field(&Podium::storeys, {.key = "storeys",
                                                .flag = "--podium",
                                                .label = NM_TEXT("Podium"),
                                                .help = NM_TEXT("Storeys of a podium below the tower"),
                                                .hint = "N",
                                                .range = ValueRange{1, storeyRange.max - 1},
                                                .hasDefault = false,
                                                .restated = true})}
            .embed(&Podium::plate, makePlateFields(flags), "plate")
            .embed(&Podium::walls, makeWallFields(flags));
    return fields;
}

const Fields<Setback>& setbackFields() {
    static const auto fields = Fields<Setback>{field(&Setback::aboveM, {.key = "above_m",
                                                                        .label = NM_TEXT("From height"),
                                                                        .unit = "m",
                                                                        .range = aboveGroundRangeM,
                                                                        .restated = true}),
                                               field(&Setback::insetM, {.key = "inset_m",
                                                                        .label = NM_TEXT("Inset"),
                                                                        .unit = "m",
                                                                        .range = aboveGroundRangeM,
                                                                        .restated = true})}
                                   .embed(&Setback::walls, makeWallFields({}));
    return fields;
}

const Fields<FloorUse>& floorUseFields() {
    static const Fields<FloorUse> fields{
        field(&FloorUse::use, {.key = "use", .label = NM_TEXT("Use"), .restated = true}),
        field(&FloorUse::storeys,
              {.key = "storeys", .label = NM_TEXT("Storeys"), .range = storeyRange, .restated = true})};
    return fields;
}

const Fields<FurtherTower>& furtherTowerFields() {
    static const auto fields =
        Fields<FurtherTower>{field(&FurtherTower::storeys, {.key = "storeys",
                                                            .label = NM_TEXT("Storeys"),
                                                            .range = ValueRange{1, storeyRange.max},
                                                            .restated = true})}
            .embed(&FurtherTower::plate, makePlateFields({}), "plate");
    return fields;
}

const Fields<MassingSettings>& massingListFields() {
    constexpr auto further = &MassingSettings::further;
    constexpr auto setbacks = &MassingSettings::setbacks;
    constexpr auto uses = &MassingSettings::uses;
    static const Fields<MassingSettings> fields{
        derivedField<MassingSettings>(
            ValueKind::texts, &getTexts<setbacks>, &setTexts<setbacks, &setbackFrom>,
            {.key = "setbacks",
             .flag = "--setback",
             .label = NM_TEXT("Setbacks"),
             .help = "Above HEIGHT m the walls are inset by INSET m, and taper and turn by TAPER % and TWIST "
                     "degrees up to the next setback; may be repeated",
             .hint = "HEIGHT:INSET[:TAPER[:TWIST]]"}),
        derivedField<MassingSettings>(
            ValueKind::texts, &getTexts<uses>, &setTexts<uses, &useFrom>,
            {.key = "uses",
             .flag = "--use",
             .label = NM_TEXT("Uses"),
             .help = "What the next STOREYS storeys from the ground up are used for; `rest`: all above; may "
                     "be repeated",
             .hint = "USE:STOREYS"}),
        derivedField<MassingSettings>(
            ValueKind::texts, &getTexts<further>, &setTexts<further, &furtherFrom>,
            {.key = "further",
             .flag = "--tower",
             .label = NM_TEXT("Further towers"),
             .help = "Another tower on the lot, apart from the first, of STOREYS storeys on a plate of M2 or "
                     "a share of the lot; may be repeated",
             .hint = "STOREYS[:M2|:PERCENT%]"})};
    return fields;
}

Result<void> checkRanges(const MassingSettings& settings) {
    auto sound = checkRanges(massingFields().of(settings));
    if (sound && settings.podium) sound = checkRanges(podiumFields().of(*settings.podium));
    for (const Setback& setback : settings.setbacks)
        if (sound) sound = checkRanges(setbackFields().of(setback));
    for (const FurtherTower& tower : settings.further)
        if (sound) sound = checkRanges(furtherTowerFields().of(tower));
    return sound;
}

}  // namespace noonmark
