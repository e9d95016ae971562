#include "core/study/provenance/command_text.h"

#include <gtest/gtest.h>

#include <random>

namespace noonmark::tests {
namespace {

using Words = std::vector<std::string>;

TEST(CommandLineText, AreSplitAsAShellSplitsThem) {
    EXPECT_EQ(splitCommand("a  b\tc \\\n  d").value(), (Words{"a", "b", "c", "d"}));
    EXPECT_EQ(splitCommand(R"(--a='x y' "q\"r" e\ f '' 'it'\''s')").value(),
              (Words{"--a=x y", "q\"r", "e f", "", "it's"}));
    EXPECT_TRUE(splitCommand("").value().empty());
}

TEST(CommandLineText, WhatAShellWouldRunIsRefused) {
    for (const char* command :
         {"a; rm b", "a `b`", "a $(b)", "a | b", "a > b", "a 'b", "a \"b", "a *", "a && b"})
        EXPECT_FALSE(splitCommand(command)) << command;
    EXPECT_EQ(splitCommand("'a; rm b' '$(b)'").value(), (Words{"a; rm b", "$(b)"}));
}

TEST(CommandLineText, AnyTextComesBackAsOneWord) {
    std::mt19937 random(16);
    const std::string letters = "ab -='\"\\\n\t$`;|*?é城";
    for (int round = 0; round < 2000; ++round) {
        std::string text;
        for (auto left = random() % 12; left > 0; --left) text += letters[random() % letters.size()];
        CommandLineText line("p");
        line.option("--name", text);
        line.file("f" + text);
        Words words = splitCommand(line.wrapped(20)).value();
        ASSERT_GE(words.size(), 3U) << text;
        const bool joined = words[1] != "--name";
        EXPECT_EQ(joined ? words[1].substr(7) : words[2], text);
        EXPECT_EQ(words.back(), "f" + text);
        EXPECT_EQ(words.size(), joined ? 3U : 4U) << text;
    }
}

TEST(CommandLineText, ARecordStatesTheOptionsThatDrawTheSame) {
    const std::string record = R"({"repeat": "noonmark-cli study a.gpkg --out repeated", "receivers": 1})";
    const std::vector<CommandOption> drawn{{"--show", {"sun"}}, {"--reverse-ramp", {}}};
    EXPECT_EQ(extendRepeat(record, {}), record);
    EXPECT_NE(extendRepeat(record, drawn)
                  .find("\"noonmark-cli study a.gpkg --out repeated --show sun --reverse-ramp\""),
              std::string::npos);
    const std::string without = R"({"repeat": null})";
    EXPECT_EQ(extendRepeat(without, drawn), without) << "no command to extend";
}

}  // namespace
}  // namespace noonmark::tests
