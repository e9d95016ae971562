#include "core/study/tile_tasks/merge/merge_tiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <unordered_map>

#include "core/io/files/plain_file.h"
#include "core/study/tiles/by_place_measure.h"
#include "core/sun/zone_country.h"

namespace noonmark {

namespace {

namespace fs = std::filesystem;

// Kilometres away half a millimetre is lost.
void moveTo(Ring& ring, const Frame& from, const Frame& to) {
    for (glm::vec2& corner : ring)
        corner = glm::vec2(to.localFromLonLat(from.lonLatFromLocal(glm::dvec2(corner))));
}

void moveTo(Place& place, const Frame& from, const Frame& to) {
    for (Footprint& polygon : place.polygons) {
        moveTo(polygon.outer, from, to);
        for (Ring& hole : polygon.holes) moveTo(hole, from, to);
    }
}

/// Joins samples: means by the cells that each stands for, and the largest.
class JoinedError {
public:
    void add(const SampledError& error) {
        const double more = double(error.ofReceivers), all = double(sum_.ofReceivers) + more;
        const auto mean = [&](double before, double own) {
            return all > 0 ? (before * (all - more) + own * more) / all : own;
        };
        const auto spread = [&](double before, double own) {
            return all > 0 ? std::hypot(before * (all - more), own * more) / all : own;
        };
        const CellError& own = error.gross;
        sum_.areaPct = mean(sum_.areaPct, error.areaPct);
        sum_.areaStandardErrorPct = spread(sum_.areaStandardErrorPct, error.areaStandardErrorPct);
        sum_.gross.meanMin = mean(sum_.gross.meanMin, own.meanMin);
        sum_.gross.meanStandardErrorMin = spread(sum_.gross.meanStandardErrorMin, own.meanStandardErrorMin);
        sum_.gross.p99Min = std::max(sum_.gross.p99Min, own.p99Min);
        if (sum_.receivers == 0 || own.maxMin > sum_.gross.maxMin) {
            sum_.gross.maxMin = own.maxMin;
            sum_.gross.worstM = own.worstM;
        }
        sum_.gross.wholeMin = own.wholeMin;
        sum_.continuous = error.continuous;
        sum_.receivers += error.receivers;
        sum_.ofReceivers += error.ofReceivers;
        sum_.rays += error.rays;
    }
    [[nodiscard]] std::optional<SampledError> get() const {
        return sum_.receivers == 0 ? std::nullopt : std::optional(sum_);
    }

private:
    SampledError sum_;
};

// Of the same quantity: the mean by the values compared, and the largest. NaN stays NaN.
void addError(std::vector<ShownError>& errors, const ShownError& more) {
    const auto same = std::ranges::find_if(
        errors, [&](const ShownError& one) { return one.facts.key == more.facts.key && one.of == more.of; });
    if (same == errors.end()) return errors.push_back(more);
    const auto before = double(same->count), own = double(more.count);
    same->mean = (same->mean * before + more.mean * own) / (before + own);
    same->p99 = std::max(same->p99, more.p99);
    same->largest = std::fmax(same->largest, more.largest);
    same->count += more.count;
}

/// One run of mergeSunByPlace().
class ByPlaceMerge {
public:
    ByPlaceMerge(const fs::path& folder, const TaskPlan& plan, const ByPlaceRequest& request,
                 const StudySettings& study, const std::vector<City>& cities)
        : folder_(folder), plan_(plan), request_(request), study_(study), cities_(cities) {}

    Result<MergedSun> run(bool partial, Progress& progress, const std::stop_token& stop) {
        auto status = findMergeable(folder_, plan_, partial);
        if (!status) return tl::make_unexpected(status.error());
        found_.resize(cities_.size());
        for (std::size_t district = 0; district < status->finished.size(); ++district) {
            auto places = readPlaces(request_, plan_.districts[district].frame, progress, stop);
            if (!places) return tl::make_unexpected(places.error());
            takePlaces(*std::move(places), district);
            for (const auto& [number, tile] : status->finished[district]) {
                if (stop.stop_requested()) return cancelled();
                if (tile.result.empty()) continue;
                const fs::path file = TileJournal::fileIn(taskFolder(folder_, tile.task), tile.result);
                if (auto added = addTile(file); !added) return tl::make_unexpected(added.error());
            }
        }
        auto sun = join(stop);
        if (!sun) return tl::make_unexpected(sun.error());
        return MergedSun{*std::move(sun), status->allTiles - status->doneTiles};
    }

private:
    /// Of one city, over the tiles.
    struct OfCity {
        std::set<std::string> engines;
        JoinedError error;
        std::vector<JoinedError> dateErrors;
        std::vector<ShownError> errors;
        Warnings warnings;
        std::string treesHow;
    };

    // Each once, in the order in which they are read.
    void takePlaces(std::vector<Place> places, std::size_t district) {
        const Frame& own = plan_.districts[district].frame;
        const Frame& first = plan_.districts.front().frame;
        for (Place& place : places) {
            if (!index_.emplace(place.name, places_.size()).second) continue;
            if (own != first) moveTo(place, own, first);
            places_.push_back(std::move(place));
        }
        lines_.resize(places_.size());
    }

    Result<void> addTile(const fs::path& file) try {
        if (const auto plain = checkPlainFile(file); !plain) return tl::make_unexpected(plain.error());
        std::ifstream stream(file, std::ios::binary);
        std::string line;
        if (!stream || !std::getline(stream, line))
            return failure("A finished tile cannot be read", file.string(), "Run its task again");
        takeTile(parseTileLine(line));
        while (std::getline(stream, line)) takePlace(parsePlaceLine(line));
        return {};
    } catch (const std::exception&) {  // lines of another structure
        return failure("A finished tile is damaged", file.string(), "Remove it and run its task again");
    }

    void takeTile(const TileLine& tile) {
        seconds_ += tile.seconds;
        for (std::size_t i = 0; i < found_.size(); ++i) {
            const SunOfTile& own = tile.cities.at(i);
            OfCity& city = found_[i];
            if (!own.engine.empty()) city.engines.insert(own.engine);
            if (own.error) city.error.add(*own.error);
            city.dateErrors.resize(request_.settings.dates.size());
            for (std::size_t date = 0; date < own.dateErrors.size(); ++date)
                if (own.dateErrors[date]) city.dateErrors.at(date).add(*own.dateErrors[date]);
            for (const ShownError& error : own.errors) addError(city.errors, error);
            std::ranges::copy(own.warnings, std::back_inserter(city.warnings));
            if (!own.treesHow.empty()) city.treesHow = own.treesHow;
        }
    }

    void takePlace(PlaceLine line) {
        if (line.sun.size() != cities_.size() || line.changes.size() + 1 != cities_.size())
            throw std::invalid_argument("a place of other cities");
        auto& place = lines_.at(index_.at(line.name));
        for (const PlaceLine::WithTrees& with : line.withTrees)
            if (with.sun.size() != line.sun.size() || with.changes.size() != line.changes.size())
                throw std::invalid_argument("trees of other cities");
        if (columns_.empty())
            for (const PlaceLine::WithTrees& with : line.withTrees) columns_.push_back(with.column);
        if (!place) place = std::move(line);
    }

    Result<SunOfCities> join(const std::stop_token& stop) {
        leaveOutMissing();
        if (places_.empty())
            return failure("No place of the plan has been measured yet", folder_.string(), "Run its tasks");
        SunOfCities all{of(0), {}};
        const Observer observer = observerOf();
        if (auto framed = prepareSunByPlace(all.baseline, observer, stop); !framed)
            return tl::make_unexpected(framed.error());
        for (std::size_t i = 1; i < cities_.size(); ++i) {
            ComparedSun compared{of(i), {}};
            if (auto framed = prepareSunByPlace(compared.sun, observer, stop); !framed)
                return tl::make_unexpected(framed.error());
            for (const auto& line : lines_) compared.changes.push_back(line->changes[i - 1]);
            for (const TreeColumns column : columns_) {
                auto& changes = compared.changesWithTrees.emplace_back();
                for (const auto& line : lines_)
                    changes.push_back((withTrees(*line, column) ? withTrees(*line, column)->changes
                                                                : line->changes)[i - 1]);
            }
            all.compared.push_back(std::move(compared));
        }
        questionTheZone(all.baseline);
        return all;
    }

    // The sun of the first district.
    [[nodiscard]] Observer observerOf() const {
        StudySettings study = study_;
        study.region = plan_.districts.front().region;
        return makeObserver(cities_.front(), study);
    }

    void questionTheZone(SunByPlace& sun) const {
        const Box2 box = bounds(sun.settings.study.region);
        const LonLat middle = sun.city.frame.lonLatFromLocal(glm::dvec2(box.low + box.high) / 2.0);
        if (auto question = questionZone(study_.period, middle))
            sun.warnings.insert(sun.warnings.begin(), *std::move(question));
    }

    void leaveOutMissing() {
        std::vector<Place> places;
        std::vector<std::optional<PlaceLine>> lines;
        for (std::size_t i = 0; i < places_.size(); ++i) {
            if (lines_[i]) {
                places.push_back(std::move(places_[i]));
                lines.push_back(std::move(lines_[i]));
            } else {
                found_.front().warnings.push_back(
                    {WarningKind::leftOut, "a place of no finished tile", places_[i].name});
            }
        }
        places_ = std::move(places);
        lines_ = std::move(lines);
    }

    [[nodiscard]] SunByPlace of(std::size_t city) const {
        const OfCity& own = found_[city];
        SunByPlace sun{.name = request_.cities[city], .city = cities_[city], .settings = request_.settings};
        sun.settings.study = study_;
        sun.places = places_;
        for (const auto& line : lines_) sun.sun.push_back(line->sun[city]);
        for (const std::string& engine : own.engines)
            sun.field.engine += (sun.field.engine.empty() ? "" : "; ") + engine;
        sun.error = own.error.get();
        for (const JoinedError& error : own.dateErrors) sun.dateErrors.push_back(error.get());
        sun.errors = own.errors;
        sun.warnings = own.warnings;
        sun.treesHow = own.treesHow;
        for (const TreeColumns column : columns_) sun.withTrees.push_back({column, listSun(column, city)});
        sun.seconds = {{"total", seconds_}};
        return sun;
    }

    // Null: no tree reaches a place of its tile, so that it has the sun without trees.
    static const PlaceLine::WithTrees* withTrees(const PlaceLine& line, TreeColumns column) {
        const auto found = std::ranges::find(line.withTrees, column, &PlaceLine::WithTrees::column);
        return found == line.withTrees.end() ? nullptr : &*found;
    }

    [[nodiscard]] std::vector<SunOfPlace> listSun(TreeColumns column, std::size_t city) const {
        std::vector<SunOfPlace> all;
        for (const auto& line : lines_) {
            const PlaceLine::WithTrees* with = withTrees(*line, column);
            all.push_back((with == nullptr ? line->sun : with->sun)[city]);
        }
        return all;
    }

    const fs::path& folder_;
    const TaskPlan& plan_;
    const ByPlaceRequest& request_;
    const StudySettings& study_;
    const std::vector<City>& cities_;
    std::vector<Place> places_;
    std::vector<std::optional<PlaceLine>> lines_;  // of each place
    std::vector<TreeColumns> columns_;             // that some tile has trees for
    std::unordered_map<std::string, std::size_t> index_;
    std::vector<OfCity> found_;  // of each city
    double seconds_ = 0;
};

}  // namespace

Result<MergedSun> mergeSunByPlace(const fs::path& folder, const TaskPlan& plan, const ByPlaceRequest& request,
                                  const StudySettings& study, const std::vector<City>& cities, bool partial,
                                  Progress& progress, const std::stop_token& stop) {
    return ByPlaceMerge(folder, plan, request, study, cities).run(partial, progress, stop);
}

}  // namespace noonmark
