#include "core/receivers/made_names.h"

#include <gtest/gtest.h>

namespace noonmark {
namespace {

std::vector<std::string> argumentsOf(const Sentence& sentence) {
    std::vector<std::string> texts;
    for (const Sentence::Argument& one : sentence.arguments) texts.push_back(std::get<std::string>(one));
    return texts;
}

void expectMade(std::string_view pattern, const std::vector<std::string>& of) {
    const std::string name = fillIn(pattern, of);
    const auto found = findMadeName(name);
    ASSERT_TRUE(found) << name;
    EXPECT_EQ(found->source, pattern);
    EXPECT_EQ(argumentsOf(*found), of);
}

TEST(MadeNames, AreFoundAsTheyWereMade) {
    expectMade(madeNames::carriageway, {"Rue Grimaldi"});
    expectMade(madeNames::sidewalks, {"Rue Grimaldi, Rue Baron to Place d'Armes"});
    expectMade(madeNames::between, {"Rue Grimaldi", "Rue Baron", "Place d'Armes"});
    expectMade(madeNames::at, {"Rue Grimaldi", "Rue Baron"});
    for (const std::string_view wind : madeNames::winds) expectMade(wind, {"Main Street", "2nd Avenue"});
    for (const std::string_view whole : {madeNames::wholeCity, madeNames::cityMiddle}) expectMade(whole, {});
    expectMade(madeNames::around, {"Tower, east"});
    expectMade(madeNames::severalSources, {"OSM way 12", "3"});
}

TEST(MadeNames, NamesOfTheDataAreNone) {
    for (const char* name : {"Rue Grimaldi", "Square, old", ", carriageway", "Two and two more", "to", ""})
        EXPECT_FALSE(findMadeName(name)) << name;
}

TEST(MadeNames, ANumberIsSplitFromItsNameAndNoOtherAppendix) {
    EXPECT_EQ(numberName("Garden", 1), "Garden");
    EXPECT_EQ(numberName("Garden", 2), "Garden (2)");
    const auto split = splitNumber("Garden (west) (12)");
    ASSERT_TRUE(split);
    EXPECT_EQ(split->name, "Garden (west)");
    EXPECT_EQ(split->number, " (12)");
    for (const char* name : {"Garden", "Garden (my note)", "Garden ()", " (2)", "Garden(2)", "Garden (2) "})
        EXPECT_FALSE(splitNumber(name)) << name;
}

}  // namespace
}  // namespace noonmark
