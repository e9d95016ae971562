#include "core/describe/figure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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
        figure(
            &Harvest::sugarPct,
            {.key = "sugar_pct", .label = "Sugar", .whenMissing = std::numeric_limits<double>::quiet_NaN()})};
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

TEST(Figures, OfShadowKeepTheirKeys) {
    EXPECT_EQ(listColumns(shadowFigures().rows()),
              (std::vector<std::string>{"receivers", "receiver_area_m2", "water_m2", "shadow_area_m2",
                                        "mean_gross_min", "max_gross_min", "mean_continuous_min",
                                        "max_continuous_min"}));
}

}  // namespace
}  // namespace noonmark
