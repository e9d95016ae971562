#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/base/warnings.h"
#include "core/city/footprints/repair_footprint.h"
#include "core/io/footprints/read_parcels.h"
#include "core/io/pieces/read_part.h"
#include "core/io/read_region.h"
#include "tests/core/io/temporary_folder.h"

namespace noonmark {
namespace {

using testing::HasSubstr;

// A round polygon of so many points around a place in Manhattan, as GeoJSON.
std::string roundFeature(std::size_t points, double eastDeg) {
    std::string ring;
    for (std::size_t i = 0; i <= points; ++i) {
        const double angle = 6.283185307179586 * double(i % points) / double(points);
        ring += fmt::format("{}[{:.8f},{:.8f}]", i == 0 ? "" : ",", -73.98 + eastDeg + 1e-3 * std::cos(angle),
                            40.75 + 1e-3 * std::sin(angle));
    }
    return fmt::format(R"({{"type":"Feature","properties":{{"height":9}},"geometry":{{"type":"Polygon",)"
                       R"("coordinates":[[{}]]}}}})",
                       ring);
}

std::string collection(const std::string& features) {
    return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

TEST(OutlineLimits, ABuildingOfMorePointsIsLeftOutWithAWarning) {
    const tests::TemporaryFolder folder;
    NoProgress quiet;
    const auto file = folder.file(
        "city.geojson", collection(roundFeature(maxOutlinePoints + 1, 0) + "," + roundFeature(50, 0.01)));
    const auto piece = readFootprints(file, {}, quiet, {});
    ASSERT_TRUE(piece) << piece.error().text();
    EXPECT_EQ(piece->buildings.size(), 1U);
    EXPECT_EQ(std::ranges::count(piece->warnings, "has more than 100000 points", &Warning::what), 1);
}

TEST(OutlineLimits, ARegionOrAParcelOfMorePointsIsRefusedWithItsLimit) {
    const tests::TemporaryFolder folder;
    const Frame frame({-73.98, 40.75});
    const auto file = folder.file("lot.geojson", collection(roundFeature(maxOutlinePoints + 1, 0)));
    const auto region = readRegion(file.string(), frame);
    ASSERT_FALSE(region);
    EXPECT_THAT(region.error().what, HasSubstr("more than 100000"));
    const auto parcels = readParcels(file, {}, frame, {});
    ASSERT_FALSE(parcels);
    EXPECT_EQ(parcels.error().kind, ErrorKind::limit);
}

}  // namespace
}  // namespace noonmark
