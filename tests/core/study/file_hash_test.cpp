#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/study/study.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

TEST(FileHash, KnownSums) {
    const tests::TemporaryFolder folder;
    const auto empty = describeInputFile(folder.file("empty", ""));
    ASSERT_TRUE(empty);
    EXPECT_EQ(empty->bytes, 0U);
    EXPECT_EQ(empty->sha256, "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    const auto abc = describeInputFile(folder.file("abc", "abc"));
    ASSERT_TRUE(abc);
    EXPECT_EQ(abc->bytes, 3U);
    EXPECT_EQ(abc->sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    const auto million = describeInputFile(folder.file("million", std::string(1000000, 'a')));
    EXPECT_EQ(million->sha256, "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(FileHash, LongerThanOnePieceDependsOnEveryByte) {
    const tests::TemporaryFolder folder;
    std::string bytes(3'000'000, 'x');
    const auto before = describeInputFile(folder.file("long", bytes));
    bytes.back() = 'y';
    const auto after = describeInputFile(folder.file("long", bytes));
    ASSERT_TRUE(before && after);
    EXPECT_NE(before->sha256, after->sha256);
}

TEST(FileHash, AShapefileIsSeveralFiles) {
    const tests::TemporaryFolder folder;
    (void)folder.file("lots.dbf", "heights");
    (void)folder.file("lots.prj", "plane");
    (void)folder.file("lots.txt", "not part of it");
    const auto files = describeInputFiles(folder.file("lots.shp", "outlines"));
    ASSERT_TRUE(files);
    ASSERT_EQ(files->size(), 3U);
    EXPECT_EQ((*files)[0].path.filename(), "lots.shp");
    EXPECT_EQ((*files)[1].path.filename(), "lots.dbf");
    EXPECT_EQ((*files)[2].path.filename(), "lots.prj");
}

TEST(FileHash, WhatCannotBeReadIsAnError) {
    const tests::TemporaryFolder folder;
    const auto missing = describeInputFile(folder.path("missing.gpkg"));
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().text(), HasSubstr("missing.gpkg"));
    std::filesystem::create_directory(folder.path("folder"));
    EXPECT_FALSE(describeInputFile(folder.path("folder")));
    EXPECT_FALSE(describeInputFiles(folder.path("missing.shp")));
}

TEST(FileHash, WhatSaysHowAFileIsReadIsHashedWithIt) {
    const tests::TemporaryFolder folder;
    for (const auto& [file, beside] :
         {std::pair{"ground.flt", "ground.hdr"}, std::pair{"town.gml", "town.xsd"},
          std::pair{"LOTS.SHP", "LOTS.DBF"}}) {
        (void)folder.file(beside, "beside");
        const auto files = describeInputFiles(folder.file(file, "values"));
        ASSERT_TRUE(files) << files.error().text();
        ASSERT_EQ(files->size(), 2U) << file;
        EXPECT_EQ((*files)[1].path, folder.path(beside));
    }
}

}  // namespace
}  // namespace noonmark
