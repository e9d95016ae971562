#include "app/cli/options/field_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/cli/options/project_options.h"

namespace noonmark::cli {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

enum class Colour { red, green };
constexpr std::array colours{Choice{Colour::red, "red"}, Choice{Colour::green, "green"}};

struct Kite {
    double tailM = 2.5;
    int bows = 3;
    bool isFlying = true;
    Colour colour = Colour::red;
    std::vector<double> stringsM;
    std::vector<std::string> names;
    NamedNumbers knots;
};

const Fields<Kite>& kiteFields() {
    static const Fields<Kite> fields{
        field(&Kite::tailM, {.key = "tail_m",
                             .flag = "--tail",
                             .help = "Length of the tail",
                             .unit = "m",
                             .range = ValueRange{1, 9}}),
        field(&Kite::bows, {.key = "bows", .flag = "--bows", .hint = "N", .range = ValueRange{0, 30}}),
        field(&Kite::isFlying, {.key = "flying", .flag = "--no-flight", .needs = "--bows"}),
        choiceField(&Kite::colour, colours,
                    {.key = "colour", .flag = "--colour", .hint = "COLOUR", .excludes = {"--tail"}}),
        field(&Kite::stringsM, {.key = "strings_m", .flag = "--strings", .range = ValueRange{1, 99}}),
        field(&Kite::names, {.key = "names", .flag = "--name"}),
        field(&Kite::knots, {.key = "knots", .flag = "--knot"})};
    return fields;
}

struct FieldOptionsTest : ::testing::Test {
    Kite kite;
    std::set<std::string, std::less<>> given;
    CLI::App app{"kites", "kites"};

    void SetUp() override {
        addFieldOptions(app, kiteFields().of(kite),
                        {.names = {{"--tail", "--tail,--length"}}, .given = &given});
    }

    bool parse(const std::string& line) {
        try {
            app.parse(line);
            return true;
        } catch (const CLI::ParseError&) {
            return false;
        }
    }
};

TEST_F(FieldOptionsTest, FillTheObject) {
    ASSERT_TRUE(parse(
        "--length 4.5 --bows 7 --no-flight --strings 1.5,20 --name a,b --name c --knot x=2 --knot y=yes"));
    EXPECT_EQ(kite.tailM, 4.5);
    EXPECT_EQ(kite.bows, 7);
    EXPECT_FALSE(kite.isFlying);
    EXPECT_THAT(kite.stringsM, ElementsAre(1.5, 20));
    EXPECT_THAT(kite.names, ElementsAre("a,b", "c"));
    EXPECT_EQ(kite.knots, (NamedNumbers{{"x", 2}, {"y", 1}}));
    EXPECT_THAT(given, ElementsAre("--bows", "--knot", "--name", "--no-flight", "--strings", "--tail"));
}

TEST_F(FieldOptionsTest, HaveTheHelpOfTheTable) {
    const std::string help = app.help();
    EXPECT_THAT(help, HasSubstr("--tail,--length M:1 to 9=2.5 Excludes: --colour"));
    EXPECT_THAT(help, HasSubstr("Length of the tail"));
    EXPECT_THAT(help, HasSubstr("--colour COLOUR:{red,green}=red Excludes: --tail"));
}

TEST_F(FieldOptionsTest, RefuseWhatTheTableRefuses) {
    for (const char* line : {"--tail 10", "--tail nan", "--tail 2m", "--bows 2.5", "--bows 31",
                             "--colour blue", "--strings 1.5,200", "--strings a", "--knot x", "--knot =1",
                             "--no-flight", "--colour red --tail 2"})
        EXPECT_FALSE(parse(line)) << line;
}

TEST(ProjectZone, IsThatOfThePeriodsElseOfTheStudyInTheWindow) {
    Project project;
    EXPECT_FALSE(commonZone(project));
    project.view["study"] = "not a study";
    EXPECT_FALSE(commonZone(project));
    project.view["study"] = R"({"period":{"zone":"America/Chicago"}})";
    EXPECT_EQ(commonZone(project), "America/Chicago");
    project.periods = {{"spring", {.zone = "Europe/Berlin"}}};
    EXPECT_EQ(commonZone(project), "Europe/Berlin");
    project.periods.push_back({"autumn", {.zone = "Europe/Paris"}});
    EXPECT_FALSE(commonZone(project));
}

}  // namespace
}  // namespace noonmark::cli
