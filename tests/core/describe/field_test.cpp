#include "core/describe/field.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/describe/command_options.h"
#include "core/describe/field_json.h"
#include "core/describe/field_values.h"

namespace noonmark {
namespace {

using ::testing::ElementsAre;
using Json = nlohmann::ordered_json;

enum class Roof { flat, gabled };
constexpr std::array roofs{Choice{Roof::flat, "flat"}, Choice{Roof::gabled, "gabled"}};

struct Garden {
    double wideM = 4;
    std::optional<std::string> gate;
    bool operator==(const Garden&) const = default;
};

/// A struct with a member of every kind.
struct House {
    double heightM = 8;
    int storeys = 2;
    bool hasCellar = false;
    bool isHeated = true;
    std::string name;
    std::optional<Roof> roof;
    std::vector<double> windowsM{1, 2};
    std::vector<std::string> owners;
    NamedNumbers rooms;
    Garden garden;
    bool operator==(const House&) const = default;
};

const Fields<Garden>& gardenFields() {
    static const Fields<Garden> fields{
        field(&Garden::wideM,
              {.key = "wide_m", .flag = "--wide", .label = "Width", .unit = "m", .range = ValueRange{1, 50}}),
        field(&Garden::gate, {.key = "gate", .flag = "--gate"}).when([](const Garden& garden) {
            return garden.wideM > 2;
        })};
    return fields;
}

const Fields<House>& houseFields() {
    static const auto fields =
        Fields<House>{
            field(&House::heightM, {.key = "height_m",
                                    .flag = "--height",
                                    .label = "Height",
                                    .unit = "m",
                                    .range = ValueRange{2, 100},
                                    .restated = true}),
            field(&House::storeys, {.key = "storeys", .flag = "--storeys", .range = ValueRange{1, 30}}),
            field(&House::hasCellar, {.key = "cellar", .flag = "--cellar"}),
            field(&House::isHeated, {.key = "heated", .flag = "--no-heating"}),
            field(&House::name, {.key = "name", .flag = "--name", .role = SettingRole::none}),
            choiceField(&House::roof, roofs, {.key = "roof", .flag = "--roof"}),
            field(&House::windowsM, {.key = "windows_m", .flag = "--windows", .range = ValueRange{0.1, 5}}),
            field(&House::owners, {.key = "owners", .flag = "--owner", .role = SettingRole::extra}),
            field(&House::rooms, {.key = "rooms", .flag = "--room"})}
            .embed(&House::garden, gardenFields(), "garden");
    return fields;
}

House grand() {
    return {.heightM = 20.25,
            .storeys = 5,
            .hasCellar = true,
            .isHeated = false,
            .name = "Villa; \"A\"",
            .roof = Roof::gabled,
            .windowsM = {0.5, 1.25},
            .owners = {"Ann", "Bo"},
            .rooms = {{"bath", 2}, {"bed", 4}},
            .garden = {.wideM = 30, .gate = "iron"}};
}

std::string commandOf(const House& house) {
    std::string command;
    for (const CommandOption& option : listOptions(houseFields().of(house))) {
        command += option.name;
        for (const std::string& value : option.values) command += "=" + value;
        command += ' ';
    }
    return command;
}

TEST(Fields, ComeBackFromJson) {
    House back;
    ASSERT_TRUE(readFieldsJson(houseFields().of(back), fieldsJson(houseFields().of(grand()))));
    EXPECT_EQ(back, grand());
    House again = grand();
    ASSERT_TRUE(readFieldsJson(houseFields().of(again), fieldsJson(houseFields().of(House{}))));
    EXPECT_EQ(again.roof, std::nullopt) << "null unsets";
}

TEST(Fields, AreWrittenByKeyAndGroup) {
    EXPECT_EQ(fieldsJson(houseFields().of(House{})),
              Json::parse(R"({"height_m": 8.0, "storeys": 2, "cellar": false, "heated": true, "name": "",
                  "roof": null, "windows_m": [1.0, 2.0], "owners": [], "rooms": {},
                  "garden": {"wide_m": 4.0, "gate": null}})"));
    House house;
    house.roof = Roof::gabled;
    EXPECT_EQ(fieldsJson(houseFields().of(house), {.which = FieldJson::Which::changed}),
              Json::parse(R"({"roof": "gabled"})"));
    EXPECT_EQ(fieldsJson(houseFields().of(house), {FieldJson::Which::changed, FieldJson::Choices::numbers}),
              Json::parse(R"({"roof": 1})"));
    house.garden.wideM = 2;
    EXPECT_FALSE(fieldsJson(houseFields().of(house)).at("garden").contains("gate")) << "does not apply";
    EXPECT_TRUE(
        fieldsJson(houseFields().of(house), {.which = FieldJson::Which::all}).at("garden").contains("gate"));
}

TEST(Fields, RefuseJsonOfAnotherKind) {
    for (const char* text : {R"({"height_m": "8"})", R"({"storeys": 2.5})", R"({"storeys": 1e300})",
                             R"({"storeys": -9223372036854775808})", R"({"cellar": 1})", R"({"name": null})",
                             R"({"roof": "thatched"})", R"({"roof": 2})", R"({"roof": -1})",
                             R"({"windows_m": 3})", R"({"windows_m": ["a"]})", R"({"owners": [1]})",
                             R"({"rooms": {"bath": "two"}})", R"({"garden": {"wide_m": []}})", "[]", "7"}) {
        House house;
        const auto read = readFieldsJson(houseFields().of(house), Json::parse(text));
        EXPECT_FALSE(read) << text;
        EXPECT_EQ(house, House{}) << text;
    }
    House house;
    ASSERT_TRUE(readFieldsJson(houseFields().of(house), Json::parse(R"({"roof": 1, "unknown": 7})")));
    EXPECT_EQ(house.roof, Roof::gabled);
}

TEST(Fields, AreRestatedAsOptions) {
    EXPECT_EQ(commandOf(House{}), "--height=8 ");
    EXPECT_EQ(commandOf(grand()),
              "--height=20.25 --storeys=5 --cellar --no-heating --name=Villa; \"A\" --roof=gabled "
              "--windows=0.5,1.25 --owner=Ann --owner=Bo --room=bath=2 --room=bed=4 --wide=30 --gate=iron ");
}

TEST(Fields, CheckTheirRanges) {
    EXPECT_TRUE(checkRanges(houseFields().of(grand())));
    House house;
    house.heightM = 101;
    const auto error = checkRanges(houseFields().of(house)).error();
    EXPECT_EQ(error.text(), "height: Height: 101 m is out of range. Give 2 to 100 m");
    house = {};
    house.heightM = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(checkRanges(houseFields().of(house)));
    house = {};
    house.windowsM.push_back(6);
    EXPECT_FALSE(checkRanges(houseFields().of(house)));
    house = {};
    house.garden.wideM = 0;
    EXPECT_EQ(checkRanges(houseFields().of(house)).error().where, "wide");
}

TEST(Fields, DecideTheQuestionByTheirRole) {
    const std::string text = questionText(houseFields().of(House{}));
    House house;
    house.name = "Renamed";
    house.owners = {"Ann"};
    EXPECT_EQ(questionText(houseFields().of(house)), text);
    EXPECT_NE(questionText(houseFields().of(house), true), questionText(houseFields().of(House{}), true));
    // A value that looks like the next field is not taken for it.
    House one, other;
    one.rooms = {{"a=1,b", 2}};
    other.rooms = {{"a", 1}, {"b", 2}};
    EXPECT_NE(questionText(houseFields().of(one)), questionText(houseFields().of(House{})));
    EXPECT_NE(commandOf(one), commandOf(other));
}

TEST(Fields, ReadWhatUsersType) {
    const auto value = [](std::string_view flag, const char* text) {
        for (const Field& field : houseFields().rows())
            if (field.flag == flag) return parseValue(field, text);
        return Result<Value>();
    };
    EXPECT_EQ(value("--height", "+1.5e1").value(), Value(15.0));
    EXPECT_EQ(value("--storeys", "3").value(), Value(std::int64_t(3)));
    EXPECT_EQ(value("--room", "bath=yes,bed=3").value(), Value(NamedNumbers{{"bath", 1}, {"bed", 3}}));
    EXPECT_EQ(value("--windows", "0.5,1").value(), Value(std::vector{0.5, 1.0}));
    for (const auto& [flag, text] : {std::pair{"--height", "8 m"},
                                     {"--height", ""},
                                     {"--storeys", "2.5"},
                                     {"--roof", "thatched"},
                                     {"--room", "bath"},
                                     {"--room", "=2"},
                                     {"--room", "bath=two"},
                                     {"--windows", "1,,2"}})
        EXPECT_FALSE(value(flag, text)) << flag << ' ' << text;
}

}  // namespace
}  // namespace noonmark
