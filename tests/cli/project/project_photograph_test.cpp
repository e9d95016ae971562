#include <QImage>
#include <filesystem>

#include "core/io/pictures/ground_raster_file.h"
#include "tests/cli/project_command.h"

namespace noonmark::cli::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class ProjectPhotograph : public ProjectCommand {
protected:
    // 60 x 60 pixels of one colour, about 2 km around a place.
    std::string photograph(const std::string& name, LonLat middle, std::uint8_t red) {
        PlacedPicture picture{60, 60, {}, "EPSG:4326"};
        picture.geoTransform = {middle.lonDeg - 0.012, 0.0004, 0, middle.latDeg + 0.009, 0, -0.0003};
        for (int pixel = 0; pixel < 60 * 60; ++pixel)
            for (const int value : {int(red), 0, 0, 255}) picture.rgba.push_back(std::uint8_t(value));
        const auto file = folder_.path(name);
        EXPECT_TRUE(writePicture(file, picture));
        return file.string();
    }
    [[nodiscard]] LonLat here() const { return opened().city->frame.lonLatFromLocal({0, 0}); }
};

TEST_F(ProjectPhotograph, IsReferredToHiddenShownAndForgotten) {
    const std::string file = photograph("aerial.tif", here(), 200);
    EXPECT_THAT(done("photograph", {file, "--attribution", "(c) Survey", "--opacity", "40"}),
                AllOf(HasSubstr("aerial.tif"), HasSubstr("(c) Survey"), HasSubstr("40 %")));
    auto picture = opened().groundPicture;
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->path, std::filesystem::absolute(file));
    EXPECT_EQ(picture->sha256.size(), 64U);
    EXPECT_EQ(picture->attribution, "(c) Survey");
    EXPECT_DOUBLE_EQ(picture->opacity, 0.4);
    EXPECT_THAT(done("photograph", {"--hide"}), HasSubstr("hidden"));
    EXPECT_FALSE(opened().groundPicture->shown);
    EXPECT_EQ(opened().groundPicture->attribution, "(c) Survey") << "the rest stays";
    done("photograph", {"--show"});
    EXPECT_TRUE(opened().groundPicture->shown);
    done("photograph", {"--remove"});
    EXPECT_FALSE(opened().groundPicture);
    EXPECT_TRUE(std::filesystem::exists(file));
}

TEST_F(ProjectPhotograph, WhatCannotBeLaidOnTheGroundIsRefused) {
    EXPECT_THAT(refused("photograph", {}), HasSubstr("no aerial photograph"));
    EXPECT_THAT(refused("photograph", {folder_.path("none.tif").string()}), HasSubstr("none.tif"));
    EXPECT_THAT(refused("photograph", {photograph("rome.tif", {12.5, 41.9}, 200)}), HasSubstr("rome.tif"));
    EXPECT_THAT(refused("photograph", {folder_.file("text.tif", "no picture").string()}),
                HasSubstr("text.tif"));
}

TEST_F(ProjectPhotograph, IsDrawnOnTheMapsOfStudiesUnlessItsFileChanged) {
    const std::string file = photograph("aerial.tif", here(), 200);
    done("photograph", {file, "--attribution", "Survey of Test"});
    // Pixels of the photograph's colour, in the margin around the studied cells.
    const auto countRed = [&] {
        const QImage map(QString::fromStdString((folder_.path("out") / "shadow.png").string()));
        int count = 0;
        for (int y = 0; y < map.height(); ++y)
            for (int x = 0; x < map.width(); ++x) {
                const QColor seen = map.pixelColor(x, y);
                count += seen.red() > 150 && seen.green() < 60 && seen.blue() < 60 ? 1 : 0;
            }
        return count;
    };
    const std::vector<std::string> noon{"--start", "2026-12-21", "--from", "12:00",  "--hours",
                                        "1",       "--step",     "10",     "--zone", "America/New_York"};
    const CommandOutput drawn = measured("study", noon);
    ASSERT_EQ(drawn.code, 0) << drawn.err;
    EXPECT_THAT(drawn.out + drawn.err, Not(HasSubstr("not drawn")));
    EXPECT_GT(countRed(), 1000);
    photograph("aerial.tif", here(), 90);
    const CommandOutput changed = measured("study", noon);
    ASSERT_EQ(changed.code, 0) << changed.err;
    EXPECT_THAT(changed.out, HasSubstr("its file has changed"));
    EXPECT_EQ(countRed(), 0);
    const CommandOutput impact = atNoon("impact", {"--from", "Existing", "--to", "Existing"});
    EXPECT_THAT(impact.err, HasSubstr("its file has changed"));
}

}  // namespace
}  // namespace noonmark::cli::tests
