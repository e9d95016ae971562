#include "scenarios/massing/massing_fields.h"

#include "scenarios/impact/impact.h"
#include "scenarios/project/title_fields.h"
#include "tests/shared/changed_fields.h"

namespace noonmark {
namespace {

using namespace tests;

// A member that is added needs a row in its table; then this number grows with it.
static_assert(countMembers<MassingSettings>() == 11);
static_assert(countMembers<Podium>() == 3);
static_assert(countMembers<Setback>() == 3);
static_assert(countMembers<FloorUse>() == 2);
static_assert(countMembers<FurtherTower>() == 2);
static_assert(countMembers<PlateSize>() == 2);
static_assert(countMembers<WallShape>() == 2);

TEST(SettingsFields, NoneOfATowerIsForgotten) {
    expectNoticed(massingFields(), MassingSettings{});
    expectNoticed(podiumFields(), Podium{});
    expectNoticed(setbackFields(), Setback{});
    expectNoticed(floorUseFields(), FloorUse{});
    expectNoticed(furtherTowerFields(), FurtherTower{});
}

static_assert(countMembers<ImpactSettings>() == 3);

TEST(SettingsFields, NoneOfAComparisonIsForgotten) { expectNoticed(impactFields(), ImpactSettings{}); }

static_assert(countMembers<TitleBlock>() == 6);
static_assert(countMembers<SheetSettings>() == 2);

TEST(SettingsFields, NoneOfTheSheetsOfAProjectIsForgotten) { expectNoticed(sheetFields(), SheetSettings{}); }

TEST(MassingFields, ListsAreWrittenAsTexts) {
    MassingSettings settings{.setbacks = {{60, 2.5}, {80, 1, {.taper = 0.25, .twistDeg = -15}}},
                             .uses = {{"retail: shops", 2}, {"homes", 0}},
                             .further = {{20, {}}, {12, {.areaM2 = 600}}, {9, {.shareOfLot = 0.3}}}};
    const std::vector<CommandOption> expected{{"--setback", {"60:2.5"}},
                                              {"--setback", {"80:1:25:-15"}},
                                              {"--use", {"retail: shops:2"}},
                                              {"--use", {"homes:rest"}},
                                              {"--tower", {"20"}},
                                              {"--tower", {"12:600"}},
                                              {"--tower", {"9:30%"}}};
    EXPECT_EQ(listOptions(massingListFields().of(settings)), expected);
    MassingSettings back;
    for (const Field& field : massingListFields().rows())
        ASSERT_TRUE(field.set(&back, field.get(&settings))) << field.key;
    EXPECT_EQ(back, settings);
}

TEST(MassingFields, AFurtherTowerIsStoreysAndAPlate) {
    const Field& tower = massingListFields().rows().back();
    ASSERT_EQ(tower.flag, "--tower");
    MassingSettings settings;
    for (const char* wrong : {"", "x", "20:", "20.5", "%", "20%", "1e12", "20:600:1", "nan"})
        EXPECT_FALSE(tower.set(&settings, std::vector<std::string>{wrong})) << wrong;
}

TEST(MassingFields, SharesAreWrittenInPercent) {
    MassingSettings settings{.plate = {.shareOfLot = 0.4}, .walls = {.taper = 0.25}};
    const std::vector<CommandOption> expected{
        {"--storey-height", {"3.5"}}, {"--plate-share", {"40"}}, {"--taper", {"25"}}};
    EXPECT_EQ(listOptions(massingFields().of(settings)), expected);
    settings.walls.taper = 0.96;
    EXPECT_EQ(checkRanges(settings).error().advice, "Give 0 to 95 %");
}

}  // namespace
}  // namespace noonmark
