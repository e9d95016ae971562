#include "app/gui/frame/help/field_texts.h"

#include <QCoreApplication>
#include <QWidget>

namespace noonmark {

namespace {

struct FieldText {
    const char* field;
    const char* text;
};

constexpr FieldText texts[] = {
    {"accuracy", QT_TRANSLATE_NOOP("FieldText",
                                   "How exactly the shadow is computed. The line below the list says what "
                                   "each choice means; its error is measured and stated beside the legend.")},
    {"periodDetails",
     QT_TRANSLATE_NOOP("FieldText",
                       "Shows or hides the time zone, the step of the sun and how sunrise is defined.")},
    {"methodDetails",
     QT_TRANSLATE_NOOP("FieldText", "Shows or hides the method and its options, for experts.")},
    {"rangeQuantity", QT_TRANSLATE_NOOP("FieldText",
                                        "What the chart of a range of days shows: shadow in the scenario, in "
                                        "the baseline, or what the scenario adds.")},
    {"verdicts",
     QT_TRANSLATE_NOOP("FieldText",
                       "The places with their verdicts, and below each its days with the numbers behind it. "
                       "A click shows the timeline, a double click zooms to the place.")},
    {"windowVerdicts",
     QT_TRANSLATE_NOOP(
         "FieldText",
         "The windows with their verdicts before and after, those that get worse first. A click on "
         "a column sorts by it, a click on a row tells when its window has sun.")},
    {"reviewFrom", QT_TRANSLATE_NOOP("FieldText", "What the proposal is compared with.")},
    {"placeFilter",
     QT_TRANSLATE_NOOP("FieldText", "Lists only the places whose name or kind contains this text.")},
    {"placesTable",
     QT_TRANSLATE_NOOP(
         "FieldText",
         "The places with their hours of sun. A click on a heading sorts them, a click on a row "
         "shows its place in the view.")},
    {"reviewPlaces", QT_TRANSLATE_NOOP("FieldText", "The places that the review judges: those with a tick.")},
    {"plateSize",
     QT_TRANSLATE_NOOP(
         "FieldText",
         "The size of the floor plate: as a share of the lot in per cent, or as an area in square metres.")},
    {"addSetback",
     QT_TRANSLATE_NOOP("FieldText",
                       "Adds a height above which the walls are set back from the edge of the plate.")},
    {"removeSetback", QT_TRANSLATE_NOOP("FieldText", "Removes the selected setback.")},
    {"setbacks",
     QT_TRANSLATE_NOOP("FieldText", "Heights, and how far the walls are set back above each, metres.")},
    {"cancelPlacing", QT_TRANSLATE_NOOP("FieldText", "Ends placing; the scenario stays as it is.")},
    {"projectTree", QT_TRANSLATE_NOOP("FieldText",
                                      "All that the project holds. Enter or a double click shows or uses a "
                                      "row, F2 renames it, Delete removes it, a right click has more.")},
    {"scenarioTable", QT_TRANSLATE_NOOP("FieldText",
                                        "The scenarios side by side, with their figures for the same period "
                                        "and region. A click on a heading sorts them.")},
    {"frozenColumn", QT_TRANSLATE_NOOP("FieldText",
                                       "The names of the scenarios, which stay in sight when the table is "
                                       "scrolled sideways. A double click shows a scenario.")},
    {"weights",
     QT_TRANSLATE_NOOP("FieldText",
                       "The intervals of the weight table: days of the year, hours of the day, and a weight "
                       "from -1 (shadow unwanted) to 1 (shade wanted). Double-click a cell to change it.")},
    {"remedy", QT_TRANSLATE_NOOP("FieldText", "Does what the message proposes.")},
    {"otherRemedy", QT_TRANSLATE_NOOP("FieldText", "Does the other thing that the message proposes.")},
    {"lookDateField", QT_TRANSLATE_NOOP("FieldText", "The date that is shown, in the year of the period.")},
    {"lookTimeField",
     QT_TRANSLATE_NOOP("FieldText", "The wall-clock time that is shown, in the time zone of the study.")},
    {"studyKind", QT_TRANSLATE_NOOP(
                      "FieldText",
                      "What the study answers: minutes of shadow, the change that a scenario makes, a score "
                      "of wanted and unwanted shadow, the verdicts of a board's rule, or the hours of sun of "
                      "places.")},
    {"reviewRule", QT_TRANSLATE_NOOP("FieldText",
                                     "The rule of a review board by which the ticked places are judged. The "
                                     "list has the rules that come with Noonmark and those of your own.")},
    {"reviewTo",
     QT_TRANSLATE_NOOP(
         "FieldText",
         "The scenario with the proposal. Displayed: whichever is chosen at the top of the window.")},
    {"reviewOption",
     QT_TRANSLATE_NOOP("FieldText",
                       "A choice that the rule leaves to the case, such as a district or a zone.")},
};

}  // namespace

QString findFieldText(const QWidget& field) {
    for (const FieldText& entry : texts)
        if (field.objectName() == QLatin1String(entry.field))
            return QCoreApplication::translate("FieldText", entry.text);
    return {};
}

}  // namespace noonmark
