#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/io/elements/write_elements.h"
#include "core/receivers/place.h"
#include "core/study/contributions/contributions.h"
#include "core/sun/stated_period.h"

namespace noonmark {

/// What the buildings and trees take from one place of a study.
struct PlaceContributions {
    Place place;
    ShadowBreakdown breakdown;  ///< by month and by building, over the study's cells in the place
    std::size_t cells = 0;      ///< with their centre in the place; at least 1
    std::size_t days = 0;       ///< of the study's period
    /// The shadow of the same cells in the study's field, min x m2 of the whole period. By the engine that
    /// attributes, and on level ground, the breakdown adds up to it, within the rounding of float32.
    double studyMinM2 = 0;
    std::vector<Contribution> rows;  ///< of listContributions()
    Period period;                   ///< of the study, or one of its dates
    double sunlitMinutesPerDay = 0;  ///< of that period
    /// What single trees take of the sun that buildings leave, in the columns that were measured.
    std::vector<TreeContribution> trees{};
};

/// Attributes the shadow of a place to buildings, with the engine, the steps and the cells of the study, but
/// only over the cells whose centre lies in the place: on level ground they get the same minutes as in the
/// whole study; on terrain the sweep rounds heights from the lowest cell up. Error: no cell of the study in
/// the place; an engine without attribution (ErrorKind::unsupported), which names others. Stops with
/// cancelled() within 0.2 s. Cost: that of a study of the place with contributions, without its error.
Result<PlaceContributions> computePlaceContributions(const Study& study, const Place& place,
                                                     Progress& progress, std::stop_token stop,
                                                     const EngineList& engines = coreEngines());

struct SunOfCities;

/// The same of a place whose sun was measured, on its own cells, in the last of the cities: each cell counts
/// by its share of the place, so that the rows add up to the place's shadow. `place`: its index. Error also
/// where the place has no cell. `date`: on this one of its dates; none: over the period. Cost: that of a
/// study of the place with contributions.
Result<PlaceContributions> computePlaceContributions(const SunOfCities& sun, std::size_t place,
                                                     std::optional<std::size_t> date, Progress& progress,
                                                     std::stop_token stop,
                                                     const EngineList& engines = coreEngines());

/// What buildings take from a place, as an answer keeps it: without maps.
struct ContributionTable {
    std::string place;      ///< its name
    std::string kind;       ///< nameOf(PlaceKind)
    StatedPeriod period{};  ///< words empty: saved by a version that did not state it
    std::string engine;
    std::size_t cells = 0;
    double sunlitMinutesPerDay = 0;
    std::vector<std::string> months{};      ///< "2026-01"; those that rows have sums of
    std::vector<Contribution> rows;         ///< read back: without indices of buildings
    std::vector<TreeContribution> trees{};  ///< read back: without indices of trees
};
ContributionTable makeContributionTable(const PlaceContributions& of);
/// Replaces an earlier one of the same place and period.
std::vector<ContributionTable> withContributions(std::vector<ContributionTable> all, ContributionTable more);

/// The JSON of an answer with a member `contributions_of_places`; without any it stays as it is.
std::string withContributions(std::string json, const std::vector<ContributionTable>& all);
/// Of an answer's JSON; throws nlohmann's exceptions for JSON of another structure.
std::vector<ContributionTable> parseContributions(const nlohmann::ordered_json& answer);
/// Columns: place,kind,period,source_id,name, the figures, two for each month as of a study's, and the source
/// columns; a row for each building of each place.
std::string contributionsCsv(const std::vector<ContributionTable>& all, const Provenance& provenance);
inline constexpr const char* contributionTableFile = "contributions_of_places.csv";
/// Columns: place,kind,period,trees ("evergreen", "seasonal"),source_id,species, the figures and the source
/// columns; a row for each tree of each place and column.
std::string placeTreesCsv(const std::vector<ContributionTable>& all, const Provenance& provenance);
inline constexpr const char* placeTreesFile = "trees_of_places.csv";

/// Rows as a layer for a GIS. `style`: by share, as contributionStyle().
struct ContributionLayer {
    std::vector<Place> outlines;
    ElementTable table;
    LayerStyle style;
};
/// The outline of each building and of each tree's crown with what it takes from a place, so that it has a
/// polygon for each place. Columns: place,kind,period,what ("building", "tree"),source_id,name and the
/// figures, which of a tree are those of chooseRankedColumn(); then those of trees by column
/// ("share_evergreen"). Without the terrain, and without what the city lacks.
ContributionLayer makeContributionLayer(const std::vector<ContributionTable>& all, const City& city);
inline constexpr const char* contributionLayerFile = "contributions_of_places.gpkg";

/// The crowns of trees of `city` with what they take. Columns: source_id,species,height_m,crown_m and the
/// figures by column.
ContributionLayer makeTreeLayer(const std::vector<TreeContribution>& rows, const City& city);
inline constexpr const char* treeLayerFile = "tree_contributions.gpkg";

}  // namespace noonmark
