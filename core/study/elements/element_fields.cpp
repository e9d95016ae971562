#include "core/study/elements/element_fields.h"

#include <fmt/format.h>

#include "core/describe/text.h"
#include "core/receivers/points/point_list.h"

namespace noonmark {

namespace {

bool onFacades(const ElementSettings& elements) { return elements.places == ElementPlaces::facades; }
bool onGlazing(const ElementSettings& elements) { return elements.places == ElementPlaces::windows; }
bool onWalls(const ElementSettings& elements) { return onFacades(elements) || onGlazing(elements); }
bool onLines(const ElementSettings& elements) { return elements.places == ElementPlaces::lines; }
bool onPoints(const ElementSettings& elements) { return elements.places == ElementPlaces::points; }
bool isLevel(const ElementSettings& elements) {
    return onLines(elements) || elements.places == ElementPlaces::plane;
}
bool looksAtPlace(const FaceChoice& faces) { return !faces.place.empty(); }

constexpr std::array heightChoices{KeyedLabel{"elevation", NM_TEXT("elevations")},
                                   KeyedLabel{"ground", NM_TEXT("above the ground")}};

Value getHeights(const GlazingFileSettings& file) {
    return std::string(heightChoices[file.aboveGround ? 1 : 0].key);
}

Result<void> setHeights(GlazingFileSettings& file, const Value& value) {
    file.aboveGround = value == Value(std::string(heightChoices[1].key));
    return {};
}

const Fields<FacadeSettings>& baySizes() {
    static const Fields<FacadeSettings> fields{
        field(&FacadeSettings::bayM, {.key = "bay_m",
                                      .flag = "--bay",
                                      .label = NM_TEXT("Bay"),
                                      .help = NM_TEXT("Facades: width of a bay, one point or window each"),
                                      .unit = "m",
                                      .range = ValueRange{FacadeSettings::minM, FacadeSettings::maxM}}),
    };
    return fields;
}

const Fields<FacadeSettings>& storeySizes() {
    static const Fields<FacadeSettings> fields{field(
        &FacadeSettings::storeyM,
        {.key = "storey_m",
         .flag = "--storey",
         .label = NM_TEXT("Storey"),
         .help =
             NM_TEXT("Height of a storey: facades have one point or window each, windows are numbered by it"),
         .unit = "m",
         .range = ValueRange{FacadeSettings::minM, FacadeSettings::maxM}})};
    return fields;
}

const Fields<FacadeSettings>& floorSizes() {
    static const Fields<FacadeSettings> fields{
        field(&FacadeSettings::aboveFloorM, {.key = "above_floor_m",
                                             .flag = "--above-floor",
                                             .label = NM_TEXT("Above floor"),
                                             .help = NM_TEXT("Facades: height of the points above the floor"),
                                             .unit = "m",
                                             .range = ValueRange{0, FacadeSettings::maxM}})};
    return fields;
}

const Fields<LineSettings>& lineSizes() {
    static const Fields<LineSettings> fields{
        field(&LineSettings::offsetsM,
              {.key = "offsets_m",
               .flag = "--offsets",
               .label = "Distances",
               .help = "Lines: their distances from the parcel, with commas",
               .hint = "M,...",
               .unit = "m",
               .range = ValueRange{LineSettings::minOffsetM, LineSettings::maxOffsetM},
               .restated = true}),
        field(&LineSettings::spacingM,
              {.key = "spacing_m",
               .flag = "--spacing",
               .label = "Spacing",
               .help = "Lines: distance from point to point",
               .unit = "m",
               .range = ValueRange{LineSettings::minSpacingM, LineSettings::maxSpacingM},
               .restated = true}),
    };
    return fields;
}

Result<std::vector<ListedPoint>> parsePoints(std::string_view csv) {
    if (csv.empty()) return std::vector<ListedPoint>();
    return parsePointList(csv, "points");
}

std::string formatPoints(std::vector<ListedPoint> points) { return points.empty() ? "" : toCsv(points); }

const Fields<ElementSettings>& pointListFields() {
    static const Fields<ElementSettings> fields{
        textField(&ElementSettings::points, &formatPoints, &parsePoints, {.key = "points", .label = "Points"})
            .when(&onPoints)};
    return fields;
}

const Fields<ElementSettings>& buildingFields() {
    static const Fields<ElementSettings> fields{
        field(&ElementSettings::proposed, {.key = "proposed", .label = "Proposed buildings only"})
            .when(&onFacades),
        field(&ElementSettings::buildings, {.key = "buildings", .flag = "--facades-of", .label = "Of"})
            .when([](const ElementSettings& elements) { return onFacades(elements) && !elements.proposed; }),
    };
    return fields;
}

constexpr std::string_view proposedFacades = "proposed";

Value getFacadesOf(const ElementSettings& elements) {
    return elements.proposed ? std::vector{std::string(proposedFacades)} : elements.buildings;
}

Result<void> setFacadesOf(ElementSettings& elements, const Value& value) {
    const auto* names = std::get_if<std::vector<std::string>>(&value);
    if (names == nullptr) return failure({});
    const auto isOnly = [&](std::string_view word) { return names->size() == 1 && names->front() == word; };
    elements.proposed = isOnly(proposedFacades);
    elements.buildings = elements.proposed || isOnly(allFacades) ? std::vector<std::string>() : *names;
    return {};
}

Value getPoints(const ElementSettings& elements) {
    std::vector<std::string> texts;
    for (const ListedPoint& point : elements.points) texts.push_back(formatText(point));
    return texts;
}

Result<void> setPoints(ElementSettings& elements, const Value& value) {
    const auto* texts = std::get_if<std::vector<std::string>>(&value);
    if (texts == nullptr) return failure({});
    for (const std::string& text : *texts) {
        auto point = parsePoint(text);
        if (!point) return tl::make_unexpected(point.error());
        point->id = fmt::format("point {}", elements.points.size() + 1);
        elements.points.push_back(*std::move(point));
    }
    return {};
}

}  // namespace

const Fields<ElementSettings>& receiverFields() {
    static const Fields<ElementSettings> fields{choiceField(
        &ElementSettings::places, elementPlaceChoices,
        {.key = "places", .flag = "--receivers", .label = "Receivers", .hint = "PLACES", .restated = true})};
    return fields;
}

const Fields<ElementSettings>& facadesOfFields() {
    static const Fields<ElementSettings> fields{
        derivedField<ElementSettings>(
            ValueKind::texts, &getFacadesOf, &setFacadesOf,
            {.key = "facades_of",
             .flag = "--facades-of",
             .help = "Facades: buildings of the region by name or id (default: all, those whose middle is in "
                     "the region), or those that a scenario of a project builds or changes; may be repeated",
             .hint = "NAME,...|all|proposed"})
            .when([](const ElementSettings& elements) { return onFacades(elements) && elements.proposed; })};
    return fields;
}

const Fields<ElementSettings>& pointFields() {
    static const Fields<ElementSettings> fields{
        derivedField<ElementSettings>(ValueKind::texts, &getPoints, &setPoints,
                                      {.key = "point",
                                       .flag = "--point",
                                       .help = "Points: one point; may be repeated",
                                       .hint = "LON,LAT[,H[,FACING]]"})
            .when([](const ElementSettings& elements) {
                return onPoints(elements) && elements.pointsFile.empty();
            })};
    return fields;
}

const Fields<ElementSettings>& pointsFileFields() {
    static const Fields<ElementSettings> fields{
        field(&ElementSettings::pointsFile,
              {.key = "points_file",
               .flag = "--points",
               .label = "File",
               .help = "Points: a CSV file with columns lon, lat and, if known, id, height (metres "
                       "above the ground) and facing (azimuth of a wall)",
               .hint = "FILE.csv",
               .role = SettingRole::none})
            .when(&onPoints)};
    return fields;
}

const Fields<ElementSettings>& glazingFields() {
    static const Fields<ElementSettings> fields{
        field(&ElementSettings::windows,
              {.key = "windows",
               .flag = "--windows",
               .label = "File",
               .help = "Windows: a file of points or polygons with heights (fields id, azimuth, floor)",
               .hint = "FILE"})
            .when(&onGlazing)};
    return fields;
}

const Fields<GlazingFileSettings>& glazingFileFields() {
    static const Fields<GlazingFileSettings> fields{
        field(&GlazingFileSettings::idField,
              {.key = "window_id",
               .flag = "--window-id",
               .label = "Field of ids",
               .help = "Windows: the field with their ids (default: id, window, window_id, name)",
               .hint = "FIELD"}),
        field(&GlazingFileSettings::crs,
              {.key = "windows_crs",
               .flag = "--windows-crs",
               .label = "Coordinate system",
               .help = "Windows: coordinate reference system, if the file states none",
               .hint = "CRS"}),
        derivedField(
            ValueKind::choice, &getHeights, &setHeights,
            {.key = "windows_above_ground",
             .flag = "--window-heights",
             .label = NM_TEXT("Heights"),
             .help = NM_TEXT("Windows: heights are elevations, as those of the city, or metres above "
                             "the ground below"),
             .hint = "WHAT"})
            .among(heightChoices),
    };
    return fields;
}

const Fields<FaceChoice>& faceFields() {
    static const Fields<FaceChoice> fields{
        field(&FaceChoice::faces,
              {.key = "faces",
               .flag = "--face",
               .label = "Faces",
               .help = "Facades: one face by the beginning of its points' ids, \"way 12 wall 3\"; may be "
                       "repeated",
               .hint = "ID"}),
        textField(&FaceChoice::facing, &formatText, &parseAzimuthRange,
                  {.key = "facing_deg",
                   .flag = "--facing",
                   .label = "Facing",
                   .help = "Facades and windows: only those that face these azimuths, degrees from true "
                           "north, clockwise",
                   .hint = "FROM-TO"}),
        field(&FaceChoice::place,
              {.key = "facing_place",
               .flag = "--facing-place",
               .label = "Facing place",
               .help = "Facades and windows: only those from which a level line straight out from the "
                       "wall meets this place",
               .hint = "NAME"}),
        field(&FaceChoice::withinM, {.key = "within_m",
                                     .flag = "--within",
                                     .label = "Within",
                                     .help = "With --facing-place: at most this far away",
                                     .unit = "m",
                                     .range = ValueRange{1, FaceChoice::maxWithinM},
                                     .restated = true,
                                     .needs = "--facing-place"})
            .when(&looksAtPlace),
    };
    return fields;
}

const Fields<ElementSettings>& facadeFields() {
    static const auto fields = Fields<ElementSettings>{}
                                   .embed(&ElementSettings::facades, baySizes(), {}, &onFacades)
                                   .embed(&ElementSettings::facades, storeySizes(), {}, &onWalls);
    return fields;
}

const Fields<ElementSettings>& aboveFloorFields() {
    static const auto fields =
        Fields<ElementSettings>{}.embed(&ElementSettings::facades, floorSizes(), {}, &onFacades);
    return fields;
}

const Fields<ElementSettings>& lineFields() {
    static const auto fields =
        Fields<ElementSettings>{
            field(&ElementSettings::parcel,
                  {.key = "parcel",
                   .flag = "--parcel",
                   .label = "Parcel",
                   .help = "Lines: the parcel, a polygon file or a lot, region or place of the project",
                   .hint = "FILE|NAME"})
                .when(&onLines)}
            .embed(&ElementSettings::lines, lineSizes(), {}, &onLines);
    return fields;
}

const Fields<ElementSettings>& planeFields() {
    static const Fields<ElementSettings> fields{
        field(
            &ElementSettings::planeHeightM,
            {.key = "plane_height_m",
             .flag = "--plane-height",
             .label = NM_TEXT("Height"),
             .help = NM_TEXT("Plane and lines: height above the mean of the ground, of the region or parcel"),
             .unit = "m",
             .range = ValueRange{0, maxPlaneHeightM},
             .hasDefault = false,
             .restated = true})
            .when(&isLevel)};
    return fields;
}

const Fields<ElementSettings>& elementFields() {
    static const auto fields = Fields<ElementSettings>{}
                                   .with(receiverFields())
                                   .with(buildingFields())
                                   .embed(&ElementSettings::faces, faceFields(), {}, &onWalls)
                                   .with(glazingFields())
                                   .embed(&ElementSettings::glazingFile, glazingFileFields(), {}, &onGlazing)
                                   .with(planeFields())
                                   .with(lineFields())
                                   .with(pointListFields())
                                   .with(pointsFileFields())
                                   .with(facadeFields())
                                   .with(aboveFloorFields());
    return fields;
}

}  // namespace noonmark
