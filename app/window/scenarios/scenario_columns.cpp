#include "app/window/scenarios/scenario_columns.h"

#include "app/window/widgets/number_words.h"
#include "app/window/widgets/unit_columns.h"

namespace noonmark {

namespace {

struct Heading {
    const char* key;
    const char* title;  // %1: the unit
    const char* tip;
};

constexpr const char* shadowTip = QT_TRANSLATE_NOOP(
    "noonmark::ScenarioTable", "Sum over the receivers of (share of the sunlit time in shadow × cell area)");

// In the order of ScenarioTable::Column.
constexpr Heading headings[] = {
    {"scenario", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Scenario"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Double-click to show it")},
    {"changes", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Changes"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                       "Steps from the existing city, including those of its bases")},
    {"height", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Height, %1"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                       "Highest point above its ground of the buildings that the scenario adds")},
    {"floor_area", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Floor area, %1"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                       "Gross floor area of the scenario's towers. Imported buildings and towers whose "
                       "height was changed afterwards are not counted")},
    {"shadow_area", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Shadow area, %1"), shadowTip},
    {"gross", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Mean gross, min"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Minutes in shadow per day, mean over days and receivers")},
    {"continuous", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Mean continuous, min"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                       "Longest unbroken run in shadow on any day, mean over the receivers")},
    {"impact", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Impact, %1"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                       "Change of the shadow area from the chosen baseline, else from the existing city, on "
                       "the receivers of both")},
    {"weighted_shade", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Weighted shade, m² h"),
     QT_TRANSLATE_NOOP(
         "noonmark::ScenarioTable",
         "Weight × hours in shadow × area, by the table that the dock Weights shows: above 0, wanted "
         "shade outweighs unwanted shadow. How the table is cut does not change it")},
    {"score", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Score, %1"),
     QT_TRANSLATE_NOOP(
         "noonmark::ScenarioTable",
         "The paper's score: the sum of weight × share of each interval's sunlit time in shadow × "
         "area. An interval that is cut in two counts twice")},
    {"verdicts", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Verdicts"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                       "By the rule and the baseline that the dock Review shows; sorted by the number that "
                       "fail, then by borderline ones")},
    {"uses", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Floor area by use"),
     QT_TRANSLATE_NOOP(
         "noonmark::ScenarioTable",
         "Gross floor area of the scenario's towers by use, sorted by its sum. Imported buildings "
         "and towers whose height was changed afterwards are not counted")},
};

static_assert(std::size(headings) == ScenarioTable::columns);

}  // namespace

QVariant headingOf(ScenarioTable::Column column, int role) {
    const Heading& heading = headings[column];
    if (role == ScenarioTable::keyRole) return QString::fromLatin1(heading.key);
    if (role == Qt::ToolTipRole) return ScenarioTable::tr(heading.tip);
    if (role != Qt::DisplayRole) return {};
    const QString title = ScenarioTable::tr(heading.title);
    if (!title.contains(QStringLiteral("%1"))) return title;
    return title.arg(column == ScenarioTable::height ? lengthUnit() : areaUnit());
}

QString numberText(double value, ScenarioTable::Column column) {
    switch (column) {
        case ScenarioTable::height:
            return lengthNumber(value);
        case ScenarioTable::floorArea:
        case ScenarioTable::shadowArea:
            return areaNumber(value);
        case ScenarioTable::impact:
        case ScenarioTable::score:
            return signedAreaNumber(value);
        case ScenarioTable::weightedShade:
            return (value > 0 ? QStringLiteral("+") : QString()) + formatAmount(value, 0);
        default:
            return formatAmount(value, column == ScenarioTable::changes ? 0 : 1);
    }
}

}  // namespace noonmark
