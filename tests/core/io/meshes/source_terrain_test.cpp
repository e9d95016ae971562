#include <fmt/format.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>

#include <memory>
#include <random>

#include "core/city/terrain/post_grid.h"
#include "core/geo/frame.h"
#include "core/io/pieces/read_part.h"
#include "core/receivers/receivers.h"
#include "core/sun/sun_steps.h"
#include "tests/core/engines/sweep_scenes.h"
#include "tests/core/io/source_surface.h"
#include "tests/core/io/temporary_folder.h"
#include "tests/shared/shared_data.h"

namespace noonmark::tests {
namespace {

// Comparison of a terrain as read with the surface of its raster: receivers spread over it, a whole day.
struct Compared {
    double heightRmsM = 0, heightMaxM = 0;        ///< of the ground's elevation
    double rayBias = 0, rayMean = 0, rayMax = 0;  ///< minutes per day
    double sweepBias = 0, sweepMean = 0, sweepMax = 0;
    std::size_t cells = 0;
};

SunSteps equinoxAt(const Frame& frame) {
    Period period;
    period.from = std::chrono::hours(4);
    period.hours = 16;
    period.stepMinutes = 3;
    return computeSunSteps(period, {frame.origin(), 0, 1010, 10}, {}).value();
}

Compared comparedWith(const SourceSurface& surface, const City& city, glm::dvec2 halfM, std::size_t cells) {
    const Receivers all =
        receiversOver(city, float(-halfM.x), float(-halfM.y), float(halfM.x), float(halfM.y), 3);
    Receivers receivers = all;
    std::mt19937 random(11);
    std::ranges::shuffle(receivers.cells, random);
    receivers.cells.resize(cells);
    std::ranges::sort(receivers.cells);
    const SunSteps sun = equinoxAt(city.frame);
    const ShadowField rays = traced(city, receivers, sun), sweep = swept(city, receivers, sun, 0.1);
    Compared compared{.cells = cells};
    for (const std::uint32_t cell : receivers.cells) {
        const glm::vec3 receiver = receivers.position(cell);
        const double ground = surface.elevationAt(glm::dvec2(receiver)).value();
        const double off = std::abs(double(receiver.z) - ground);
        compared.heightRmsM += off * off / double(cells);
        compared.heightMaxM = std::max(compared.heightMaxM, off);
        const glm::dvec3 from(glm::dvec2(receiver), ground + 0.001);
        const double truth =
            minutesOf(sun, [&](glm::dvec3 direction) { return surface.blocks(from, direction); }).gross;
        const double ray = double(rays.grossMin[cell]) - truth,
                     horizon = double(sweep.grossMin[cell]) - truth;
        compared.rayBias += ray / double(cells);
        compared.sweepBias += horizon / double(cells);
        compared.rayMean += std::abs(ray) / double(cells);
        compared.sweepMean += std::abs(horizon) / double(cells);
        compared.rayMax = std::max(compared.rayMax, std::abs(ray));
        compared.sweepMax = std::max(compared.sweepMax, std::abs(horizon));
    }
    compared.heightRmsM = std::sqrt(compared.heightRmsM);
    return compared;
}

void print(const char* name, const Compared& c) {
    std::printf(
        "%s, %zu cells, minutes a day: rays %+.3f in the mean, %.3f off, worst %.0f; horizon %+.3f, %.3f, "
        "%.0f; "
        "ground off by %.4f m (rms), %.4f m (most)\n",
        name, c.cells, c.rayBias, c.rayMean, c.rayMax, c.sweepBias, c.sweepMean, c.sweepMax, c.heightRmsM,
        c.heightMaxM);
}

// The terrain that older versions made of a raster: squares as large as its pixels, aligned with true north,
// resampled bilinearly.
std::shared_ptr<const Terrain> resampledBilinearly(const std::filesystem::path& file, const Frame& frame,
                                                   const PostGrid& posts) {
    const Box2 box = bounds(posts);
    const Grid grid{double(box.low.x), double(box.low.y), posts.cellM,
                    int(double(box.high.x - box.low.x) / posts.cellM),
                    int(double(box.high.y - box.low.y) / posts.cellM)};
    std::vector<std::string> words{
        "-of",  "MEM",       "-r",     "bilinear",         "-ot",        "Float32", "-et",
        "0.01", "-novshift", "-t_srs", frame.projString(), "-dstnodata", "nan"};
    for (const std::string& word :
         {std::string("-te"), fmt::format("{:.6f}", grid.westM), fmt::format("{:.6f}", grid.southM),
          fmt::format("{:.6f}", grid.eastM()), fmt::format("{:.6f}", grid.northM()), std::string("-ts"),
          fmt::to_string(grid.columns), fmt::to_string(grid.rows)})
        words.push_back(word);
    char** list = nullptr;
    for (const std::string& word : words) list = CSLAddString(list, word.c_str());
    GDALWarpAppOptions* options = GDALWarpAppOptionsNew(list, nullptr);
    CSLDestroy(list);
    const GDALDatasetUniquePtr source(GDALDataset::Open(file.string().c_str()));
    GDALDatasetH handle = GDALDataset::ToHandle(source.get());
    const GDALDatasetUniquePtr warped(
        GDALDataset::FromHandle(GDALWarp("", nullptr, 1, &handle, options, nullptr)));
    GDALWarpAppOptionsFree(options);
    Terrain terrain{grid, std::vector<float>(grid.size())};
    std::vector<float> northFirst(grid.size());
    EXPECT_EQ(warped->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, grid.columns, grid.rows, northFirst.data(),
                                                 grid.columns, grid.rows, GDT_Float32, 0, 0, nullptr),
              CE_None);
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const float value = northFirst[grid.index(column, grid.rows - 1 - row)];
            terrain.elevationM[grid.index(column, row)] =
                float(double(value) - frame.originElevationM() - earthDropM(grid.centre(column, row)));
        }
    fillGaps(terrain.elevationM, grid.columns, grid.rows);
    return std::make_shared<const Terrain>(std::move(terrain));
}

Compared comparedFile(const std::filesystem::path& file, glm::dvec2 halfM, std::size_t cells) {
    NoProgress progress;
    const FilePiece piece = readTerrain(file, {}, progress, {}).value();
    City city{.frame = *piece.frame, .terrain = piece.terrain};
    const SourceSurface surface(file, city.frame.origin().lonDeg, city.frame.origin().latDeg,
                                city.frame.originElevationM());
    const City before{.frame = city.frame,
                      .terrain = resampledBilinearly(file, city.frame, city.terrain->grid)};
    print("  resampled bilinearly", comparedWith(surface, before, halfM, cells));
    const Compared kept = comparedWith(surface, city, halfM, cells);
    print("  posts kept", kept);
    return kept;
}

void expectTheSameSurface(const char* name, const Compared& compared) {
    SCOPED_TRACE(name);
    EXPECT_LE(compared.heightMaxM, 0.002);
    EXPECT_LE(compared.rayMean, 0.02);
    EXPECT_LE(std::abs(compared.rayBias), 0.02);
    EXPECT_LE(compared.sweepMean, 0.6);
    EXPECT_LE(std::abs(compared.sweepBias), 0.3);
}

// Steep and rough hills in a national grid whose north is not true north.
std::filesystem::path hillsIn(const TemporaryFolder& folder, int epsg, glm::dvec2 northWest, double pixelM,
                              int side) {
    GDALAllRegister();
    const auto path = folder.path("hills.tif");
    const GDALDatasetUniquePtr dataset(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
        path.string().c_str(), side, side, 1, GDT_Float32, nullptr));
    double transform[] = {northWest.x, pixelM, 0, northWest.y, 0, -pixelM};
    dataset->SetGeoTransform(transform);
    OGRSpatialReference system;
    system.importFromEPSG(epsg);
    dataset->SetSpatialRef(&system);
    std::mt19937 random(4);
    std::vector<float> values;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            values.push_back(float(60 + 14 * std::sin(x * 0.21) * std::cos(y * 0.13 + x * 0.05) +
                                   5 * std::sin(y * 0.6 + 1) * std::sin(x * 0.5) +
                                   double(random() % 100) * 0.008));
    EXPECT_EQ(dataset->GetRasterBand(1)->RasterIO(GF_Write, 0, 0, side, side, values.data(), side, side,
                                                  GDT_Float32, 0, 0, nullptr),
              CE_None);
    return path;
}

TEST(SourceTerrain, HillsInAGridTurnedFromTrueNorthKeepTheirShadows) {
    const TemporaryFolder folder;
    // UTM zone 33 at Gotland's longitude, 4 degrees from its middle: turned by 3.4 degrees.
    expectTheSameSurface("UTM",
                         comparedFile(hillsIn(folder, 32633, {735000, 6400000}, 2, 160), {110, 110}, 300));
}

TEST(SourceTerrain, PixelsOfLongitudeAndLatitudeKeepTheirShadows) {
    const TemporaryFolder folder;
    // 2.2 by 1.1 m.
    expectTheSameSurface("degrees",
                         comparedFile(hillsIn(folder, 4326, {18.3, 60.5}, 2e-5, 160), {60, 110}, 300));
}

TEST(SourceTerrain, GoteborgsGroundKeepsItsShadows) {
    const auto file = sharedData("goteborg/DEM_KRbig.tif");
    if (!file) GTEST_SKIP() << "shared data is missing";
    expectTheSameSurface("Goteborg, ground", comparedFile(*file, {100, 95}, 300));
}

TEST(SourceTerrain, GoteborgsRoofsKeepTheirShadows) {
    const auto file = sharedData("goteborg/DSM_KRbig.tif");
    if (!file) GTEST_SKIP() << "shared data is missing";
    const Compared compared = comparedFile(*file, {100, 95}, 120);
    // On walls of one pixel's width, float32's rounding of position, a millimetre, changes the height by more
    // than the tolerance.
    EXPECT_LE(compared.heightMaxM, 0.05);
    // The sweep has no error; the rays, which start 1 mm above the ground in float32, differ by 75 min in one
    // cell of 120, on the face of such a wall.
    EXPECT_LE(compared.sweepMean, 0.05);
    EXPECT_LE(compared.rayMean, 1);
}

}  // namespace
}  // namespace noonmark::tests
