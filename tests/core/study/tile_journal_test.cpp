#include "core/study/tiles/tile_journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Key;

const TilePlan plan{{0, 0, 1, 200, 200}, 64};

class TileJournalTest : public testing::Test {
protected:
    [[nodiscard]] Result<TileJournal> opened(const std::string& study = "abc") const {
        return TileJournal::open(path, study, plan);
    }
    void finish(TileJournal& journal, std::size_t tile) const {
        std::ofstream(journal.fileOf({.number = tile})) << "cells";
        TileResult result{.number = tile, .sums = {7, 0.1, 1.0 / 3, 2, 3}};
        result.engineKey = "ray";
        result.engine = "Ray reference";
        result.cost.rays = 12;
        result.cost.skipped["cells under buildings"] = 5;
        result.cost.seconds["trace"] = 0.7;
        result.compared = {{{1.5, 2.5}, 0.1F, 0.2F, 3, 4}};
        result.withTrees = {{TreeColumns::evergreen, {7, 0.3, std::nan(""), 2.5, 0}, {1.0 / 7, 2}},
                            {TreeColumns::seasonal, {7, 0.2, 0.4, 2.5, 3}, {}}};
        result.treesHow = "rays";
        ASSERT_TRUE(journal.add(result));
    }

    tests::TemporaryFolder folder;
    std::filesystem::path path = folder.path("made/shadow.tif.tiles");
};

TEST_F(TileJournalTest, WhatWasFinishedComesBackToTheLastBit) {
    {
        auto journal = opened();
        ASSERT_TRUE(journal) << journal.error().text();
        EXPECT_TRUE(journal->finished().empty());
        finish(*journal, 3);
        ASSERT_TRUE(journal->add({.number = 5}));
    }
    const auto again = opened();
    ASSERT_TRUE(again);
    EXPECT_THAT(again->finished(), ElementsAre(Key(3), Key(5)));
    const TileResult& result = again->finished().at(3);
    EXPECT_EQ(result.sums.continuousMin, 1.0 / 3);
    EXPECT_EQ(result.sums.receivers, 7U);
    ASSERT_EQ(result.withTrees.size(), 2);
    EXPECT_EQ(result.withTrees[1].column, TreeColumns::seasonal);
    EXPECT_EQ(result.sumsOf(TreeColumns::evergreen).grossMin, 0.3);
    EXPECT_TRUE(std::isnan(result.sumsOf(TreeColumns::evergreen).continuousMin));
    EXPECT_THAT(result.monthMinutesOf(TreeColumns::evergreen), ElementsAre(1.0 / 7, 2));
    EXPECT_EQ(result.treesHow, "rays");
    EXPECT_EQ(again->finished().at(5).sumsOf(TreeColumns::seasonal).receivers, 0U) << "those without trees";
    EXPECT_EQ(result.compared.at(0).referenceGrossMin, double(0.2F));
    EXPECT_EQ(result.compared.at(0).centreM, glm::dvec2(1.5, 2.5));
    EXPECT_EQ(result.cost.skipped.at("cells under buildings"), 5U);
    EXPECT_EQ(result.cost.rays, 12U);
    EXPECT_EQ(result.engineKey, "ray");
    EXPECT_TRUE(again->finished().at(5).empty());
}

TEST_F(TileJournalTest, RunsThatWereNotCountedComeBackAsSuch) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    {
        auto journal = opened();
        TileResult result{.number = 1, .sums = {7, 0.1, none, 2, 0}};
        result.compared = {{{1.5, 2.5}, 1, 2, none, 4}};
        std::ofstream(journal->fileOf({.number = 1})) << "cells";
        ASSERT_TRUE(journal->add(result));
    }
    const auto again = opened();
    ASSERT_THAT(again->finished(), ElementsAre(Key(1)));
    EXPECT_TRUE(std::isnan(again->finished().at(1).sums.continuousMin));
    EXPECT_TRUE(std::isnan(again->finished().at(1).compared.at(0).continuousMin));
    EXPECT_EQ(again->finished().at(1).compared.at(0).referenceContinuousMin, 4);
}

TEST_F(TileJournalTest, ALineThatWasCutOffIsNotThereAndDoesNoHarm) {
    {
        auto journal = opened();
        finish(*journal, 1);
        finish(*journal, 2);
    }
    const auto file = path / "journal.jsonl";
    std::filesystem::resize_file(file, std::filesystem::file_size(file) - 9);
    {
        auto journal = opened();
        EXPECT_THAT(journal->finished(), ElementsAre(Key(1)));
        finish(*journal, 2);
    }
    EXPECT_THAT(opened()->finished(), ElementsAre(Key(1), Key(2)));
}

TEST_F(TileJournalTest, ATileWithoutItsFileIsNotFinished) {
    {
        auto journal = opened();
        finish(*journal, 1);
        finish(*journal, 2);
        std::filesystem::remove(journal->fileOf({.number = 2}));
    }
    EXPECT_THAT(opened()->finished(), ElementsAre(Key(1)));
}

TEST_F(TileJournalTest, TilesOfAnotherStudyAreRefused) {
    { auto journal = opened("abc"); }
    const auto other = opened("def");
    ASSERT_FALSE(other);
    EXPECT_THAT(other.error().text(), HasSubstr("another study"));
    EXPECT_FALSE(TileJournal::open(path, "abc", {plan.whole, 128}));
    EXPECT_TRUE(opened("abc"));
}

TEST_F(TileJournalTest, OneProcessAtATime) {
    const auto first = opened();
    const auto second = opened();
    ASSERT_FALSE(second);
    EXPECT_THAT(second.error().text(), HasSubstr("is working"));
}

TEST_F(TileJournalTest, IsGoneWhenRemoved) {
    auto journal = opened();
    finish(*journal, 1);
    journal->remove();
    EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(TileJournalTest, AFolderThatCannotBeMadeIsAnError) {
    path = folder.file("in the way", "a file") / "tiles";
    const auto journal = opened();
    ASSERT_FALSE(journal);
    EXPECT_THAT(journal.error().text(), HasSubstr("in the way"));
}

}  // namespace
}  // namespace noonmark
