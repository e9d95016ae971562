#pragma once

// The folder core/study/contributions states what each building takes: this file has the rows of a table
// with their figures, place_contributions.h finds them for one place of a study.

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/describe/figure.h"
#include "core/io/write_city.h"
#include "core/study/study.h"

namespace noonmark {

/// The shadow of one building, of the terrain, or of a tree, on the cells of a breakdown.
struct Contribution {
    std::optional<std::uint32_t> building;      ///< index in City::buildings; none: the terrain, or a tree
    std::string id;                             ///< of the source; terrainId
    std::string name;                           ///< may be empty; of a tree its species
    BuildingShadow shadow;                      ///< by set of steps
    double attributedMinM2 = 0, soleMinM2 = 0;  ///< of the whole period
    double attributedMin = 0, soleMin = 0;      ///< a day, mean over the cells
    double share = 0;                           ///< of all shadow on the cells, 0 to 1
    bool isTree = false;
};

inline constexpr const char* terrainId = "terrain";

/// Its name, else its id; of a tree "Tilia cordata (node/12)".
std::string nameOf(const Contribution& one);

/// Glossary: attributed shadow, sole contribution. These rows hold their definitions.
const Figures<Contribution>& contributionFigures();
/// Of the table above.
std::string_view attributedDefinition();
std::string_view soleDefinition();

/// One row for each building that shades a cell, those with the most attributed shadow first, and at the end
/// one for the terrain where it shades any. `city` and `days`: those of the breakdown.
std::vector<Contribution> listContributions(const City& city, const ShadowBreakdown& breakdown,
                                            std::size_t days);

/// Columns: building,source_id,name and the figures; with several months two more columns for each of them
/// ("attributed 2026-01", "sole 2026-01"); then the source columns. Rows as of listContributions().
std::string contributionsCsv(const std::vector<Contribution>& rows, const StepSets& sets,
                             const Provenance& provenance);
/// The study's breakdown must exist.
std::string contributionsCsv(const Study& study);

/// What one tree takes, in each column that the study has; the shadow by set is empty.
struct TreeContribution {
    std::uint32_t tree = 0;                                     ///< index in City::trees
    std::vector<std::pair<TreeColumns, Contribution>> columns;  ///< evergreens first
};
/// One row for each tree that takes some, those that take most by their seasons, else as evergreens, first.
/// Shares are of all shadow with trees. Empty where the study has none.
std::vector<TreeContribution> listTreeContributions(const Study& study);
/// The same of what was traced over other cells of a city, whose breakdown says what buildings take.
std::vector<TreeContribution> listTreeContributions(const City& city, const TakenByTree& taken,
                                                    std::span<const TreeColumns> columns,
                                                    const ShadowBreakdown& breakdown, std::size_t days);

/// Which column a list of buildings and trees states: the one that is wanted where it was measured, else by
/// seasons, else as evergreens; TreeColumns::without where no tree takes any.
TreeColumns chooseRankedColumn(const std::vector<TreeContribution>& trees, TreeColumns wanted);
/// Buildings and trees of a column in one list, those that are charged with most first, the terrain last.
/// Shares are of what all of them are charged with; what is sole of a building is that without trees.
std::vector<Contribution> rankWithTrees(std::vector<Contribution> rows,
                                        const std::vector<TreeContribution>& trees, TreeColumns column);
/// "share_evergreen", "attributed_min_day_seasonal"
std::span<const Figure> contributionFiguresWithTrees(TreeColumns column);
/// Columns: source_id,species,lon_deg,lat_deg and the figures with trees; then the source columns.
/// `rows`: their trees are of `city`.
std::string treeContributionsCsv(const std::vector<TreeContribution>& rows, const City& city,
                                 const Provenance& provenance);
inline constexpr const char* treeContributionsFile = "tree_contributions.csv";
/// As saved answers hold them: source_id, species and a key for each figure and column ("share_seasonal").
nlohmann::ordered_json treeContributionsJson(const std::vector<TreeContribution>& trees);
/// Of that, without indices of trees; throws nlohmann's exceptions for JSON of another structure.
std::vector<TreeContribution> parseTreeContributions(const nlohmann::ordered_json& json);

/// The figures as columns of the layer of buildings; 0 where a building shades nothing.
std::vector<BuildingColumn> contributionColumns(const std::vector<Contribution>& rows, std::size_t buildings);

/// The classes of maps of contributions: a share of at least `from` has this colour. Sequential, told apart
/// by colour-blind readers and by lightness; none of them is a colour of the maps of shadow.
struct ContributionClass {
    double from = 0;  ///< 0 to 1
    Rgb colour;
};
inline constexpr std::array contributionClasses{
    ContributionClass{0, {0xfe, 0xeb, 0xe2}}, ContributionClass{0.01, {0xfb, 0xb4, 0xb9}},
    ContributionClass{0.05, {0xf7, 0x68, 0xa1}}, ContributionClass{0.15, {0xc5, 0x1b, 0x8a}},
    ContributionClass{0.30, {0x7a, 0x01, 0x77}}};

/// The style of such columns for QGIS: polygons coloured by this one, a share.
LayerStyle contributionStyle(std::string_view column = "share");

}  // namespace noonmark
