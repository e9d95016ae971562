#include "app/input/load_city.h"

#include <tbb/task_group.h>
#include <algorithm>
#include <glm/common.hpp>
#include <iterator>
#include <system_error>

#include "core/base/stop_scope.h"
#include "core/city/city_position.h"
#include "core/city/map_context.h"
#include "core/io/pictures/ground_raster_file.h"
#include "core/receivers/made_names.h"
#include "core/receivers/place_names.h"
#include "core/samples/sample_city.h"

namespace noonmark {

OutputRules outputRules(const std::vector<std::string>& named, const std::vector<InputFile>& inputs,
                        bool overwrite) {
    OutputRules rules{{named.begin(), named.end()}, overwrite};
    for (const InputFile& input : inputs) {
        rules.inputs.push_back(input.path);
        if (input.path.is_relative())
            for (const std::filesystem::path file : named)
                rules.inputs.push_back(file.parent_path() / input.path);
    }
    return rules;
}

void addPlace(OutputRules& rules, const std::string& place) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(place, ignored)) rules.inputs.emplace_back(place);
}

namespace {

void append(MapContext& to, MapContext from) {
    std::ranges::move(from.areas, std::back_inserter(to.areas));
    std::ranges::move(from.lines, std::back_inserter(to.lines));
    std::ranges::move(from.trees, std::back_inserter(to.trees));
    if (to.attribution.empty()) to.attribution = std::move(from.attribution);
}

}  // namespace

Result<ContextRead> loadCityContext(const std::vector<std::string>& files, const Frame& frame,
                                    Progress& progress, const std::stop_token& stop) {
    ContextRead all;
    for (const std::string& file : files) {
        if (isParkSample(file)) append(all.context, makeCentralParkContext(frame));
        if (isSample(file) || !isOsmFile(file)) continue;
        auto read = readContext(file, {}, frame, progress, stop);
        if (!read) return tl::make_unexpected(read.error());
        append(all.context, std::move(read->context));
        std::ranges::move(read->warnings, std::back_inserter(all.warnings));
        all.features += read->features;
    }
    return all;
}

std::shared_ptr<const MapContext> joinContext(const std::shared_ptr<const MapContext>& before,
                                              MapContext added) {
    auto joined = std::make_shared<MapContext>(before ? *before : MapContext{});
    append(*joined, std::move(added));
    return joined->empty() ? nullptr : joined;
}

Box2 photographBox(const City& city) {
    constexpr float aroundM = 500;
    Box2 box = bounds(city);
    box.low -= aroundM;
    box.high += aroundM;
    return box;
}

Result<Photograph> loadPhotograph(const GroundPictureFile& wanted, const City& city, Progress& progress,
                                  const std::stop_token& stop) {
    const StopScope scope(stop);
    const auto described = describeInputFile(wanted.path);
    if (!described) return tl::make_unexpected(described.error());
    auto raster = readGroundRaster(wanted.path, city.frame, photographBox(city), {}, progress, stop);
    if (!raster) return tl::make_unexpected(raster.error());
    Photograph photograph{wanted, std::make_shared<const GroundRaster>(*std::move(raster))};
    photograph.file.sha256 = described->sha256;
    return photograph;
}

Project withLoadedPhotograph(Project project, Warnings& warnings, Progress& progress,
                             const std::stop_token& stop) {
    if (!project.groundPicture || !project.groundPicture->shown) return project;
    const GroundPictureFile file = *project.groundPicture;
    const auto leftOut = [&](const std::string& what) {
        warnings.push_back({WarningKind::leftOut, what, file.path.string()});
    };
    auto loaded = loadPhotograph(file, *project.city, progress, stop);
    if (!loaded) {
        leftOut("the aerial photograph is not drawn: " + loaded.error().what);
        return project;
    }
    if (loaded->file.sha256 != file.sha256) {
        leftOut("the aerial photograph is not drawn: its file has changed; choose it again");
        return project;
    }
    return withGroundPicture(std::move(project), file, std::move(loaded->raster));
}

namespace {

void addPlaces(PlacesRead read, PlacesRead& to) {
    std::ranges::move(read.places, std::back_inserter(to.places));
    std::ranges::move(read.warnings, std::back_inserter(to.warnings));
    std::ranges::move(read.layers, std::back_inserter(to.layers));
    to.features += read.features;
    to.streetsOfAssumedWidth += read.streetsOfAssumedWidth;
    if (to.attribution.empty()) to.attribution = read.attribution;
}

}  // namespace

Result<PlacesRead> loadPlaceFiles(const std::vector<std::string>& files, const PlaceSettings& settings,
                                  const Frame& frame, PlacesRead before, Progress& progress,
                                  const std::stop_token& stop) {
    for (const std::string& file : files) {
        auto read = readPlaces(file, settings, frame, progress, stop);
        if (!read) return tl::make_unexpected(read.error());
        addPlaces(*std::move(read), before);
    }
    makeNamesUnique(before.places);
    return before;
}

namespace {

std::vector<Place> placesOfSample(const PlaceSettings& settings, const Frame& frame) {
    std::vector<Place> places = listCentralParkPlaces(frame);
    std::erase_if(places, [&](const Place& place) {
        const bool isOtherKind = !settings.kinds.empty() && !settings.kinds.contains(place.kind);
        return isOtherKind || (place.kind == PlaceKind::street && !settings.streets);
    });
    return places;
}

// The lines beside the buildings of a GeoPackage. What its polygons are, nobody has said.
Result<PlacesRead> withStreetsOf(const std::vector<std::string>& files, PlaceSettings settings,
                                 const Frame& frame, PlacesRead before, Progress& progress,
                                 const std::stop_token& stop) {
    if (!settings.streets) return before;
    settings.kinds = {PlaceKind::street};
    for (const std::string& file : files) {
        if (isSample(file)) continue;
        auto read = readStreetLines(file, settings, frame, progress, stop);
        if (!read) return read;
        addPlaces(*std::move(read), before);
    }
    makeNamesUnique(before.places);
    return before;
}

}  // namespace

Result<PlacesRead> loadCityPlaces(const std::vector<std::string>& files, const PlaceSettings& settings,
                                  const Frame& frame, Progress& progress, const std::stop_token& stop) {
    std::vector<std::string> maps;
    PlacesRead ofSample;
    for (const std::string& file : files) {
        if (isParkSample(file)) ofSample.places = placesOfSample(settings, frame);
        if (!isSample(file) && isOsmFile(file)) maps.push_back(file);
    }
    auto read = loadPlaceFiles(maps, settings, frame, std::move(ofSample), progress, stop);
    return read ? withStreetsOf(files, settings, frame, *std::move(read), progress, stop) : std::move(read);
}

namespace {

constexpr std::string_view samplePrefix = "sample:";
constexpr std::string_view parkSample = "sample:central-park-south";

Result<CityRead> sampleRead(const std::string& file) {
    auto city = sampleCity(file.substr(samplePrefix.size()));
    if (!city) return tl::make_unexpected(city.error());
    CityRead read;
    read.city = *std::move(city);
    read.format = "Noonmark sample";
    for (const auto& building : read.city.buildings) read.features += building->parts.size();
    return read;
}

Result<CityRead> readOrMake(const std::vector<std::string>& files, const ReadSettings& settings,
                            Progress& progress, std::stop_token stop) {
    if (std::ranges::none_of(files, isSample))
        return readCity({files.begin(), files.end()}, settings, progress, std::move(stop));
    if (files.size() == 1) return sampleRead(files.front());
    return failure("A sample cannot be combined with other files", files.front(),
                   "Write it to a file with `noonmark-cli sample` and read that file with the others");
}

Result<std::vector<InputFile>> inputsOf(const std::vector<std::string>& files) {
    std::vector<InputFile> inputs;
    for (const std::string& file : files) {
        const auto isKnown = [&](const InputFile& input) { return input.path == file; };
        if (std::ranges::any_of(inputs, isKnown)) continue;
        if (isSample(file)) {
            inputs.push_back({.path = file});
            continue;
        }
        const auto some = describeInputFiles(file);
        if (!some) return tl::make_unexpected(some.error());
        inputs.insert(inputs.end(), some->begin(), some->end());
    }
    return inputs;
}

}  // namespace

bool isSample(std::string_view file) { return file.starts_with(samplePrefix); }
bool isParkSample(std::string_view file) { return file == parkSample; }

Result<City> sampleCity(const std::string& name) {
    if (name == "central-park-south") return makeCentralParkSouthSample();
    if (name == "grid") return makeGridSample({});
    return failure("There is no such sample", "sample '" + name + "'",
                   "The samples are central-park-south and grid");
}

Result<LoadedCity> loadCity(const std::vector<std::string>& files, const ReadSettings& settings,
                            Progress& progress, std::stop_token stop) {
    Result<std::vector<InputFile>> inputs;
    tbb::task_group describing;  // beside the reading; both mostly wait for the disk
    describing.run([&, stop] {
        const StopScope scope(stop);
        std::vector<std::string> all = files;
        std::ranges::copy(settings.treeFiles, std::back_inserter(all));
        inputs = inputsOf(all);
    });
    const Stopwatch watch;
    auto read = readOrMake(files, settings, progress, std::move(stop));
    describing.wait();
    if (!inputs) return tl::make_unexpected(inputs.error());
    if (!read) return tl::make_unexpected(read.error());
    const double seconds = watch.seconds();
    return LoadedCity{files, settings, *std::move(read), *std::move(inputs), seconds};
}

Provenance provenanceOf(const LoadedCity& loaded) {
    Provenance provenance;
    provenance.inputs = loaded.inputs;
    provenance.reading = loaded.settings;
    provenance.attribution = joinAttribution(loaded.read.attribution, loaded.read.city.context.get());
    return provenance;
}

void addReading(Study& study, const LoadedCity& loaded) {
    study.provenance = provenanceOf(loaded);
    study.heights = loaded.read.heights;
    study.warnings.insert(study.warnings.begin(), loaded.read.warnings.begin(), loaded.read.warnings.end());
    study.seconds["read"] = loaded.seconds;
    study.seconds["total"] += loaded.seconds;
}

Result<Region> cityRegion(const City& city) {
    const Box2 box = bounds(city);
    if (box.empty())
        return failure("There is no building, so \"city\" is no region", {},
                       "Name files with buildings, or give the region as west,south,east,north");
    Region region = makeRegionFromLocalBox(box);
    region.name = madeNames::wholeCity;
    return region;
}

namespace {

// What lies on no terrain cannot be measured. Buildings beyond it keep the box.
Box2 keepOnTerrain(const Box2& box, const City& city) {
    if (!city.terrain) return box;
    const Box2 terrain = bounds(city.terrain->grid);
    const Box2 kept{glm::max(box.low, terrain.low), glm::min(box.high, terrain.high)};
    return kept.empty() ? box : kept;
}

}  // namespace

Region firstRegion(const LoadedCity& loaded, float maxM) {
    if (loaded.files.size() == 1 && loaded.files.front() == parkSample)
        return centralParkRegion(loaded.read.city);
    Box2 box = findMainPart(loaded.read.city).box;
    if (box.empty()) box = {{-maxM / 2, -maxM / 2}, {maxM / 2, maxM / 2}};
    // The border leaves some open ground even around a single building.
    constexpr float borderM = 50;
    const Box2 within = keepOnTerrain({box.low - borderM, box.high + borderM}, loaded.read.city);
    Region region = makeRegionFromLocalBox(findDensestBox(loaded.read.city, within, glm::vec2(maxM)));
    region.name = madeNames::cityMiddle;
    return region;
}

}  // namespace noonmark
