#include "app/gui/docks/scenarios/scenario_columns.h"

#include "app/gui/base/widgets/number_words.h"
#include "app/gui/base/widgets/translated.h"
#include "app/gui/base/widgets/unit_columns.h"
#include "core/measures/shadow_figures.h"
#include "scenarios/weights/score_figures.h"

namespace noonmark {

namespace {

struct Heading {
    const char* key;
    const char* title;  // %1: the unit; null: of a figure (figureAt())
    const char* tip;
};

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
    {"shadow_area", nullptr, nullptr},
    {"gross", nullptr, nullptr},
    {"continuous", nullptr, nullptr},
    {"impact", QT_TRANSLATE_NOOP("noonmark::ScenarioTable", "Impact, %1"),
     QT_TRANSLATE_NOOP("noonmark::ScenarioTable",
                       "Change of the shadow area from the chosen baseline, else from the existing city, on "
                       "the receivers of both")},
    {"weighted_shade", nullptr, nullptr},
    {"score", nullptr, nullptr},
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

namespace {

// A column that shows a figure has its label and definition; null for any other.
const Figure* figureAt(ScenarioTable::Column column) {
    switch (column) {
        case ScenarioTable::shadowArea:
            return &findFigure(shadowFigures().rows(), "shadow_area_m2");
        case ScenarioTable::gross:
            return &findFigure(shadowFigures().rows(), "mean_gross_min");
        case ScenarioTable::continuous:
            return &findFigure(shadowFigures().rows(), "mean_continuous_min");
        case ScenarioTable::weightedShade:
            return &findFigure(scoreFigures().rows(), "weighted_shade_m2h");
        case ScenarioTable::score:
            return &findFigure(scoreFigures().rows(), "score_m2");
        default:
            return nullptr;
    }
}

QString unitOf(ScenarioTable::Column column) {
    if (column == ScenarioTable::height) return lengthUnit();
    if (column == ScenarioTable::gross || column == ScenarioTable::continuous) return QStringLiteral("min");
    return column == ScenarioTable::weightedShade ? QStringLiteral("m² h") : areaUnit();
}

QString titleOf(ScenarioTable::Column column) {
    if (const Figure* figure = figureAt(column))
        return QStringLiteral("%1, %2").arg(translated(figure->label), unitOf(column));
    const QString title = ScenarioTable::tr(headings[column].title);
    return title.contains(QStringLiteral("%1")) ? title.arg(unitOf(column)) : title;
}

QString tipOf(ScenarioTable::Column column) {
    const Figure* figure = figureAt(column);
    return figure ? translatedSentence(figure->definition) : ScenarioTable::tr(headings[column].tip);
}

}  // namespace

QVariant headingOf(ScenarioTable::Column column, int role) {
    if (role == ScenarioTable::keyRole) return QString::fromLatin1(headings[column].key);
    if (role == Qt::ToolTipRole) return tipOf(column);
    return role == Qt::DisplayRole ? titleOf(column) : QVariant();
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
