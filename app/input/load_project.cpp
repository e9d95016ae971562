#include "app/input/load_project.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <iterator>
#include <set>
#include <utility>

#include "core/io/files/geopackage_check.h"
#include "core/io/read_region.h"
#include "core/receivers/place_names.h"
#include "core/samples/sample_city.h"
#include "scenarios/edits/apply_edits.h"
#include "scenarios/massing/tower_design.h"
#include "scenarios/project/project_file.h"

namespace noonmark {

bool isProjectFile(const std::string& file) {
    return file.ends_with(projectEnding) || holdsProject(file).value_or(false);
}

LoadedCity loadProjectCity(const Project& project, const std::string& file) {
    LoadedCity loaded;
    loaded.files = {file};
    loaded.inputs = project.inputs;
    loaded.settings = project.reading->settings;
    loaded.read.city = *project.city;
    loaded.read.format = "Noonmark project";
    loaded.read.features = project.city->buildings.size();
    loaded.read.attribution = project.attribution;
    loaded.read.warnings = project.reading->warnings;
    loaded.read.heights = project.reading->heights;
    return loaded;
}

namespace {

void addSamplePlaces(Project& project, const LoadedCity& loaded) {
    if (loaded.files.size() != 1 || !isParkSample(loaded.files.front())) return;
    Region park = centralParkRegion(*project.city);
    park.name = "Park";
    project.regions.push_back(std::move(park));
    for (const CaseStudyLot& lot : listCaseStudyLots(*project.city))
        project.lots.push_back({lot.tower, lot.ground});
}

}  // namespace

Project projectOf(const LoadedCity& loaded) {
    Project project;
    City city = makeIdsUnique(loaded.read.city);
    project.city = std::make_shared<const City>(std::move(city));
    project.attribution = loaded.read.attribution;
    project.inputs = loaded.inputs;
    project.reading = std::make_shared<const CityReading>(
        CityReading{loaded.settings, loaded.read.warnings, loaded.read.heights});
    addSamplePlaces(project, loaded);
    return project;
}

namespace {

Result<void> findFacedPlace(ElementSettings& elements, const std::vector<Place>& places) {
    if (elements.faces.place.empty()) return {};
    const auto place = findPlace(places, elements.faces.place);
    if (!place) return tl::make_unexpected(place.error());
    elements.parts.facedPlace = place->polygons;
    return {};
}

bool measuresLines(const ElementSettings& elements) {
    return elements.places == ElementPlaces::lines && !elements.parcel.empty();
}

Result<void> readParcel(ElementSettings& elements, const Frame& frame) {
    const auto region = readRegion(elements.parcel, frame);
    if (!region) return tl::make_unexpected(region.error());
    elements.parts.parcel = region->polygons;
    return {};
}

// A name of the project comes before a file of that name.
Result<void> findParcel(ElementSettings& elements, const Project& project, const Frame& frame) {
    if (!measuresLines(elements)) return {};
    std::vector<Footprint>& parcel = elements.parts.parcel;
    if (const auto lot = findLot(project, elements.parcel))
        parcel = {lot->outline};
    else if (const auto region = findRegion(project, elements.parcel))
        parcel = region->polygons;
    else if (const auto place = findPlace(project, elements.parcel))
        parcel = place->polygons;
    else if (const auto read = readParcel(elements, frame); !read)
        return tl::make_unexpected(Error{lot.error().what + ", and no file of that name can be read",
                                         elements.parcel, lot.error().advice});
    return {};
}

void findProposed(ElementSettings& elements, const City& existing, const City& city) {
    std::set<const Building*> before;
    for (const auto& building : existing.buildings) before.insert(building.get());
    for (const auto& building : city.buildings)
        if (!before.contains(building.get())) elements.parts.proposed.push_back(building->sourceId);
}

/// Storeys as they were designed. Where scenarios have different towers of one id, none is known.
OwnStoreys findDesignedStoreys(const std::vector<Scenario>& scenarios) {
    OwnStoreys storeys;
    std::set<std::string> unclear;
    for (const Scenario& scenario : scenarios)
        for (const auto& [id, tower] : findProposedTowers(scenario.edits)) {
            if (tower.storeyHeightM <= 0) continue;
            const auto [at, isNew] = storeys.emplace(id, tower.storeyHeightM);
            if (!isNew && at->second != tower.storeyHeightM) unclear.insert(id);
        }
    for (const std::string& id : unclear) storeys.erase(id);
    return storeys;
}

std::optional<ModelPlace> placeOfMeshes(const ReadSettings& reading) {
    if (!reading.meshAnchor) return std::nullopt;
    return ModelPlace{*reading.meshAnchor, reading.meshNorthDeg};
}

/// A proposal's own zero, and the middle of its outlines, as the edits of a scenario move them.
struct MovedModel {
    std::string id;
    glm::dvec2 zero, middle;
    double clockwiseDeg, scale;

    static MovedModel of(const ImportMesh& import) {
        const Placement& placement = import.placement;
        return {import.shape->sourceId, applyTo({0, 0}, placement),
                applyTo(findMiddle(*import.shape), placement), placement.clockwiseDeg,
                placement.scale * import.readScale};
    }
    void take(const Edit& edit) {
        if (const auto* move = std::get_if<Move>(&edit); move != nullptr && move->building == id) {
            zero += move->byM;
            middle += move->byM;
        }
        if (const auto* turn = std::get_if<Rotate>(&edit); turn != nullptr && turn->building == id) {
            zero = applyTo(zero, {.about = middle, .clockwiseDeg = turn->clockwiseDeg});
            clockwiseDeg += turn->clockwiseDeg;
        }
    }
};

bool standsIn(const City& city, const MovedModel& model) {
    constexpr double sameM = 0.1;
    return std::ranges::any_of(city.buildings, [&](const auto& building) {
        return building->sourceId == model.id && glm::distance(findMiddle(*building), model.middle) < sameM;
    });
}

// Of scenarios with other editions or other places of the proposal, that of the city.
std::optional<ModelPlace> placeOfProposal(const std::string& file, const Project& project, const City& city) {
    for (const Scenario& scenario : project.scenarios) {
        const auto edits = collectEdits(project.scenarios, scenario.name);
        if (!edits) continue;
        std::vector<MovedModel> models;
        for (const Edit& edit : *edits) {
            const auto* import = std::get_if<ImportMesh>(&edit);
            if (import != nullptr && import->file == file) models.push_back(MovedModel::of(*import));
            for (MovedModel& model : models) model.take(edit);
        }
        for (const MovedModel& model : models)
            if (standsIn(city, model))
                return ModelPlace{city.frame.lonLatFromLocal(model.zero), model.clockwiseDeg, model.scale};
    }
    return std::nullopt;
}

}  // namespace

Result<ElementSettings> findElementParts(ElementSettings elements, const Project& project, const City& city) {
    elements.parts = {};
    elements.parts.storeys = findDesignedStoreys(project.scenarios);
    if (elements.proposed) findProposed(elements, *project.city, city);
    elements.parts.model = placeOfProposal(elements.windows.filename().string(), project, city);
    if (!elements.parts.model && project.reading->settings)
        elements.parts.model = placeOfMeshes(*project.reading->settings);
    return findFacedPlace(elements, project.places)
        .and_then([&] { return findParcel(elements, project, city.frame); })
        .map([&] { return std::move(elements); });
}

Result<ElementSettings> findElementParts(ElementSettings elements, const std::vector<Place>& places,
                                         const ReadSettings& reading, const City& city) {
    elements.parts = {};
    elements.parts.model = placeOfMeshes(reading);
    if (elements.proposed)
        return failure("Only a project has proposed buildings", "--facades-of proposed",
                       "Give one project file, NAME.noonmark.gpkg");
    return findFacedPlace(elements, places)
        .and_then([&] { return measuresLines(elements) ? readParcel(elements, city.frame) : Result<void>(); })
        .map([&] { return std::move(elements); });
}

}  // namespace noonmark
