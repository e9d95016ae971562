#include "core/study/tiles/by_place_measure.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/describe/field_values.h"

namespace noonmark {

namespace {

using Json = nlohmann::ordered_json;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// JSON has no NaN: null.
double numberFrom(const Json& json) { return json.is_null() ? nan : json.get<double>(); }

std::vector<double> numbersFrom(const Json& json) {
    std::vector<double> numbers;
    for (const Json& one : json) numbers.push_back(numberFrom(one));
    return numbers;
}

Json figuresLine(const DescribedFigures& figures) {
    Json json;
    for (const Figure& figure : figures.figures) json[std::string(figure.key)] = figures.get(figure);
    return json;
}

template <class R>
R figuresFrom(const Figures<R>& figures, const Json& json) {
    R result;
    for (const Figure& figure : figures.rows())
        figure.set(&result, numberFrom(json.at(std::string(figure.key))));
    return result;
}

Json sunLine(const SunOfPlace& of) {
    Json json = figuresLine(sunOfPlaceFigures().of(of));
    json["cells"] = of.cells;
    json["cell_m"] = of.cellM;
    json["why"] = int(of.status);
    for (const PlaceRemark remark : of.remarks) json["remarks"].push_back(int(remark));
    json["seasons"] = of.seasonHours;
    json["months"] = of.monthHours;
    json["dates"] = of.dateHours;
    json["below"] = of.belowShare;
    return json;
}

SunOfPlace sunFrom(const Json& json) {
    SunOfPlace of = figuresFrom(sunOfPlaceFigures(), json);
    of.cells = json.at("cells");
    of.cellM = json.at("cell_m");
    of.status = PlaceStatus(json.at("why").get<int>());
    for (const Json& remark : json.value("remarks", Json::array()))
        of.remarks.push_back(PlaceRemark(remark.get<int>()));
    of.seasonHours = numbersFrom(json.at("seasons"));
    of.monthHours = numbersFrom(json.at("months"));
    of.dateHours = numbersFrom(json.at("dates"));
    of.belowShare = numbersFrom(json.at("below"));
    return of;
}

// Without longest shadows, which places do not have.
Json errorLine(const std::optional<SampledError>& error) {
    if (!error) return nullptr;
    const CellError& gross = error->gross;
    return {error->receivers,
            error->ofReceivers,
            error->rays,
            error->areaPct,
            error->areaStandardErrorPct,
            gross.meanMin,
            gross.meanStandardErrorMin,
            gross.p99Min,
            gross.maxMin,
            gross.worstM.x,
            gross.worstM.y,
            gross.wholeMin};
}

std::optional<SampledError> errorFrom(const Json& json) {
    if (json.is_null()) return std::nullopt;
    const auto number = [&](std::size_t i) { return numberFrom(json.at(i)); };
    SampledError error{.receivers = json.at(0),
                       .ofReceivers = json.at(1),
                       .rays = json.at(2),
                       .areaPct = number(3),
                       .areaStandardErrorPct = number(4)};
    error.gross = {number(5), number(6), number(7), number(8), {number(9), number(10)}, number(11)};
    error.continuous = {nan, nan, nan, nan, {nan, nan}, nan};
    return error;
}

Json cityLine(const SunByPlace& sun) {
    Json json{{"engine", sun.field.engine}, {"error", errorLine(sun.error)}};
    if (!sun.treesHow.empty()) json["trees"] = sun.treesHow;
    json["date_errors"] = Json::array();
    for (const auto& error : sun.dateErrors) json["date_errors"].push_back(errorLine(error));
    json["errors"] = errorsJson(sun.errors);
    json["warnings"] = Json::array();
    for (const Warning& warning : sun.warnings)
        json["warnings"].push_back({int(warning.kind), warning.what, warning.where});
    return json;
}

SunOfTile cityFrom(const Json& json) {
    SunOfTile city{.engine = json.at("engine"),
                   .treesHow = json.value("trees", std::string()),
                   .error = errorFrom(json.at("error"))};
    for (const Json& error : json.at("date_errors")) city.dateErrors.push_back(errorFrom(error));
    city.errors = parseErrors(json.at("errors"));
    for (const Json& one : json.at("warnings"))
        city.warnings.push_back({WarningKind(one.at(0).get<int>()), one.at(1), one.at(2)});
    return city;
}

// What a place gets in each city, and what that changes against the first.
void addSun(Json& json, const SunOfCities& sun, std::size_t i) {
    json["sun"].push_back(sunLine(sun.baseline.sun[i]));
    json["changes"] = Json::array();
    for (const ComparedSun& one : sun.compared) {
        json["sun"].push_back(sunLine(one.sun.sun[i]));
        json["changes"].push_back(figuresLine(sunChangeFigures().of(one.changes[i])));
    }
}

PlaceLine::WithTrees treesFrom(const Json& json) {
    PlaceLine::WithTrees with{.column = TreeColumns(json.at("column").get<int>()), .sun = {}, .changes = {}};
    for (const Json& sun : json.at("sun")) with.sun.push_back(sunFrom(sun));
    for (const Json& change : json.at("changes"))
        with.changes.push_back(figuresFrom(sunChangeFigures(), change));
    return with;
}

/// An answer in one of its columns of trees.
struct SunInColumn {
    TreeColumns column;
    SunOfCities sun;
};

std::vector<SunInColumn> listInColumns(const SunOfCities& sun) {
    std::vector<SunInColumn> all;
    for (const TreeColumns column : listSunColumns(sun))
        if (auto made = inColumn(sun, column)) all.push_back({column, *std::move(made)});
    return all;
}

Json placeLine(const SunOfCities& sun, const std::vector<SunInColumn>& columns, std::size_t i) {
    Json json{{"place", sun.baseline.places[i].name}};
    addSun(json, sun, i);
    for (const SunInColumn& with : columns) {
        Json line{{"column", int(with.column)}};
        addSun(line, with.sun, i);
        json["with_trees"].push_back(std::move(line));
    }
    return json;
}

// Names may hold bytes that are no UTF-8.
std::string textOf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string formatLines(const SunOfCities& sun) {
    Json tile{{"seconds", sun.baseline.seconds.at("total")}};
    tile["cities"].push_back(cityLine(sun.baseline));
    for (const ComparedSun& one : sun.compared) tile["cities"].push_back(cityLine(one.sun));
    std::string lines = textOf(tile);
    const std::vector<SunInColumn> columns = listInColumns(sun);
    for (std::size_t i = 0; i < sun.baseline.places.size(); ++i) lines += textOf(placeLine(sun, columns, i));
    return lines;
}

TileLine parseTileLine(const std::string& line) {
    const Json json = Json::parse(line);
    TileLine tile{.cities = {}, .seconds = json.at("seconds")};
    for (const Json& city : json.at("cities")) tile.cities.push_back(cityFrom(city));
    return tile;
}

PlaceLine parsePlaceLine(const std::string& line) {
    const Json json = Json::parse(line);
    PlaceLine place{.name = json.at("place"), .sun = {}, .changes = {}, .withTrees = {}};
    for (const Json& sun : json.at("sun")) place.sun.push_back(sunFrom(sun));
    for (const Json& change : json.at("changes"))
        place.changes.push_back(figuresFrom(sunChangeFigures(), change));
    for (const Json& with : json.value("with_trees", Json::array()))
        place.withTrees.push_back(treesFrom(with));
    return place;
}

namespace {

std::size_t countCells(const SunByPlace& sun) {
    std::size_t cells = 0;
    for (const SunOfPlace& of : sun.sun) cells += of.cells;
    return cells;
}

}  // namespace

std::string ByPlaceRequest::key() const {
    return fmt::format("sun by place;{};{};{}", PlacesRequest::key(), fmt::join(cities, ";"),
                       questionText(sunByPlaceFields().of(settings), true));
}

ByPlaceMeasure::ByPlaceMeasure(std::vector<const City*> cities, const PlacesOfTiles& places,
                               const ByPlaceRequest& request, const TileQuestion& question,
                               const EngineList& engines)
    : cities_(std::move(cities)),
      places_(places),
      request_(request),
      question_(question),
      engines_(engines) {}

Result<TileAnswer> ByPlaceMeasure::measure(const Grid& tile, Progress& progress,
                                           const std::stop_token& stop) {
    const std::vector<Place>& places = places_.in(tile);
    if (places.empty()) return TileAnswer{};
    SunByPlaceSettings settings = request_.settings;
    settings.study = question_.settings;
    std::vector<NamedCity> cities;
    for (std::size_t i = 0; i < cities_.size(); ++i) cities.push_back({request_.cities.at(i), *cities_[i]});
    const Observer observer = makeObserver(*cities_.front(), question_.settings);
    return measurePlacesOfTile(cities, places, settings, observer, progress, stop, engines_)
        .map([&](const SunOfCities& sun) {
            TileAnswer answer;
            answer.result.lines = places.size() + 1;
            answer.result.sums.receivers = countCells(sun.baseline);
            answer.result.engineKey = question_.settings.engine;
            answer.result.engine = sun.baseline.field.engine;
            answer.lines = formatLines(sun);
            return answer;
        });
}

}  // namespace noonmark
