#include "app/gui/frame/help/help_actions.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QDateTimeEdit>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QString>
#include <QWhatsThisClickedEvent>
#include <QWidget>

#include "app/gui/base/widgets/number_fields.h"
#include "app/gui/base/widgets/number_text.h"

class QWidget;

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

/// What a field without a tool tip means, by its object name; empty for others.
QString findFieldText(const QWidget& field) {
    for (const FieldText& entry : texts)
        if (field.objectName() == QLatin1String(entry.field))
            return QCoreApplication::translate("FieldText", entry.text);
    return {};
}

// Parts of a field that have no meaning of their own: the line of a spin box, the list of a combo box.
bool isPart(const QWidget& widget) {
    const QWidget* parent = widget.parentWidget();
    for (; parent != nullptr; parent = parent->parentWidget())
        if (qobject_cast<const QAbstractSpinBox*>(parent) || qobject_cast<const QComboBox*>(parent) ||
            qobject_cast<const QAbstractItemView*>(parent) || parent->inherits("QLineEdit") ||
            parent->inherits("QTabBar"))
            return true;
    return widget.objectName().startsWith(QStringLiteral("qt_"));
}

QString labelOf(const QWidget& field) {
    if (const auto* button = qobject_cast<const QAbstractButton*>(&field)) return button->text();
    if (field.parentWidget() == nullptr) return {};
    for (const QLabel* label : field.window()->findChildren<QLabel*>())
        if (label->buddy() == &field) return label->text();
    return {};
}

QString rangeOf(const QString& low, const QString& high, const QString& unit) {
    return FieldHelp::tr("%1 to %2").arg(low, high) + unit;
}

QString rangeOf(const QWidget& field) {
    if (const auto* whole = qobject_cast<const QSpinBox*>(&field))
        return rangeOf(formatAmount(whole->minimum()), formatAmount(whole->maximum()), whole->suffix());
    if (const auto* length = qobject_cast<const LengthField*>(&field))
        return rangeOf(length->textFromValue(length->minimum()), length->textFromValue(length->maximum()),
                       {});
    if (const auto* number = qobject_cast<const QDoubleSpinBox*>(&field))
        return rangeOf(formatAmount(number->minimum(), number->decimals()),
                       formatAmount(number->maximum(), number->decimals()), number->suffix());
    const auto* date = qobject_cast<const QDateTimeEdit*>(&field);
    if (date == nullptr || !(date->displayedSections() & QDateTimeEdit::YearSection)) return {};
    return rangeOf(date->minimumDate().toString(date->displayFormat()),
                   date->maximumDate().toString(date->displayFormat()), {});
}

QString meaningOf(const QWidget& field) {
    const QString text = findFieldText(field);
    return text.isEmpty() ? field.toolTip() : text;
}

// A tool tip may be HTML already.
QString paragraph(const QString& text) {
    if (Qt::mightBeRichText(text)) return text;
    return QStringLiteral("<p>%1</p>")
        .arg(text.toHtmlEscaped().replace(QLatin1Char('\n'), QStringLiteral("<br>")));
}

}  // namespace

bool isField(const QWidget& widget) {
    const bool takesInput =
        qobject_cast<const QAbstractSpinBox*>(&widget) || qobject_cast<const QComboBox*>(&widget) ||
        qobject_cast<const QLineEdit*>(&widget) || qobject_cast<const QAbstractButton*>(&widget) ||
        qobject_cast<const QAbstractSlider*>(&widget) || qobject_cast<const QAbstractItemView*>(&widget);
    return takesInput && !widget.inherits("QScrollBar") && !isPart(widget);
}

QString describeField(const QWidget& field) {
    const QString meaning = meaningOf(field);
    if (meaning.isEmpty()) return {};
    QString text;
    const QString label = labelOf(field).remove(QLatin1Char('&'));
    if (!label.isEmpty()) text += QStringLiteral("<p><b>%1</b></p>").arg(label.toHtmlEscaped());
    text += paragraph(meaning);
    if (const QString range = rangeOf(field); !range.isEmpty()) text += paragraph(range);
    return text + QStringLiteral("<p><a href=\"%1\">%2</a></p>")
                      .arg(guideLink(findGuidePlace(&field)), FieldHelp::tr("More in the guide (F1)"));
}

FieldHelp::FieldHelp(ShowGuide showGuide, QObject* parent)
    : QObject(parent), showGuide_(std::move(showGuide)) {
    qApp->installEventFilter(this);
}

bool FieldHelp::eventFilter(QObject* watched, QEvent* event) {
    const auto type = event->type();
    if (type == QEvent::WhatsThisClicked) {
        showGuide_(parseGuideLink(static_cast<QWhatsThisClickedEvent*>(event)->href()));
        return true;
    }
    if (type == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->matches(QKeySequence::HelpContents))
        return openGuide(*watched);
    const bool asks =
        type == QEvent::QueryWhatsThis || type == QEvent::WhatsThis ||
        (type == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->matches(QKeySequence::WhatsThis));
    auto* widget = asks ? qobject_cast<QWidget*>(watched) : nullptr;
    if (widget != nullptr && isField(*widget)) widget->setWhatsThis(describeField(*widget));
    return false;
}

// In a dialog; elsewhere the menu's F1 comes first.
bool FieldHelp::openGuide(const QObject& watched) {
    const auto* widget = qobject_cast<const QWidget*>(&watched);
    if (widget == nullptr || widget->window() == nullptr || !widget->window()->inherits("QDialog"))
        return false;
    showGuide_(findGuidePlace(widget));
    return true;
}

}  // namespace noonmark
