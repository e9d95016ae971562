#include "app/gui/frame/help/field_help.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QSpinBox>
#include <QWhatsThisClickedEvent>

#include "app/gui/base/widgets/length_field.h"
#include "app/gui/base/widgets/number_words.h"
#include "app/gui/frame/help/field_texts.h"

namespace noonmark {

namespace {

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
