// A project of the grid sample with 43,000 buildings and a million triangles: opened, up to the arrays of its
// first picture (target: under 1 s), and saved with one more edit (target: under 0.2 s). First the loaded
// project is compared with the saved one. Reports the best of several rounds; processor time is that of all
// threads.
//
//     project_bench [city file] [rounds]
#include <cstdio>

#include "render/scene/city_arrays.h"
#include "scenarios/project/project_file.h"
#include "tests/benchmarks/bench_scene.h"

using namespace noonmark;
using namespace noonmark::bench;

namespace {

void must(const Result<void>& done) {
    if (done) return;
    fmt::print(stderr, "{}\n", done.error().text());
    std::exit(EXIT_FAILURE);
}

// A project with everything that a study adds to it.
Project projectOf(City city) {
    Project project;
    const Box2 box = bounds(city);
    project.regions.push_back(findMiddle(city));
    project.regions.back().name = "Middle";
    project.lots.push_back({"Lot", makeRegionFromLocalBox({box.low, box.low + 40.0F}).polygons.front()});
    project.city = std::make_shared<const City>(std::move(city));
    project.scenarios.push_back({"A", "", {}});
    return project;
}

void check(bool right, const char* what) {
    if (right) return;
    fmt::print(stderr, "wrong: {}\n", what);
    std::exit(EXIT_FAILURE);
}

bool sameBuildings(const City& a, const City& b) {
    return std::ranges::equal(a.buildings, b.buildings,
                              [](const auto& one, const auto& other) { return *one == *other; });
}

void print(const char* what, const Seconds& seconds, const std::string& more) {
    fmt::print("{:34} {:7.3f} s wall, {:7.3f} s of processors{}\n", what, seconds.wall, seconds.processor,
               more);
}

constexpr GridSampleSettings largeGrid{.buildings = 43'000, .roundness = 7};

struct Rounds {
    Seconds open, arrays, save;
    std::size_t triangles = 0;
};

// Opens the project, makes the arrays of the first picture, and saves one more demolition. Each step is
// checked after it is timed.
void round(const std::filesystem::path& file, const Project& truth, Rounds& best) {
    ProjectFile disk;
    best.open.keepBest(secondsOf([&] { disk = taken(ProjectFile::open(file)); }));
    check(sameBuildings(*disk.project().city, *truth.city), "the city that was read");
    CityArrays arrays;
    best.arrays.keepBest(secondsOf([&] { arrays = makeArrays(*disk.project().city); }));
    best.triangles = arrays.triangles.size() / 3;
    check(best.triangles > 9 * truth.city->buildings.size(), "the arrays of the picture");
    Project project = disk.project();
    auto& edits = project.scenarios[0].edits;
    edits.emplace_back(Demolish{project.city->buildings[edits.size()]->sourceId});
    best.save.keepBest(secondsOf([&] { must(disk.save(project)); }));
    check(taken(ProjectFile::open(file)).project().scenarios == project.scenarios, "the edit that was saved");
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 2 ? std::atoi(argv[2]) : 5;
    const Project project = projectOf(argc > 1 ? cityFrom(argv[1]) : taken(makeGridSample(largeGrid)));
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / "noonmark_project_bench.noonmark.gpkg";
    const Seconds create =
        secondsOf([&] { taken(ProjectFile::create(file, project, ProjectFile::IfExists::replace)); });
    Rounds best;
    for (int i = 0; i < rounds; ++i) round(file, project, best);
    print("create", create,
          fmt::format(" ({} buildings, {:.1f} MB)", project.city->buildings.size(),
                      double(std::filesystem::file_size(file)) / 1e6));
    print("open", best.open, "");
    print("arrays of the first picture", best.arrays, fmt::format(" ({} triangles)", best.triangles));
    fmt::print("{:34} {:7.3f} s wall, asked: 1\n", "both", best.open.wall + best.arrays.wall);
    print("save of one edit", best.save, ", asked: 0.2");
    std::filesystem::remove(file);
    return EXIT_SUCCESS;
}
