#include "scenarios/project/project_provenance.h"

#include <fmt/format.h>

#include "core/city/map_context.h"
#include "core/study/provenance/sha256.h"
#include "core/study/provenance/study_hash.h"
#include "core/study/text/region_text.h"
#include "scenarios/project/edit_json.h"
#include "scenarios/weights/time_weights.h"

namespace noonmark {

namespace {

Result<void> addEdits(Sha256& sum, const Project& project, const char* role, const std::string& scenario) {
    return collectEdits(project.scenarios, scenario).map([&](const std::vector<Edit>& edits) {
        sum.add(fmt::format("{}\n", role));
        for (const Edit& edit : edits) sum.add(fmt::format("edit {} {}\n", getKind(edit), toJson(edit)));
    });
}

// `citySha256`: hash of the existing city, which takes longest to compute.
Result<std::string> hashContent(const Project& project, const std::string& citySha256,
                                const MeasuredPart& part) {
    Sha256 sum;
    sum.add(fmt::format("city {}\n", citySha256));
    auto added = addEdits(sum, project, "scenario", part.scenario);
    if (added && !part.baseline.empty()) added = addEdits(sum, project, "baseline", part.baseline);
    if (!added) return tl::make_unexpected(added.error());
    if (part.weights) sum.add(fmt::format("weights {}\n", weightsJson(*part.weights)));
    return sum.hex();
}

// The same part in another version of the project, with that version's weight table of the same name.
MeasuredPart asIn(const Project& project, MeasuredPart part) {
    if (!part.weights) return part;
    const auto table = findWeights(project, part.weights->name);
    part.weights = table ? *table : TimeWeights{};
    return part;
}

bool holds(const ProjectFile& file, const Project& project, const std::string& citySha256,
           const std::string& contentSha256, const MeasuredPart& part) {
    const Project& saved = file.project();
    const std::string city = saved.city == project.city ? citySha256 : hashCity(*saved.city);
    const auto content = hashContent(saved, city, asIn(saved, part));
    return content && *content == contentSha256 && file.isUnchanged();
}

ScenarioRecord recordOf(const Project& project, const std::string& scenario, const std::string& citySha256) {
    ScenarioRecord record{scenario, {}, {}};
    const auto edits = collectEdits(project.scenarios, scenario);
    if (edits)
        for (const Edit& edit : *edits) record.edits.push_back(formatText(edit));
    const auto city = cityOf(project, scenario);
    if (city) record.citySha256 = record.edits.empty() ? citySha256 : hashCity(city->city);
    return record;
}

ProjectRecord recordOf(const Project& project, const ProjectFile* onDisk, const MeasuredPart& part) {
    const std::string citySha256 = hashCity(*project.city);
    ProjectRecord record{.scenario = recordOf(project, part.scenario, citySha256)};
    record.contentSha256 = hashContent(project, citySha256, part).value_or(std::string());
    if (!part.baseline.empty()) record.baseline = recordOf(project, part.baseline, citySha256);
    if (onDisk == nullptr) return record;
    record.file = onDisk->path().filename().string();
    if (!holds(*onDisk, project, citySha256, record.contentSha256, part)) return record;
    if (const auto file = describeInputFile(onDisk->path())) record.fileSha256 = file->sha256;
    return record;
}

// A region or place of the saved project is given by its name, which identifies it exactly.
std::string regionTextOf(const Project& project, const ProjectFile* onDisk, const ProjectRecord& record,
                         const Region& region) {
    if (!record.saved()) return formatRegion(region, *project.city);
    const Project& saved = onDisk->project();
    for (const Region& named : saved.regions)
        if (named.polygons == region.polygons) return named.name;
    for (const Place& place : saved.places)
        if (place.polygons == region.polygons && !findRegion(saved, place.name)) return place.name;
    return formatBox(region, project.city->frame).value_or(regionFileName);
}

}  // namespace

Result<std::string> hashContent(const Project& project, const MeasuredPart& part) {
    return hashContent(project, hashCity(*project.city), part);
}

Provenance provenanceOf(const Project& project, const ProjectFile* onDisk, const MeasuredPart& part) {
    Provenance provenance{project.inputs,
                          project.reading->settings,
                          joinAttribution(project.attribution, project.city->context.get()),
                          recordOf(project, onDisk, part),
                          {}};
    provenance.region = regionTextOf(project, onDisk, *provenance.project, part.region);
    return provenance;
}

void prependWarnings(Warnings& warnings, const Warnings& ofReading) {
    warnings.insert(warnings.begin(), ofReading.begin(), ofReading.end());
}

}  // namespace noonmark
