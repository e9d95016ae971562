#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/command_output.h"
#include "tests/core/io/temporary_folder.h"

// What info says of a stranger's file.
namespace noonmark::cli::tests {
namespace {

using testing::HasSubstr;

std::string folderOf(const char* name, const char* coordinates) {
    return fmt::format(
        "<Folder><name>{}</name><Placemark><name>{} 1</name><Polygon><extrude>1</extrude>"
        "<altitudeMode>relativeToGround</altitudeMode><outerBoundaryIs><LinearRing>"
        "<coordinates>{}</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>"
        "</Folder>",
        name, name, coordinates);
}

TEST(InfoCommand, NamesTheLayersAndWhichOfThemWereRead) {
    const noonmark::tests::TemporaryFolder folder;
    const std::string file =
        folder
            .file("two.kml",
                  "<?xml version=\"1.0\" encoding=\"UTF-8\"?><kml xmlns=\"http://www.opengis.net/kml/2.2\">"
                  "<Document>" +
                      folderOf("buildings", "13.4,52.5,20 13.4003,52.5,20 13.4003,52.5002,20 13.4,52.5,20") +
                      folderOf("plots", "13.4,52.5,0 13.4005,52.5,0 13.4005,52.5005,0 13.4,52.5,0") +
                      "</Document></kml>")
            .string();
    const auto json = noonmarkCli({"info", file, "--json"}).json();
    ASSERT_EQ(json["layers"].size(), 2U);
    EXPECT_EQ(json["layers"][0]["layer"], "buildings");
    EXPECT_EQ(json["layers"][0]["features"], 1);
    EXPECT_EQ(json["layers"][0]["read"], true);
    EXPECT_EQ(json["layers"][1]["read"], false);
    EXPECT_THAT(noonmarkCli({"info", file}).out, HasSubstr("buildings (1); not read: plots (1)"));
    EXPECT_THAT(noonmarkCli({"info", file, "--layer", "plots"}).out,
                HasSubstr("plots (1); not read: buildings (1)"));
}

}  // namespace
}  // namespace noonmark::cli::tests
