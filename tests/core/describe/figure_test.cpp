#include "core/describe/figure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/base/json_number.h"
#include "core/describe/figure_text.h"
#include "core/measures/shadow_figures.h"

namespace noonmark {
namespace {

using Json = nlohmann::ordered_json;

struct Harvest {
    std::size_t apples = 3;
    double weightKg = 0.75;
    double sugarPct = std::numeric_limits<double>::quiet_NaN();  // not measured
};

const Figures<Harvest>& harvestFigures() {
    static const Figures<Harvest> figures{
        figure(&Harvest::apples, {.key = "apples", .label = "Apples", .definition = "number of apples"}),
        figure(&Harvest::weightKg, {.key = "weight_kg", .label = "Weight", .decimals = 2}),
        figure(&Harvest::sugarPct, {.key = "sugar_pct",
                                    .label = "Sugar",
                                    .valueIfMissing = std::numeric_limits<double>::quiet_NaN()})};
    return figures;
}

TEST(Figures, AreWrittenAndReadByKey) {
    const Json json = figuresJson(harvestFigures().of(Harvest{}));
    EXPECT_EQ(json.dump(), R"({"apples":3,"weight_kg":0.75,"sugar_pct":null})");
    const Harvest back = readFigures(harvestFigures(), Json::parse(json.dump()));
    EXPECT_EQ(back.apples, 3U);
    EXPECT_EQ(back.weightKg, 0.75);
    EXPECT_TRUE(std::isnan(back.sugarPct));
}

TEST(Figures, ThatEarlierVersionsLackHaveTheirValueOrAreAnError) {
    const Json json{{"apples", 2}, {"weight_kg", 1.5}};
    EXPECT_TRUE(std::isnan(readFigures(harvestFigures(), json).sugarPct));
    EXPECT_THROW(readFigures(harvestFigures(), Json{{"apples", 2}}), Json::exception);
    EXPECT_THROW(readFigures(harvestFigures(), Json{{"apples", 2.5}, {"weight_kg", 1}}), std::out_of_range);
    EXPECT_THROW(readFigures(harvestFigures(), Json{{"apples", -1}, {"weight_kg", 1}}), std::out_of_range);
    EXPECT_THROW(readFigures(harvestFigures(), Json{{"apples", 1}, {"weight_kg", "a"}}), Json::exception);
}

TEST(Figures, AreColumnsWithTheirDecimals) {
    CsvText csv(listColumns(harvestFigures().rows()));
    addFigures(csv, harvestFigures().of(Harvest{}));
    csv.endRow();
    EXPECT_EQ(csv.take(), "apples,weight_kg,sugar_pct\r\n3,0.75,\r\n");
    EXPECT_EQ(definitionsJson(harvestFigures().rows()), (Json{{"apples", "number of apples"}}));
}

// 0.0625 lies in the middle of two texts of three digits, 1.005 a little below that of two.
TEST(Figures, JsonAndCsvRoundHalvesAlike) {
    struct Half {
        double value = 0;
    };
    static const Figures<Half> table{figure(&Half::value, {.key = "v", .decimals = 3, .jsonDecimals = 3})};
    for (const double value : {0.0625, 0.1875, 2.0625, -0.0625, 1.0005, 0.5, 12345.0}) {
        CsvText csv({"v"});
        addFigures(csv, table.of(Half{value}));
        csv.endRow();
        const std::string text = csv.take();
        EXPECT_EQ(figuresJson(table.of(Half{value}))["v"].get<double>(), std::stod(text.substr(3))) << text;
    }
    EXPECT_EQ(roundAsText(0.0625, 3), 0.062) << "halves go to the even digit";
    EXPECT_EQ(roundAsText(1.005, 2), 1.0) << "it is 1.00499999999999989...";
    EXPECT_TRUE(std::isnan(roundAsText(std::nan(""), 2)));
}

struct Wind {
    double grossMin = 90, runMin = std::numeric_limits<double>::quiet_NaN();
    double areaM2 = 1234, changeM2 = 12, waterM2 = 0, weight = 0.125, gusts = 6;
};

const Figures<Wind>& windFigures() {
    static const Figures<Wind> figures{
        figure(
            &Wind::areaM2,
            {.key = "area_m2", .label = "Area", .unit = FigureUnit::squareMetres, .use = FigureUse::basis}),
        figure(&Wind::waterM2, {.key = "water_m2",
                                .label = "Water",
                                .unit = FigureUnit::squareMetres,
                                .use = FigureUse::basis,
                                .onlyIfPositive = true}),
        figure(&Wind::changeM2, {.key = "change_m2",
                                 .label = "Change",
                                 .definition = "more of it",
                                 .unit = FigureUnit::squareMetres,
                                 .whole = Whole::area,
                                 .isChange = true}),
        figure(&Wind::grossMin, {.key = "gross_min",
                                 .label = "Wind",
                                 .definition = "time of wind",
                                 .unit = FigureUnit::hoursADay,
                                 .together = Aggregation::mean}),
        figure(&Wind::runMin, {.key = "run_min", .label = "Longest", .unit = FigureUnit::minutes}),
        figure(&Wind::weight,
               {.key = "weight", .label = "Weight", .use = FigureUse::file, .together = Aggregation::max}),
        derivedFigure<Wind>([](const Wind& wind) { return wind.gusts / 2; },
                            {.key = "pairs", .label = "Pairs of gusts", .inFiles = false})};
    return figures;
}

std::string textOf(const std::vector<FigureLine>& lines) {
    std::string text;
    for (const FigureLine& line : lines) text += labelOf(line) + '=' + valueOf(line) + ';';
    return text;
}

TEST(Figures, AreReadByPeopleWithUnitSignAndShareResultsFirst) {
    EXPECT_EQ(textOf(listLines(windFigures().of(Wind{}), {.areaM2 = 48, .sunlitMin = 360})),
              "Change=+12 m² (25 %);Wind=1.5 h a day;Longest=not counted;Pairs of gusts=3;Area=1,234 m²;");
    EXPECT_EQ(textOf(listLines(windFigures().of(Wind{}), FigureUse::result, {.isInstant = true})),
              "Change=+12 m²;Pairs of gusts=3;");
    EXPECT_EQ(valueOf(listLines(windFigures().of(Wind{})).front(), UnitSystem::imperial), "+129 sq ft");
    EXPECT_EQ(joinLines(listLines(windFigures().of(Wind{}), FigureUse::basis)), "area 1,234 m²");
    EXPECT_EQ(definitionsOf(listLines(windFigures().of(Wind{}))), "Change: more of it. Wind: time of wind.");
}

TEST(Figures, SayWhichMeasureAndThresholdTheyAreOf) {
    const Figure& change = findFigure(windFigures().rows(), "change_m2");
    EXPECT_EQ(labelOf({.figure = &change, .measure = "Gross"}), "Gross: change");
    EXPECT_EQ(labelOf({.figure = &change, .measure = "Gross", .thresholdMin = 30}), "Gross > 30 min: change");
}

TEST(Figures, ThatFollowFromOthersAreInNoFile) {
    EXPECT_FALSE(figuresJson(windFigures().of(Wind{})).contains("pairs"));
    EXPECT_EQ(listColumns(windFigures().rows()).back(), "weight");
    EXPECT_EQ(readFigures(windFigures(), figuresJson(windFigures().of(Wind{.weight = 2}))).weight, 2);
}

TEST(Figures, OfPiecesAreAddedUp) {
    Wind whole{.grossMin = 60, .changeM2 = 10, .weight = 3};
    const Wind piece{.grossMin = 120, .changeM2 = 5, .weight = 2};
    addPiece(windFigures().rows(), &whole, 3, &piece, 1);
    EXPECT_EQ(whole.grossMin, 75);
    EXPECT_EQ(whole.changeM2, 15);
    EXPECT_EQ(whole.weight, 3);
}

TEST(Figures, OfShadowKeepTheirKeys) {
    EXPECT_EQ(listColumns(shadowFigures().rows()),
              (std::vector<std::string>{"receivers", "receiver_area_m2", "water_m2", "shadow_area_m2",
                                        "mean_gross_min", "max_gross_min", "mean_sun_min",
                                        "mean_continuous_min", "max_continuous_min"}));
}

TEST(Figures, OfShadowAreToldAsSunWhereSunIsShown) {
    const ShadowStatistics statistics{.receivers = 1,
                                      .receiverAreaM2 = 100,
                                      .shadowAreaM2 = 40,
                                      .meanGrossMin = 240,
                                      .maxGrossMin = 480,
                                      .meanSunMin = 360};
    const auto linesAs = [&](ShownAs show) {
        return joinLines(listLines(shadowFigures().of(statistics), FigureUse::result,
                                   {.areaM2 = 100, .sunlitMin = 600, .show = show}));
    };
    EXPECT_TRUE(linesAs(ShownAs::sun)
                    .starts_with("mean sun 6 h a day (60 %), least sun 2 h a day (20 %), "
                                 "sunlit area 60 m² (60 %), "))
        << linesAs(ShownAs::sun);
    EXPECT_EQ(linesAs(ShownAs::sun).find("gross"), std::string::npos);
    EXPECT_EQ(linesAs(ShownAs::shadow).find("least sun"), std::string::npos);
    EXPECT_NE(linesAs(ShownAs::shadow).find("mean gross 240 min a day (40 %)"), std::string::npos);
}

}  // namespace
}  // namespace noonmark
