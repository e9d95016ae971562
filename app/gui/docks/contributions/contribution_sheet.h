#pragma once

// The folder app/gui/docks/contributions shows how much sun each building takes from a region or a place.
// This file makes the rows, as plain data; contributions_dock.h shows them with bars by month;
// contribution_links.h asks for them and connects them with the view.

#include <QString>
#include <memory>
#include <string>
#include <vector>

#include "core/describe/shown_as.h"
#include "core/study/contributions/place_contributions.h"
#include "core/study/text/breakdown_text.h"
#include "scenarios/impact/impact_text.h"
#include "scenarios/project/results/saved_answer.h"

namespace noonmark {

/// A column of numbers: its heading with the unit, and what it means.
struct ContributionColumn {
    QString heading, meaning;
    FigureUnit unit = FigureUnit::none;
    int decimals = 1;
};

/// A building, a tree, or the terrain.
struct ContributionRow {
    QString name;
    std::shared_ptr<const Building> building;  ///< null: a tree, or the terrain
    double share = 0;                          ///< of all that is listed, 0 to 1: its colour on the map
    std::vector<double> values;                ///< by column
    std::string tree;                          ///< Tree::sourceId; empty: no tree
    bool isDescribed = false;                  ///< `name` says how high it is and where: it has no name
};

/// What the dock shows of a region or place.
struct ContributionSheet {
    QString headline;  ///< in one sentence, what matters most
    QString note;      ///< below the headline; may be empty
    QString method;    ///< how it was found: the tooltip of both
    std::vector<ContributionColumn> columns;
    std::vector<ContributionRow> rows;
    Bars months{};  ///< hours of sun; without groups: none
    bool areTreesListed = false;
};

/// How a sheet is worded, and which trees it ranks with the buildings.
struct ContributionView {
    ShownAs show = ShownAs::shadow;  ///< what sentences are about; what buildings take is shadow in both
    TreeColumns trees = TreeColumns::seasonal;  ///< where they were measured (chooseRankedColumn())
    std::optional<glm::dvec2> from{};  ///< from where it is said in which direction a building stands
};

/// The sheet of a study: the buildings of `rows` and the trees, over the cells of `breakdown`.
ContributionSheet makeContributionSheet(const Study& study, const ShadowBreakdown& breakdown,
                                        const std::vector<Contribution>& rows, const ContributionView& view,
                                        const std::vector<TreeContribution>& trees = {});
/// With the study's own figure of the same cells beside it.
ContributionSheet makeContributionSheet(const Study& study, const PlaceContributions& of,
                                        const ContributionView& view);
/// The sheet of a saved study that states contributions(), for the buildings that still stand in `city`.
ContributionSheet makeContributionSheet(const SavedStudy& study, const City& city,
                                        const ContributionView& view);
/// The sheet of a place whose contributions an answer keeps, for the buildings that still stand in `city`.
ContributionSheet makeContributionSheet(const ContributionTable& of, const City& city,
                                        const ContributionView& view);
/// The sheet of a comparison: the new buildings, by what each of them adds alone. `place`: null is the whole
/// region. `after`: the city with the new buildings.
ContributionSheet makeContributionSheet(const ImpactAnswer& answer, const City& after, const Place* place,
                                        ShownAs show);

/// Whether people can read it as a name: "Woolworth Building", but no number of a register
/// ("{0C3309A9-671F-4F25-8321-5EDF03882E91}", "2O2Fr$t4X7Zf8NOew3FLOH").
bool isReadableName(const std::string& name);

std::size_t classOf(double share);     ///< index in contributionClasses
QString describeClass(std::size_t i);  ///< "< 1 %", "1-5 %", "≥ 30 %"

}  // namespace noonmark
